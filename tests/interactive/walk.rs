//! The pose of the camera, the frames, and that the refined picture is exact.

use canvas::{Canvas, Picture, Pixel};
use glam::{UVec2, Vec2, Vec3};
use harness::bits;
use interactive::views::WalkView;
use interactive::{
    Accumulator, CameraPose, FOCAL_LENGTHS, MAX_LOD, PoseError, STAGE, WORLD, block_of,
    next_lod, size_at_lod,
};
use proptest::prelude::*;
use ray_casting::scene::still_life_camera;
use reflection::{MAX_DEPTH, PathBudget};
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_surface, trace, untracked};
use std::time::Duration;

const SIZE: UVec2 = UVec2::new(97, 61);

fn canvas_bits(canvas: &Canvas) -> Vec<[u32; 3]> {
    canvas.radiance.iter().map(bits).collect()
}

fn view(name: &str) -> &'static WalkView {
    WalkView::named(name).expect("a view")
}

/// Returns the picture that the walk must converge to: one ray at a time, n × n samples of
/// every pixel.
fn one_by_one(pose: CameraPose, n: u32, size: UVec2) -> Canvas {
    let (scene, camera) = (still_life_with_glass(GLASS, AIR), pose.camera());
    let budget = PathBudget::new(MAX_DEPTH);
    let radiance = move |pixel: Pixel| {
        anti_aliasing::regular(pixel, n, &|point| {
            trace(&scene, &untracked(camera.ray(point)), budget, from_surface)
        })
    };
    Canvas::render(&Picture::new(radiance), size)
}

fn elsewhere() -> CameraPose {
    "1,1.5,-5,-0.2,-0.1,1,1.5".parse().expect("a pose")
}

#[test]
fn samples_add_up_to_the_books_picture_bit_for_bit() {
    let view = view("still-life");
    for (pose, n) in [(CameraPose::START, 4), (elsewhere(), 3), (elsewhere(), 1)] {
        let expected = one_by_one(pose, n, SIZE);
        let (camera, setting) = (pose.camera(), n as f32);
        assert_eq!(view.samples(setting), n * n);
        let mut accumulator = Accumulator::new(SIZE);
        let (mut rays, mut last) = (0, None);
        for i in 0..n * n {
            let mut canvas = Canvas::render(&view.sample(camera, setting, i), SIZE);
            accumulator.add(&mut canvas);
            rays += canvas.rays;
            last = Some(canvas);
        }
        let last = last.expect("a sample");
        assert_eq!(canvas_bits(&last), canvas_bits(&expected), "{n}");
        assert_eq!(last.levels, expected.levels, "{n}");
        assert_eq!(rays, expected.rays);
        let at_once = Canvas::render(&(view.picture)(camera, setting), SIZE);
        assert_eq!(canvas_bits(&at_once), canvas_bits(&expected), "{n}");
    }
}

#[test]
fn the_first_of_the_samples_is_shown_as_it_is() {
    let sample = view("still-life").sample(CameraPose::START.camera(), 4.0, 0);
    let [first, mut mean] = [(); 2].map(|()| Canvas::render(&sample, SIZE));
    Accumulator::new(SIZE).add(&mut mean);
    assert_eq!(canvas_bits(&mean), canvas_bits(&first));
}

/// Each view of the walk, from where the book's camera stands, is its chapter's own picture.
#[test]
fn at_the_start_every_view_is_its_chapters_picture() {
    let chapters = [
        &ray_casting::STAGE,
        &sphere_hit::STAGE,
        &plane_hit::STAGE,
        &shadows::STAGE,
        &shading::STAGE,
        &reflection::STAGE,
        &refraction::STAGE,
        &fresnel::STAGE,
    ];
    let camera = CameraPose::START.camera();
    for (walk, stage) in WalkView::ALL.iter().zip(chapters) {
        let (view, hero) = (&walk.view, stage.hero());
        assert!(
            stage.name.ends_with(view.name),
            "{} {}",
            stage.name,
            view.name
        );
        let mut settings = vec![(view.default_setting(), hero.default_setting())];
        if let Some(knob) = &view.knob {
            settings.push((knob.min, knob.min));
        }
        for (setting, its_setting) in settings {
            let book = Canvas::render(&(hero.picture)(its_setting), SIZE);
            assert_eq!(walk.samples(setting), 1);
            for picture in [
                (view.picture)(setting),
                (walk.picture)(camera, setting),
                walk.sample(camera, setting, 0),
                walk.preview(camera, setting),
            ] {
                let walked = Canvas::render(&picture, SIZE);
                assert_eq!(canvas_bits(&walked), canvas_bits(&book), "{}", view.name);
            }
        }
    }
    let book = Canvas::render(&(packets::STAGE.hero().picture)(4.0), SIZE);
    let walked = Canvas::render(&(STAGE.hero().picture)(4.0), SIZE);
    assert_eq!(canvas_bits(&walked), canvas_bits(&book));
}

#[test]
fn every_view_of_the_stage_is_walked() {
    let names = STAGE.views.iter().map(|view| view.name);
    assert!(names.eq(WalkView::ALL.iter().map(|walk| walk.view.name)));
    assert_eq!(view("still-life").view.name, STAGE.hero);
}

#[test]
fn the_start_is_the_books_camera() {
    assert_eq!(CameraPose::START.camera(), still_life_camera());
}

#[test]
fn steps_are_level_and_as_long_as_they_say() {
    for start in [CameraPose::START, elsewhere()] {
        let eye = start.camera().eye;
        for (steps, height) in [
            (Vec3::X, 0.0),
            (Vec3::Y, 1.0),
            (Vec3::NEG_Z, 0.0),
            (Vec3::new(1.0, 2.0, -2.0), 2.0),
        ] {
            let moved = start.moved(steps).camera();
            let by = moved.eye - eye;
            assert!((by.length() - steps.length()).abs() < 1e-5, "{by}");
            assert!((by.y - height).abs() < 1e-5, "{by}");
            assert_eq!(moved.forward, start.camera().forward);
        }
        let ahead = start.moved(Vec3::Z).camera().eye - eye;
        assert!(ahead.dot(start.camera().forward) > 0.9);
        let right = start.moved(Vec3::X).camera().eye - eye;
        assert!((right.dot(start.camera().right) - 1.0).abs() < 1e-5);
    }
}

#[test]
fn a_turn_brings_what_it_names_to_the_middle() {
    let start = elsewhere();
    for point in [Vec2::new(0.5, 0.2), Vec2::new(-0.3, -0.4), Vec2::ZERO] {
        let seen_there = start.camera().ray(point).direction;
        let turned = start.turned(point).camera();
        let seen_in_the_middle = turned.ray(Vec2::ZERO).direction;
        assert!(seen_there.distance(seen_in_the_middle) < 1e-6);
        assert_eq!(turned.eye, start.camera().eye);
        // The horizon stays level.
        assert_eq!(turned.right.y, 0.0);
    }
}

#[test]
fn at_the_ends_the_pose_stays() {
    let mut pose = CameraPose::START;
    for _ in 0..1000 {
        pose = pose.turned(Vec2::new(0.0, 0.5));
    }
    assert!(pose.camera().forward.y <= 0.99);
    assert!(pose.camera().forward.y > 0.8);
    for _ in 0..1000 {
        pose = pose.moved(Vec3::new(0.0, 5.0, 0.0));
    }
    assert_eq!(pose.camera().eye.y.round(), WORLD - 3.0);
    // Up no more, but still aside.
    let aside = pose.moved(Vec3::new(1.0, 5.0, 0.0)).camera().eye;
    assert!(aside.distance(pose.camera().eye) > 0.99);
    let turned = pose.turned(Vec2::new(0.05, 0.5)).camera();
    assert!(turned.forward.distance(pose.camera().forward) > 0.01);
    let [shortest, longest] = FOCAL_LENGTHS;
    for _ in 0..1000 {
        pose = pose.zoomed(1.1);
    }
    assert!((longest / 1.1..=longest).contains(&pose.camera().focal_length));
    for _ in 0..1000 {
        pose = pose.zoomed(1.0 / 1.1);
    }
    assert!((shortest..=shortest * 1.1).contains(&pose.camera().focal_length));
}

#[test]
fn what_is_no_pose_is_refused() {
    use PoseError::{Direction, Eye, FocalLength, Syntax};
    for (text, reason) in [
        ("", Syntax),
        ("1", Syntax),
        ("0,2,-7,0,-1.1,7", Syntax),
        ("0,2,-7,0,-1.1,7,2,1", Syntax),
        ("a,2,-7,0,-1.1,7,2", Syntax),
        ("0 2 -7 0 -1 7 2", Syntax),
        ("NaN,2,-7,0,-1,7,2", Eye),
        ("0,inf,-7,0,-1,7,2", Eye),
        ("0,2,1001,0,-1,7,2", Eye),
        ("0,2,-7,0,0,0,2", Direction),
        ("0,2,-7,0,1,0,2", Direction),
        ("0,2,-7,0.01,1,0,2", Direction),
        ("0,2,-7,0,NaN,7,2", Direction),
        ("0,2,-7,0,inf,7,2", Direction),
        ("0,2,-7,0,-1,7,0", FocalLength),
        ("0,2,-7,0,-1,7,-2", FocalLength),
        ("0,2,-7,0,-1,7,17", FocalLength),
        ("0,2,-7,0,-1,7,NaN", FocalLength),
    ] {
        assert_eq!(text.parse::<CameraPose>(), Err(reason), "{text}");
        let line = reason.to_string();
        assert!(
            line.contains("seven numbers") && !line.contains('\n'),
            "{line}"
        );
    }
    let spaced = " 0, 2,-7, 0,-1.1,7, 2.5".parse::<CameraPose>();
    assert_eq!(spaced.map(|pose| pose.camera().focal_length), Ok(2.5));
}

#[test]
fn a_frame_that_takes_too_long_is_halved_until_it_does_not() {
    let target = Duration::from_millis(33);
    // A frame's time is proportional to its number of pixels.
    let settle = |whole: Duration, mut lod: u32| {
        for _ in 0..20 {
            lod = next_lod(lod, whole / 4_u32.pow(lod), target);
        }
        lod
    };
    for start in [0, MAX_LOD] {
        assert_eq!(settle(Duration::from_millis(1), start), 0);
        assert_eq!(settle(Duration::from_millis(70), start), 1);
        assert_eq!(settle(Duration::from_millis(1000), start), 3);
        assert_eq!(settle(Duration::from_secs(1000), start), MAX_LOD);
    }
    // Between the target and a fifth of it, nothing changes.
    for ms in [7, 20, 33] {
        assert_eq!(next_lod(2, Duration::from_millis(ms), target), 2);
    }
}

#[test]
fn coarse_blocks_cover_the_picture_and_cost_what_they_say() {
    let picture = view("still-life").preview(CameraPose::START.camera(), 4.0);
    let full = Canvas::render(&picture, SIZE).rays as f64;
    for lod in 0..=MAX_LOD {
        let size = size_at_lod(SIZE, lod);
        for pixel in Pixel::all(SIZE) {
            let block = block_of(pixel, lod);
            assert!(block.x < size.x && block.y < size.y && block.size == size);
        }
        let last = Pixel::all(SIZE).last().expect("a pixel");
        let last = block_of(last, lod);
        assert_eq!((last.x + 1, last.y + 1), (size.x, size.y));
        let cost = Canvas::render(&picture, size).rays as f64 / full;
        let pixels = f64::from(size.element_product());
        let fraction = pixels / f64::from(SIZE.element_product());
        assert!((0.5..2.0).contains(&(cost / fraction)), "{lod}: {cost}");
    }
}

/// A frame of the `coarse` view has one ray for a block, and its blocks are of one colour.
#[test]
fn the_coarse_view_shows_what_the_window_does() {
    let preview = view("still-life").preview(CameraPose::START.camera(), 4.0);
    for lod in [0, 2, MAX_LOD] {
        let picture = (view("coarse").view.picture)(lod as f32);
        let shown = Canvas::render(&picture, SIZE);
        let frame = Canvas::render(&preview, size_at_lod(SIZE, lod));
        for (pixel, shown) in Pixel::all(SIZE).zip(&shown.radiance) {
            let Pixel { x, y, size } = block_of(pixel, lod);
            assert_eq!(*shown, frame.radiance[(y * size.x + x) as usize]);
        }
    }
}

proptest! {
    #[test]
    fn a_pose_read_again_is_the_same_to_the_last_bit(
        eye in prop::array::uniform3(-WORLD..WORLD),
        forward in prop::array::uniform3(-1.0e3_f32..1.0e3),
        focal_length in 0.25_f32..16.0,
    ) {
        let (eye, forward) = (Vec3::from_array(eye), Vec3::from_array(forward));
        if let Ok(pose) = CameraPose::new(eye, forward, focal_length) {
            let again: CameraPose = pose.to_string().parse().expect("a pose");
            prop_assert_eq!(again, pose);
            prop_assert_eq!(again.camera(), pose.camera());
        }
    }

    #[test]
    fn wherever_we_walk_the_picture_is_finite_and_the_books(
        steps in prop::array::uniform3(-8.0_f32..8.0),
        turns in prop::collection::vec(prop::array::uniform2(-1.0_f32..1.0), 0..6),
        zoom in 0.3_f32..3.0,
    ) {
        let mut pose = CameraPose::START.zoomed(zoom).moved(Vec3::from_array(steps));
        for turn in turns {
            pose = pose.turned(Vec2::from_array(turn));
        }
        let size = UVec2::new(21, 15);
        let walked = (view("still-life").picture)(pose.camera(), 2.0);
        let walked = Canvas::render(&walked, size);
        prop_assert_eq!(canvas_bits(&walked), canvas_bits(&one_by_one(pose, 2, size)));
    }
}
