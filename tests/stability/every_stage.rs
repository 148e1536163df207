//! All chapters: every picture is of finite light, and every knob stays within its range.

use crate::common::cases;
use ::canvas::{Canvas, Knob, Scale, Stage, View};
use glam::UVec2;
use light_backwards::STAGES;
use proptest::prelude::*;

fn views() -> impl Iterator<Item = (&'static Stage, &'static View)> {
    STAGES
        .into_iter()
        .flat_map(|stage| stage.views.iter().map(move |view| (stage, view)))
}

/// Every setting that anyone could think of first: the default, both ends, and those pinned.
fn settings(view: &View) -> Vec<f32> {
    let mut settings = vec![view.default_setting()];
    if let Some(knob) = &view.knob {
        settings.extend([knob.min, knob.max]);
        settings.extend(knob.pinned);
    }
    settings
}

#[test]
fn no_picture_has_a_pixel_that_is_not_finite() {
    for (stage, view) in views() {
        for setting in settings(view) {
            let canvas = Canvas::paint(&(view.picture)(setting), UVec2::new(64, 48));
            let name = stage.picture_name(view, setting);
            assert!(canvas.light.iter().all(|light| light.is_finite()), "{name}");
        }
    }
}

#[test]
fn every_knob_begins_and_is_pinned_within_its_range() {
    for (stage, view) in views() {
        for setting in settings(view) {
            let accepted = view.knob.as_ref().is_none_or(|knob| knob.accepts(setting));
            assert!(accepted, "{}--{}: {setting}", stage.name, view.name);
        }
    }
}

/// From every end a knob can be turned to the other, and it stops there.
#[test]
fn every_knob_turns_from_end_to_end() {
    for knob in views().filter_map(|(_, view)| view.knob.as_ref()) {
        for (start, up, end) in [(knob.min, true, knob.max), (knob.max, false, knob.min)]
        {
            let mut setting = start;
            for _ in 0..1000 {
                let turned = knob.turned(setting, up);
                assert!(knob.accepts(turned), "{}: {turned}", knob.name);
                assert!(setting == end || (turned > setting) == up);
                setting = turned;
            }
            assert_eq!(setting, end, "{}", knob.name);
        }
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Knobs of each scale, with any range, at any of its settings.
    #[test]
    fn a_turned_knob_stays_within_its_range(
        scale in prop::sample::select(&[Scale::Linear, Scale::Logarithmic, Scale::Whole][..]),
        min in 1e-3..100.0_f32, range in 1.0..1e6_f32, part in 0.0..=1.0_f32, up in any::<bool>(),
    ) {
        let whole = scale == Scale::Whole;
        let round = |x: f32| if whole { x.ceil() } else { x };
        let (min, max) = (round(min), round(min) + round(range));
        let setting = round(min + part * (max - min));
        let setting = if setting > max { max } else { setting };
        let knob = Knob { name: "", unit: "", min, max, default: min, scale, pinned: &[] };
        prop_assert!(knob.accepts(setting));
        prop_assert!(knob.accepts(knob.turned(setting, up)));
    }
}
