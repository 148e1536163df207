//! Charts and numbers from chapter 13's studies.

use crate::figures::{command, escape};
use mdbook_preprocessor::errors::{Error, Result};
use speed_and_accuracy::study::{Study, Table, three_digits};
use speed_and_accuracy::{STAGE, studies};
use std::fs;

/// The chart of a study, and where its numbers come from.
pub fn chart(name: &str) -> Result<String> {
    let (study, table) = find(name)?;
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../src/studies");
    let path = format!("{folder}/{name}.svg");
    let svg = fs::read_to_string(&path)
        .map_err(|problem| Error::msg(format!("{path}: {problem}")))?;
    // A blank line would end Markdown's block of HTML.
    let lines: Vec<_> = svg.lines().filter(|line| !line.trim().is_empty()).collect();
    let command = command(&format!(
        "cargo run --release --bin {} -- --study {name}",
        STAGE.name
    ));
    Ok(format!(
        "<div class=\"figures\">\n<figure>\n{}\n\
         <figcaption>{}. Measured on {}: <a href=\"studies/{name}.csv\">the table</a>.<br>{command}</figcaption>\n\
         </figure>\n</div>\n",
        lines.join("\n"),
        escape(study.title),
        escape(&table.machine),
    ))
}

/// The number that is asked for by `STUDY; SCENE; METHOD; SETTING; COLUMN`.
///
/// No `|` between them, which would end a cell of a table.
pub fn number(asked: &str) -> Result<String> {
    let words = asked.split_whitespace().collect::<Vec<_>>().join(" ");
    let number = match words.split(';').map(str::trim).collect::<Vec<_>>()[..] {
        [name, scene, method, setting, column] => {
            let (_, table) = find(name)?;
            match setting.parse() {
                Ok(setting) => table.number(scene, method, setting, column),
                Err(_) => Err(format!("“{setting}” is not a number")),
            }
        }
        _ => Err("not STUDY; SCENE; METHOD; SETTING; COLUMN".to_string()),
    };
    let problem = |problem| Error::msg(format!("{{{{#measured {words}}}}}: {problem}"));
    number.map(for_readers).map_err(problem)
}

fn find(name: &str) -> Result<(&'static Study, Table)> {
    let study = studies::find(name).map_err(Error::msg)?;
    let table = Table::from_csv(study.table)
        .map_err(|problem| Error::msg(format!("{name}.csv: {problem}")))?;
    Ok((study, table))
}

/// A number as the table has it, but with its power of ten as we write it by hand.
fn for_readers(number: f64) -> String {
    if number.is_infinite() {
        return "∞".to_string();
    }
    let digits = three_digits(Some(number));
    match digits.split_once('e') {
        Some((digits, exponent)) => {
            // No line ends within it.
            let exponent = exponent.replace('-', "−");
            format!("{digits}\u{a0}×\u{a0}10<sup>{exponent}</sup>")
        }
        None => digits,
    }
}

#[cfg(test)]
mod a_number {
    use super::{for_readers, number};
    use speed_and_accuracy::STUDIES;
    use speed_and_accuracy::study::Table;

    #[test]
    fn is_written_as_by_hand() {
        for (number, written) in [
            (0.0, "0"),
            (4.45, "4.45"),
            (307_000.0, "307000"),
            (1.13e6, "1.13\u{a0}×\u{a0}10<sup>6</sup>"),
            (1.2e-7, "1.2\u{a0}×\u{a0}10<sup>−7</sup>"),
            (f64::INFINITY, "∞"),
        ] {
            assert_eq!(for_readers(number), written);
        }
    }

    #[test]
    fn is_found_in_every_cell_that_is_not_empty() {
        for study in STUDIES {
            for row in Table::from_csv(study.table).unwrap().rows {
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
                    let asked = format!("{name}; {scene}; {method}; {setting}; {column}");
                    assert_eq!(number(&asked).ok(), cell.map(for_readers), "{asked}");
                }
            }
        }
    }
}
