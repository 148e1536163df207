//! The mouse in a window, event by event where that is possible.

use glam::Vec2;
use minifb::{MouseButton, MouseMode, Window};

/// What the mouse does. Positions are pixels of the window, from its upper left corner.
pub enum MouseEvent {
    /// The left button goes down.
    Press(Vec2),
    /// The pointer is there.
    Move(Vec2),
    /// The left button goes up.
    Release(Vec2),
    /// The wheel turns up by so many notches.
    Scroll(f32),
}

/// What minifb reports for a notch of the wheel. X11's is a button, and minifb counts both
/// its press and its release.
const NOTCH: f32 = if cfg!(windows) {
    12.0
} else if cfg!(target_os = "macos") {
    1.0
} else {
    2.0
};

/// A window's mouse.
///
/// minifb only knows whether the button is down *now*: a click that is shorter than the time
/// between two looks is lost. So under X11 the events come from there.
pub struct Mouse {
    #[cfg(target_os = "linux")]
    x11: Option<x11::Mouse>,
    is_down: bool,
}

impl Mouse {
    /// Returns the mouse of `window`.
    pub fn new(window: &Window) -> Self {
        Self {
            #[cfg(target_os = "linux")]
            x11: x11::Mouse::new(window.get_window_handle() as usize as u32).ok(),
            is_down: false,
        }
    }

    /// Returns whether no click is lost, however short.
    pub fn has_events(&self) -> bool {
        #[cfg(target_os = "linux")]
        let has_events = self.x11.is_some();
        #[cfg(not(target_os = "linux"))]
        let has_events = false;
        has_events
    }

    /// Returns what has happened since the last call, in order.
    pub fn events(&mut self, window: &Window) -> Vec<MouseEvent> {
        #[cfg(target_os = "linux")]
        if let Some(mouse) = &self.x11 {
            return mouse.events();
        }
        let mut events = Vec::new();
        if let Some((_, up)) = window.get_scroll_wheel() {
            events.push(MouseEvent::Scroll(up / NOTCH));
        }
        if let Some(at) = window.get_mouse_pos(MouseMode::Pass).map(Vec2::from) {
            let is_down = window.get_mouse_down(MouseButton::Left);
            events.push(match (self.is_down, is_down) {
                (false, true) => MouseEvent::Press(at),
                (true, false) => MouseEvent::Release(at),
                _ => MouseEvent::Move(at),
            });
            self.is_down = is_down;
        }
        events
    }
}

#[cfg(target_os = "linux")]
mod x11 {
    use super::MouseEvent;
    use glam::Vec2;
    use std::error::Error;
    use x11rb::connection::Connection;
    use x11rb::protocol::Event;
    use x11rb::protocol::xinput::{
        ConnectionExt, Device, EventMask, Fp1616, XIEventMask,
    };
    use x11rb::rust_connection::RustConnection;

    /// A second connection, to which the X Input extension sends the window's events.
    pub struct Mouse(RustConnection);

    impl Mouse {
        /// # Errors
        /// If there is no X server, or none with the extension.
        pub fn new(window: u32) -> Result<Self, Box<dyn Error>> {
            let (connection, _) = x11rb::connect(None)?;
            connection.xinput_xi_query_version(2, 0)?.reply()?;
            let events = XIEventMask::BUTTON_PRESS
                | XIEventMask::BUTTON_RELEASE
                | XIEventMask::MOTION;
            let mask = EventMask {
                deviceid: Device::ALL_MASTER.into(),
                mask: vec![events],
            };
            connection
                .xinput_xi_select_events(window, &[mask])?
                .check()?;
            Ok(Self(connection))
        }

        pub fn events(&self) -> Vec<MouseEvent> {
            // A connection that is lost is minifb's as well, which ends the program.
            let events = std::iter::from_fn(|| self.0.poll_for_event().ok()?);
            let event = |event| match event {
                // The wheel is two buttons.
                Event::XinputButtonPress(event) => match event.detail {
                    1 => Some(MouseEvent::Press(at(event.event_x, event.event_y))),
                    4 => Some(MouseEvent::Scroll(1.0)),
                    5 => Some(MouseEvent::Scroll(-1.0)),
                    _ => None,
                },
                Event::XinputButtonRelease(event) if event.detail == 1 => {
                    Some(MouseEvent::Release(at(event.event_x, event.event_y)))
                }
                Event::XinputMotion(event) => {
                    Some(MouseEvent::Move(at(event.event_x, event.event_y)))
                }
                _ => None,
            };
            events.filter_map(event).collect()
        }
    }

    /// Returns the position that two numbers with 16 bits after the point give.
    fn at(x: Fp1616, y: Fp1616) -> Vec2 {
        Vec2::new(x as f32, y as f32) / 65536.0
    }
}
