//! The window for real: under Xvfb, an X server without a screen, with synthesised keys.
//!
//! A key is held until its effect is seen, and every wait has a deadline, so that no test depends on how
//! fast the machine is. Without Xvfb (Debian: `apt install xvfb`) the tests are skipped, but not in CI.
#![cfg(target_os = "linux")]

#[path = "window/interactive.rs"]
mod interactive;
mod programs;

use canvas::{Canvas, RgbImage, Stage};
use glam::UVec2;
use std::fmt::Debug;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use std::{env, fs};
use tempfile::TempDir;
use x11rb::connection::Connection;
use x11rb::protocol::xproto::{
    self, BUTTON_PRESS_EVENT as BUTTON_PRESS, BUTTON_RELEASE_EVENT as BUTTON_RELEASE,
    ConfigureWindowAux, ConnectionExt as _, EventMask, ImageFormat, InputFocus,
    KEY_PRESS_EVENT as KEY_PRESS, KEY_RELEASE_EVENT as KEY_RELEASE,
    MOTION_NOTIFY_EVENT as MOTION,
};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

const SPHERE_HIT: &Stage = &sphere_hit::STAGE;
const SHADING: &Stage = &shading::STAGE;

/// X's names of keys, from its keysymdef.h. A digit's or a letter's is its ASCII code.
const TAB: u32 = 0xff09;
const ESCAPE: u32 = 0xff1b;
const UP: u32 = 0xff52;
const DOWN: u32 = 0xff54;
const F1: u32 = 0xffbe;
const F12: u32 = 0xffc9;
const KEYPAD_0: u32 = 0xffb0;

/// As short as a tap or a click that a window must not miss.
const TAP: Duration = Duration::from_millis(5);

/// Calls `find` until it returns something; panics after 20 seconds.
#[track_caller]
fn wait_for<T>(what: impl Debug, mut find: impl FnMut() -> Option<T>) -> T {
    let deadline = Instant::now() + Duration::from_secs(20);
    while Instant::now() < deadline {
        if let Some(found) = find() {
            return found;
        }
        sleep(Duration::from_millis(10));
    }
    panic!("waited in vain for {what:?}");
}

/// A process that is killed when it is dropped, so that none outlives its test.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// An Xvfb with a screen of 1280x1024 pixels.
struct Screen {
    x: RustConnection,
    root: xproto::Window,
    /// `:1`, for the environment.
    name: String,
    _server: Process,
}

impl Screen {
    /// Starts Xvfb. `None`, and a line that says so, if there is none.
    fn new() -> Option<Self> {
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "1280x1024x24"])
            .args(["-nolisten", "tcp", "-terminate"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = match server {
            Ok(server) => Process(server),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                programs::skip("Xvfb", "xvfb");
                return None;
            }
            Err(error) => panic!("Xvfb does not start: {error}"),
        };
        let mut number = String::new();
        let stdout = server.0.stdout.take().expect("a pipe");
        let read = BufReader::new(stdout).read_line(&mut number);
        assert!(read.is_ok_and(|bytes| bytes > 1), "Xvfb does not start");
        let name = format!(":{}", number.trim());
        let (x, screen) = x11rb::connect(Some(&name)).expect("a connection to Xvfb");
        let root = x.setup().roots[screen].root;
        Some(Self {
            x,
            root,
            name,
            _server: server,
        })
    }

    fn atom(&self, name: &str) -> xproto::Atom {
        let cookie = self.x.intern_atom(false, name.as_bytes());
        cookie.expect("sent").reply().expect("an atom").atom
    }

    /// Returns the window's title; `None` if it has none yet, or no longer exists.
    fn title(&self, window: xproto::Window) -> Option<String> {
        let (name, utf8) = (self.atom("_NET_WM_NAME"), self.atom("UTF8_STRING"));
        let cookie = self.x.get_property(false, window, name, utf8, 0, 1024);
        String::from_utf8(cookie.ok()?.reply().ok()?.value).ok()
    }

    /// Starts Xvfb with a keyboard of another layout. `None`, and a line that says so, if
    /// there is no Xvfb or no setxkbmap.
    fn with_layout(layout: &str) -> Option<Self> {
        let screen = Self::new()?;
        let mut setxkbmap = Command::new("setxkbmap");
        setxkbmap.args(["-display", &screen.name, layout]);
        match setxkbmap.status() {
            Ok(status) => assert!(status.success(), "no layout {layout}"),
            Err(error) if error.kind() == ErrorKind::NotFound => {
                programs::skip("setxkbmap", "x11-xkb-utils");
                return None;
            }
            Err(error) => panic!("setxkbmap does not start: {error}"),
        }
        Some(screen)
    }

    /// Returns the code of the key that has a symbol where no other key must be held for it;
    /// of the keypad's digits, whatever Num Lock says. `None` if the layout has no such key.
    fn code(&self, symbol: u32) -> Option<u8> {
        let first = self.x.setup().min_keycode;
        let count = self.x.setup().max_keycode - first + 1;
        let cookie = self.x.get_keyboard_mapping(first, count).expect("sent");
        let mapping = cookie.reply().expect("the keyboard's mapping");
        let is_digit = (KEYPAD_0..KEYPAD_0 + 10).contains(&symbol);
        let column = usize::from(is_digit);
        let mut keys = mapping.keysyms.chunks(mapping.keysyms_per_keycode.into());
        let key = keys.position(|symbols| symbols.get(column) == Some(&symbol))?;
        Some(first + key as u8)
    }

    /// Presses or releases a key, as the keyboard would.
    fn key(&self, symbol: u32, event: u8) {
        let code = self.code(symbol).expect("such a key");
        self.fake(event, code, 0, 0);
    }

    /// Presses a key and releases it after a moment.
    fn tap(&self, symbol: u32) {
        let code = self.code(symbol).expect("such a key");
        self.fake(KEY_PRESS, code, 0, 0);
        sleep(TAP);
        self.fake(KEY_RELEASE, code, 0, 0);
    }

    /// Gives the keyboard to a window as soon as it is on the screen.
    fn focus(&self, window: xproto::Window) {
        wait_for("the focus", || {
            let (parent, now) = (InputFocus::PARENT, x11rb::CURRENT_TIME);
            let focus = self.x.set_input_focus(parent, window, now);
            focus.ok()?.check().ok()
        });
    }

    /// Presses or releases a mouse button; the wheel is buttons 4 and 5.
    fn button(&self, button: u8, event: u8) {
        self.fake(event, button, 0, 0);
    }

    /// Moves the mouse pointer to a pixel of the screen.
    fn point(&self, x: i16, y: i16) {
        self.fake(MOTION, 0, x, y);
    }

    fn fake(&self, event: u8, detail: u8, x: i16, y: i16) {
        self.x
            .xtest_fake_input(event, detail, x11rb::CURRENT_TIME, self.root, x, y, 0)
            .expect("sent")
            .check()
            .expect("XTEST");
    }
}

/// A chapter's program with its window, in a temporary folder.
struct Shown<'a> {
    screen: &'a Screen,
    stage: &'static Stage,
    window: xproto::Window,
    folder: TempDir,
    process: Process,
}

impl<'a> Shown<'a> {
    #[track_caller]
    fn new(screen: &'a Screen, stage: &'static Stage, arguments: &[&str]) -> Self {
        let mut program = Command::new(programs::path(stage.name));
        program.args(arguments);
        Self::of(screen, stage, program)
    }

    /// A program whose window's title begins with the name of the stage.
    #[track_caller]
    fn of(screen: &'a Screen, stage: &'static Stage, mut program: Command) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let process = program
            .current_dir(folder.path())
            .env("DISPLAY", &screen.name)
            .env_remove("WAYLAND_DISPLAY")
            // So that a long picture is long on every machine.
            .env("RAYON_NUM_THREADS", "1")
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program runs");
        let process = Process(process);
        let window = wait_for("a window", || {
            let tree = screen.x.query_tree(screen.root).ok()?.reply().ok()?;
            let mut windows = tree.children.into_iter();
            windows.find(|&window| {
                screen
                    .title(window)
                    .is_some_and(|title| title.starts_with(stage.name))
            })
        });
        // There is no window manager that would give it the keyboard.
        screen.focus(window);
        Self {
            screen,
            stage,
            window,
            folder,
            process,
        }
    }

    /// Waits for a title with all of `words`, and returns it.
    #[track_caller]
    fn title_with(&self, words: &[&str]) -> String {
        let mut title = None;
        let find = || {
            title = self.screen.title(self.window);
            let title = title.clone()?;
            words
                .iter()
                .all(|word| title.contains(word))
                .then_some(title)
        };
        wait_for(words, find)
    }

    /// Presses a key, waits until the title has all of `words`, and returns it.
    #[track_caller]
    fn press_down(&self, symbol: u32, words: &[&str]) -> String {
        self.screen.key(symbol, KEY_PRESS);
        self.title_with(words)
    }

    /// Holds a key until the title has all of `words`, and returns it.
    #[track_caller]
    fn press(&self, symbol: u32, words: &[&str]) -> String {
        let title = self.press_down(symbol, words);
        self.screen.key(symbol, KEY_RELEASE);
        title
    }

    /// Sends what the close button of a title bar sends.
    fn press_close_button(&self) {
        let protocols = self.screen.atom("WM_PROTOCOLS");
        let close = self.screen.atom("WM_DELETE_WINDOW");
        let event = xproto::ClientMessageEvent::new(
            32,
            self.window,
            protocols,
            [close, 0, 0, 0, 0],
        );
        let x = &self.screen.x;
        x.send_event(false, self.window, EventMask::NO_EVENT, event)
            .expect("sent")
            .check()
            .expect("a window that takes it");
    }

    /// Asserts that the program ends with success within 10 seconds; returns stdout and stderr.
    #[track_caller]
    fn ended(mut self) -> (String, String) {
        let child = &mut self.process.0;
        let deadline = Instant::now() + Duration::from_secs(10);
        let status = loop {
            if let Some(status) = child.try_wait().expect("a process") {
                break status;
            }
            assert!(Instant::now() < deadline, "the program does not end");
            sleep(Duration::from_millis(10));
        };
        assert_eq!(status.code(), Some(0));
        let (mut stdout, mut stderr) = (String::new(), String::new());
        let pipes = (child.stdout.as_mut(), child.stderr.as_mut());
        let (Some(out), Some(err)) = pipes else {
            panic!("no pipes")
        };
        out.read_to_string(&mut stdout).expect("UTF-8");
        err.read_to_string(&mut stderr).expect("UTF-8");
        (stdout, stderr)
    }

    #[track_caller]
    fn close_with_escape(self) -> (String, String) {
        self.screen.key(ESCAPE, KEY_PRESS);
        self.ended()
    }

    /// Closes the window by Escape or else by its close button; returns stdout and stderr.
    #[track_caller]
    fn ended_by(self, escape: bool) -> (String, String) {
        if escape {
            return self.close_with_escape();
        }
        self.press_close_button();
        self.ended()
    }

    /// Returns the window's pixels on the screen, row by row: red, green, blue.
    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        let (x, window) = (&self.screen.x, self.window);
        let size = x.get_geometry(window).ok()?.reply().ok()?;
        let (format, all) = (ImageFormat::Z_PIXMAP, u32::MAX);
        let image = x.get_image(format, window, 0, 0, size.width, size.height, all);
        let bytes = image.ok()?.reply().ok()?.data;
        let (pixels, _) = bytes.as_chunks::<4>();
        let colour = |pixel: &[u8; 4]| {
            let [_, red, green, blue] = u32::from_ne_bytes(*pixel).to_be_bytes();
            [red, green, blue]
        };
        Some(pixels.iter().map(colour).collect())
    }

    /// Waits until the window shows exactly these pixels.
    #[track_caller]
    fn assert_shows(&self, what: &str, pixels: &[[u8; 3]]) {
        wait_for(what, || (self.pixels()? == pixels).then_some(()));
    }

    fn resize(&self, width: u32, height: u32) {
        let position = ConfigureWindowAux::new().x(0).y(0);
        let cookie = (self.screen.x)
            .configure_window(self.window, &position.width(width).height(height))
            .expect("sent");
        cookie.check().expect("a window that can be resized");
    }

    /// Returns the library's own picture, which the window should show.
    fn rendered(&self, view: &str, setting: f32, size: UVec2) -> Canvas {
        let view = self.stage.view(view).expect("a view");
        Canvas::render(&(view.picture)(setting), size)
    }
}

const SMALL: UVec2 = UVec2::new(400, 300);
const SMALL_ARGUMENTS: [&str; 2] = ["--size", "400x300"];

/// The title when a picture is done: its last two parts are its cost.
const DONE: [&str; 2] = [" ms | ", " rays"];

/// Returns the picture that chapter 0 has a reader draw, small.
fn readers_picture() -> RgbImage {
    let picture = (canvas::STAGE.hero().picture)(0.0);
    canvas::render(SMALL, |pixel| picture.radiance(pixel))
}

/// Returns this test's program, which runs nothing but [`a_readers_program`].
fn readers_program() -> Command {
    let mut program = Command::new(env::current_exe().expect("a program"));
    program.args(["--ignored", "--exact", "a_readers_program"]);
    program
}

#[test]
#[ignore = "it shows a window until Escape: the two tests below run it"]
fn a_readers_program() {
    preview::save_and_show(&readers_picture(), canvas::STAGE.name).expect("a PNG");
}

#[test]
fn a_readers_window_shows_the_picture_until_escape_and_saves_it() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::of(&screen, &canvas::STAGE, readers_program());
    let picture = readers_picture();
    let pixels: Vec<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
    shown.assert_shows("the picture", &pixels);
    let saved = shown.folder.path().join("00-canvas.png");
    assert_eq!(image::open(saved).expect("a PNG").into_rgb8(), picture);
    shown.close_with_escape();
}

#[test]
fn without_a_display_a_readers_program_says_so_and_saves_the_picture() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let output = readers_program()
        .arg("--nocapture")
        .current_dir(folder.path())
        .env_remove("DISPLAY")
        .output();
    let output = output.expect("the program runs");
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = "no window: there is no display; the picture is in 00-canvas.png\n";
    assert!(said.contains(line), "{said}");
    let saved = image::open(folder.path().join("00-canvas.png"));
    assert_eq!(saved.expect("a PNG").into_rgb8(), readers_picture());
}

#[test]
fn it_shows_the_picture_and_its_title_says_what_it_cost() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SHADING, &[]);
    let title = shown.title_with(&DONE);
    let expected = shown.rendered("combined", 0.0, UVec2::new(800, 600));
    let parts: Vec<_> = title.split(" | ").collect();
    let [name, "combined", time, rays] = parts[..] else {
        panic!("{title}");
    };
    assert_eq!(name, SHADING.name);
    let time = time.strip_suffix(" ms").expect("milliseconds");
    assert!(time.parse::<u64>().is_ok(), "{title}");
    assert_eq!(rays, format!("{} rays", expected.rays));
    shown.assert_shows("the picture on the screen", &expected.levels);
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn tab_digits_and_arrows_change_view_and_knob() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
    let shows = |view: &str, setting: f32| {
        let expected = shown.rendered(view, setting, SMALL).levels;
        shown.assert_shows(&format!("{view} at {setting}"), &expected);
    };
    shown.title_with(&["| combined |"]);
    shown.press(TAB, &["| ambient |"]);
    shows("ambient", 0.0);
    shown.press('3'.into(), &["| diffuse |"]);
    shows("diffuse", 0.0);
    shown.press('4'.into(), &["| specular | shininess 50 |"]);
    shown.press(UP, &["| specular | shininess 51 |"]);
    shows("specular", 51.0);
    shown.press(DOWN, &["| specular | shininess 50 |"]);
    // The last view is followed by the first; a digit beyond the last view does nothing, nor does a
    // knob that is not there.
    shown.press(TAB, &["| too-much-light |"]);
    shown.press(TAB, &["| combined |"]);
    for key in ['6'.into(), '9'.into(), UP] {
        screen.key(key, KEY_PRESS);
        sleep(Duration::from_millis(150));
        screen.key(key, KEY_RELEASE);
    }
    shown.press('1'.into(), &["| combined |", DONE[0]]);
    shows("combined", 0.0);
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn no_tap_is_too_short() {
    let Some(screen) = Screen::new() else { return };
    let arguments = ["--view", "specular", "--size", "400x300"];
    let shown = Shown::new(&screen, SHADING, &arguments);
    shown.title_with(&["| specular | shininess 50 |"]);
    // Far apart, close together, and all at once.
    for (pause, down, up) in [(40, 30, 50), (1, 30, 50), (0, 30, 50)] {
        for (key, setting) in [(DOWN, down), (UP, up)] {
            let code = screen.code(key).expect("such a key");
            for _ in 0..20 {
                screen.fake(KEY_PRESS, code, 0, 0);
                sleep(if pause == 0 { Duration::ZERO } else { TAP });
                screen.fake(KEY_RELEASE, code, 0, 0);
                sleep(Duration::from_millis(pause));
            }
            shown.title_with(&[&format!("| specular | shininess {setting} |")]);
        }
    }
    screen.tap(ESCAPE);
    assert_eq!(shown.ended(), Default::default());
}

/// Every key that `--help` names works, or another that it names for the same.
#[test]
fn keys_work_in_every_layout() {
    for layout in ["us", "fr", "de", "cz", "ru"] {
        let Some(screen) = Screen::with_layout(layout) else {
            return;
        };
        let shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
        shown.title_with(&["| combined |"]);
        for key in [TAB, F1 + 1, KEYPAD_0 + 2, '2'.into()] {
            if screen.code(key).is_some() {
                shown.press(key, &["| ambient |", DONE[0]]);
                shown.press(F1, &["| combined |", DONE[0]]);
            }
        }
        shown.press(F1 + 3, &["| specular | shininess 50 |"]);
        screen.tap(UP);
        shown.title_with(&["| specular | shininess 51 |"]);
        screen.tap(DOWN);
        shown.title_with(&["| specular | shininess 50 |", DONE[0]]);
        for key in ['p'.into(), F12] {
            if screen.code(key).is_some() {
                shown.press(key, &["| saved "]);
                shown.press(F1, &["| combined |", DONE[0]]);
            }
        }
        shown.close_with_escape();
    }
}

#[test]
fn every_views_knob_keeps_its_own_setting() {
    let Some(screen) = Screen::new() else { return };
    #[rustfmt::skip]
    let arguments = ["--view", "far-textbook", "--knob", "4000", "--size", "400x300"];
    let shown = Shown::new(&screen, SPHERE_HIT, &arguments);
    shown.title_with(&["| far-textbook | distance 4000 radii |"]);
    shown.press(DOWN, &["| far-textbook | distance 2000 radii |"]);
    shown.press('7'.into(), &["| far-stable | distance 1000 radii |"]);
    shown.press(UP, &["| far-stable | distance 2000 radii |"]);
    shown.press('6'.into(), &["| far-textbook | distance 2000 radii |"]);
    let expected = shown.rendered("far-textbook", 2000.0, SMALL).levels;
    shown.assert_shows("the sphere from afar", &expected);
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn p_saves_what_the_window_shows() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
    shown.press('4'.into(), &["| specular | shininess 50 |", DONE[0]]);
    shown.press(UP, &["| specular | shininess 51 |"]);
    // The key may have been held for long enough to repeat.
    let title = shown.title_with(&["| specular | shininess 5", DONE[0]]);
    let setting = title.split([' ']).nth(5).expect("a setting");
    let name = format!("{}--specular--knob-{setting}.png", SHADING.name);
    let folder = fs::canonicalize(shown.folder.path()).expect("a folder");
    let path = folder.join(&name);
    let path_shown = path.display().to_string();
    shown.press('p'.into(), &["| specular |", &path_shown]);

    let saved = image::open(&path).expect("a PNG");
    assert!(programs::png_info(&path).srgb.is_some(), "no sRGB chunk");
    let expected = shown.rendered("specular", setting.parse().expect("a number"), SMALL);
    assert!(saved.as_bytes() == expected.levels.as_flattened());
    let printed = format!("{path_shown}\n");
    assert_eq!(shown.close_with_escape(), (printed, String::new()));
}

#[test]
fn p_in_the_middle_of_a_picture_saves_it_when_it_is_done() {
    let Some(screen) = Screen::new() else { return };
    let arguments = ["--size", "1600x1200"];
    let shown = Shown::new(&screen, SHADING, &arguments);
    shown.press('p'.into(), &["| saved "]);
    let name = format!("{}--combined.png", SHADING.name);
    let saved = image::open(shown.folder.path().join(name));
    let expected = shown.rendered("combined", 0.0, UVec2::new(1600, 1200));
    assert!(saved.expect("a PNG").as_bytes() == expected.levels.as_flattened());
    shown.close_with_escape();
}

#[test]
fn a_view_chosen_in_the_middle_of_a_picture_replaces_it() {
    let Some(screen) = Screen::new() else { return };
    let arguments = ["--size", "1600x1200"];
    let shown = Shown::new(&screen, SHADING, &arguments);
    shown.press(TAB, &["| ambient |"]);
    shown.press('p'.into(), &["| ambient | saved "]);
    let name = format!("{}--ambient.png", SHADING.name);
    let saved = image::open(shown.folder.path().join(name));
    let expected = shown.rendered("ambient", 0.0, UVec2::new(1600, 1200));
    assert!(saved.expect("a PNG").as_bytes() == expected.levels.as_flattened());
    shown.close_with_escape();
}

#[test]
fn a_picture_that_cannot_be_saved_leaves_the_window_open() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
    let name = format!("{}--combined.png", SHADING.name);
    fs::create_dir(shown.folder.path().join(&name)).expect("a folder");
    shown.press('p'.into(), &[&format!("{name}: it is a folder")]);
    shown.press(TAB, &["| ambient |", DONE[0]]);
    let (stdout, stderr) = shown.close_with_escape();
    assert_eq!((stdout.as_str(), stderr.lines().count()), ("", 1));
    assert!(stderr.contains("it is a folder"), "{stderr}");
}

#[test]
fn a_resized_window_keeps_the_pictures_shape() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
    shown.title_with(&DONE);
    let picture = shown.rendered("combined", 0.0, SMALL).levels;
    // Twice as large, each pixel four times, in the middle of a window that is wider or higher.
    for (width, height) in [(900, 600), (800, 700), (800, 600)] {
        shown.resize(width, height);
        let (left, top) = ((width - 800) / 2, (height - 600) / 2);
        let expected: Vec<_> = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| match (x.checked_sub(left), y.checked_sub(top)) {
                (Some(x), Some(y)) if x < 800 && y < 600 => {
                    picture[(y / 2 * 400 + x / 2) as usize]
                }
                _ => [0; 3],
            })
            .collect();
        shown.assert_shows(&format!("the picture in {width}x{height}"), &expected);
    }
    // And still when there is next to no room.
    for (width, height) in [(1, 1), (400, 1), (1, 300), (400, 300)] {
        shown.resize(width, height);
        let pixels = (width * height) as usize;
        wait_for("the new size", || {
            let shown = shown.pixels()?;
            (shown.len() == pixels && shown.iter().any(|&pixel| pixel != [0; 3]))
                .then_some(())
        });
    }
    shown.assert_shows("the picture in its own size", &picture);
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn the_close_button_ends_it() {
    let Some(screen) = Screen::new() else { return };
    let shown = Shown::new(&screen, SPHERE_HIT, &SMALL_ARGUMENTS);
    shown.title_with(&DONE);
    shown.press_close_button();
    assert_eq!(shown.ended(), Default::default());
}

#[test]
fn it_ends_at_once_in_the_middle_of_a_picture() {
    let Some(screen) = Screen::new() else { return };
    for escape in [true, false] {
        let shown = Shown::new(&screen, SHADING, &["--size", "8192x8192"]);
        wait_for("the first rows", || {
            let pixels = shown.pixels()?;
            pixels.iter().any(|&pixel| pixel != [0; 3]).then_some(())
        });
        shown.title_with(&["| rendering"]);
        assert_eq!(shown.ended_by(escape), Default::default());
        screen.key(ESCAPE, KEY_RELEASE);
    }
}

#[test]
fn without_memory_for_a_window_it_says_so() {
    let Some(screen) = Screen::new() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    // The canvas alone would take 4 GB.
    for size in ["16384x16384", "16384x8192"] {
        let output = Command::new("sh")
            .args(["-c", "ulimit -v 2000000; exec \"$@\"", "sh"])
            .arg(programs::path(SHADING.name))
            .args(["--size", size])
            .current_dir(folder.path())
            .env("DISPLAY", &screen.name)
            .output();
        let output = output.expect("sh runs");
        let stderr = String::from_utf8(output.stderr).expect("UTF-8");
        assert_eq!(output.status.code(), Some(1), "{stderr}");
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
        assert!(stderr.contains(&format!("not enough memory for a window of {size}")));
        assert_eq!(output.stdout, b"");
    }
    let mut files = fs::read_dir(folder.path()).expect("a folder");
    assert!(files.next().is_none());
}

/// Whatever the limit: a window with its picture, or one line.
#[test]
fn where_memory_is_short_a_window_opens_or_says_so() {
    let Some(screen) = Screen::new() else { return };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (mut opened, mut refused) = (0, 0);
    for (stage, done) in [(SHADING, " rays"), (&::interactive::STAGE, "16 of 16")] {
        let limits = std::iter::successors(Some(20_000_u64), |limit| Some(limit * 3 / 2));
        for kilobytes in limits.take_while(|&limit| limit < 2_000_000) {
            let process = Command::new("sh")
                .args(["-c", "ulimit -v \"$1\"; shift; exec \"$@\"", "sh"])
                .args([&kilobytes.to_string()])
                .arg(programs::path(stage.name))
                .args(["--size", "640x480"])
                .current_dir(folder.path())
                .env("DISPLAY", &screen.name)
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn();
            let mut process = Process(process.expect("sh runs"));
            let status = wait_for("a picture or an end", || {
                let ended = process.0.try_wait().expect("a process");
                let tree = screen.x.query_tree(screen.root).ok()?.reply().ok()?;
                let is_done = |&window: &xproto::Window| {
                    screen.title(window).is_some_and(|title| {
                        title.starts_with(stage.name) && title.contains(done)
                    })
                };
                let is_done = tree.children.iter().any(is_done);
                (ended.is_some() || is_done).then_some(ended)
            });
            let Some(status) = status else {
                opened += 1;
                drop(process);
                wait_for("its window to go", || {
                    let tree = screen.x.query_tree(screen.root).ok()?.reply().ok()?;
                    tree.children.is_empty().then_some(())
                });
                continue;
            };
            let mut stderr = String::new();
            let pipe = process.0.stderr.as_mut().expect("a pipe");
            pipe.read_to_string(&mut stderr).expect("UTF-8");
            // Too little for the program to be loaded at all.
            if !matches!(status.code(), Some(126 | 127)) {
                assert_eq!(status.code(), Some(1), "{kilobytes}: {stderr}");
                assert_eq!(stderr.lines().count(), 1, "{kilobytes}: {stderr}");
                refused += 1;
            }
        }
    }
    assert!(opened > 0 && refused > 0, "{opened}, {refused}");
}

/// Returns the CPU time of a process or thread, in hundredths of a second, by its `stat` in
/// /proc.
fn ticks(stat: &str) -> u64 {
    let stat = fs::read_to_string(stat).expect("the process");
    // Fields 14 and 15 are those in it and for it; the name, field 2, ends with ')'.
    let (_, fields) = stat.rsplit_once(')').expect("a name");
    let fields = fields.split_whitespace().skip(11).take(2);
    fields
        .map(|field| field.parse::<u64>().expect("ticks"))
        .sum()
}

#[test]
fn it_stays_open_while_nothing_happens() {
    let Some(screen) = Screen::new() else { return };
    let mut shown = Shown::new(&screen, SHADING, &SMALL_ARGUMENTS);
    shown.title_with(&DONE);
    sleep(Duration::from_secs(1));
    assert!(shown.process.0.try_wait().expect("a process").is_none());
    assert_eq!(shown.close_with_escape(), Default::default());
}
