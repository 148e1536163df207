//! The window to walk in.

use crate::mouse::{Mouse, MouseEvent};
use crate::shot;
use canvas::{Pixel, View};
use glam::{UVec2, Vec2, Vec3};
use interactive::explain::{budget, explain, explanation};
use interactive::overlay::Overlay;
use interactive::views::WalkView;
use interactive::{CameraPose, Frame, RenderRequest, RenderThread, STAGE};
use minifb::{Key, ScaleMode, Window, WindowOptions};
use preview::{
    Error, KeyEvent, Keyboard, check_memory, digit, print_error, print_line,
    size_on_screen,
};
use std::time::{Duration, Instant};

/// How many times per second keys and mouse are looked at.
const LOOKS_PER_SECOND: usize = 60;

/// The same where the mouse has no events: a click is then lost that is shorter than the time
/// between two looks.
const LOOKS_WITHOUT_EVENTS: usize = 500;

/// How often the camera moves and the window is redrawn, at most.
const FRAME_INTERVAL: Duration = Duration::from_millis(16);

/// The speed of a walk, in units of the scene per second.
const SPEED: f32 = 2.5;

/// The factor by which a notch of the wheel, or + and −, change the focal length.
const ZOOM: f32 = 1.1;

/// A press of the button is a click, and no drag, while the pointer stays this close, in pixels.
const CLICK_RADIUS: f32 = 3.0;

/// How often an unchanged picture is shown again: what other windows have covered is black
/// until then.
const REDRAW_INTERVAL: Duration = Duration::from_millis(500);

/// X11 drops what a window is given before it is mapped: for this long after opening, the
/// picture is shown again in every frame.
const MAP_GRACE: Duration = Duration::from_secs(2);

/// The bytes that a pixel needs: 15 on each of the three canvases between render thread and
/// window, 12 for the sum of its samples, and 11 on the way to the screen.
const BYTES_PER_PIXEL: u64 = 68;

/// Opens a window to walk in, and returns when it is closed.
///
/// # Errors
/// If no window can be opened, if memory is short, or if a line cannot be printed.
pub fn open(request: RenderRequest, target: Duration) -> Result<(), Error> {
    let options = WindowOptions {
        resize: true,
        scale_mode: ScaleMode::UpperLeft,
        ..WindowOptions::default()
    };
    let size = size_on_screen(request.size);
    let mut window = Window::new(STAGE.name, size.x as usize, size.y as usize, options)
        .map_err(Error::NoWindow)?;
    let mut keyboard = Keyboard::new(&mut window);
    let mut mouse = Mouse::new(&window);
    window.set_target_fps(if mouse.has_events() {
        LOOKS_PER_SECOND
    } else {
        LOOKS_WITHOUT_EVENTS
    });

    check_memory(size, BYTES_PER_PIXEL)?;
    let mut walk = Walk::new(RenderRequest { size, ..request }, target);
    let opened = Instant::now();
    let (mut stepped, mut shown) = (opened, opened);
    while window.is_open() {
        for event in keyboard.events(&window) {
            if event == KeyEvent::Pressed(Key::Escape) {
                return Ok(());
            }
            walk.handle_key(event)?;
        }
        for event in mouse.events(&window) {
            walk.handle_mouse(event)?;
        }
        let passed = stepped.elapsed();
        if passed < FRAME_INTERVAL {
            window.update();
            continue;
        }
        stepped = Instant::now();
        walk.step(&keyboard, &window, passed);
        keyboard.end_frame();
        walk.receive_frame()?;
        if let Some(title) = walk.new_title.take() {
            window.set_title(&title);
        }
        let is_due = shown.elapsed() > REDRAW_INTERVAL || opened.elapsed() < MAP_GRACE;
        if walk.is_new || is_due {
            let size = walk.screen_size;
            window
                .update_with_buffer(&walk.screen, size.x as usize, size.y as usize)
                .map_err(Error::Window)?;
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
    /// What the wheel has turned and has not yet had its effect: less than a notch.
    scroll: f32,
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
            scroll: 0.0,
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

    fn handle_key(&mut self, event: KeyEvent) -> Result<(), Error> {
        match event {
            KeyEvent::Pressed(Key::Space) => {
                self.is_frozen = !self.is_frozen;
                self.update_title(None);
            }
            KeyEvent::Pressed(Key::P | Key::F12) => {
                self.save_when_exact = true;
                self.update_title(None);
                self.save_if_exact()?;
            }
            _ if self.is_frozen => {}
            KeyEvent::Pressed(Key::Home) => self.request.pose = CameraPose::START,
            KeyEvent::Pressed(Key::Tab) => {
                self.show((self.index() + 1) % WalkView::ALL.len());
            }
            KeyEvent::Pressed(key @ (Key::Up | Key::Down))
            | KeyEvent::Repeated(key @ (Key::Up | Key::Down)) => {
                let request = &mut self.request;
                if let Some(knob) = &request.view.view.knob {
                    request.setting = knob.stepped(request.setting, key == Key::Up);
                }
            }
            // As characters: on a German keyboard + has a key of its own, on an English one
            // it is Shift and =.
            KeyEvent::Typed('+' | '=') => self.zoom(ZOOM),
            KeyEvent::Typed('-') => self.zoom(1.0 / ZOOM),
            KeyEvent::Pressed(key) => {
                if let Some(index) = digit(key) {
                    self.show(index);
                }
            }
            KeyEvent::Repeated(_) | KeyEvent::Typed(_) => {}
        }
        Ok(())
    }

    fn zoom(&mut self, factor: f32) {
        self.request.pose = self.request.pose.zoomed(factor);
    }

    /// A click explains a pixel; a drag turns the camera, so that what is under the pointer
    /// stays about there; the wheel zooms.
    fn handle_mouse(&mut self, event: MouseEvent) -> Result<(), Error> {
        match event {
            MouseEvent::Press(at) => {
                self.press = Some(Press {
                    start: at,
                    last: at,
                    is_drag: false,
                });
            }
            MouseEvent::Move(at) => self.drag(at),
            MouseEvent::Release(at) => {
                self.drag(at);
                if let Some(press) = self.press.take()
                    && !press.is_drag
                {
                    return self.explain(press.start);
                }
            }
            MouseEvent::Scroll(_) if self.is_frozen => {}
            MouseEvent::Scroll(notches) => {
                self.scroll += notches;
                while self.scroll >= 1.0 {
                    self.zoom(ZOOM);
                    self.scroll -= 1.0;
                }
                while self.scroll <= -1.0 {
                    self.zoom(1.0 / ZOOM);
                    self.scroll += 1.0;
                }
            }
        }
        Ok(())
    }

    /// Turns the camera if the button is down and the pointer has moved.
    fn drag(&mut self, at: Vec2) {
        let Some(press) = &mut self.press else { return };
        press.is_drag |= at.distance(press.start) > CLICK_RADIUS;
        if press.is_drag && !self.is_frozen {
            let moved = (press.last - at) / (self.request.size.y as f32 / 2.0);
            self.request.pose = self.request.pose.turned(moved * Vec2::new(1.0, -1.0));
        }
        press.last = at;
    }

    /// Moves the camera by the keys that are held, and requests a picture of the window's
    /// size; `passed` is the time since the last call.
    fn step(&mut self, keyboard: &Keyboard, window: &Window, passed: Duration) {
        if self.is_frozen {
            return;
        }
        let request = &mut self.request;
        // Beside the letters, keys that every layout has.
        let keys = [
            ([Key::D, Key::Right], [Key::A, Key::Left]),
            ([Key::R, Key::Insert], [Key::F, Key::Delete]),
            ([Key::W, Key::PageUp], [Key::S, Key::PageDown]),
        ];
        let steps = Vec3::from_array(keys.map(|(more, less)| {
            f32::from(keyboard.is_down(&more)) - f32::from(keyboard.is_down(&less))
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

    /// Explains the pixel of the shown frame at a point of the window.
    fn explain(&mut self, at: Vec2) -> Result<(), Error> {
        let Some(Frame { request, .. }) = &self.frame else {
            return Ok(());
        };
        let size = request.size;
        if at.cmpge(Vec2::ZERO).all() && at.cmplt(size.as_vec2()).all() {
            let (x, y) = (at.x as u32, at.y as u32);
            let pixel = Pixel { x, y, size };
            let scene = (request.view.scene)(request.setting);
            print_line(explanation(&scene, &request.pose.camera(), pixel))?;
            self.explained = Some((request.pose, pixel));
            self.show_frame();
        }
        Ok(())
    }

    fn receive_frame(&mut self) -> Result<(), Error> {
        if self.is_frozen {
            return Ok(());
        }
        if let Some(frame) = self.render_thread.take_frame() {
            self.frame = Some(frame);
            self.show_frame();
            self.update_title(None);
        }
        self.save_if_exact()
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

    fn save_if_exact(&mut self) -> Result<(), Error> {
        let Some(frame) = &self.frame else {
            return Ok(());
        };
        // A step or another view may just have been requested, of which no frame has come.
        let is_latest = self.is_frozen || frame.request == self.request;
        if !self.save_when_exact || !frame.is_exact() || !is_latest {
            return Ok(());
        }
        self.save_when_exact = false;
        let Frame {
            request, canvas, ..
        } = frame;
        let path = shot::free_path(request);
        let news = match shot::save(request, &path, |write| write(&canvas.levels)) {
            Ok(()) => {
                let command = shot::command(request, &path);
                print_line(format!("{}\n{command}", path.display()))?;
                format!("saved {}", path.display())
            }
            Err(error) => {
                print_error(&error);
                error.to_string()
            }
        };
        self.update_title(Some(&news));
        Ok(())
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
