//! The window of the walk: it moves, refines, explains, resizes and closes.

use super::*;
use ::interactive::explain::{budget, explain};
use ::interactive::overlay::Overlay;
use ::interactive::views::WalkView;
use ::interactive::{CameraPose, STAGE};
use canvas::{Picture, Pixel};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_surface, trace, untracked};

/// A function that returns how far a step leads in the right direction.
type Towards = fn(glam::Vec3, &ray_casting::Camera) -> f32;

const HOME: u32 = 0xff50;
const LEFT: u32 = 0xff51;
const RIGHT: u32 = 0xff53;
const PAGE_UP: u32 = 0xff55;
const PAGE_DOWN: u32 = 0xff56;
const INSERT: u32 = 0xff63;
const DELETE: u32 = 0xffff;
const KEYPAD_PLUS: u32 = 0xffab;
const KEYPAD_MINUS: u32 = 0xffad;

/// The title when a picture of 4 × 4 samples is done.
const REFINED: [&str; 1] = ["16 of 16 samples"];

/// Returns what the walk must arrive at: one ray at a time, n × n samples of every pixel.
fn one_by_one(pose: CameraPose, n: u32, size: UVec2) -> Vec<[u8; 3]> {
    let (scene, camera) = (still_life_with_glass(GLASS, AIR), pose.camera());
    let picture = Picture::new(move |pixel| {
        anti_aliasing::regular(pixel, n, &|point| {
            trace(
                &scene,
                &untracked(camera.ray(point)),
                budget(),
                from_surface,
            )
        })
    });
    Canvas::render(&picture, size).levels
}

/// Returns the pose that a command line asks for.
fn pose_in(command: &str) -> CameraPose {
    let (_, camera) = command.split_once("--camera=").expect("a camera");
    let (camera, _) = camera.split_once(' ').expect("numbers");
    camera.parse().expect("a pose")
}

fn open(screen: &Screen) -> Shown<'_> {
    let shown = Shown::new(screen, &STAGE, &SMALL_ARGUMENTS);
    // In the corner, so that the window's pixels are the screen's.
    shown.resize(SMALL.x, SMALL.y);
    shown
}

impl Shown<'_> {
    /// Presses P until the picture is saved; returns the pose in the PNG's command, and its
    /// pixels.
    fn saved(&self, number: u32) -> (CameraPose, Vec<u8>) {
        let name = format!("shot-{number}.png");
        self.press('p'.into(), &["saved ", &name]);
        let files = fs::read_dir(self.folder.path()).expect("a folder");
        let paths = files.map(|file| file.expect("a file").path());
        let path = { paths }
            .find(|path| path.to_str().is_some_and(|path| path.ends_with(&name)))
            .expect("a shot");
        let file = BufReader::new(fs::File::open(&path).expect("a file"));
        let mut reader = png::Decoder::new(file).read_info().expect("a PNG");
        assert!(reader.info().srgb.is_some(), "no sRGB chunk");
        let texts = &reader.info().uncompressed_latin1_text;
        let command = texts.iter().find(|text| text.keyword == "Command");
        let pose = pose_in(&command.expect("the command").text);
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut pixels).expect("pixels");
        (pose, pixels)
    }

    /// Moves the pointer with the button held, so that what is done is a drag, not a click.
    fn drag(&self, from: (i16, i16), to: (i16, i16)) {
        let steps = 8;
        self.screen.point(from.0, from.1);
        sleep(Duration::from_millis(60));
        self.screen.button(1, BUTTON_PRESS);
        sleep(Duration::from_millis(60));
        for step in 1..=steps {
            let at = |from, to| from + (to - from) * step / steps;
            self.screen.point(at(from.0, to.0), at(from.1, to.1));
            sleep(Duration::from_millis(40));
        }
        sleep(Duration::from_millis(60));
        self.screen.button(1, BUTTON_RELEASE);
    }

    fn click(&self, x: i16, y: i16) {
        self.screen.point(x, y);
        sleep(Duration::from_millis(60));
        self.screen.button(1, BUTTON_PRESS);
        sleep(TAP);
        self.screen.button(1, BUTTON_RELEASE);
    }
}

#[test]
fn standing_still_it_refines_to_the_books_picture() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    let title = shown.title_with(&REFINED);
    let parts: Vec<_> = title.split(" | ").collect();
    let [name, "still-life", "n 4", ms, "400x300", _, rays] = parts[..] else {
        panic!("{title}");
    };
    assert_eq!(name, STAGE.name);
    assert!(
        ms.strip_suffix(" ms")
            .is_some_and(|ms| ms.parse::<u64>().is_ok()),
        "{title}"
    );
    let rate = rays
        .strip_suffix(" Mrays/s")
        .and_then(|rate| rate.parse::<f64>().ok());
    assert!(rate.is_some_and(|rate| rate > 0.0), "{title}");
    let expected = one_by_one(CameraPose::START, 4, SMALL);
    shown.assert_shows("sixteen samples a pixel", &expected);

    shown.press(UP, &["n 5 |"]);
    shown.title_with(&["25 of 25 samples"]);
    shown.assert_shows(
        "25 samples a pixel",
        &one_by_one(CameraPose::START, 5, SMALL),
    );
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn keys_walk_and_what_is_saved_there_can_be_drawn_again() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let mut before = CameraPose::START.camera();
    let moves: [(char, Towards); 6] = [
        ('w', |by, camera| by.dot(camera.forward)),
        ('s', |by, camera| -by.dot(camera.forward)),
        ('a', |by, camera| -by.dot(camera.right)),
        ('d', |by, camera| by.dot(camera.right)),
        ('r', |by, _| by.y),
        ('f', |by, _| -by.y),
    ];
    for (number, (key, ahead)) in (1..).zip(moves) {
        // While it moves, a frame is coarse: one sample, never all of them.
        shown.press(key.into(), &["0 of 16 samples"]);
        sleep(Duration::from_millis(100));
        let (pose, pixels) = shown.saved(number);
        let after = pose.camera();
        assert!(ahead(after.eye - before.eye, &before) > 0.0, "{key}");
        assert_eq!(after.forward, before.forward);
        let expected = one_by_one(pose, 4, SMALL);
        assert!(pixels == expected.as_flattened(), "{key}");
        before = after;
    }
    // And home again.
    screen.key(HOME, KEY_PRESS);
    let start = one_by_one(CameraPose::START, 4, SMALL);
    shown.assert_shows("the start", &start);
    screen.key(HOME, KEY_RELEASE);
    let (stdout, stderr) = shown.close_with_escape();
    assert_eq!(stderr, "");
    let lines: Vec<_> = stdout.lines().collect();
    assert_eq!(lines.len(), 12, "{stdout}");
    // The last command, by this binary, into a folder of its own.
    let (cargo, arguments) = lines[11].split_once(" -- ").expect("a command");
    assert_eq!(cargo, format!("cargo run --release --bin {}", STAGE.name));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let drawn = Command::new(programs::path(STAGE.name))
        .args(arguments.split(' '))
        .current_dir(folder.path())
        .output();
    assert_eq!(drawn.expect("the binary runs").status.code(), Some(0));
    let (_, name) = arguments.rsplit_once(' ').expect("a name");
    let again = image::open(folder.path().join(name)).expect("a PNG");
    let pose = pose_in(arguments);
    assert_eq!(pose.camera().eye, before.eye);
    assert!(again.as_bytes() == one_by_one(pose, 4, SMALL).as_flattened());
}

#[test]
fn the_mouse_turns_and_its_wheel_zooms() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let start = CameraPose::START.camera();
    shown.drag((200, 150), (120, 150));
    let (turned, pixels) = shown.saved(1);
    let camera = turned.camera();
    assert_eq!(camera.eye, start.eye);
    // What was dragged to the left leaves more to be seen at the right.
    assert!(camera.forward.dot(start.right) > 0.05, "{turned}");
    assert!(
        (camera.forward.y - start.forward.y).abs() < 0.02,
        "{turned}"
    );
    assert!(pixels == one_by_one(turned, 4, SMALL).as_flattened());
    shown.drag((200, 150), (200, 200));
    let (raised, _) = shown.saved(2);
    assert!(
        raised.camera().forward.y > camera.forward.y + 0.05,
        "{raised}"
    );

    let focal_length = |number| shown.saved(number).0.camera().focal_length;
    let wheel = |button| {
        screen.button(button, BUTTON_PRESS);
        screen.button(button, BUTTON_RELEASE);
        sleep(Duration::from_millis(200));
    };
    wheel(4);
    let near = focal_length(3);
    assert!(near > 1.05 * start.focal_length, "{near}");
    wheel(5);
    wheel(5);
    let far = focal_length(4);
    assert!(far < start.focal_length / 1.05, "{far}");
    screen.key('='.into(), KEY_PRESS);
    sleep(Duration::from_millis(200));
    screen.key('='.into(), KEY_RELEASE);
    let nearer = focal_length(5);
    assert!(nearer > far, "{nearer}");
    screen.key('-'.into(), KEY_PRESS);
    sleep(Duration::from_millis(200));
    screen.key('-'.into(), KEY_RELEASE);
    assert!(focal_length(6) < nearer);
    // A drag is no click, and the wheel neither: nothing has been explained.
    let (stdout, _) = shown.close_with_escape();
    assert_eq!(stdout.lines().count(), 12, "{stdout}");
}

#[test]
fn no_tap_and_no_click_is_too_short() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let pause = Duration::from_millis(60);
    for _ in 0..20 {
        screen.tap('w'.into());
        sleep(pause);
    }
    let (pose, _) = shown.saved(1);
    let way = pose.camera().eye.distance(CameraPose::START.camera().eye);
    // 2.5 a second, for at least a sixtieth each time.
    assert!(way > 20.0 * 2.5 / 63.0, "{way}");

    for i in 0..20 {
        shown.click(100 + 10 * i, 150);
        sleep(pause);
    }
    // Four notches of the wheel at once.
    for _ in 0..4 {
        screen.button(4, BUTTON_PRESS);
        screen.button(4, BUTTON_RELEASE);
    }
    sleep(Duration::from_millis(200));
    let (pose, _) = shown.saved(2);
    let zoom = pose.camera().focal_length / CameraPose::START.camera().focal_length;
    assert!(
        (zoom / [1.1_f32; 4].iter().product::<f32>() - 1.0).abs() < 1e-5,
        "{zoom}"
    );

    shown.press('6'.into(), &["| reflection | depth 64 bounces |"]);
    for _ in 0..20 {
        screen.tap(DOWN);
    }
    shown.title_with(&["| reflection | depth 44 bounces |"]);
    screen.tap(ESCAPE);
    let (stdout, _) = shown.ended();
    for i in 0..20 {
        let position = format!("{},150 of 400x300", 100 + 10 * i);
        assert!(stdout.contains(&position), "no click at {position}");
    }
}

#[test]
fn a_key_that_is_let_go_in_another_window_is_let_go() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let other = screen.x.generate_id().expect("an id");
    let aux = xproto::CreateWindowAux::new();
    let class = xproto::WindowClass::INPUT_OUTPUT;
    let created = (screen.x).create_window(
        0,
        other,
        screen.root,
        600,
        600,
        50,
        50,
        0,
        class,
        0,
        &aux,
    );
    created.expect("sent").check().expect("a window");
    screen.x.map_window(other).expect("sent");

    shown.press_down('w'.into(), &["0 of 16 samples"]);
    screen.focus(other);
    // It stops at once, not only when the window has the focus again.
    shown.title_with(&REFINED);
    screen.key('w'.into(), KEY_RELEASE);
    screen.focus(shown.window);
    let (first, _) = shown.saved(1);
    assert_ne!(first, CameraPose::START);
    sleep(Duration::from_millis(200));
    let (second, _) = shown.saved(2);
    assert_eq!(second, first);
    // And the key works again.
    shown.press('w'.into(), &["0 of 16 samples"]);
    assert_ne!(shown.saved(3).0, first);
    shown.close_with_escape();
}

/// Every key that the page names moves the camera in its direction, or another does that it
/// names for the same.
#[test]
fn keys_move_in_every_layout() {
    let moves: [(char, u32, Towards); 6] = [
        ('w', PAGE_UP, |by, camera| by.dot(camera.forward)),
        ('s', PAGE_DOWN, |by, camera| -by.dot(camera.forward)),
        ('a', LEFT, |by, camera| -by.dot(camera.right)),
        ('d', RIGHT, |by, camera| by.dot(camera.right)),
        ('r', INSERT, |by, _| by.y),
        ('f', DELETE, |by, _| -by.y),
    ];
    let zooms = [
        ('+', KEYPAD_PLUS, 1.1_f32),
        ('=', KEYPAD_PLUS, 1.1),
        ('-', KEYPAD_MINUS, 1.0 / 1.1),
    ];
    for layout in ["us", "fr", "de", "cz", "ru"] {
        let Some(screen) = Screen::with_layout(layout) else {
            return;
        };
        let shown = Shown::new(&screen, &STAGE, &["--size", "80x60"]);
        shown.title_with(&REFINED);
        let mut before = CameraPose::START.camera();
        let mut number = 0;
        let mut saved = || {
            number += 1;
            let name = format!("shot-{number}.png");
            shown.press(F12, &["saved ", &name]);
            let path = shown.folder.path();
            let path = path.join(format!("{}--still-life--{name}", STAGE.name));
            pose_in(&programs::png_info(&path).uncompressed_latin1_text[0].text).camera()
        };
        for (letter, twin, ahead) in moves {
            for key in [letter.into(), twin] {
                if screen.code(key).is_none() {
                    assert_ne!(key, twin, "{layout} has no twin of {letter}");
                    continue;
                }
                screen.key(key, KEY_PRESS);
                sleep(Duration::from_millis(50));
                screen.key(key, KEY_RELEASE);
                let after = saved();
                let way = ahead(after.eye - before.eye, &before);
                assert!(way > 0.0, "{layout}: {key:x} for {letter} leads {way}");
                before = after;
            }
        }
        for (character, twin, factor) in zooms {
            for key in [character.into(), twin] {
                if screen.code(key).is_some() {
                    screen.tap(key);
                    sleep(Duration::from_millis(50));
                    let after = saved();
                    let zoom = after.focal_length / before.focal_length;
                    assert!((zoom / factor - 1.0).abs() < 1e-5, "{layout}: {key:x}");
                    before = after;
                }
            }
        }
        shown.press(F1, &["| ray-casting |"]);
        shown.press(KEYPAD_0 + 3, &["| plane-hit |"]);
        shown.press(' '.into(), &["frozen"]);
        shown.close_with_escape();
    }
}

#[test]
fn digits_show_each_chapters_stage_of_the_picture() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    for (digit, walk) in ('1'..='9').zip(WalkView::ALL) {
        let view = &walk.view;
        let setting = view.default_setting();
        let count = walk.samples(setting);
        shown.press(
            digit.into(),
            &[
                &format!("| {} |", view.name),
                &format!("{count} of {count} samples"),
            ],
        );
        let expected = shown.rendered(view.name, setting, SMALL).levels;
        shown.assert_shows(view.name, &expected);
    }
    shown.press('6'.into(), &["| reflection | depth 64 bounces |"]);
    shown.press(DOWN, &["| reflection | depth 63 bounces |"]);
    shown.press(TAB, &["| refraction | index 1.5 |"]);
    shown.press('6'.into(), &["| reflection | depth 6"]);
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn a_click_explains_a_pixel_and_draws_its_path() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let plain = one_by_one(CameraPose::START, 4, SMALL);
    shown.assert_shows("the refined picture", &plain);
    shown.click(240, 195);
    let mut levels = plain.clone();
    let (scene, camera) = (
        still_life_with_glass(GLASS, AIR),
        CameraPose::START.camera(),
    );
    let (x, y, size) = (240, 195, SMALL);
    let centre = Pixel { x, y, size }.centre();
    let explained = explain(&scene, &camera, centre, budget());
    Overlay::new(&explained, &camera, size).draw(size, &mut levels);
    assert!(levels != plain);
    shown.assert_shows("the path over the picture", &levels);
    // The key of the view that is shown takes it away.
    screen.key('9'.into(), KEY_PRESS);
    shown.assert_shows("the picture without it", &plain);
    screen.key('9'.into(), KEY_RELEASE);
    let (stdout, stderr) = shown.close_with_escape();
    let printed = Command::new(programs::path(STAGE.name))
        .args(SMALL_ARGUMENTS)
        .args(["--trace", "240,195"])
        .output();
    let printed = printed.expect("the binary runs").stdout;
    assert!(stdout.contains("glass"), "{stdout}");
    assert_eq!(stdout, String::from_utf8(printed).expect("UTF-8"));
    assert_eq!(stderr, "");
}

#[test]
fn frozen_nothing_changes_until_it_is_not() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let plain = one_by_one(CameraPose::START, 4, SMALL);
    shown.assert_shows("the refined picture", &plain);
    shown.press(' '.into(), &["| frozen"]);
    // A drag turns nothing, neither now nor later.
    shown.drag((200, 150), (120, 150));
    for key in ['w'.into(), '5'.into(), UP] {
        screen.key(key, KEY_PRESS);
        sleep(Duration::from_millis(150));
        screen.key(key, KEY_RELEASE);
    }
    let title = screen.title(shown.window).expect("a title");
    assert!(
        title.contains("| still-life | n 4 |") && title.ends_with("| frozen"),
        "{title}"
    );
    shown.assert_shows("the same picture", &plain);
    screen.key(' '.into(), KEY_PRESS);
    wait_for("no longer frozen", || {
        (!screen.title(shown.window)?.contains("frozen")).then_some(())
    });
    screen.key(' '.into(), KEY_RELEASE);
    let (pose, _) = shown.saved(1);
    assert_eq!(pose, CameraPose::START);
    shown.close_with_escape();
}

#[test]
fn a_resized_window_has_a_picture_of_its_size() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    for size in [
        UVec2::new(333, 222),
        UVec2::new(150, 400),
        UVec2::ONE,
        SMALL,
    ] {
        shown.resize(size.x, size.y);
        shown.title_with(&[&format!("| {}x{} |", size.x, size.y), REFINED[0]]);
        let expected = one_by_one(CameraPose::START, 4, size);
        shown.assert_shows(&format!("a picture of {size}"), &expected);
    }
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn refined_its_render_threads_sleep() {
    let Some(screen) = Screen::new() else { return };
    let shown = open(&screen);
    shown.title_with(&REFINED);
    let process = shown.process.0.id();
    let tasks = || -> Vec<String> {
        let tasks = fs::read_dir(format!("/proc/{process}/task")).expect("threads");
        let id =
            |task: std::io::Result<fs::DirEntry>| task.expect("a thread").file_name();
        tasks
            .map(|task| id(task).to_string_lossy().into_owned())
            .collect()
    };
    let spent = |task: &String| ticks(&format!("/proc/{process}/task/{task}/stat"));
    // A worker may take a moment to fall asleep.
    sleep(Duration::from_millis(500));
    let others: Vec<_> = tasks()
        .into_iter()
        .filter(|task| *task != process.to_string())
        .collect();
    assert!(!others.is_empty(), "no thread has rendered");
    let before: Vec<_> = others.iter().map(spent).collect();
    let (main, start) = (spent(&process.to_string()), Instant::now());
    sleep(Duration::from_secs(2));
    assert_eq!(others.iter().map(spent).collect::<Vec<_>>(), before);
    let main = spent(&process.to_string()) - main;
    let busy = main as f64 / start.elapsed().as_secs_f64();
    writeln!(
        std::io::stderr(),
        "refined at 400x300: {busy:.1} % of a core"
    )
    .expect("stderr");
    assert_eq!(shown.close_with_escape(), Default::default());
}

#[test]
fn it_closes_at_once_while_it_refines() {
    let Some(screen) = Screen::new() else { return };
    for escape in [true, false] {
        let arguments = ["--size", "1280x960", "--knob", "20"];
        let shown = Shown::new(&screen, &STAGE, &arguments);
        // Four hundred samples of a million pixels on one thread: it is far from done.
        shown.title_with(&[" of 400 samples"]);
        assert_eq!(shown.ended_by(escape), Default::default());
        screen.key(ESCAPE, KEY_RELEASE);
    }
}
