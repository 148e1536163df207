//! A chapter's one description of its pictures: the window, the command line, the
//! snapshots and the book are driven by it.

use crate::Picture;

// ANCHOR: stage
/// A chapter, as what it shows.
pub struct Stage {
    /// Number and name, `04-shadows`: the name of its binary, and the start of its
    /// pictures' names.
    pub name: &'static str,
    /// The idea, in a few words.
    pub title: &'static str,
    /// What it shows; the first is the default.
    pub views: &'static [View],
}

/// One picture of a chapter: a slide of the talk, a bug on purpose, or its cure.
pub struct View {
    /// Lower case, with hyphens: `beyond-buggy`.
    pub name: &'static str,
    /// What to look for; also the picture's text for those who cannot see it.
    pub caption: &'static str,
    /// The one number the reader may turn.
    pub knob: Option<Knob>,
    /// From the knob's setting to what to paint. A view without a knob is given 0.
    pub picture: fn(f32) -> Picture,
}

/// The one number of a view that the reader may turn.
pub struct Knob {
    /// What the number is.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// The least setting.
    pub min: f32,
    /// The greatest setting.
    pub max: f32,
    /// The setting to begin with.
    pub default: f32,
    /// How it steps.
    pub scale: Scale,
    /// Further settings that the page argues with: the snapshots pin them.
    pub pinned: &'static [f32],
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
    /// The index of the view called `name`, if there is one.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<usize> {
        self.views.iter().position(|view| view.name == name)
    }

    /// What a picture of this stage is called, without an ending:
    /// `02-sphere-hit--far-slide--knob-1000`.
    ///
    /// The default setting is not named, and a name never holds a dot.
    #[must_use]
    pub fn picture_name(&self, view: &View, setting: f32) -> String {
        let name = format!("{}--{}", self.name, view.name);
        match &view.knob {
            Some(knob) if setting != knob.default => {
                format!("{name}--knob-{}", setting.to_string().replace('.', "_"))
            }
            _ => name,
        }
    }

    /// How a window's title begins: stage, view, and what the knob is set to.
    #[must_use]
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
    /// The setting to begin with: the knob's default, or 0 where there is none.
    #[must_use]
    pub fn default_setting(&self) -> f32 {
        self.knob.as_ref().map_or(0.0, |knob| knob.default)
    }
}

impl Knob {
    /// Whether `setting` is one: within the range, and whole where it must be.
    #[must_use]
    pub fn accepts(&self, setting: f32) -> bool {
        (self.min..=self.max).contains(&setting)
            && (self.scale != Scale::Whole || setting.fract() == 0.0)
    }

    /// The next setting up or down, never beyond the range.
    #[must_use]
    pub fn turned(&self, setting: f32, up: bool) -> f32 {
        let step = match self.scale {
            Scale::Linear => (self.max - self.min) / 32.0,
            Scale::Logarithmic if up => setting,
            Scale::Logarithmic => setting / 2.0,
            Scale::Whole => 1.0,
        };
        let turned = if up { setting + step } else { setting - step };
        if turned > self.max {
            self.max
        } else if turned < self.min {
            self.min
        } else {
            turned
        }
    }

    /// The range in words: `1 to 256, whole`.
    #[must_use]
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
