//! The studies of the book, the numbers that its pages quote, and their drawings.

pub mod drawings;

use mdbook_preprocessor::errors::{Error, Result};
use speed_and_accuracy::STUDIES;
use speed_and_accuracy::chart::Quantity;
use speed_and_accuracy::study::Study;
use speed_and_accuracy::table::{Table, for_readers};

/// Returns every study.
pub fn studies() -> impl Iterator<Item = &'static Study> {
    STUDIES.into_iter().chain([&plan::study::STUDY])
}

/// Returns the study called `name`, and its table in the book.
///
/// # Errors
/// If there is no such study, or its file holds no table.
pub fn study(name: &str) -> Result<(&'static Study, Table)> {
    let study = studies().find(|study| study.name == name);
    let study = study.ok_or_else(|| {
        let names: Vec<_> = studies().map(|study| study.name).collect();
        let names = names.join(", ");
        Error::msg(format!("there is no study '{name}'; the studies: {names}"))
    })?;
    let table = study.table();
    let table = table.map_err(|problem| Error::msg(format!("{name}.csv: {problem}")))?;
    Ok((study, table))
}

/// Returns the number that a page includes by `STUDY; SCENE; METHOD; SETTING; COLUMN`, as we
/// write it by hand. The column is `work`, `max`, `rms`, `wrong` or `ns`.
///
/// They are not separated by `|`, which would end a cell of a table.
///
/// # Errors
/// If there is no such number.
pub fn measured(reference: &str) -> Result<String> {
    let words = reference.split_whitespace().collect::<Vec<_>>().join(" ");
    let number = || {
        let parts = words.split(';').map(str::trim).collect::<Vec<_>>();
        let [name, scene, method, setting, column] = parts[..] else {
            return Err(Error::msg("not STUDY; SCENE; METHOD; SETTING; COLUMN"));
        };
        let setting: f64 = setting
            .parse()
            .map_err(|_| Error::msg(format!("“{setting}” is not a number")))?;
        let column = match column {
            "work" => Quantity::Work,
            "max" => Quantity::Max,
            "rms" => Quantity::Rms,
            "wrong" => Quantity::Wrong,
            "ns" => Quantity::Ns,
            _ => return Err(Error::msg(format!("there is no column “{column}”"))),
        };
        let (_, table) = study(name)?;
        let row = table.rows.iter().find(|row| {
            row.scene == scene && row.method == method && row.setting == setting
        });
        let row = row.ok_or_else(|| Error::msg("there is no such row"))?;
        column
            .of(row)
            .ok_or_else(|| Error::msg("the cell is empty"))
    };
    let problem = |problem| Error::msg(format!("{{{{#measured {words}}}}}: {problem}"));
    number().map(for_readers).map_err(problem)
}

/// Returns plain text as HTML, with the apostrophes that mdBook gives to all other text.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "’")
}

#[cfg(test)]
mod a_number {
    use super::{for_readers, measured, studies};

    #[test]
    fn is_found_in_every_cell_that_is_not_empty() {
        for study in studies() {
            let rows = study.table().unwrap().rows;
            // Each call reads the whole table: a few of them are enough.
            for row in rows.iter().step_by(rows.len() / 8 + 1) {
                let (scene, method, setting) = (&row.scene, &row.method, row.setting);
                let cells = [
                    ("work", row.work),
                    ("max", row.max),
                    ("rms", row.rms),
                    ("wrong", row.wrong),
                    ("ns", row.ns),
                ];
                for (column, cell) in cells {
                    let name = study.name;
                    let reference =
                        format!("{name}; {scene}; {method}; {setting}; {column}");
                    assert_eq!(
                        measured(&reference).ok(),
                        cell.map(for_readers),
                        "{reference}"
                    );
                }
            }
        }
    }
}
