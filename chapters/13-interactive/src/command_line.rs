//! The walk's command line: the arguments of every chapter, and some of its own.

use crate::{shot, window};
use canvas::Pixel;
use clap::Arg;
use glam::UVec2;
use interactive::explain::explanation;
use interactive::views::WalkView;
use interactive::{CameraPose, RenderRequest, STAGE};
use preview::{Error, RenderArgs, check_destination, print_line, show_or_save};
use std::path::Path;
use std::time::Duration;

const KEYS: &str = "In the window: W A S D move, R F rise and sink (or: Page Up and Down, Left and Right, Insert and \
                    Delete), Home leads back, the mouse turns (drag), its wheel and + - change the focal length, \
                    1-9 (or F1-F9) and Tab change the view, Up and Down turn the knob, a click explains a pixel, \
                    Space freezes, P saves a PNG (or F12), Esc closes.";

/// Parses the program's arguments, and runs the walk or renders what they request.
///
/// # Errors
/// If the arguments are invalid, or the request cannot be carried out.
pub fn run() -> Result<(), Error> {
    let option = |name, value, help| {
        let arg = Arg::new(name).long(name).value_name(value).help(help);
        arg.allow_hyphen_values(true)
            .conflicts_with_all(["list", "all"])
    };
    let command = preview::command(&STAGE).after_help(KEYS).args([
        option(
            "camera",
            "NUMBERS",
            "Start there: eye, direction, focal length",
        )
        .value_parser(str::parse::<CameraPose>),
        option(
            "trace",
            "X,Y",
            "Explain this pixel's ray, counted from the upper left, and open no window",
        )
        .value_parser(parse_position)
        .conflicts_with("png"),
        option(
            "target",
            "MS",
            "While moving, halve the resolution until a frame takes no longer",
        )
        .value_parser(parse_target)
        .default_value("33")
        .conflicts_with_all(["png", "trace"]),
    ]);
    let Some(matches) = preview::matches(&STAGE, command)? else {
        return Ok(());
    };
    let args = RenderArgs::from_matches(&STAGE, &matches)?;
    let request = RenderRequest {
        pose: *matches.get_one("camera").unwrap_or(&CameraPose::START),
        view: WalkView::named(args.view.name).expect("every view is walked"),
        setting: args.setting,
        size: args.size,
        is_moving: false,
    };
    if let Some(&position) = matches.get_one("trace") {
        return trace(&request, position);
    }
    let target = *matches.get_one("target").expect("a default");
    let open = || window::open(request, target);
    show_or_save(&STAGE, &args, open, |path| save(&request, path))
}

fn trace(request: &RenderRequest, UVec2 { x, y }: UVec2) -> Result<(), Error> {
    let size = request.size;
    if x >= size.x || y >= size.y {
        let [width, height] = size.to_array();
        return Err(Error::usage(format!(
            "--trace {x},{y} is no pixel of {width}x{height}; write X,Y, from 0,0 to {},{}",
            width - 1,
            height - 1
        )));
    }
    let scene = (request.view.scene)(request.setting);
    let pixel = Pixel { x, y, size };
    print_line(explanation(&scene, &request.pose.camera(), pixel))
}

fn save(request: &RenderRequest, path: &Path) -> Result<(), Error> {
    check_destination(path)?;
    let picture = (request.view.picture)(request.pose.camera(), request.setting);
    let size = request.size;
    shot::save(request, path, |write| picture.render_rows(size, write))?;
    print_line(path.display())
}

fn parse_position(text: &str) -> Result<UVec2, Error> {
    let position = text
        .split_once(',')
        .and_then(|(x, y)| Some(UVec2::new(x.parse().ok()?, y.parse().ok()?)));
    position.ok_or_else(|| Error::usage("write X,Y, two whole numbers like 0,0"))
}

fn parse_target(text: &str) -> Result<Duration, Error> {
    match text.parse() {
        Ok(ms @ 1..=10_000) => Ok(Duration::from_millis(ms)),
        _ => Err(Error::usage("write whole milliseconds, from 1 to 10000")),
    }
}
