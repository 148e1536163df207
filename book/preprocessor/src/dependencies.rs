//! The dependency graph of the chapters, drawn from their manifests.

use mdbook_preprocessor::errors::{Error, Result};
use preprocessor::escape;
use stages::STAGES;
use std::collections::BTreeSet;
use std::fs;
use toml::{Table, Value};

/// Returns for every chapter, in the order of the book, the chapters that its manifest
/// names.
fn imports() -> Result<Vec<BTreeSet<usize>>> {
    // A chapter's package is called like its folder, without the number.
    let packages = STAGES.map(|stage| stage.name.split_once('-').unwrap_or_default().1);
    let chapter = |package: &String| packages.iter().position(|it| it == package);
    let imported = STAGES.map(|stage| {
        let chapters = concat!(env!("CARGO_MANIFEST_DIR"), "/../../chapters");
        let path = format!("{chapters}/{}/Cargo.toml", stage.name);
        let text = fs::read_to_string(&path)
            .map_err(|problem| Error::msg(format!("{path}: {problem}")))?;
        let manifest: Table = text.parse()?;
        let kinds = ["dependencies", "dev-dependencies", "build-dependencies"];
        let tables = kinds.map(|kind| manifest.get(kind).and_then(Value::as_table));
        let named = tables.into_iter().flatten().flat_map(Table::keys);
        Ok(named.filter_map(chapter).collect())
    });
    imported.into_iter().collect()
}

/// Returns the imports without those that another import implies, since it imports them in
/// turn.
fn direct(imports: &[BTreeSet<usize>]) -> Vec<BTreeSet<usize>> {
    // The chapters that each imports, directly or not.
    let mut all: Vec<BTreeSet<usize>> = Vec::new();
    let mut direct = Vec::new();
    for imported in imports {
        let in_turn = imported.iter().filter_map(|&chapter| all.get(chapter));
        let in_turn: BTreeSet<_> = in_turn.flatten().copied().collect();
        direct.push(imported - &in_turn);
        all.push(imported | &in_turn);
    }
    direct
}

/// Returns an SVG of the chapters as boxes in the order of the book, with an arrow from
/// each to those that it imports.
pub fn diagram() -> Result<String> {
    const STEP: usize = 46;
    const EDGE: usize = 442;
    let mut boxes = String::new();
    let mut arrows = String::new();
    let mut words = Vec::new();
    for (row, (stage, built_on)) in STAGES.iter().zip(direct(&imports()?)).enumerate() {
        let number = |row: usize| STAGES[row].name.split('-').next().unwrap_or_default();
        let top = STEP * row + 2;
        boxes += &format!(
            "<a href=\"{}.md\"><rect class=\"solid\" x=\"2\" y=\"{top}\" width=\"440\" height=\"34\" rx=\"5\"/>\
             <text class=\"label\" x=\"14\" y=\"{}\">{} {}</text></a>\n",
            stage.name,
            top + 23,
            number(row),
            escape(stage.title),
        );
        for &below in &built_on {
            // From the upper part of one box to the lower part of the other.
            let (start, end) = (top + 11, STEP * below + 25);
            let (bend, tip) = (EDGE + 24 + 24 * row.abs_diff(below), EDGE + 11);
            arrows += &format!(
                "<path class=\"ray\" d=\"M{EDGE} {start} C{bend} {start} {bend} {end} {tip} {end}\"/>\
                 <path class=\"ray head\" d=\"M{EDGE} {end} l11 -6 v12 z\"/>\n"
            );
        }
        let built_on: Vec<_> = built_on.into_iter().map(number).collect();
        if !built_on.is_empty() {
            words.push(format!("{} on {}", number(row), built_on.join(" and ")));
        }
    }
    Ok(format!(
        "<svg class=\"diagram\" viewBox=\"0 0 640 {}\" role=\"img\" \
         aria-label=\"Which chapter is built on which: {}.\">\n{boxes}{arrows}</svg>\n",
        STEP * STAGES.len() - 8,
        words.join(", "),
    ))
}

#[cfg(test)]
mod the_chapters {
    use super::*;

    #[test]
    fn import_no_later_one() {
        for (chapter, imported) in imports().unwrap().iter().enumerate() {
            let name = STAGES[chapter].name;
            assert!(chapter == 0 || !imported.is_empty(), "{name} imports none");
            let later: Vec<_> = imported.range(chapter..).collect();
            assert!(later.is_empty(), "{name} imports {later:?}");
        }
    }

    #[test]
    fn are_drawn_without_the_arrows_that_others_imply() {
        let sets = |graph: [&[usize]; 5]| graph.map(|it| it.iter().copied().collect());
        let imports = sets([&[], &[0], &[0, 1], &[0, 1], &[0, 2, 3]]);
        assert_eq!(direct(&imports), sets([&[], &[0], &[1], &[1], &[2, 3]]));
    }

    #[test]
    fn all_stand_in_the_diagram_and_in_its_description() {
        let diagram = diagram().unwrap();
        for stage in STAGES {
            let link = format!("<a href=\"{}.md\">", stage.name);
            assert!(diagram.contains(&link), "{link} is not in {diagram}");
        }
        let number = |name: &str| {
            let mut stages = STAGES.iter();
            let stage = stages.find(|stage| stage.name.ends_with(name)).unwrap();
            stage.name.split('-').next().unwrap()
        };
        let words = format!("{} on {}", number("-refraction"), number("-reflection"));
        assert!(diagram.contains(&words), "{diagram}");
    }
}
