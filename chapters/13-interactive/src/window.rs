//! The window to walk in.

use crate::shot;
use canvas::{Pixel, View};
use glam::{UVec2, Vec2, Vec3};
use interactive::explain::{budget, explain, explanation};
use interactive::overlay::Overlay;
use interactive::views::WalkView;
use interactive::{CameraPose, Frame, RenderRequest, RenderThread, STAGE};
use minifb::{Key, KeyRepeat, MouseButton, MouseMode, ScaleMode, Window, WindowOptions};
use preview::{digit, print_error, print_line, size_on_screen};
use std::time::{Duration, Instant};

/// The most times per second that keys and mouse are read and the window is redrawn.
const TARGET_FPS: usize = 60;

/// The speed of a walk, in units of the scene per second.
const SPEED: f32 = 2.5;

/// The factor by which the wheel, or + and −, change the focal length.
const ZOOM: f32 = 1.1;

/// A press of the button is a click, and no drag, while the pointer stays this close, in pixels.
const CLICK_RADIUS: f32 = 3.0;

/// How often an unchanged picture is shown again: what other windows have covered is black
/// until then.
const REDRAW_INTERVAL: Duration = Duration::from_millis(500);

/// X11 drops what a window is given before it is mapped: for this long after opening, the
/// picture is shown again in every frame.
const MAP_GRACE: Duration = Duration::from_secs(2);

/// Opens a window to walk in, and returns when it is closed.
///
/// # Errors
/// If no window can be opened.
pub fn open(request: RenderRequest, target: Duration) -> minifb::Result<()> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::UpperLeft,
        ..WindowOptions::default()
    };
    let size = size_on_screen(request.size);
    let mut window = Window::new(STAGE.name, size.x as usize, size.y as usize, options)?;
    window.set_target_fps(TARGET_FPS);

    let mut walk = Walk::new(RenderRequest { size, ..request }, target);
    let opened = Instant::now();
    let (mut looked, mut shown) = (opened, opened);
    while window.is_open() && !window.is_key_down(Key::Escape) {
        let passed = looked.elapsed();
        looked = Instant::now();
        walk.handle_input(&window, passed);
        walk.receive_frame();
        if let Some(title) = walk.new_title.take() {
            window.set_title(&title);
        }
        let is_due = shown.elapsed() > REDRAW_INTERVAL || opened.elapsed() < MAP_GRACE;
        if walk.is_new || is_due {
            let size = walk.screen_size;
            window.update_with_buffer(&walk.screen, size.x as usize, size.y as usize)?;
            (walk.is_new, shown) = (false, Instant::now());
        } else {
            window.update();
        }
    }
    Ok(())
}

/// A button held down on the picture, with the first and the last position of the pointer.
struct Press {
    start: Vec2,
    last: Vec2,
    is_drag: bool,
}

/// The state of the window.
struct Walk {
    render_thread: RenderThread,
    request: RenderRequest,
    /// The setting of every view's knob.
    settings: Vec<f32>,
    press: Option<Press>,
    is_frozen: bool,
    save_when_exact: bool,
    /// The pixel that is explained, and the pose of the camera then.
    explained: Option<(CameraPose, Pixel)>,
    frame: Option<Frame>,
    /// What minifb shows: 0x00RRGGBB.
    screen: Vec<u32>,
    screen_size: UVec2,
    is_new: bool,
    new_title: Option<String>,
}

impl Walk {
    fn new(request: RenderRequest, target: Duration) -> Self {
        let views = STAGE.views.iter();
        Self {
            render_thread: RenderThread::new(target),
            request,
            settings: views.map(View::default_setting).collect(),
            press: None,
            is_frozen: false,
            save_when_exact: false,
            explained: None,
            frame: None,
            screen: vec![0; request.size.element_product() as usize],
            screen_size: request.size,
            is_new: true,
            new_title: None,
        }
    }

    /// Returns the index of the requested view.
    fn index(&self) -> usize {
        let mut views = WalkView::ALL.iter();
        let index = views.position(|view| view == self.request.view);
        index.expect("every view is in the table")
    }

    fn show(&mut self, index: usize) {
        let old = self.index();
        self.settings[old] = self.request.setting;
        self.request.view = &WalkView::ALL[index];
        self.request.setting = self.settings[index];
        self.explained = None;
        self.show_frame();
    }

    /// Handles keys, mouse and the window's size; `passed` is the time since the last call.
    fn handle_input(&mut self, window: &Window, passed: Duration) {
        for key in window.get_keys_pressed(KeyRepeat::No) {
            match key {
                Key::Space => {
                    self.is_frozen = !self.is_frozen;
                    self.update_title(None);
                }
                Key::P => {
                    self.save_when_exact = true;
                    self.update_title(None);
                    self.save_if_exact();
                }
                _ if self.is_frozen => {}
                Key::Home => self.request.pose = CameraPose::START,
                Key::Tab => self.show((self.index() + 1) % WalkView::ALL.len()),
                key => {
                    if let Some(index) = digit(key) {
                        self.show(index);
                    }
                }
            }
        }
        self.click_or_drag(window);
        if self.is_frozen {
            return;
        }

        let request = &mut self.request;
        let mut zoom = window.get_scroll_wheel().map_or(0.0, |(_, up)| up);
        for key in window.get_keys_pressed(KeyRepeat::Yes) {
            match key {
                Key::Up | Key::Down => {
                    if let Some(knob) = &request.view.view.knob {
                        request.setting = knob.stepped(request.setting, key == Key::Up);
                    }
                }
                Key::Equal | Key::NumPadPlus => zoom = 1.0,
                Key::Minus | Key::NumPadMinus => zoom = -1.0,
                _ => {}
            }
        }
        if zoom != 0.0 {
            let factor = if zoom > 0.0 { ZOOM } else { 1.0 / ZOOM };
            request.pose = request.pose.zoomed(factor);
        }
        let keys = [(Key::D, Key::A), (Key::R, Key::F), (Key::W, Key::S)];
        let steps = Vec3::from_array(keys.map(|(more, less)| {
            f32::from(window.is_key_down(more)) - f32::from(window.is_key_down(less))
        }));
        if steps != Vec3::ZERO {
            // After a pause, such as one while the window is moved, the camera must not
            // leap.
            let seconds = passed.min(Duration::from_millis(100)).as_secs_f32();
            request.pose = request.pose.moved(SPEED * seconds * steps.normalize());
        }
        request.is_moving =
            steps != Vec3::ZERO || self.press.as_ref().is_some_and(|press| press.is_drag);
        let (width, height) = window.get_size();
        let size = UVec2::new(width as u32, height as u32).max(UVec2::ONE);
        self.is_new |= size != request.size;
        request.size = size;
        self.render_thread.request(*request);
    }

    /// A click explains a pixel; a drag turns the camera, so that what is under the pointer
    /// stays about there.
    fn click_or_drag(&mut self, window: &Window) {
        let is_down = window.get_mouse_down(MouseButton::Left);
        let Some(at) = window.get_mouse_pos(MouseMode::Pass).map(Vec2::from) else {
            return;
        };
        let Some(press) = &mut self.press else {
            self.press = is_down.then_some(Press {
                start: at,
                last: at,
                is_drag: false,
            });
            return;
        };
        if is_down {
            press.is_drag |= at.distance(press.start) > CLICK_RADIUS;
            if press.is_drag && !self.is_frozen {
                let moved = (press.last - at) / (self.request.size.y as f32 / 2.0);
                self.request.pose =
                    self.request.pose.turned(moved * Vec2::new(1.0, -1.0));
            }
            press.last = at;
        } else {
            let clicked = (!press.is_drag).then_some(press.start);
            self.press = None;
            if let Some(at) = clicked {
                self.explain(at);
            }
        }
    }

    /// Explains the pixel of the shown frame at a point of the window.
    fn explain(&mut self, at: Vec2) {
        let Some(Frame { request, .. }) = &self.frame else {
            return;
        };
        let size = request.size;
        if at.cmpge(Vec2::ZERO).all() && at.cmplt(size.as_vec2()).all() {
            let (x, y) = (at.x as u32, at.y as u32);
            let pixel = Pixel { x, y, size };
            let scene = (request.view.scene)(request.setting);
            print_line(explanation(&scene, &request.pose.camera(), pixel));
            self.explained = Some((request.pose, pixel));
            self.show_frame();
        }
    }

    fn receive_frame(&mut self) {
        if self.is_frozen {
            return;
        }
        if let Some(frame) = self.render_thread.take_frame() {
            self.frame = Some(frame);
            self.show_frame();
            self.update_title(None);
            self.save_if_exact();
        }
    }

    /// Copies the frame to the screen, and draws the path of the explained ray over it.
    fn show_frame(&mut self) {
        let Some(frame) = &self.frame else { return };
        let (request, size) = (&frame.request, frame.request.size);
        let mut levels = frame.levels();
        if let Some((pose, pixel)) = self.explained {
            let scene = (request.view.scene)(request.setting);
            let explained = explain(&scene, &pose.camera(), pixel.centre(), budget());
            let overlay = Overlay::new(&explained, &request.pose.camera(), size);
            overlay.draw(size, &mut levels);
        }
        let colour = |&[r, g, b]: &[u8; 3]| u32::from_be_bytes([0, r, g, b]);
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
        let path = shot::free_path(&frame.request);
        let news = match shot::save(&frame.request, &frame.canvas, &path) {
            Ok(()) => {
                let command = shot::command(&frame.request, &path);
                print_line(format!("{}\n{command}", path.display()));
                format!("saved {}", path.display())
            }
            Err(error) => {
                print_error(&error);
                error.to_string()
            }
        };
        self.update_title(Some(&news));
    }

    /// Puts the view, its cost and any `news` into the title.
    fn update_title(&mut self, news: Option<&str>) {
        let Some(frame) = &self.frame else { return };
        let UVec2 { x, y } = frame.canvas.size;
        let rays = frame.canvas.rays as f64 / frame.took.as_secs_f64() / 1e6;
        let waits = self.save_when_exact.then_some("P waits until it is exact");
        let parts = [self.is_frozen.then_some("frozen"), waits, news];
        let mut title = format!(
            "{} | {} ms | {x}x{y} | {} of {} samples | {rays:.1} Mrays/s",
            STAGE.title_of(&frame.request.view.view, frame.request.setting),
            frame.took.as_millis(),
            frame.samples,
            frame.total_samples
        );
        for part in parts.into_iter().flatten() {
            title = format!("{title} | {part}");
        }
        self.new_title = Some(title);
    }
}
