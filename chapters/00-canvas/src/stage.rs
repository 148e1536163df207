//! The description of a chapter's pictures, from which the window, the command line, the
//! snapshots and the book are made.

use crate::Picture;

// ANCHOR: stage
/// A chapter: its names and its pictures.
pub struct Stage {
    /// The chapter's [`folder_name`]: also the name of its program, and the start of its
    /// pictures' names.
    pub name: &'static str,
    /// The idea, in a few words.
    pub title: &'static str,
    /// The name of the view that is shown first, and large in the book.
    pub hero: &'static str,
    /// The names of the views that show a bug.
    pub bugs: &'static [&'static str],
    /// The pictures of the chapter, in the order in which the window shows them.
    pub views: &'static [View],
}

/// A picture that a chapter shows: of a method, a bug, or its fix.
pub struct View {
    /// Lower case, with hyphens: `beyond-buggy`.
    pub name: &'static str,
    /// The caption: what to look for. Also the picture's alternative text.
    pub caption: &'static str,
    /// The parameter that the reader may change. `None` if there is none.
    pub knob: Option<Knob>,
    /// Returns the picture at a setting of the knob. A view without a knob is given 0.
    pub picture: fn(f32) -> Picture,
}

/// A parameter of a view that the reader may change.
pub struct Knob {
    /// The quantity's name.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The least setting.
    pub min: f32,
    /// The greatest setting.
    pub max: f32,
    /// The initial setting.
    pub default: f32,
    /// How the setting steps.
    pub scale: Scale,
    /// Further settings with a picture in the book.
    pub snapshot_settings: &'static [f32],
}

/// How a knob steps from one setting to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// By a thirty-second of the range.
    Linear,
    /// By a factor of two.
    Logarithmic,
    /// By one; only whole numbers are settings.
    Whole,
}
// ANCHOR_END: stage

impl Stage {
    /// Returns the view that is shown first.
    ///
    /// # Panics
    /// If no view has the name [`Stage::hero`].
    pub fn hero(&self) -> &'static View {
        self.view(self.hero).expect("`hero` names a view")
    }

    /// Returns the view called `name`, or `None` if there is no such view.
    pub fn view(&self, name: &str) -> Option<&'static View> {
        self.views.iter().find(|view| view.name == name)
    }

    /// Returns the name of a picture's file, without an extension:
    /// `STAGE--VIEW--knob-SETTING`.
    ///
    /// The default setting is not named, and the name holds no dot.
    pub fn picture_name(&self, view: &View, setting: f32) -> String {
        let name = format!("{}--{}", self.name, view.name);
        match &view.knob {
            Some(knob) if setting != knob.default => {
                format!("{name}--knob-{}", setting.to_string().replace('.', "_"))
            }
            _ => name,
        }
    }

    /// Returns the beginning of a window's title: stage, view, and the knob's setting.
    pub fn title_of(&self, view: &View, setting: f32) -> String {
        let name = format!("{} | {}", self.name, view.name);
        match &view.knob {
            Some(knob) => format!("{name} | {} {setting} {}", knob.name, knob.unit)
                .trim_end()
                .to_string(),
            None => name,
        }
    }
}

impl View {
    /// Returns the knob's default, or 0 if there is no knob.
    pub fn default_setting(&self) -> f32 {
        self.knob.as_ref().map_or(0.0, |knob| knob.default)
    }
}

impl Knob {
    /// Returns whether `setting` is within the range, and whole if it must be.
    pub fn accepts(&self, setting: f32) -> bool {
        (self.min..=self.max).contains(&setting)
            && (self.scale != Scale::Whole || setting.fract() == 0.0)
    }

    /// Returns the next setting up or down, never beyond the range.
    pub fn stepped(&self, setting: f32, up: bool) -> f32 {
        let step = match self.scale {
            Scale::Linear => (self.max - self.min) / 32.0,
            Scale::Logarithmic if up => setting,
            Scale::Logarithmic => setting / 2.0,
            Scale::Whole => 1.0,
        };
        let stepped = if up { setting + step } else { setting - step };
        if stepped > self.max {
            self.max
        } else if stepped < self.min {
            self.min
        } else {
            stepped
        }
    }

    /// Returns the range in words: `1 to 256, whole`.
    pub fn range(&self) -> String {
        let whole = if self.scale == Scale::Whole {
            ", whole"
        } else {
            ""
        };
        let unit = if self.unit.is_empty() { "" } else { " " };
        format!("{} to {}{unit}{}{whole}", self.min, self.max, self.unit)
    }
}

/// Returns the last part of a path. Of `env!("CARGO_MANIFEST_DIR")` that is the name of the
/// chapter's folder, so that no source holds the chapter's number.
pub const fn folder_name(path: &'static str) -> &'static str {
    let bytes = path.as_bytes();
    let mut start = bytes.len();
    while start > 0 && bytes[start - 1] != b'/' && bytes[start - 1] != b'\\' {
        start -= 1;
    }
    path.split_at(start).1
}
