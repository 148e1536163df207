//! Figures, captions and commands from the chapters' stages.

use canvas::{Stage, View};
use mdbook_preprocessor::errors::{Error, Result};
use preprocessor::study;
use stages::STAGES;
use std::fs;

/// Returns the HTML of the pictures of a stage's `views`, each `VIEW` or `VIEW=KNOB`, side
/// by side.
pub fn figures(stage: &str, views: &[&str]) -> Result<String> {
    let stage = STAGES
        .into_iter()
        .find(|known| known.name == stage)
        .ok_or_else(|| Error::msg(format!("no stage is called “{stage}”")))?;
    if views.is_empty() {
        return Err(Error::msg(format!(
            "a figure of {} names no view",
            stage.name
        )));
    }
    let figures: String = views
        .iter()
        .map(|view| figure(stage, view))
        .collect::<Result<_>>()?;
    Ok(format!("<div class=\"figures\">\n{figures}</div>\n"))
}

fn figure(stage: &Stage, wanted: &str) -> Result<String> {
    let (name, setting) = match wanted.split_once('=') {
        Some((name, setting)) => (name, Some(setting)),
        None => (wanted, None),
    };
    let view = stage.view(name).ok_or_else(|| {
        let known: Vec<_> = stage.views.iter().map(|view| view.name).collect();
        Error::msg(format!(
            "{} has no view “{name}”, but {}",
            stage.name,
            known.join(", ")
        ))
    })?;
    let setting = match setting {
        Some(setting) => with_picture(view, setting)?,
        None => view.default_setting(),
    };

    let is_hero = view.name == stage.hero;
    let by_default = setting == view.default_setting();
    let (width, height) = if is_hero && by_default {
        (800, 600)
    } else {
        (320, 240)
    };
    let mut options = String::new();
    if !is_hero {
        options += &format!(" --view {name}");
    }
    let mut caption = escape(view.caption);
    if let (false, Some(knob)) = (by_default, &view.knob) {
        options += &format!(" --knob {setting}");
        let value = format!("{setting} {}", knob.unit);
        caption += &format!(" Here: {} {}.", knob.name, value.trim_end());
    }
    if !options.is_empty() {
        options.insert_str(0, " --");
    }
    let command = command(&format!("cargo run --bin {}{options}", stage.name));
    let picture = format!("pictures/{}.snap.png", stage.picture_name(view, setting));
    Ok(format!(
        "<figure style=\"width: {width}px\">\n\
         <a href=\"{picture}\"><img src=\"{picture}\" alt=\"{caption}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\"></a>\n\
         <figcaption>{caption}<br>{command}</figcaption>\n\
         </figure>\n"
    ))
}

/// Returns the HTML of a study's charts, and of the source of their numbers.
pub fn chart(name: &str) -> Result<String> {
    let (study, table) = study(name)?;
    let path = study.path("svg");
    let svg = fs::read_to_string(&path)
        .map_err(|problem| Error::msg(format!("{name}.svg: {problem}")))?;
    // A blank line would end Markdown's block of HTML.
    let lines: Vec<_> = svg.lines().filter(|line| !line.trim().is_empty()).collect();
    let command = command(&format!("cargo bench --bench studies -- {name}"));
    Ok(format!(
        "<div class=\"figures\">\n<figure>\n{}\n\
         <figcaption>{}. Measured on {}: <a href=\"studies/{name}.csv\">the table</a>.<br>{command}</figcaption>\n\
         </figure>\n</div>\n",
        lines.join("\n"),
        escape(study.title),
        escape(&table.machine),
    ))
}

/// Returns the HTML of a command whose line may break between two words, and nowhere else.
pub fn command(words: &str) -> String {
    let words = words.split(' ').map(|word| format!("<span>{word}</span>"));
    format!("<code>{}</code>", words.collect::<Vec<_>>().join(" "))
}

/// Returns a setting of the view's knob if the book has its picture.
fn with_picture(view: &View, setting: &str) -> Result<f32> {
    let knob = view
        .knob
        .as_ref()
        .ok_or_else(|| Error::msg(format!("the view “{}” has no knob", view.name)))?;
    let setting: f32 = setting
        .parse()
        .map_err(|_| Error::msg(format!("“{setting}” is not a number")))?;
    if setting != knob.default && !knob.snapshot_settings.contains(&setting) {
        return Err(Error::msg(format!(
            "{setting} is not among the snapshot_settings of the knob of “{}”: there is no picture of it",
            view.name
        )));
    }
    Ok(setting)
}

/// Returns a table of all chapters: number, title and command.
pub fn chapters() -> String {
    let rows = STAGES.map(|stage| {
        let number = stage.name.split('-').next().unwrap_or_default();
        format!(
            "| {number} | [{}]({name}.md) | `cargo run --bin {name}` |\n",
            stage.title,
            name = stage.name
        )
    });
    format!("| | Chapter | Run it |\n|---|---|---|\n{}\n", rows.concat())
}

/// Returns plain text as HTML, with the apostrophes that mdBook gives to all other text.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
        .replace('\'', "’")
}
