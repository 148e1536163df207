//! The arguments that every chapter has.

use crate::error::Error;
use canvas::{Stage, View};
use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use glam::UVec2;
use std::path::PathBuf;

/// The longest side of a picture, in pixels.
const MAX_SIDE: u32 = 16_384;

/// Returns the command line that every chapter has. A chapter may add arguments to it.
pub fn command(stage: &'static Stage) -> Command {
    let names = PossibleValuesParser::new(stage.views.iter().map(|view| view.name));
    let view = names.map(|name| stage.view(&name).expect("one of the possible values"));
    let option =
        |name, value, help| Arg::new(name).long(name).value_name(value).help(help);
    Command::new(stage.name)
        .about(stage.title)
        .after_help(
            "In the window: Tab or 1-9 (or F1-F9) change the view, Up and Down turn the knob, P saves a PNG (or F12), Esc closes.",
        )
        .args([
            option("view", "NAME", "Show this view")
                .value_parser(view)
                .default_value(stage.hero),
            // Text, as its range depends on the view.
            option("knob", "X", "Turn the view's knob to X (--list shows its range)")
                .allow_hyphen_values(true),
            option("size", "WxH", "Render W x H pixels")
                .allow_hyphen_values(true)
                .value_parser(parse_size)
                .default_value("800x600"),
            option("png", "PATH", "Save a PNG and open no window")
                .value_parser(PathBufValueParser::new().try_map(parse_png_path)),
            option("all", "DIR", "Save every view as a PNG in the folder DIR")
                .value_parser(value_parser!(PathBuf))
                .conflicts_with_all(["view", "knob", "png"]),
            Arg::new("list")
                .long("list")
                .action(ArgAction::SetTrue)
                .conflicts_with_all(["view", "knob", "size", "png", "all"])
                .help("List the views and their knobs"),
        ])
}

fn parse_size(text: &str) -> Result<UVec2, Error> {
    let side = |text: &str| {
        let side = text.parse().ok()?;
        (1..=MAX_SIDE).contains(&side).then_some(side)
    };
    text.split_once('x')
        .and_then(|(width, height)| Some(UVec2::new(side(width)?, side(height)?)))
        .ok_or_else(|| {
            Error::usage(format!(
                "write WxH, like 800x600, each from 1 to {MAX_SIDE}"
            ))
        })
}

fn parse_png_path(path: PathBuf) -> Result<PathBuf, Error> {
    match path.extension() {
        Some(extension) if extension.eq_ignore_ascii_case("png") => Ok(path),
        _ => Err(Error::usage("write a name that ends in .png")),
    }
}

/// The picture that the arguments of [`command`] request.
pub struct RenderArgs {
    /// The view.
    pub view: &'static View,
    /// The setting of its knob.
    pub setting: f32,
    /// The size of the picture, in pixels.
    pub size: UVec2,
    /// Where to save the picture instead of opening a window.
    pub png: Option<PathBuf>,
}

impl RenderArgs {
    /// Reads the arguments.
    ///
    /// # Errors
    /// If the view has no knob, or the knob no such setting.
    ///
    /// # Panics
    /// If `matches` are not of this stage's [`command`].
    pub fn from_matches(stage: &Stage, matches: &ArgMatches) -> Result<Self, Error> {
        let view: &View = matches.get_one("view").copied().expect("a default");
        let setting = match matches.get_one::<String>("knob") {
            Some(text) => parse_setting(stage, view, text)?,
            None => view.default_setting(),
        };
        Ok(Self {
            view,
            setting,
            size: matches.get_one("size").copied().expect("a default"),
            png: matches.get_one("png").cloned(),
        })
    }
}

fn parse_setting(stage: &Stage, view: &View, text: &str) -> Result<f32, Error> {
    let Some(knob) = &view.knob else {
        let views = stage.views.iter().filter(|view| view.knob.is_some());
        let names: Vec<_> = views.map(|view| view.name).collect();
        let advice = match names[..] {
            [] => "no view of this chapter has one".to_string(),
            _ => format!("views with one: {}", names.join(", ")),
        };
        let message = format!("the view '{}' has no knob; {advice}", view.name);
        return Err(Error::usage(message));
    };
    let setting = text.parse().ok().filter(|&setting| knob.accepts(setting));
    setting.ok_or_else(|| {
        let (name, range) = (knob.name, knob.range());
        Error::usage(format!(
            "--knob '{text}' is not a setting of {name}; it goes from {range}"
        ))
    })
}
