//! The window that every chapter has.

use crate::command_line::RenderArgs;
use crate::error::Error;
use crate::file::save_png;
use crate::keyboard::{KeyEvent, Keyboard, digit};
use crate::memory::make_room;
use crate::terminal::{print_error, print_line};
use canvas::{Canvas, Row, Stage, View, spawn_render};
use glam::UVec2;
use minifb::{Key, ScaleMode, Window, WindowOptions};
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::Instant;

/// Frames a second: enough to see rows appear, and cheap when the picture is done.
const TARGET_FPS: usize = 30;

/// The largest window that is opened, in pixels, so that it fits a small screen. It can be
/// resized.
const MAX_WINDOW_SIZE: UVec2 = UVec2::new(1280, 960);

/// The bytes that a pixel needs: 15 on the canvas, 4 on the screen.
const BYTES_PER_PIXEL: u64 = 19;

/// Opens a window that shows a view of `stage`, and returns when it is closed.
///
/// # Errors
/// If no window can be opened, for example without a display, if memory is short, or if a
/// line cannot be printed.
pub fn open(stage: &'static Stage, args: &RenderArgs) -> Result<(), Error> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::AspectRatioStretch,
        ..WindowOptions::default()
    };
    let UVec2 { x, y } = size_on_screen(args.size);
    let mut window = Window::new(stage.name, x as usize, y as usize, options)
        .map_err(Error::NoWindow)?;
    window.set_target_fps(TARGET_FPS);
    let mut keyboard = Keyboard::new(&mut window);

    check_memory(args.size, BYTES_PER_PIXEL)?;
    let mut preview = Preview::new(stage, args);
    while window.is_open() {
        for event in keyboard.events(&window) {
            match event {
                KeyEvent::Pressed(Key::Escape) => return Ok(()),
                KeyEvent::Pressed(Key::P | Key::F12) => {
                    preview.save_when_done = true;
                    // At once, before a key that follows shows another view.
                    preview.save_if_done()?;
                }
                KeyEvent::Pressed(Key::Tab) => preview.show(preview.next_view()),
                KeyEvent::Pressed(Key::Up) | KeyEvent::Repeated(Key::Up) => {
                    preview.step_knob(true);
                }
                KeyEvent::Pressed(Key::Down) | KeyEvent::Repeated(Key::Down) => {
                    preview.step_knob(false);
                }
                KeyEvent::Pressed(key) => {
                    preview.show(digit(key).and_then(|i| stage.views.get(i)));
                }
                KeyEvent::Repeated(_) | KeyEvent::Typed(_) => {}
            }
        }
        preview.receive_rows()?;
        if let Some(title) = preview.new_title.take() {
            window.set_title(&title);
        }
        // With a buffer, every frame: after a resize, `update` alone leaves the window black.
        let UVec2 { x, y } = args.size;
        window
            .update_with_buffer(&preview.screen, x as usize, y as usize)
            .map_err(Error::Window)?;
    }
    Ok(())
}

/// Returns `size`, or the largest size of the same shape that fits a small screen.
pub fn size_on_screen(size: UVec2) -> UVec2 {
    let fit = (MAX_WINDOW_SIZE.as_vec2() / size.as_vec2()).min_element();
    if fit < 1.0 {
        (size.as_vec2() * fit).as_uvec2().max(UVec2::ONE)
    } else {
        size
    }
}

/// Checks that there is memory for a window of `size` pixels, of which each needs `bytes`.
///
/// # Errors
/// [`Error::Memory`] if there is not.
pub fn check_memory(size: UVec2, bytes: u64) -> Result<(), Error> {
    let pixels = u64::from(size.x) * u64::from(size.y);
    if make_room(pixels * bytes) {
        Ok(())
    } else {
        Err(Error::Memory(size))
    }
}

/// The state of the window.
struct Preview {
    stage: &'static Stage,
    view: &'static View,
    /// The settings of the knobs that have been turned, by the name of the view.
    settings: HashMap<&'static str, f32>,
    canvas: Canvas,
    /// Pixels 0x00RRGGBB. The old picture stays until the new one's rows replace it.
    screen: Vec<u32>,
    /// The rows that are being rendered; `None` when the picture is done.
    rows: Option<Receiver<Row>>,
    started: Instant,
    save_when_done: bool,
    new_title: Option<String>,
}

impl Preview {
    fn new(stage: &'static Stage, args: &RenderArgs) -> Self {
        let canvas = Canvas::black(args.size);
        let mut preview = Self {
            stage,
            view: args.view,
            settings: HashMap::from([(args.view.name, args.setting)]),
            screen: vec![0; canvas.levels.len()],
            canvas,
            rows: None,
            started: Instant::now(),
            save_when_done: false,
            new_title: None,
        };
        preview.start_render();
        preview
    }

    fn setting(&self) -> f32 {
        let turned = self.settings.get(self.view.name).copied();
        turned.unwrap_or_else(|| self.view.default_setting())
    }

    /// Returns the view after the one that is shown; the last is followed by the first.
    fn next_view(&self) -> Option<&'static View> {
        let views = self.stage.views.iter().chain(self.stage.views);
        views.skip_while(|view| view.name != self.view.name).nth(1)
    }

    fn show(&mut self, view: Option<&'static View>) {
        if let Some(view) = view {
            self.view = view;
            self.start_render();
        }
    }

    fn step_knob(&mut self, up: bool) {
        if let Some(knob) = &self.view.knob {
            let setting = knob.stepped(self.setting(), up);
            self.settings.insert(self.view.name, setting);
            self.start_render();
        }
    }

    /// Replaces the receiver of the old picture's rows, which stops its rendering.
    fn start_render(&mut self) {
        self.save_when_done = false;
        self.canvas.rays = 0;
        self.started = Instant::now();
        let picture = (self.view.picture)(self.setting());
        self.rows = Some(spawn_render(picture, self.canvas.size));
        self.set_title("rendering");
    }

    fn receive_rows(&mut self) -> Result<(), Error> {
        while let Some(rows) = &self.rows {
            match rows.try_recv() {
                Ok(row) => {
                    let start = row.y as usize * self.canvas.size.x as usize;
                    let pixels = self.screen[start..].iter_mut();
                    for (pixel, &[red, green, blue]) in pixels.zip(&row.levels) {
                        *pixel = u32::from_be_bytes([0, red, green, blue]);
                    }
                    self.canvas.write_row(&row);
                }
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => {
                    self.rows = None;
                    let ms = self.started.elapsed().as_millis();
                    self.set_title(&format!("{ms} ms | {} rays", self.canvas.rays));
                }
            }
        }
        self.save_if_done()
    }

    fn save_if_done(&mut self) -> Result<(), Error> {
        if self.rows.is_some() || !self.save_when_done {
            return Ok(());
        }
        self.save_when_done = false;
        let name = self.stage.picture_name(self.view, self.setting());
        let path = PathBuf::from(format!("{name}.png"));
        let path = std::path::absolute(&path).unwrap_or(path);
        let Canvas { size, levels, .. } = &self.canvas;
        match save_png(&path, *size, &[], |write| write(levels)) {
            Ok(()) => {
                print_line(path.display())?;
                self.set_title(&format!("saved {}", path.display()));
            }
            Err(error) => {
                print_error(&error);
                self.set_title(&error.to_string());
            }
        }
        Ok(())
    }

    /// Sets the title: stage, view and knob, and after them `status`.
    fn set_title(&mut self, status: &str) {
        let title = self.stage.title_of(self.view, self.setting());
        self.new_title = Some(format!("{title} | {status}"));
    }
}
