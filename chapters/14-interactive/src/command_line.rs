//! What chapter 14's command line has beside the others'.

use crate::explain::explain;
use crate::shot::Shot;
use crate::views::{REACH, scene, whole};
use crate::{STAGE, Walker, window};
use canvas::{Asked, Canvas, Failure, Pixel, check_destination, say};
use clap::Arg;
use std::path::Path;
use std::time::Duration;

/// Does what the program's arguments ask for.
///
/// # Errors
/// One line that says what makes no sense, or what could not be done.
pub fn obey() -> Result<(), Failure> {
    let command = canvas::command(&STAGE)
        .after_help(
            "In the window: W A S D move, R F rise and sink, Home leads back, the mouse turns (drag), its wheel and + - \
             change the focal length, 1-9 and Tab change the view, Up and Down turn the knob, a click explains a pixel, Space freezes, \
             P saves a PNG, Esc closes.",
        )
        .args([
            Arg::new("camera")
                .long("camera")
                .value_name("NUMBERS")
                .allow_hyphen_values(true)
                .conflicts_with_all(["list", "all"])
                .help("Start there: eye, direction and focal length, seven numbers with commas between them"),
            Arg::new("trace")
                .long("trace")
                .value_name("X,Y")
                .allow_hyphen_values(true)
                .conflicts_with_all(["list", "all", "png"])
                .help("Explain this pixel's ray and open no window; X from the left, Y from the top, from 0"),
            Arg::new("target")
                .long("target")
                .value_name("MS")
                .allow_hyphen_values(true)
                .conflicts_with_all(["list", "all", "png", "trace"])
                .help("While moving, halve the resolution until a frame takes no longer [default: 33]"),
        ]);
    let Some(matches) = canvas::matches(&STAGE, command)? else {
        return Ok(());
    };
    let asked = Asked::of(&STAGE, &matches)?;
    let text = |name| matches.get_one::<String>(name).map(String::as_str);
    let walker = match text("camera") {
        Some(text) => text
            .parse()
            .map_err(|line| Failure::Usage(format!("--camera {line}")))?,
        None => Walker::START,
    };
    if let Some(text) = text("trace") {
        let pixel = parse_pixel(text, &asked)?;
        say(&explanation(walker, asked.index, asked.setting, pixel));
        return Ok(());
    }
    let target = parse_target(text("target").unwrap_or("33"))?;
    if let Some(path) = &asked.png {
        return save(walker, &asked, path);
    }
    match window::open(walker, &asked, target) {
        Ok(()) => Ok(()),
        Err(why_not) => {
            save(walker, &asked, &asked.path_without_window(&STAGE, &why_not))
        }
    }
}

/// What a pixel's ray meets, as text: the ray through its centre.
pub fn explanation(walker: Walker, view: usize, setting: f32, pixel: Pixel) -> String {
    let scene = scene(view, setting);
    let explained = explain(&scene, &walker.camera(), pixel.centre(), REACH);
    let Pixel { x, y, size } = pixel;
    let text = format!(
        "pixel {x},{y} of {}x{}, the ray through its centre\n{explained}",
        size.x, size.y
    );
    text.trim_end().to_string()
}

fn parse_pixel(text: &str, asked: &Asked) -> Result<Pixel, Failure> {
    let size = asked.size;
    let pixel = text.split_once(',').and_then(|(x, y)| {
        let (x, y) = (x.trim().parse().ok()?, y.trim().parse().ok()?);
        (x < size.x && y < size.y).then_some(Pixel { x, y, size })
    });
    pixel.ok_or_else(|| {
        Failure::Usage(format!(
            "--trace '{text}' is no pixel of {}x{}; write X,Y, from 0,0 to {},{}",
            size.x,
            size.y,
            size.x - 1,
            size.y - 1
        ))
    })
}

fn parse_target(text: &str) -> Result<Duration, Failure> {
    match text.parse() {
        Ok(ms @ 1..=10_000) => Ok(Duration::from_millis(ms)),
        _ => Err(Failure::Usage(format!(
            "--target '{text}' is no time for a frame; write milliseconds, from 1 to 10000"
        ))),
    }
}

fn save(walker: Walker, asked: &Asked, path: &Path) -> Result<(), Failure> {
    check_destination(path).map_err(Failure::Failed)?;
    let picture = whole(asked.index, walker.camera(), asked.setting);
    let shot = Shot {
        walker,
        view: asked.index,
        setting: asked.setting,
        canvas: &Canvas::paint(&picture, asked.size),
    };
    shot.save(path).map_err(Failure::Failed)?;
    say(&path.display().to_string());
    Ok(())
}
