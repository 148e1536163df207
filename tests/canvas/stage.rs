//! Knobs, names and titles: what the window, the command line and the book are made from.

use ::canvas::{Knob, Picture, STAGE, Scale, Stage, View, folder_name};
use glam::Vec3;

fn knob(scale: Scale, min: f32, max: f32, default: f32) -> Knob {
    Knob {
        name: "distance",
        unit: "radii",
        min,
        max,
        default,
        scale,
        snapshot_settings: &[],
    }
}

fn view(knob: Option<Knob>) -> View {
    View {
        name: "far",
        caption: "",
        knob,
        picture: |_| Picture::new(|_| Vec3::ZERO),
    }
}

/// A thirty-second of the range from −2 to 14 is a half; twice, and half as much; one more,
/// and one less.
#[test]
fn a_knob_steps_as_its_scale_says() {
    for (scale, up, down) in [
        (Scale::Linear, 3.5, 2.5),
        (Scale::Logarithmic, 6.0, 1.5),
        (Scale::Whole, 4.0, 2.0),
    ] {
        let knob = knob(scale, -2.0, 14.0, 3.0);
        assert_eq!(
            (knob.stepped(3.0, true), knob.stepped(3.0, false)),
            (up, down)
        );
    }
}

/// A step is up or down, whatever the range, until it ends at the end of the range.
#[test]
fn a_step_goes_its_way_and_never_beyond_the_range() {
    for scale in [Scale::Linear, Scale::Logarithmic, Scale::Whole] {
        for (min, max) in [(1.0, 2.0), (1.0, 20.0), (3.0, 1000.0), (7.0, 70.0)] {
            let knob = knob(scale, min, max, min);
            for setting in (min as u32..=max as u32).map(|setting| setting as f32) {
                let [up, down] = [true, false].map(|up| knob.stepped(setting, up));
                assert!(up > setting || (up, setting) == (max, max));
                assert!(down < setting || (down, setting) == (min, min));
                assert!(up <= max && down >= min);
            }
        }
    }
}

/// Both ends are within the range; halves are no whole numbers.
#[test]
fn a_knob_accepts_its_range_and_nothing_else() {
    for scale in [Scale::Linear, Scale::Logarithmic, Scale::Whole] {
        let knob = knob(scale, 1.0, 20.0, 4.0);
        for setting in [1.0, 2.0, 20.0] {
            assert!(knob.accepts(setting), "{scale:?}: {setting}");
        }
        let beyond = [1.0_f32.next_down(), 20.0_f32.next_up(), 0.0, 21.0, -4.0];
        for setting in [&beyond[..], &[f32::INFINITY, f32::NAN]].concat() {
            assert!(!knob.accepts(setting), "{scale:?}: {setting}");
        }
        assert_eq!(knob.accepts(1.5), scale != Scale::Whole);
    }
}

#[test]
fn a_range_is_written_with_its_unit() {
    let distance = knob(Scale::Linear, 0.5, 20.0, 4.0);
    assert_eq!(distance.range(), "0.5 to 20 radii");
    let samples = Knob {
        unit: "",
        ..knob(Scale::Whole, 1.0, 20.0, 4.0)
    };
    assert_eq!(samples.range(), "1 to 20, whole");
}

/// The default setting is not named, and the name of a file holds no dot.
#[test]
fn a_picture_and_a_window_are_named_by_their_setting() {
    let with = view(Some(knob(Scale::Linear, 0.0, 9.0, 4.0)));
    let without = view(None);
    assert_eq!(
        (with.default_setting(), without.default_setting()),
        (4.0, 0.0)
    );
    let names = |view: &View, setting| {
        (
            STAGE.picture_name(view, setting),
            STAGE.title_of(view, setting),
        )
    };
    let expected = |name: &str, title: &str| (name.to_string(), title.to_string());
    assert_eq!(
        names(&with, 4.0),
        expected("00-canvas--far", "00-canvas | far | distance 4 radii")
    );
    assert_eq!(
        names(&with, 2.5),
        expected(
            "00-canvas--far--knob-2_5",
            "00-canvas | far | distance 2.5 radii"
        )
    );
    assert_eq!(
        names(&without, 2.5),
        expected("00-canvas--far", "00-canvas | far")
    );
    let pure = view(Some(Knob {
        unit: "",
        ..knob(Scale::Linear, 0.0, 9.0, 4.0)
    }));
    assert_eq!(STAGE.title_of(&pure, 4.0), "00-canvas | far | distance 4");
}

#[test]
fn a_view_is_found_by_its_name_alone() {
    static VIEWS: [View; 2] = [
        View {
            name: "near",
            caption: "",
            knob: None,
            picture: |_| Picture::new(|_| Vec3::ZERO),
        },
        View {
            name: "far",
            caption: "",
            knob: None,
            picture: |_| Picture::new(|_| Vec3::ZERO),
        },
    ];
    let stage = Stage {
        hero: "far",
        views: &VIEWS,
        ..STAGE
    };
    assert_eq!(stage.hero().name, "far");
    assert_eq!(stage.view("near").map(|view| view.name), Some("near"));
    assert!(stage.view("nea").is_none());
}

/// With the separators of any system, or none.
#[test]
fn a_folders_name_is_the_last_part_of_its_path() {
    for (path, name) in [
        ("/home/reader/00-canvas", "00-canvas"),
        (r"C:\books\00-canvas", "00-canvas"),
        ("00-canvas", "00-canvas"),
        ("/x", "x"),
        ("/", ""),
        ("", ""),
    ] {
        assert_eq!(folder_name(path), name);
    }
}
