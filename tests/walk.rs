//! The walk through the picture, without its window: the walker, the frames, and that what is refined
//! is exact.

use canvas::{Canvas, Pixel, Stage};
use glam::{UVec2, Vec2, Vec3};
use interactive::views::{central, sample, samples, whole};
use interactive::{
    FOCAL_LENGTHS, MOST_HALVINGS, STAGE, WORLD, Walker, accumulating, block_of, halved,
    next_halvings, no_sums,
};
use proptest::prelude::*;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_the_eye, from_the_surface, trace};
use std::sync::Arc;
use std::time::Duration;

mod interactive_walk {
    use super::*;

    const SIZE: UVec2 = UVec2::new(97, 61);

    fn bits(canvas: &Canvas) -> Vec<[u32; 3]> {
        let bits = |light: &Vec3| light.to_array().map(f32::to_bits);
        canvas.light.iter().map(bits).collect()
    }

    /// Chapter 9's n × n sampler over chapter 10's trace: what the walk must arrive at.
    fn by_the_book(walker: Walker, n: u32, size: UVec2) -> Canvas {
        let (scene, camera) = (still_life_with_glass(GLASS, AIR), walker.camera());
        let light = move |pixel: Pixel| {
            anti_aliasing::regular(pixel, n, &|point| {
                let leaving = from_the_eye(camera.ray(point));
                trace(&scene, leaving, Reach::new(MAX_DEPTH), from_the_surface)
            })
        };
        Canvas::paint(&canvas::Picture::new(light), size)
    }

    fn elsewhere() -> Walker {
        "1,1.5,-5,-0.2,-0.1,1,1.5".parse().expect("a walker")
    }

    #[test]
    fn samples_add_up_to_the_books_picture_bit_for_bit() {
        for (walker, n) in [(Walker::START, 4), (elsewhere(), 3), (elsewhere(), 1)] {
            let expected = by_the_book(walker, n, SIZE);
            let setting = n as f32;
            assert_eq!(samples(0, setting), n * n);
            let sums = no_sums(SIZE);
            let (mut rays, mut last) = (0, None);
            for i in 0..n * n {
                let sample = sample(0, walker.camera(), setting, i);
                let mean = accumulating(sample, Arc::clone(&sums), i + 1);
                let canvas = Canvas::paint(&mean, SIZE);
                rays += canvas.rays;
                last = Some(canvas);
            }
            let last = last.expect("a sample");
            assert_eq!(bits(&last), bits(&expected), "{n}");
            assert_eq!(rays, expected.rays);
            let at_once = Canvas::paint(&whole(0, walker.camera(), setting), SIZE);
            assert_eq!(bits(&at_once), bits(&expected), "{n}");
        }
    }

    #[test]
    fn the_first_of_the_samples_is_shown_as_it_is() {
        let camera = Walker::START.camera();
        let first = sample(0, camera, 4.0, 0);
        let mean = accumulating(sample(0, camera, 4.0, 0), no_sums(SIZE), 1);
        let [first, mean] = [first, mean].map(|picture| Canvas::paint(&picture, SIZE));
        assert_eq!(bits(&first), bits(&mean));
    }

    /// Each stage of the walk, from where the book's camera stands, is its chapter's own picture.
    #[test]
    fn at_the_start_every_view_is_its_chapters_picture() {
        let chapters: [(usize, &Stage); 8] = [
            (1, &ray_casting::STAGE),
            (2, &sphere_hit::STAGE),
            (3, &plane_hit::STAGE),
            (4, &shadows::STAGE),
            (5, &shading::STAGE),
            (6, &reflection::STAGE),
            (7, &refraction::STAGE),
            (8, &fresnel::STAGE),
        ];
        for (index, stage) in chapters {
            let (view, hero) = (&STAGE.views[index], &stage.views[0]);
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
                let walked = Canvas::paint(&(view.picture)(setting), SIZE);
                let book = Canvas::paint(&(hero.picture)(its_setting), SIZE);
                assert_eq!(bits(&walked), bits(&book), "{} {setting}", view.name);
                let central = central(index, Walker::START.camera(), setting);
                assert_eq!(bits(&Canvas::paint(&central, SIZE)), bits(&book));
            }
        }
        let book = Canvas::paint(&(packets::STAGE.views[0].picture)(4.0), SIZE);
        let walked = Canvas::paint(&(STAGE.views[0].picture)(4.0), SIZE);
        assert_eq!(bits(&walked), bits(&book));
    }

    #[test]
    fn the_start_is_the_books_camera() {
        let book = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
        assert_eq!(Walker::START.camera(), book);
    }

    #[test]
    fn steps_are_level_and_as_long_as_they_say() {
        for start in [Walker::START, elsewhere()] {
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
    fn at_the_ends_the_walker_stays() {
        let mut walker = Walker::START;
        for _ in 0..1000 {
            walker = walker.turned(Vec2::new(0.0, 0.5));
        }
        assert!(walker.camera().forward.y <= 0.99);
        assert!(walker.camera().forward.y > 0.8);
        for _ in 0..1000 {
            walker = walker.moved(Vec3::new(0.0, 5.0, 0.0));
        }
        assert_eq!(walker.camera().eye.y.round(), WORLD - 3.0);
        // Up no more, but still aside.
        let aside = walker.moved(Vec3::new(1.0, 5.0, 0.0)).camera().eye;
        assert!(aside.distance(walker.camera().eye) > 0.99);
        let turned = walker.turned(Vec2::new(0.05, 0.5)).camera();
        assert!(turned.forward.distance(walker.camera().forward) > 0.01);
        let [shortest, longest] = FOCAL_LENGTHS;
        for _ in 0..1000 {
            walker = walker.zoomed(1.1);
        }
        assert!((longest / 1.1..=longest).contains(&walker.camera().focal_length));
        for _ in 0..1000 {
            walker = walker.zoomed(1.0 / 1.1);
        }
        assert!((shortest..=shortest * 1.1).contains(&walker.camera().focal_length));
    }

    #[test]
    fn what_is_no_camera_is_refused() {
        #[rustfmt::skip]
        let wrong = [
            "", "1", "0,2,-7,0,-1.1,7", "0,2,-7,0,-1.1,7,2,1", "a,2,-7,0,-1.1,7,2", "0,2,-7,0,0,0,2",
            "0,2,-7,0,1,0,2", "0,2,-7,0.01,1,0,2", "NaN,2,-7,0,-1,7,2", "0,inf,-7,0,-1,7,2", "0,2,1001,0,-1,7,2",
            "0,2,-7,0,-1,7,0", "0,2,-7,0,-1,7,-2", "0,2,-7,0,-1,7,17", "0,2,-7,0,NaN,7,2", "0,2,-7,0,inf,7,2",
            "0 2 -7 0 -1 7 2",
        ];
        for text in wrong {
            let line = text.parse::<Walker>().expect_err(text);
            assert!(line.contains("seven numbers"), "{line}");
        }
        let spaced = " 0, 2,-7, 0,-1.1,7, 2.5".parse::<Walker>();
        assert_eq!(spaced.map(|walker| walker.camera().focal_length), Ok(2.5));
    }

    #[test]
    fn a_frame_that_takes_too_long_is_halved_until_it_does_not() {
        let target = Duration::from_millis(33);
        // What a frame takes is in proportion to its pixels.
        let settle = |whole: Duration, mut halvings: u32| {
            for _ in 0..20 {
                halvings = next_halvings(halvings, whole / 4_u32.pow(halvings), target);
            }
            halvings
        };
        for start in [0, MOST_HALVINGS] {
            assert_eq!(settle(Duration::from_millis(1), start), 0);
            assert_eq!(settle(Duration::from_millis(70), start), 1);
            assert_eq!(settle(Duration::from_millis(1000), start), 3);
            assert_eq!(settle(Duration::from_secs(1000), start), MOST_HALVINGS);
        }
        // Between the target and a fifth of it, nothing changes.
        for ms in [7, 20, 33] {
            assert_eq!(next_halvings(2, Duration::from_millis(ms), target), 2);
        }
    }

    #[test]
    fn coarse_blocks_cover_the_picture_and_cost_what_they_say() {
        let picture = central(0, Walker::START.camera(), 4.0);
        let full = Canvas::paint(&picture, SIZE).rays as f64;
        for halvings in 0..=MOST_HALVINGS {
            let size = halved(SIZE, halvings);
            for (x, y) in [(0, 0), (96, 60), (33, 17)] {
                let block = block_of(Pixel { x, y, size: SIZE }, halvings);
                assert!(block.x < size.x && block.y < size.y && block.size == size);
            }
            let last = block_of(
                Pixel {
                    x: 96,
                    y: 60,
                    size: SIZE,
                },
                halvings,
            );
            assert_eq!((last.x + 1, last.y + 1), (size.x, size.y));
            let share = Canvas::paint(&picture, size).rays as f64 / full;
            let pixels = f64::from(size.element_product());
            let its_share = pixels / f64::from(SIZE.element_product());
            assert!(
                (0.5..2.0).contains(&(share / its_share)),
                "{halvings}: {share}"
            );
        }
    }

    /// A frame of the `coarse` view has one ray for a block, and its blocks are of one colour.
    #[test]
    fn the_coarse_view_shows_what_the_window_does() {
        let view = &STAGE.views[STAGE.find("coarse").expect("a view")];
        for halvings in [0, 2, MOST_HALVINGS] {
            let shown = Canvas::paint(&(view.picture)(halvings as f32), SIZE);
            let frame = Canvas::paint(
                &central(0, Walker::START.camera(), 4.0),
                halved(SIZE, halvings),
            );
            for y in 0..SIZE.y {
                for x in 0..SIZE.x {
                    let block = block_of(Pixel { x, y, size: SIZE }, halvings);
                    let shown = shown.light[(y * SIZE.x + x) as usize];
                    let light = frame.light[(block.y * block.size.x + block.x) as usize];
                    assert_eq!(shown, light);
                }
            }
        }
    }

    proptest! {
        #[test]
        fn a_walker_read_again_is_the_same_to_the_last_bit(
            eye in prop::array::uniform3(-WORLD..WORLD),
            forward in prop::array::uniform3(-1.0e3_f32..1.0e3),
            focal_length in 0.25_f32..16.0,
        ) {
            let (eye, forward) = (Vec3::from_array(eye), Vec3::from_array(forward));
            if let Some(walker) = Walker::new(eye, forward, focal_length) {
                let again: Walker = walker.to_string().parse().expect("a walker");
                prop_assert_eq!(again, walker);
                prop_assert_eq!(again.camera(), walker.camera());
            }
        }

        #[test]
        fn wherever_we_walk_the_picture_is_finite_and_the_books(
            steps in prop::array::uniform3(-8.0_f32..8.0),
            turns in prop::collection::vec(prop::array::uniform2(-1.0_f32..1.0), 0..6),
            zoom in 0.3_f32..3.0,
        ) {
            let mut walker = Walker::START.zoomed(zoom).moved(Vec3::from_array(steps));
            for turn in turns {
                walker = walker.turned(Vec2::from_array(turn));
            }
            let size = UVec2::new(21, 15);
            let walked = Canvas::paint(&whole(0, walker.camera(), 2.0), size);
            prop_assert_eq!(bits(&walked), bits(&by_the_book(walker, 2, size)));
        }
    }
}
