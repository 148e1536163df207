//! One page: finds what is to be replaced, and leaves all else, code above all, as it is.

use crate::{dependencies, figures, maths};
use mdbook_preprocessor::errors::Result;
use pulldown_cmark::{Event, Options, Parser, Tag};

/// Replaces a page's formulas, figures, table of chapters and diagram of their dependencies.
pub fn prepare(markdown: &str) -> Result<String> {
    let options =
        Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    let mut prepared = String::new();
    let mut done = 0;
    for (event, place) in Parser::new_ext(markdown, options).into_offset_iter() {
        let replacement = match event {
            Event::InlineMath(latex) => Some(maths::inline(&latex)?),
            Event::DisplayMath(latex) => Some(maths::display(&latex)?),
            Event::Start(Tag::Paragraph) => paragraph(markdown[place.clone()].trim())?,
            _ => None,
        };
        if let Some(replacement) = replacement {
            prepared += &markdown[done..place.start];
            prepared += &replacement;
            done = place.end;
        }
    }
    Ok(prepared + &markdown[done..])
}

/// What stands in for a paragraph that is nothing but `{{#figure …}}`, `{{#stages}}` or
/// `{{#dependencies}}`.
fn paragraph(text: &str) -> Result<Option<String>> {
    let Some(command) = text
        .strip_prefix("{{#")
        .and_then(|text| text.strip_suffix("}}"))
    else {
        return Ok(None);
    };
    match command.split_whitespace().collect::<Vec<_>>()[..] {
        ["figure", stage, ref views @ ..] => figures::figures(stage, views).map(Some),
        ["stages"] => Ok(Some(figures::chapters())),
        ["dependencies"] => dependencies::diagram().map(Some),
        _ => Ok(None),
    }
}

#[cfg(test)]
mod a_page {
    use super::prepare;

    #[test]
    fn keeps_what_is_neither_maths_nor_figure() {
        let page = "# A title\n\n| a | b |\n|---|---|\n| 1 | <br> |\n\nIt *costs* \\$5 & more.\n";
        assert_eq!(prepare(page).unwrap(), page);
    }

    #[test]
    fn keeps_its_code_even_if_it_looks_like_maths_or_a_figure() {
        let page = "`$x$`\n\n```rust\nlet cost = \"$x$ or $$y$$\";\n\n{{#figure 02-sphere-hit flat}}\n```\n";
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

    #[test]
    fn gets_a_figure_for_each_view() {
        let page = prepare(
            "Before.\n\n{{#figure 02-sphere-hit flat far-slide=10000}}\n\nAfter.\n",
        )
        .unwrap();
        for expected in [
            r#"<a href="pictures/02-sphere-hit--flat.snap.png">"#,
            r#"width="800" height="600""#,
            "<span>02-sphere-hit</span></code>",
            r#"<img src="pictures/02-sphere-hit--far-slide--knob-10000.snap.png""#,
            r#"width="320" height="240""#,
            "Here: distance 10000 radii.",
            "<span>--view</span> <span>far-slide</span> <span>--knob</span> <span>10000</span></code>",
        ] {
            assert!(page.contains(expected), "no {expected} in {page}");
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
            ("02-sphere flat", "no stage is called “02-sphere”"),
            ("02-sphere-hit flatt", "02-sphere-hit has no view “flatt”"),
            ("02-sphere-hit flat=1", "“flat” has no knob"),
            ("02-sphere-hit far-slide=x", "“x” is not a number"),
            ("02-sphere-hit far-slide=20", "20 is not pinned"),
            ("02-sphere-hit", "a figure of 02-sphere-hit names no view"),
        ] {
            let problem = prepare(&format!("{{{{#figure {command}}}}}\n")).unwrap_err();
            assert!(problem.to_string().contains(complaint), "{problem}");
        }
    }

    #[test]
    fn gets_a_table_of_every_chapter() {
        let page = prepare("{{#stages}}\n").unwrap();
        for stage in light_backwards::STAGES {
            assert!(page.contains(&format!("({}.md)", stage.name)), "{page}");
        }
    }
}
