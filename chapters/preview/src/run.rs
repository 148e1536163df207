//! The main function of a chapter's program.

use crate::command_line::{RenderArgs, command};
use crate::error::{Error, exit_code};
use crate::file::{check_destination, save_png};
use crate::terminal::{print_line, printed};
use crate::window;
use canvas::{Stage, View};
use clap::error::ErrorKind;
use clap::{ArgMatches, Command};
use glam::UVec2;
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Runs a chapter's program: opens its window, or saves or lists its pictures, as the
/// arguments request.
///
/// Returns the program's [`exit_code`].
pub fn run(stage: &'static Stage) -> ExitCode {
    exit_code(|| run_arguments(stage))
}

fn run_arguments(stage: &'static Stage) -> Result<(), Error> {
    let Some(matches) = matches(stage, command(stage))? else {
        return Ok(());
    };
    let args = RenderArgs::from_matches(stage, &matches)?;
    show_or_save(
        stage,
        &args,
        || window::open(stage, &args),
        |path| save_view(args.view, args.setting, args.size, path),
    )
}

/// Parses the program's arguments by a `command` that has at least those of [`command`].
///
/// `None` if they request help, the list of the views, or all pictures; these are then
/// printed or saved.
///
/// # Errors
/// If the arguments are invalid, a picture cannot be saved, or a line cannot be printed.
pub fn matches(stage: &Stage, command: Command) -> Result<Option<ArgMatches>, Error> {
    let matches = match command.try_get_matches() {
        Err(error) if error.kind() == ErrorKind::DisplayHelp => {
            printed(error.print())?;
            return Ok(None);
        }
        result => result?,
    };
    if matches.get_flag("list") {
        print_views(stage)?;
    } else if let Some(folder) = matches.get_one::<PathBuf>("all") {
        let size = matches.get_one("size").copied().expect("a default");
        save_all(stage, size, folder)?;
    } else {
        return Ok(Some(matches));
    }
    Ok(None)
}

/// Saves the picture if the arguments request a PNG, and opens a window otherwise.
///
/// If no window can be opened, a line says so, and the picture is saved in the current
/// folder: a machine without a display still gets it.
///
/// # Errors
/// Those of `save`, and those of `open` but for [`Error::NoWindow`].
pub fn show_or_save(
    stage: &Stage,
    args: &RenderArgs,
    open: impl FnOnce() -> Result<(), Error>,
    save: impl FnOnce(&Path) -> Result<(), Error>,
) -> Result<(), Error> {
    if let Some(path) = &args.png {
        return save(path);
    }
    let result = open();
    let Err(Error::NoWindow(reason)) = result else {
        return result;
    };
    print_line(format!("no window ({reason}): saving the picture instead"))?;
    save(&picture_path(stage, args.view, args.setting))
}

fn picture_path(stage: &Stage, view: &View, setting: f32) -> PathBuf {
    format!("{}.png", stage.picture_name(view, setting)).into()
}

fn print_views(stage: &Stage) -> Result<(), Error> {
    print_line(format!("{}: {}", stage.name, stage.title))?;
    for view in stage.views {
        print_line(format!("\n{}\n    {}", view.name, view.caption))?;
        if let Some(knob) = &view.knob {
            let (name, range, default) = (knob.name, knob.range(), knob.default);
            print_line(format!("    knob: {name}, {range} (default {default})"))?;
        }
    }
    Ok(())
}

fn save_view(view: &View, setting: f32, size: UVec2, path: &Path) -> Result<(), Error> {
    check_destination(path)?;
    let picture = (view.picture)(setting);
    save_png(path, size, &[], |write| picture.render_rows(size, write))?;
    print_line(path.display())
}

fn save_all(stage: &Stage, size: UVec2, folder: &Path) -> Result<(), Error> {
    let path_of =
        |view: &View| folder.join(picture_path(stage, view, view.default_setting()));
    // Before the first is rendered, see that none will be refused.
    for view in stage.views {
        check_destination(&path_of(view))?;
    }
    // indicatif draws the bar on a terminal only.
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}")
        .expect("a valid template");
    let progress = ProgressBar::new(stage.views.len() as u64).with_style(style);
    for view in stage.views {
        progress.set_message(view.name);
        progress
            .suspend(|| save_view(view, view.default_setting(), size, &path_of(view)))?;
        progress.inc(1);
    }
    progress.finish_and_clear();
    Ok(())
}
