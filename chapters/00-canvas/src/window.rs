//! The preview window.

use crate::command_line::{complain, say};
use crate::{Canvas, Row, Stage, View, paint_in_background};
use glam::UVec2;
use minifb::{Key, KeyRepeat, ScaleMode, Window, WindowOptions};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::Instant;

/// Frames a second: enough to see rows appear, and next to nothing when the picture is done.
const FRAME_RATE: usize = 30;

/// A window is at first no larger than this, so that it fits a small screen; it can be resized.
const LARGEST_WINDOW: UVec2 = UVec2::new(1280, 960);

/// Opens a window that shows `stage`, and returns when it is closed.
///
/// Returns why, in a few words, if no window can be opened.
pub fn open(
    stage: &'static Stage,
    index: usize,
    setting: f32,
    size: UVec2,
) -> Result<(), String> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::AspectRatioStretch,
        ..WindowOptions::default()
    };
    let on_screen = size_on_screen(size);
    let mut window = Window::new(
        stage.name,
        on_screen.x as usize,
        on_screen.y as usize,
        options,
    )
    .map_err(|error| error.to_string())?;
    window.set_target_fps(FRAME_RATE);

    let mut preview = Preview::new(stage, index, setting, size);
    while window.is_open() {
        for key in window.get_keys_pressed(KeyRepeat::No) {
            match key {
                Key::Escape => return Ok(()),
                Key::P => preview.save_when_done = true,
                Key::Tab => preview.show((preview.index + 1) % stage.views.len()),
                key => {
                    if let Some(index) =
                        digit(key).filter(|&index| index < stage.views.len())
                    {
                        preview.show(index);
                    }
                }
            }
        }
        for key in window.get_keys_pressed(KeyRepeat::Yes) {
            match key {
                Key::Up => preview.turn(true),
                Key::Down => preview.turn(false),
                _ => {}
            }
        }
        preview.receive_rows();
        if let Some(title) = preview.new_title.take() {
            window.set_title(&title);
        }
        // With a buffer, every frame: after a resize, `update` alone leaves the window black.
        window
            .update_with_buffer(&preview.screen, size.x as usize, size.y as usize)
            .map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// As large as `size`, or smaller, so that it fits a small screen.
#[must_use]
pub fn size_on_screen(size: UVec2) -> UVec2 {
    let fit = (LARGEST_WINDOW.as_vec2() / size.as_vec2()).min_element();
    if fit < 1.0 {
        (size.as_vec2() * fit).as_uvec2().max(UVec2::ONE)
    } else {
        size
    }
}

/// 0 for the key 1, up to 8 for the key 9.
#[must_use]
pub fn digit(key: Key) -> Option<usize> {
    const DIGITS: [Key; 9] = [
        Key::Key1,
        Key::Key2,
        Key::Key3,
        Key::Key4,
        Key::Key5,
        Key::Key6,
        Key::Key7,
        Key::Key8,
        Key::Key9,
    ];
    DIGITS.iter().position(|&digit| digit == key)
}

/// What the window shows, and the rows still to come.
struct Preview {
    stage: &'static Stage,
    index: usize,
    /// Every view's knob keeps its setting.
    settings: Vec<f32>,
    canvas: Canvas,
    /// What minifb shows: 0x00RRGGBB. The old picture stays until the new one's rows replace it.
    screen: Vec<u32>,
    /// Rows in the making; none when the picture is done.
    rows: Option<Receiver<Row>>,
    started: Instant,
    save_when_done: bool,
    new_title: Option<String>,
}

impl Preview {
    fn new(stage: &'static Stage, index: usize, setting: f32, size: UVec2) -> Self {
        let mut settings: Vec<f32> =
            stage.views.iter().map(View::default_setting).collect();
        settings[index] = setting;
        let canvas = Canvas::black(size);
        let mut preview = Self {
            stage,
            index,
            settings,
            screen: vec![0; canvas.levels.len()],
            canvas,
            rows: None,
            started: Instant::now(),
            save_when_done: false,
            new_title: None,
        };
        preview.repaint();
        preview
    }

    fn view(&self) -> &'static View {
        &self.stage.views[self.index]
    }

    fn setting(&self) -> f32 {
        self.settings[self.index]
    }

    fn show(&mut self, index: usize) {
        self.index = index;
        self.repaint();
    }

    fn turn(&mut self, up: bool) {
        if let Some(knob) = &self.view().knob {
            self.settings[self.index] = knob.turned(self.setting(), up);
            self.repaint();
        }
    }

    /// Starts over. Replacing the receiver stops a painting that is still going on.
    fn repaint(&mut self) {
        self.save_when_done = false;
        self.canvas.rays = 0;
        self.started = Instant::now();
        let picture = (self.view().picture)(self.setting());
        self.rows = Some(paint_in_background(picture, self.canvas.size));
        self.new_title = Some(format!("{} | painting", self.name()));
    }

    fn receive_rows(&mut self) {
        while let Some(rows) = &self.rows {
            match rows.try_recv() {
                Ok(row) => {
                    let start = row.y as usize * self.canvas.size.x as usize;
                    for (pixel, level) in self.screen[start..].iter_mut().zip(&row.levels)
                    {
                        *pixel = u32::from_be_bytes([0, level[0], level[1], level[2]]);
                    }
                    self.canvas.put(&row);
                }
                Err(TryRecvError::Empty) => break,
                Err(TryRecvError::Disconnected) => {
                    self.rows = None;
                    self.new_title = Some(format!(
                        "{} | {} ms | {} rays",
                        self.name(),
                        self.started.elapsed().as_millis(),
                        self.canvas.rays
                    ));
                }
            }
        }
        if self.rows.is_none() && self.save_when_done {
            self.save();
        }
    }

    fn save(&mut self) {
        self.save_when_done = false;
        let name = self.stage.picture_name(self.view(), self.setting());
        let path = PathBuf::from(format!("{name}.png"));
        let path = std::path::absolute(&path).unwrap_or(path);
        let outcome = match self.canvas.save(&path) {
            Ok(()) => {
                say(&path.display().to_string());
                format!("saved {}", path.display())
            }
            Err(line) => {
                complain(&line);
                line
            }
        };
        self.new_title = Some(format!("{} | {outcome}", self.name()));
    }

    /// Stage, view and knob, for the title.
    fn name(&self) -> String {
        self.stage.title_of(self.view(), self.setting())
    }
}
