//! Figures, captions and commands from the chapters' stages.

use canvas::{Stage, View};
use mdbook_preprocessor::errors::{Error, Result};
use preprocessor::{escape, study};
use speed_and_accuracy::table::{for_readers, with_separators};
use stages::STAGES;
use std::fs;

/// Returns the HTML of the pictures of a stage's `views`, each `VIEW` or `VIEW=KNOB`, side
/// by side.
pub fn figures(stage: &str, views: &[&str]) -> Result<String> {
    let stage = known(stage)?;
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

/// Returns the stage called `name`.
fn known(name: &str) -> Result<&'static Stage> {
    let stage = STAGES.into_iter().find(|stage| stage.name == name);
    stage.ok_or_else(|| Error::msg(format!("no stage is called “{name}”")))
}

/// One picture in the book.
struct Shown {
    view: &'static View,
    setting: f32,
    is_default: bool,
    size: [u32; 2],
    file: String,
}

impl Shown {
    /// Finds the picture of `VIEW` or `VIEW=KNOB`.
    fn new(stage: &'static Stage, wanted: &str) -> Result<Self> {
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
        let is_default = setting == view.default_setting();
        let is_hero = is_default && view.name == stage.hero;
        Ok(Self {
            view,
            setting,
            is_default,
            size: if is_hero { [800, 600] } else { [320, 240] },
            file: format!("pictures/{}.snap.png", stage.picture_name(view, setting)),
        })
    }

    /// Returns what to see in it, and at which setting of the knob if there is one.
    fn caption(&self) -> String {
        let caption = escape(self.view.caption);
        match self.knob() {
            Some(knob) => format!("{caption} Here, {knob}."),
            None => caption,
        }
    }

    /// Returns the knob's name and setting: `n = 4`, `depth = 20 bounces`. `None` if there is no
    /// knob.
    fn knob(&self) -> Option<String> {
        let knob = self.view.knob.as_ref()?;
        let value = if self.setting.fract() == 0.0 {
            with_separators(self.setting as u64)
        } else {
            for_readers(self.setting.into())
        };
        let words = format!("{} = {value} {}", knob.name, knob.unit);
        Some(words.trim_end().to_string())
    }
}

fn figure(stage: &'static Stage, wanted: &str) -> Result<String> {
    let shown = Shown::new(stage, wanted)?;
    let Shown { view, setting, .. } = shown;
    let mut options = String::new();
    if view.name != stage.hero {
        options += &format!(" --view {}", view.name);
    }
    if !shown.is_default {
        options += &format!(" --knob {setting}");
    }
    let [width, height] = shown.size;
    // Without a size, the command draws 800 x 600.
    if width != 800 {
        options += &format!(" --size {width}x{height}");
    }
    if !options.is_empty() {
        options.insert_str(0, " --");
    }
    let command = command(&format!("cargo run --bin {}{options}", stage.name));
    let (caption, picture) = (shown.caption(), shown.file);
    Ok(format!(
        "<figure style=\"width: {width}px\">\n\
         <a href=\"{picture}\"><img src=\"{picture}\" alt=\"{caption}\" width=\"{width}\" height=\"{height}\" loading=\"lazy\"></a>\n\
         <figcaption>{caption}<br>{command}</figcaption>\n\
         </figure>\n"
    ))
}

/// How many times larger a crop is than its picture.
const MAGNIFICATION: u32 = 8;

/// Returns the HTML of the same rectangle of several views' pictures, magnified, with the edges
/// of their pixels. The rectangle is its left and top edge, its width and its height, in pixels.
/// A view with a setting has that as its caption, and another one that of its figure.
pub fn crops(stage: &str, rectangle: [&str; 4], views: &[&str]) -> Result<String> {
    let stage = known(stage)?;
    let numbers: Vec<u32> = rectangle.iter().filter_map(|it| it.parse().ok()).collect();
    let [left, top, width, height] = numbers[..] else {
        let rectangle = rectangle.join(" ");
        return Err(Error::msg(format!(
            "“{rectangle}” is not LEFT TOP WIDTH HEIGHT"
        )));
    };
    let crop = |view: &&str| {
        let shown = Shown::new(stage, view)?;
        let (picture, [full_width, full_height]) = (&shown.file, shown.size);
        if width == 0
            || height == 0
            || left.saturating_add(width) > full_width
            || top.saturating_add(height) > full_height
        {
            let size = format!("{full_width} × {full_height}");
            return Err(Error::msg(format!(
                "the crop of “{view}” is not within its {size} pixels"
            )));
        }
        let alt = format!(
            "{} Magnified {MAGNIFICATION} times: {width} × {height} pixels, the first of them at ({left}, {top}).",
            shown.caption()
        );
        let caption = match shown.knob() {
            Some(knob) if view.contains('=') => knob,
            _ => shown.caption(),
        };
        let side = [width, height].map(|pixels| MAGNIFICATION * pixels);
        Ok(format!(
            "<figure style=\"width: {}px\">\n\
             <a href=\"{picture}\"><svg class=\"crop\" width=\"{}\" height=\"{}\" viewBox=\"{left} {top} {width} {height}\" role=\"img\" aria-label=\"{alt}\"><image href=\"{picture}\" width=\"{full_width}\" height=\"{full_height}\"/></svg></a>\n\
             <figcaption>{caption}</figcaption>\n\
             </figure>\n",
            side[0], side[0], side[1],
        ))
    };
    if views.is_empty() {
        return Err(Error::msg(format!(
            "a crop of {} names no view",
            stage.name
        )));
    }
    let crops: String = views.iter().map(crop).collect::<Result<_>>()?;
    Ok(format!("<div class=\"figures\">\n{crops}</div>\n"))
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
