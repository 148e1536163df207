//! The window to walk in.

use crate::command_line::explanation;
use crate::explain::explain;
use crate::overlay;
use crate::painter::{Frame, Painter, Wish};
use crate::shot::Shot;
use crate::views::{REACH, scene};
use crate::{STAGE, Walker, block_of};
use canvas::{Asked, Pixel, View, complain, digit, say, size_on_screen};
use glam::{UVec2, Vec2, Vec3};
use minifb::{Key, KeyRepeat, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};
use std::time::{Duration, Instant};

/// How often a second the keys are looked at.
const LOOKS: usize = 60;

/// Steps a second, while a key is held.
const SPEED: f32 = 2.5;

/// By how much a turn of the wheel, or + and −, change the focal length.
const ZOOM: f32 = 1.1;

/// A press of the button that moves the pointer no further, in pixels, is a click.
const CLICK: f32 = 3.0;

/// How often the window is given its picture again though it has not changed: what other windows have
/// covered is black until then.
const AGAIN: Duration = Duration::from_millis(500);

/// For so long a window may not be on the screen yet, where what it is given is lost.
const YOUNG: Duration = Duration::from_secs(2);

/// Opens a window to walk in, and returns when it is closed.
///
/// Returns why, in a few words, if no window can be opened.
pub fn open(walker: Walker, asked: &Asked, target: Duration) -> Result<(), String> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::UpperLeft,
        ..WindowOptions::default()
    };
    let size = size_on_screen(asked.size);
    let mut window = Window::new(STAGE.name, size.x as usize, size.y as usize, options)
        .map_err(|error| error.to_string())?;
    window.set_target_fps(LOOKS);

    let mut walk = Walk::new(walker, asked, size, target);
    let opened = Instant::now();
    let (mut looked, mut shown) = (opened, opened);
    while window.is_open() && !window.is_key_down(Key::Escape) {
        let passed = looked.elapsed();
        looked = Instant::now();
        walk.follow(&window, passed);
        walk.receive();
        if let Some(title) = walk.new_title.take() {
            window.set_title(&title);
        }
        let is_lost = shown.elapsed() > AGAIN || opened.elapsed() < YOUNG;
        if walk.is_new || is_lost {
            let size = walk.screen_size;
            window
                .update_with_buffer(&walk.screen, size.x as usize, size.y as usize)
                .map_err(|error| error.to_string())?;
            (walk.is_new, shown) = (false, Instant::now());
        } else {
            window.update();
        }
    }
    Ok(())
}

/// A button held down on the picture.
struct Press {
    start: Vec2,
    last: Vec2,
    is_drag: bool,
}

/// What the window shows, and what has been asked of it.
struct Walk {
    painter: Painter,
    wish: Wish,
    /// Every view's knob keeps its setting.
    settings: Vec<f32>,
    press: Option<Press>,
    is_frozen: bool,
    save_when_exact: bool,
    /// The ray that is explained: seen from where, and through which pixel.
    explained: Option<(Walker, Pixel)>,
    frame: Option<Frame>,
    /// What minifb shows: 0x00RRGGBB.
    screen: Vec<u32>,
    screen_size: UVec2,
    is_new: bool,
    new_title: Option<String>,
}

impl Walk {
    fn new(walker: Walker, asked: &Asked, size: UVec2, target: Duration) -> Self {
        let mut settings: Vec<f32> =
            STAGE.views.iter().map(View::default_setting).collect();
        settings[asked.index] = asked.setting;
        Self {
            painter: Painter::new(target),
            wish: Wish {
                walker,
                view: asked.index,
                setting: asked.setting,
                size,
                is_moving: false,
            },
            settings,
            press: None,
            is_frozen: false,
            save_when_exact: false,
            explained: None,
            frame: None,
            screen: vec![0; size.element_product() as usize],
            screen_size: size,
            is_new: true,
            new_title: None,
        }
    }

    /// Does what keys, mouse and window ask for.
    fn follow(&mut self, window: &Window, passed: Duration) {
        for key in window.get_keys_pressed(KeyRepeat::No) {
            match key {
                Key::Space => {
                    self.is_frozen = !self.is_frozen;
                    self.tell("");
                }
                Key::P => {
                    self.save_when_exact = true;
                    self.tell("");
                    self.save_if_exact();
                }
                _ => {}
            }
        }
        self.click_or_drag(window);
        if self.is_frozen {
            return;
        }
        for key in window.get_keys_pressed(KeyRepeat::No) {
            match key {
                Key::Home => self.wish.walker = Walker::START,
                Key::Tab => self.show((self.wish.view + 1) % STAGE.views.len()),
                key => {
                    if let Some(index) = digit(key) {
                        // The ninth chapter's key shows the finished picture, the first view.
                        self.show((index + 1) % 9);
                    }
                }
            }
        }
        for key in window.get_keys_pressed(KeyRepeat::Yes) {
            match key {
                Key::Up => self.turn(true),
                Key::Down => self.turn(false),
                Key::Equal | Key::NumPadPlus => self.zoom(ZOOM),
                Key::Minus | Key::NumPadMinus => self.zoom(1.0 / ZOOM),
                _ => {}
            }
        }
        match window.get_scroll_wheel() {
            Some((_, up)) if up > 0.0 => self.zoom(ZOOM),
            Some((_, up)) if up < 0.0 => self.zoom(1.0 / ZOOM),
            _ => {}
        }
        let axis = |more, less| {
            f32::from(window.is_key_down(more)) - f32::from(window.is_key_down(less))
        };
        let steps = Vec3::new(
            axis(Key::D, Key::A),
            axis(Key::R, Key::F),
            axis(Key::W, Key::S),
        );
        self.wish.is_moving =
            steps != Vec3::ZERO || self.press.as_ref().is_some_and(|press| press.is_drag);
        if steps != Vec3::ZERO {
            // After a pause, such as a window that was moved, no leap.
            let seconds = passed.as_secs_f32();
            let seconds = if seconds < 0.1 { seconds } else { 0.1 };
            let steps = SPEED * seconds * steps.normalize();
            self.wish.walker = self.wish.walker.moved(steps);
        }
        let size = window.get_size();
        let size = UVec2::new(size.0 as u32, size.1 as u32).max(UVec2::ONE);
        if size != self.wish.size {
            self.wish.size = size;
            self.is_new = true;
        }
        self.painter.wish(self.wish);
    }

    /// A click explains a pixel; a drag turns, so that what was under the pointer stays about there.
    fn click_or_drag(&mut self, window: &Window) {
        let is_down = window.get_mouse_down(MouseButton::Left);
        let Some(at) = window.get_mouse_pos(MouseMode::Pass).map(Vec2::from) else {
            return;
        };
        match &mut self.press {
            None if is_down => {
                self.press = Some(Press {
                    start: at,
                    last: at,
                    is_drag: false,
                });
            }
            Some(press) if is_down => {
                press.is_drag |= at.distance(press.start) > CLICK;
                if press.is_drag && !self.is_frozen {
                    let moved = (press.last - at) / (self.wish.size.y as f32 / 2.0);
                    self.wish.walker =
                        self.wish.walker.turned(Vec2::new(moved.x, -moved.y));
                }
                press.last = at;
            }
            Some(press) => {
                let at = press.start;
                if !press.is_drag {
                    self.explain(at);
                }
                self.press = None;
            }
            None => {}
        }
    }

    /// Explains the pixel of the shown frame that is there on the screen.
    fn explain(&mut self, at: Vec2) {
        let Some(Frame { wish, .. }) = &self.frame else {
            return;
        };
        let is_in = at.cmpge(Vec2::ZERO).all() && at.cmplt(wish.size.as_vec2()).all();
        if is_in {
            let (x, y, size) = (at.x as u32, at.y as u32, wish.size);
            let pixel = Pixel { x, y, size };
            say(&explanation(wish.walker, wish.view, wish.setting, pixel));
            self.explained = Some((wish.walker, pixel));
            self.show_frame();
        }
    }

    fn show(&mut self, view: usize) {
        self.wish.view = view;
        self.wish.setting = self.settings[view];
        self.explained = None;
        self.show_frame();
    }

    fn turn(&mut self, up: bool) {
        if let Some(knob) = &STAGE.views[self.wish.view].knob {
            self.wish.setting = knob.turned(self.wish.setting, up);
            self.settings[self.wish.view] = self.wish.setting;
        }
    }

    fn zoom(&mut self, factor: f32) {
        self.wish.walker = self.wish.walker.zoomed(factor);
    }

    fn receive(&mut self) {
        if self.is_frozen {
            return;
        }
        if let Some(frame) = self.painter.frame() {
            self.frame = Some(frame);
            self.show_frame();
            self.tell("");
            self.save_if_exact();
        }
    }

    /// Brings the frame to the screen, in blocks as large as it is coarse, and the path over it.
    fn show_frame(&mut self) {
        let Some(Frame {
            wish,
            canvas,
            halvings,
            ..
        }) = &self.frame
        else {
            return;
        };
        let size = wish.size;
        let level = |i: u32| {
            let (x, y) = (i % size.x, i / size.x);
            let block = block_of(Pixel { x, y, size }, *halvings);
            canvas.levels[(block.y * block.size.x + block.x) as usize]
        };
        let mut levels: Vec<_> = (0..size.element_product()).map(level).collect();
        if let Some((walker, pixel)) = self.explained {
            let scene = scene(wish.view, wish.setting);
            let explained = explain(&scene, &walker.camera(), pixel.centre(), REACH);
            overlay::draw(&explained, &wish.walker.camera(), size, &mut levels);
        }
        let colour =
            |&[red, green, blue]: &[u8; 3]| u32::from_be_bytes([0, red, green, blue]);
        self.screen = levels.iter().map(colour).collect();
        self.screen_size = size;
        self.is_new = true;
    }

    fn save_if_exact(&mut self) {
        let Some(frame) = &self.frame else { return };
        if !self.save_when_exact || !frame.is_exact() {
            return;
        }
        self.save_when_exact = false;
        let shot = Shot {
            walker: frame.wish.walker,
            view: frame.wish.view,
            setting: frame.wish.setting,
            canvas: &frame.canvas,
        };
        let path = shot.path();
        let outcome = match shot.save(&path) {
            Ok(()) => {
                say(&format!("{}\n{}", path.display(), shot.command(&path)));
                format!("saved {}", path.display())
            }
            Err(line) => {
                complain(&line);
                line
            }
        };
        self.tell(&outcome);
    }

    /// Puts what is shown, what it cost, and a `word` more into the title.
    fn tell(&mut self, word: &str) {
        let Some(frame) = &self.frame else { return };
        let Wish { view, setting, .. } = frame.wish;
        let name = STAGE.title_of(&STAGE.views[view], setting);
        let UVec2 { x, y } = frame.canvas.size;
        let rays = frame.canvas.rays as f64 / frame.took.as_secs_f64() / 1e6;
        let (done, count) = frame.samples;
        let mut title = format!(
            "{name} | {} ms | {x}x{y} | {done} of {count} samples | {rays:.1} Mrays/s",
            frame.took.as_millis()
        );
        let frozen = if self.is_frozen { "frozen" } else { "" };
        let waits = if self.save_when_exact {
            "P waits until it is exact"
        } else {
            ""
        };
        for word in [frozen, waits, word] {
            if !word.is_empty() {
                title = format!("{title} | {word}");
            }
        }
        self.new_title = Some(title);
    }
}
