//! Formulas: LaTeX to MathML that Markdown leaves unchanged.

use mdbook_preprocessor::errors::{Error, Result};
use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};
use std::convert::Infallible;

/// Returns the MathML of a formula in a line of text.
pub fn inline(latex: &str) -> Result<String> {
    mathml(latex, DisplayMode::Inline)
}

/// Returns the MathML of a formula in a line of its own, which scrolls where it is wider
/// than the page.
pub fn display(latex: &str) -> Result<String> {
    let formula = mathml(latex, DisplayMode::Block)?;
    Ok(format!("<span class=\"formula\">{formula}</span>"))
}

fn mathml(latex: &str, display_mode: DisplayMode) -> Result<String> {
    let storage = Storage::new();
    let events = Parser::new(latex, &storage)
        .collect::<std::result::Result<Vec<_>, _>>()
        .map_err(|problem| Error::msg(format!("the formula ${latex}$: {problem}")))?;
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    let mut mathml = String::new();
    push_mathml(
        &mut mathml,
        events.into_iter().map(Ok::<_, Infallible>),
        config,
    )?;
    // Repairs what pulldown-latex 0.8 writes wrongly: the relation <, and the attributes of \bigl and
    // similar commands.
    let mathml = mathml
        .replace("><<", ">&lt;<")
        .replace("\"minsize", "\" minsize");
    // It puts the space before a function into the power that follows it.
    if mathml.contains("<msup><mspace") || mathml.contains("<msub><mspace") {
        return Err(Error::msg(format!(
            "the formula ${latex}$: put braces around a function with a power, as in {{\\cos^2\\theta}}"
        )));
    }
    Ok(safe_in_markdown(&mathml))
}

/// Writes the punctuation between tags as entities: Markdown and the table's `|` take no notice of those.
fn safe_in_markdown(mathml: &str) -> String {
    let mut safe = String::new();
    let mut in_tag = false;
    for character in mathml.chars() {
        match character {
            '<' => in_tag = true,
            '>' => in_tag = false,
            '\n' => continue,
            // `&` and `;` are those of entities.
            '&' | ';' => (),
            _ if !in_tag && character.is_ascii_punctuation() => {
                safe += &format!("&#{};", u32::from(character));
                continue;
            }
            _ => (),
        }
        safe.push(character);
    }
    safe
}
