//! The keyboard of a window, event by event.

use minifb::{InputCallback, Key, Window};
use std::sync::mpsc::{Receiver, Sender, channel};

/// What the keyboard does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeyEvent {
    /// A key goes down.
    Pressed(Key),
    /// A key that is held down repeats itself.
    Repeated(Key),
    /// A character is typed, by whatever key the keyboard's layout has it on.
    Typed(char),
}

/// A window's keyboard.
///
/// Its keys are those of minifb, which under X11 knows them by what the layout prints on
/// them: there are no W A S D under a Russian one, and no digits under a French one.
pub struct Keyboard {
    events: Receiver<Event>,
    /// The keys that are down, and of those that are up the ones that have been tapped since
    /// [`Keyboard::end_frame`].
    down: Vec<Key>,
    tapped: Vec<Key>,
    was_active: bool,
}

enum Event {
    Key(Key, bool),
    Typed(char),
}

struct Listener(Sender<Event>);

/// minifb calls these for every event, also where it afterwards only knows that a key is up
/// again.
impl InputCallback for Listener {
    fn add_char(&mut self, character: u32) {
        if let Some(character) = char::from_u32(character) {
            let _ = self.0.send(Event::Typed(character));
        }
    }

    fn set_key_state(&mut self, key: Key, is_down: bool) {
        let _ = self.0.send(Event::Key(key, is_down));
    }
}

impl Keyboard {
    /// Returns the keyboard of `window`; it replaces an earlier one.
    pub fn new(window: &mut Window) -> Self {
        let (sender, events) = channel();
        window.set_input_callback(Box::new(Listener(sender)));
        Self {
            events,
            down: Vec::new(),
            tapped: Vec::new(),
            was_active: false,
        }
    }

    /// Returns what has happened since the last call, in order. No tap is too short.
    ///
    /// If the window has lost the focus, all keys are up: that they are let go is told to
    /// another window.
    pub fn events(&mut self, window: &Window) -> Vec<KeyEvent> {
        let mut events = Vec::new();
        for event in self.events.try_iter() {
            match event {
                Event::Typed(character) => events.push(KeyEvent::Typed(character)),
                Event::Key(key, true) if self.down.contains(&key) => {
                    events.push(KeyEvent::Repeated(key));
                }
                Event::Key(key, true) => {
                    self.down.push(key);
                    self.tapped.push(key);
                    events.push(KeyEvent::Pressed(key));
                }
                Event::Key(key, false) => self.down.retain(|&down| down != key),
            }
        }
        let is_active = window.is_active();
        if self.was_active && !is_active {
            self.down.clear();
        }
        self.was_active = is_active;
        events
    }

    /// Returns whether any of `keys` is down, or has been since [`Keyboard::end_frame`].
    pub fn is_down(&self, keys: &[Key]) -> bool {
        let mut known = self.down.iter().chain(&self.tapped);
        known.any(|key| keys.contains(key))
    }

    /// Ends a frame: the keys that were only tapped have had their effect.
    pub fn end_frame(&mut self) {
        self.tapped.clear();
    }
}

/// Returns 0 for 1, up to 8 for 9: for the digits of either part of the keyboard, and for F1 to
/// F9, which every layout has. `None` for any other key.
pub fn digit(key: Key) -> Option<usize> {
    const DIGITS: [[Key; 3]; 9] = [
        [Key::Key1, Key::NumPad1, Key::F1],
        [Key::Key2, Key::NumPad2, Key::F2],
        [Key::Key3, Key::NumPad3, Key::F3],
        [Key::Key4, Key::NumPad4, Key::F4],
        [Key::Key5, Key::NumPad5, Key::F5],
        [Key::Key6, Key::NumPad6, Key::F6],
        [Key::Key7, Key::NumPad7, Key::F7],
        [Key::Key8, Key::NumPad8, Key::F8],
        [Key::Key9, Key::NumPad9, Key::F9],
    ];
    DIGITS.iter().position(|digit| digit.contains(&key))
}
