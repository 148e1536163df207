//! All chapters: every picture is of finite light, every knob stays within its range, and each picture takes as
//! many rays as the book says.

use ::stages::STAGES;
use canvas::{Canvas, Knob, Scale, Stage, View};
use glam::UVec2;
use harness::{Numbers, cases, three_digits, with_separators};
use proptest::prelude::*;

fn views() -> impl Iterator<Item = (&'static Stage, &'static View)> {
    STAGES
        .into_iter()
        .flat_map(|stage| stage.views.iter().map(move |view| (stage, view)))
}

/// Returns the default setting, both ends, and the settings that have a picture.
fn settings(view: &View) -> Vec<f32> {
    let mut settings = vec![view.default_setting()];
    if let Some(knob) = &view.knob {
        settings.extend([knob.min, knob.max]);
        settings.extend(knob.snapshot_settings);
    }
    settings
}

#[test]
fn no_picture_has_a_pixel_that_is_not_finite() {
    for (stage, view) in views() {
        for setting in settings(view) {
            let canvas = Canvas::render(&(view.picture)(setting), UVec2::new(64, 48));
            let name = stage.picture_name(view, setting);
            assert!(
                canvas.radiance.iter().all(|radiance| radiance.is_finite()),
                "{name}"
            );
        }
    }
}

#[test]
fn every_knob_begins_and_has_its_pictures_within_its_range() {
    for (stage, view) in views() {
        for setting in settings(view) {
            let accepted = view.knob.as_ref().is_none_or(|knob| knob.accepts(setting));
            assert!(accepted, "{}--{}: {setting}", stage.name, view.name);
        }
    }
}

/// From every end a knob can be stepped to the other, and it stops there.
#[test]
fn every_knob_steps_from_end_to_end() {
    for knob in views().filter_map(|(_, view)| view.knob.as_ref()) {
        for (start, up, end) in [(knob.min, true, knob.max), (knob.max, false, knob.min)]
        {
            let mut setting = start;
            for _ in 0..1000 {
                let stepped = knob.stepped(setting, up);
                assert!(knob.accepts(stepped), "{}: {stepped}", knob.name);
                assert!(setting == end || (stepped > setting) == up);
                setting = stepped;
            }
            assert_eq!(setting, end, "{}", knob.name);
        }
    }
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// Knobs of each scale, with any range, at any of its settings.
    #[test]
    fn a_stepped_knob_stays_within_its_range(
        scale in prop::sample::select(&[Scale::Linear, Scale::Logarithmic, Scale::Whole][..]),
        min in 1e-3..100.0_f32, range in 1.0..1e6_f32, part in 0.0..=1.0_f32, up in any::<bool>(),
    ) {
        let whole = scale == Scale::Whole;
        let round = |x: f32| if whole { x.ceil() } else { x };
        let (min, max) = (round(min), round(min) + round(range));
        let setting = round(min + part * (max - min));
        let setting = if setting > max { max } else { setting };
        let knob = Knob { name: "", unit: "", min, max, default: min, scale, snapshot_settings: &[] };
        prop_assert!(knob.accepts(setting));
        prop_assert!(knob.accepts(knob.stepped(setting, up)));
    }
}

/// Each chapter's first view, the still life if the chapter draws it; but not of chapters that trace no ray.
///
/// A slower way to the same picture hides in the noise of a clock; not in a count.
#[test]
fn every_chapter_traces_as_many_rays_as_the_book_says() {
    let size = UVec2::new(160, 120);
    let row = |stage: &Stage| {
        let view = stage.hero();
        let rays = Canvas::render(&(view.picture)(view.default_setting()), size).rays;
        let per_pixel = three_digits(rays as f64 / f64::from(size.x * size.y));
        (rays > 0).then(|| {
            format!(
                "| {} | {} | {per_pixel} |",
                stage.name,
                with_separators(rays)
            )
        })
    };
    let rows = |stages: &[&Stage]| {
        let rows: Vec<String> = stages.iter().copied().filter_map(row).collect();
        rows.join("\n")
    };
    let mut numbers = Numbers::default();
    numbers.note("chapters", rows(&STAGES));
    // The same rays, one by one and sixteen at once.
    numbers.note("packets", rows(&[&shadow_acne::STAGE, &packets::STAGE]));
    numbers.check("ray-counts");
}
