//! The command line that every chapter shares.

use crate::file::check_destination;
use crate::{Canvas, Stage, View};
use clap::error::ErrorKind;
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use glam::UVec2;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// The longest side of a picture, in pixels.
const MAX_SIDE: u32 = 16_384;

/// Why a chapter ends without what was asked for, in one line that says what would be right.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// What was asked for makes no sense: exit code 2.
    Usage(String),
    /// It could not be done: exit code 1.
    Failed(String),
}

/// Something that a chapter's command line can do in place of showing a view.
pub struct Task {
    /// Its option, without the hyphens.
    pub flag: &'static str,
    /// What the option's value is, in capitals.
    pub value: &'static str,
    /// What it does.
    pub help: &'static str,
    /// Does it, given the option's value.
    pub run: fn(&str) -> Result<(), Failure>,
}

/// Runs a chapter: its window, or what the command line asks for.
///
/// Returns 0 for success, 2 for a command line that makes no sense, 1 for what could not be done.
#[must_use]
pub fn run(stage: &'static Stage) -> ExitCode {
    run_with(stage, &[])
}

/// Runs a chapter that can also do `tasks`.
#[must_use]
pub fn run_with(stage: &'static Stage, tasks: &'static [Task]) -> ExitCode {
    end_with(obey(stage, tasks))
}

/// Ends a program: says what went wrong, if anything did, and gives the exit code for it.
#[must_use]
pub fn end_with(result: Result<(), Failure>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Usage(line)) => {
            complain(&line);
            ExitCode::from(2)
        }
        Err(Failure::Failed(line)) => {
            complain(&line);
            ExitCode::FAILURE
        }
    }
}

/// One line on the terminal. A terminal that has gone away is no reason to panic, as `println!` would.
pub fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// One line on stderr, also where it quotes an argument that has line breaks.
pub fn complain(line: &str) {
    let line = line.replace(char::is_control, " ");
    let _ = writeln!(std::io::stderr(), "error: {line}");
}

fn obey(stage: &'static Stage, tasks: &'static [Task]) -> Result<(), Failure> {
    let others = ["view", "knob", "size", "png", "all", "list"];
    let tasks_as_arguments = tasks.iter().map(|task| {
        Arg::new(task.flag)
            .long(task.flag)
            .value_name(task.value)
            .help(task.help)
            .allow_hyphen_values(true)
            .conflicts_with_all(others)
    });
    let Some(matches) = matches(stage, command(stage).args(tasks_as_arguments))? else {
        return Ok(());
    };
    for task in tasks {
        if let Some(value) = matches.get_one::<String>(task.flag) {
            return (task.run)(value);
        }
    }
    let asked = Asked::of(stage, &matches)?;
    if let Some(path) = &asked.png {
        return save_one(asked.view, asked.setting, asked.size, path);
    }

    #[cfg(feature = "window")]
    let why_not = match crate::window::open(stage, asked.index, asked.setting, asked.size)
    {
        Ok(()) => return Ok(()),
        Err(why_not) => why_not,
    };
    #[cfg(not(feature = "window"))]
    let why_not = "built without the feature `window`".to_string();

    let path = asked.path_without_window(stage, &why_not);
    save_one(asked.view, asked.setting, asked.size, &path)
}

/// What a command line asks for, by the options that every chapter has.
pub struct Asked {
    /// The view's index in its stage.
    pub index: usize,
    /// The view.
    pub view: &'static View,
    /// The setting of its knob.
    pub setting: f32,
    /// The size of its picture, in pixels.
    pub size: UVec2,
    /// Where to save the picture, in place of opening a window.
    pub png: Option<PathBuf>,
}

impl Asked {
    /// Reads the options that [`command`] has defined.
    ///
    /// # Errors
    /// One line that says which of them makes no sense, and what would.
    pub fn of(stage: &'static Stage, matches: &ArgMatches) -> Result<Self, Failure> {
        let size = size_of(matches)?;
        let index = match matches.get_one::<String>("view") {
            Some(name) => find_view(stage, name)?,
            None => 0,
        };
        let view = &stage.views[index];
        Ok(Self {
            index,
            view,
            setting: setting_of(stage, view, matches)?,
            size,
            png: matches
                .get_one::<PathBuf>("png")
                .map(|path| png_path(path))
                .transpose()?,
        })
    }

    /// Says that there is no window, and where the picture goes instead: a machine without a display
    /// still gets it.
    #[must_use]
    pub fn path_without_window(&self, stage: &Stage, why_not: &str) -> PathBuf {
        say(&format!(
            "no window ({why_not}): saving the picture instead"
        ));
        format!("{}.png", stage.picture_name(self.view, self.setting)).into()
    }
}

/// The command line that every chapter has.
#[must_use]
pub fn command(stage: &Stage) -> Command {
    Command::new(stage.name)
        .about(stage.title)
        .after_help(
            "In the window: Tab or 1-9 change the view, Up and Down turn the knob, P saves a PNG, Esc closes.",
        )
        .args([
            Arg::new("view")
                .long("view")
                .value_name("NAME")
                .help("Show this view (--list names them)"),
            Arg::new("knob")
                .long("knob")
                .value_name("X")
                .allow_hyphen_values(true)
                .help("Turn the view's knob to X"),
            Arg::new("size")
                .long("size")
                .value_name("WxH")
                .allow_hyphen_values(true)
                .help("Paint W x H pixels [default: 800x600]"),
            Arg::new("png")
                .long("png")
                .value_name("PATH")
                .value_parser(value_parser!(PathBuf))
                .help("Save a PNG and open no window"),
            Arg::new("all")
                .long("all")
                .value_name("DIR")
                .value_parser(value_parser!(PathBuf))
                .conflicts_with_all(["view", "knob", "png"])
                .help("Save every view as a PNG in the folder DIR"),
            Arg::new("list")
                .long("list")
                .action(ArgAction::SetTrue)
                .conflicts_with_all(["view", "knob", "size", "png", "all"])
                .help("List the views and their knobs"),
        ])
}

/// The program's arguments, by a [`command`] that may have been given more of them. None, if it asked
/// for help, for the list of views, or for all of them: that is then done.
///
/// # Errors
/// One line that says what makes no sense, or what could not be done.
pub fn matches(stage: &Stage, command: Command) -> Result<Option<ArgMatches>, Failure> {
    let matches = match command.try_get_matches() {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            let _ = error.print();
            return Ok(None);
        }
        Err(error) => return Err(Failure::Usage(one_line(&error))),
    };
    if matches.get_flag("list") {
        list(stage);
        return Ok(None);
    }
    if let Some(folder) = matches.get_one::<PathBuf>("all") {
        save_all(stage, size_of(&matches)?, folder)?;
        return Ok(None);
    }
    Ok(Some(matches))
}

/// clap explains itself in paragraphs; the first says what is wrong.
fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first: Vec<_> = text
        .lines()
        .take_while(|line| !line.is_empty())
        .map(str::trim)
        .collect();
    let first = first.join(" ");
    format!(
        "{}; --help lists the options",
        first.strip_prefix("error: ").unwrap_or(&first)
    )
}

fn list(stage: &Stage) {
    say(&format!("{}: {}", stage.name, stage.title));
    for view in stage.views {
        say(&format!("\n{}\n    {}", view.name, view.caption));
        if let Some(knob) = &view.knob {
            say(&format!(
                "    knob: {}, {} (default {})",
                knob.name,
                knob.range(),
                knob.default
            ));
        }
    }
}

fn find_view(stage: &Stage, name: &str) -> Result<usize, Failure> {
    stage.find(name).ok_or_else(|| {
        let names: Vec<_> = stage.views.iter().map(|view| view.name).collect();
        Failure::Usage(format!(
            "there is no view '{name}' in {}; its views: {}",
            stage.name,
            names.join(", ")
        ))
    })
}

fn setting_of(stage: &Stage, view: &View, matches: &ArgMatches) -> Result<f32, Failure> {
    let Some(text) = matches.get_one::<String>("knob") else {
        return Ok(view.default_setting());
    };
    let Some(knob) = &view.knob else {
        let with_knob: Vec<_> = stage
            .views
            .iter()
            .filter(|view| view.knob.is_some())
            .map(|view| view.name)
            .collect();
        let advice = if with_knob.is_empty() {
            "no view of this chapter has one".to_string()
        } else {
            format!("views with one: {}", with_knob.join(", "))
        };
        return Err(Failure::Usage(format!(
            "the view '{}' has no knob; {advice}",
            view.name
        )));
    };
    match text.parse() {
        Ok(setting) if knob.accepts(setting) => Ok(setting),
        _ => Err(Failure::Usage(format!(
            "--knob '{text}' is not a setting of {}; it goes from {}",
            knob.name,
            knob.range()
        ))),
    }
}

fn png_path(path: &Path) -> Result<PathBuf, Failure> {
    let is_png = path
        .extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("png"));
    if !is_png {
        return Err(Failure::Usage(format!(
            "--png '{}' does not end in .png, and a PNG is what it would be",
            path.display()
        )));
    }
    Ok(path.to_path_buf())
}

fn size_of(matches: &ArgMatches) -> Result<UVec2, Failure> {
    let Some(text) = matches.get_one::<String>("size") else {
        return Ok(UVec2::new(800, 600));
    };
    let side = |text: &str| {
        text.parse()
            .ok()
            .filter(|side| (1..=MAX_SIDE).contains(side))
    };
    text.split_once('x')
        .and_then(|(width, height)| Some(UVec2::new(side(width)?, side(height)?)))
        .ok_or_else(|| {
            Failure::Usage(format!(
                "--size '{text}' is not a size; write WxH, like 800x600, each from 1 to {MAX_SIDE}"
            ))
        })
}

fn save_one(view: &View, setting: f32, size: UVec2, path: &Path) -> Result<(), Failure> {
    check_destination(path).map_err(Failure::Failed)?;
    Canvas::paint(&(view.picture)(setting), size)
        .save(path)
        .map_err(Failure::Failed)?;
    say(&path.display().to_string());
    Ok(())
}

fn save_all(stage: &Stage, size: UVec2, folder: &Path) -> Result<(), Failure> {
    let path_of = |view| {
        let name = stage.picture_name(view, view.default_setting());
        folder.join(format!("{name}.png"))
    };
    // Before the first is painted, see that none will be refused.
    for view in stage.views {
        check_destination(&path_of(view)).map_err(Failure::Failed)?;
    }
    // indicatif draws the bar on a terminal only.
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")
        .expect("a valid template");
    let progress = ProgressBar::new(stage.views.len() as u64).with_style(style);
    for view in stage.views {
        progress.set_message(view.name);
        progress
            .suspend(|| save_one(view, view.default_setting(), size, &path_of(view)))?;
        progress.inc(1);
    }
    progress.finish_and_clear();
    Ok(())
}
