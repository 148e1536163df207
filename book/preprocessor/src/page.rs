//! Replaces the formulas and commands of one page, and leaves everything else, code
//! included, as it is.

use crate::{dependencies, figures, maths};
use mdbook_preprocessor::errors::{Error, Result};
use pulldown_cmark::{Event, Options, Parser, Tag};

const OPTIONS: Options = Options::ENABLE_MATH
    .union(Options::ENABLE_TABLES)
    .union(Options::ENABLE_FOOTNOTES);

/// Replaces a page's formulas, figures, crops, drawings, charts, measured numbers, table of chapters and
/// diagram of their dependencies.
pub fn prepare(markdown: &str) -> Result<String> {
    let markdown = &with_numbers(markdown)?;
    let mut prepared = String::new();
    let mut done = 0;
    for (event, range) in Parser::new_ext(markdown, OPTIONS).into_offset_iter() {
        let replacement = match event {
            // It is part of what has been replaced.
            _ if range.start < done => None,
            Event::InlineMath(latex) => Some(maths::inline(&latex)?),
            Event::DisplayMath(latex) => Some(maths::display(&latex)?),
            Event::Start(Tag::Paragraph) => paragraph(markdown[range.clone()].trim())?,
            Event::Start(Tag::Image { dest_url, .. })
                if dest_url.starts_with("pictures/solutions/") =>
            {
                Some(linked(&markdown[range.clone()], &dest_url))
            }
            _ => None,
        };
        if let Some(replacement) = replacement {
            prepared += &markdown[done..range.start];
            prepared += &replacement;
            done = range.end;
        }
    }
    Ok(prepared + &markdown[done..])
}

/// Returns an image, followed by a link to its file, under its name: for a reader to save.
fn linked(image: &str, file: &str) -> String {
    let (_, name) = file.rsplit_once('/').unwrap_or_default();
    format!("{image}\n[`{name}`]({file})")
}

/// Returns the page without what is folded away as a solution or an answer.
pub fn without_solutions(markdown: &str) -> String {
    let mut kept = String::new();
    for text in markdown.split_inclusive("</details>") {
        match text.split_once("<details>") {
            Some((before, fold))
                if ["Solution", "Answer"]
                    .iter()
                    .any(|word| fold.contains(&format!("<summary>{word}</summary>"))) =>
            {
                kept += before;
            }
            _ => kept += text,
        }
    }
    kept
}

/// Returns the page with each `{{#measured …}}` replaced that is not code.
fn with_numbers(markdown: &str) -> Result<String> {
    let mut filled = String::new();
    let mut done = 0;
    for (event, range) in Parser::new_ext(markdown, OPTIONS).into_offset_iter() {
        if let Event::Code(_) | Event::Start(Tag::CodeBlock(_)) = event {
            filled += &fill_in(&markdown[done..range.start])?;
            filled += &markdown[range.clone()];
            done = range.end;
        }
    }
    Ok(filled + &fill_in(&markdown[done..])?)
}

fn fill_in(text: &str) -> Result<String> {
    let mut filled = String::new();
    let mut rest = text;
    while let Some((before, command)) = rest.split_once("{{#measured ") {
        let (reference, after) = command
            .split_once("}}")
            .ok_or_else(|| Error::msg("a {{#measured has no }}"))?;
        filled += before;
        filled += &preprocessor::measured(reference)?;
        rest = after;
    }
    Ok(filled + rest)
}

/// Returns the replacement of a paragraph that is nothing but `{{#figure …}}`, `{{#crop …}}`,
/// `{{#drawing …}}`, `{{#chart …}}`, `{{#stages}}` or `{{#dependencies}}`.
fn paragraph(text: &str) -> Result<Option<String>> {
    let Some(command) = text
        .strip_prefix("{{#")
        .and_then(|text| text.strip_suffix("}}"))
    else {
        return Ok(None);
    };
    match command.split_whitespace().collect::<Vec<_>>()[..] {
        ["figure", stage, ref views @ ..] => figures::figures(stage, views).map(Some),
        ["crop", stage, left, top, width, height, ref views @ ..] => {
            figures::crops(stage, [left, top, width, height], views).map(Some)
        }
        ["drawing", name] => preprocessor::drawings::drawing(name).map(Some),
        ["chart", name] => figures::chart(name).map(Some),
        ["stages"] => Ok(Some(figures::chapters())),
        ["dependencies"] => dependencies::diagram().map(Some),
        _ => Ok(None),
    }
}

#[cfg(test)]
mod a_page {
    use super::{prepare, without_solutions};
    use preprocessor::{escape, measured, studies};

    #[test]
    fn keeps_what_is_neither_maths_nor_figure() {
        let page = "# A title\n\n| a | b |\n|---|---|\n| 1 | <br> |\n\nIt *costs* \\$5 & more.\n";
        assert_eq!(prepare(page).unwrap(), page);
    }

    #[test]
    fn keeps_everything_but_its_solutions_if_these_are_not_wanted() {
        let fold = |summary| {
            format!("<details>\n<summary>{summary}</summary>\n\n…\n\n</details>\n")
        };
        let [hint, solution, answer] = ["Hint", "Solution", "Answer"].map(fold);
        let page = format!("# 1\n{hint}\n{solution}\n# 2\n{hint}\n{answer}\n# 3\n{hint}");
        let rest = format!("# 1\n{hint}\n\n\n# 2\n{hint}\n\n\n# 3\n{hint}");
        assert_eq!(without_solutions(&page), rest);

        // The pages have no other folds, and none of another form.
        let pages = concat!(env!("CARGO_MANIFEST_DIR"), "/../src");
        let mut removed = 0;
        for page in std::fs::read_dir(pages).unwrap() {
            let page = page.unwrap().path();
            if page.extension().is_none_or(|ending| ending != "md") {
                continue;
            }
            let page = std::fs::read_to_string(page).unwrap();
            let rest = without_solutions(&page);
            let count = |text: &str| text.matches("<details").count();
            let hints = rest.matches("<summary>Hint</summary>").count();
            assert_eq!(count(&rest), hints);
            assert_eq!(count(&page), 2 * hints);
            assert_eq!(rest.matches("### Exercise ").count(), hints);
            assert!(!rest.contains("(pictures/solutions/"));
            removed += count(&page) - count(&rest);
        }
        assert!(removed > 50, "only {removed}");
    }

    #[test]
    fn names_the_files_of_its_solutions_pictures() {
        let page = "Before.\n\n![A *disc*](pictures/solutions/x--1.snap.png)\n\nAfter.\n";
        let image = "![A *disc*](pictures/solutions/x--1.snap.png)";
        assert_eq!(
            prepare(page).unwrap(),
            format!(
                "Before.\n\n{image}\n[`x--1.snap.png`](pictures/solutions/x--1.snap.png)\n\nAfter.\n"
            )
        );
        let other = "![A disc](pictures/x--1.snap.png)\n";
        assert_eq!(prepare(other).unwrap(), other);
    }

    #[test]
    fn keeps_its_code_even_if_it_looks_like_maths_or_a_figure() {
        let page = "`$x$`\n\n```rust\nlet cost = \"$x$ or $$y$$\";\n\n{{#figure NN-sphere-hit flat}}\n\n{{#chart sphere}}\n```\n";
        assert_eq!(prepare(page).unwrap(), page);
    }

    #[test]
    fn gets_mathml_for_its_formulas() {
        let page = prepare("A ray is $\\mathbf{o} + t\\mathbf{d}$.\n").unwrap();
        assert!(page.starts_with("A ray is <math"), "{page}");
        assert!(page.ends_with("</math>.\n"), "{page}");
        // Bold o and d are letters of their own.
        assert!(page.contains("𝐨") && page.contains("𝐝"), "{page}");
    }

    #[test]
    fn gets_wellformed_mathml_even_where_its_maker_is_careless() {
        let page = prepare("$0 < x$ and $\\bigl(x\\bigr)$").unwrap();
        assert!(page.contains("<mo>&lt;</mo>"), "{page}");
        assert!(page.contains("\"true\" minsize="), "{page}");
    }

    #[test]
    fn says_which_formula_is_wrong() {
        let problem = prepare("$\\frac{1}$ and $\\nonsense$").unwrap_err();
        assert!(problem.to_string().contains("$\\frac{1}$"), "{problem}");
    }

    /// The text with the name of the stage about spheres, whichever its number is.
    fn named(text: &str) -> String {
        let mut stages = stages::STAGES.into_iter();
        let stage = stages.find(|stage| stage.name.ends_with("-sphere-hit"));
        text.replace("NN-sphere-hit", stage.unwrap().name)
    }

    #[test]
    fn gets_a_figure_for_each_view() {
        let page =
            "Before.\n\n{{#figure NN-sphere-hit flat far-textbook=10000}}\n\nAfter.\n";
        let page = prepare(&named(page)).unwrap();
        for expected in [
            r#"<a href="pictures/NN-sphere-hit--flat.snap.png">"#,
            r#"width="800" height="600""#,
            "<span>NN-sphere-hit</span></code>",
            r#"<img src="pictures/NN-sphere-hit--far-textbook--knob-10000.snap.png""#,
            r#"width="320" height="240""#,
            "Here, distance = 10,000 radii.",
            "<span>--view</span> <span>far-textbook</span> <span>--knob</span> <span>10000</span> <span>--size</span> <span>320x240</span></code>",
        ] {
            assert!(page.contains(&named(expected)), "no {expected} in {page}");
        }
        assert!(
            page.starts_with("Before.\n\n<div class=\"figures\">"),
            "{page}"
        );
        assert!(page.ends_with("</div>\n\nAfter.\n"), "{page}");
    }

    #[test]
    fn cannot_show_what_no_stage_shows() {
        for (command, complaint) in [
            ("sphere flat", "no stage is called “sphere”"),
            ("NN-sphere-hit flatt", "NN-sphere-hit has no view “flatt”"),
            ("NN-sphere-hit flat=1", "“flat” has no knob"),
            ("NN-sphere-hit far-textbook=x", "“x” is not a number"),
            (
                "NN-sphere-hit far-textbook=20",
                "20 is not among the snapshot_settings",
            ),
            ("NN-sphere-hit", "a figure of NN-sphere-hit names no view"),
        ] {
            let command = named(&format!("{{{{#figure {command}}}}}\n"));
            let problem = prepare(&command).unwrap_err().to_string();
            assert!(problem.contains(&named(complaint)), "{problem}");
        }
    }

    #[test]
    fn gets_a_magnified_crop_of_each_view() {
        let command =
            "{{#crop NN-sphere-hit 10 20 30 40 flat far-textbook far-textbook=10000}}\n";
        let page = prepare(&named(command)).unwrap();
        for expected in [
            r#"<svg class="crop" width="240" height="320" viewBox="10 20 30 40" role="img" aria-label=""#,
            r#"<image href="pictures/NN-sphere-hit--flat.snap.png" width="800" height="600"/>"#,
            r#"<image href="pictures/NN-sphere-hit--far-textbook--knob-10000.snap.png" width="320" height="240"/>"#,
            "<figcaption>distance = 10,000 radii</figcaption>",
            "Magnified 8 times: 30 × 40 pixels, the first of them at (10, 20).",
        ] {
            assert!(page.contains(&named(expected)), "no {expected} in {page}");
        }
        // The other one, of the default distance, is captioned as a figure is.
        assert_eq!(page.matches("<figcaption>distance").count(), 1, "{page}");
    }

    #[test]
    fn cannot_crop_what_is_not_there() {
        for (command, complaint) in [
            (
                "NN-sphere-hit 0 0 8 8",
                "a crop of NN-sphere-hit names no view",
            ),
            (
                "NN-sphere-hit 0 0 8 flat flat",
                "“0 0 8 flat” is not LEFT TOP WIDTH HEIGHT",
            ),
            (
                "NN-sphere-hit 0 0 0 8 flat",
                "the crop of “flat” is not within its 800 × 600",
            ),
            (
                "NN-sphere-hit 793 0 8 8 flat",
                "the crop of “flat” is not within its 800 × 600",
            ),
            (
                "NN-sphere-hit 0 233 8 8 normals",
                "“normals” is not within its 320 × 240",
            ),
        ] {
            let command = named(&format!("{{{{#crop {command}}}}}\n"));
            let problem = prepare(&command).unwrap_err().to_string();
            assert!(problem.contains(&named(complaint)), "{problem}");
        }
    }

    #[test]
    fn gets_its_drawings_in_one_block_of_html() {
        let page = prepare("Before.\n\n{{#drawing pixel-grid}}\n\nAfter.\n").unwrap();
        assert!(
            page.starts_with("Before.\n\n<div class=\"figures\">\n<figure"),
            "{page}"
        );
        assert!(page.ends_with("</figure>\n</div>\n\nAfter.\n"), "{page}");
        assert!(prepare("{{#drawing pixel-gird}}\n").is_err());
    }

    #[test]
    fn gets_the_charts_of_a_study() {
        for study in studies() {
            let command = format!("Before.\n\n{{{{#chart {}}}}}\n\nAfter.\n", study.name);
            let page = prepare(&command).unwrap();
            let table = study.table().unwrap();
            for expected in [
                &escape(study.title),
                &format!("Measured on {}", escape(&table.machine)),
                &format!("<a href=\"studies/{}.csv\">", study.name),
                "<span>cargo</span> <span>bench</span> <span>--bench</span> <span>studies</span>",
                &format!("<span>{}</span></code>", study.name),
            ] {
                assert!(page.contains(expected), "no {expected} in {page}");
            }
            // All of it, in one block of HTML.
            let figure = page.strip_prefix("Before.\n\n<div class=\"figures\">\n");
            let figure = figure.and_then(|page| page.strip_suffix("</div>\n\nAfter.\n"));
            let figure = figure.expect("a figure");
            assert!(!figure.contains("\n\n"), "{figure}");
            let svg = std::fs::read_to_string(study.path("svg")).unwrap();
            let lines = svg.lines().filter(|line| !line.is_empty());
            assert!(
                figure.contains(&lines.collect::<Vec<_>>().join("\n")),
                "{figure}"
            );
        }
    }

    #[test]
    fn cannot_show_the_charts_of_what_is_no_study() {
        let problem = prepare("{{#chart spheres}}\n").unwrap_err().to_string();
        assert!(problem.contains("'spheres'"), "{problem}");
        for study in studies() {
            assert!(problem.contains(study.name), "{problem}");
        }
    }

    #[test]
    fn gets_measured_numbers_wherever_they_stand_but_in_code() {
        let command = "{{#measured sphere; from afar; textbook; 1000; wrong}}";
        let number = measured("sphere; from afar; textbook; 1000; wrong").unwrap();
        let page = |number: &str| {
            format!(
                "# Wrong: {number}\n\n{number} % is *wrong ({number} %)*, or $x = {number}$.\n\n\
                 * An item with {number} and {number}.\n\n\
                 | {number} | b |\n|---|---|\n| 1 | {number} |\n\n\
                 <p>{number}</p>\n\n`{command}`, says\n\n```text\n{command}\n```\n"
            )
        };
        let expected = prepare(&page(&number)).unwrap();
        assert_eq!(prepare(&page(command)).unwrap(), expected);
        let broken = command
            .replace("; ", ";\n  ")
            .replace("from afar", "from\nafar");
        assert_eq!(prepare(&page(&broken)).unwrap(), expected);
    }

    #[test]
    fn cannot_know_a_number_that_nobody_measured() {
        for (reference, complaint) in [
            (
                "cube; from afar; textbook; 1000; wrong",
                "there is no study 'cube'",
            ),
            ("sphere; afar; textbook; 1000; wrong", "no such row"),
            ("sphere; from afar; textbok; 1000; wrong", "no such row"),
            ("sphere; from afar; textbook; 1001; wrong", "no such row"),
            (
                "sphere; from afar; textbook; far; wrong",
                "“far” is not a number",
            ),
            (
                "sphere; from afar; textbook; 1000; scene",
                "no column “scene”",
            ),
            (
                "sphere; from afar; textbook; 1000; work",
                "the cell is empty",
            ),
            (
                "sphere; from afar; textbook; 1000",
                "not STUDY; SCENE; METHOD;",
            ),
            (
                "sphere; from afar; textbook; 1000; wrong; ns",
                "not STUDY; SCENE;",
            ),
        ] {
            let page = format!("It is {{{{#measured {reference}}}}} % wrong.\n");
            let problem = prepare(&page).unwrap_err().to_string();
            assert!(problem.contains(complaint), "{problem}");
        }
        let problem = prepare("It is {{#measured sphere; from afar\n").unwrap_err();
        assert!(problem.to_string().contains("has no }}"), "{problem}");
    }

    #[test]
    fn gets_a_table_of_every_chapter() {
        let page = prepare("{{#stages}}\n").unwrap();
        for stage in stages::STAGES {
            assert!(page.contains(&format!("({}.md)", stage.name)), "{page}");
        }
    }
}
