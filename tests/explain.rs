//! Chapter 14's explained ray: what it says is what chapter 10 painted, and its path is drawn where it is.

#[expect(dead_code, reason = "nothing here is a share of a whole")]
mod numbers_file;

use ::canvas::{Picture, Pixel, rays_so_far};
use glam::{UVec2, Vec2, Vec3};
use interactive::explain::{End, Explained, Sight, explain};
use interactive::overlay;
use numbers_file::Numbers;
use plane_hit::{Object, Pattern, Plane, Shape};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use ray_casting::Camera;
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};
use refraction::{Body, Material};
use shading::Phong;
use shadow_acne::views::balls_on_a_planet;
use shadow_acne::{from_the_eye, from_the_surface};
use shadows::{PointLight, Scene};
use speed_and_accuracy::pictures::pixels;
use speed_and_accuracy::scenes::{Model, SCENES};
use sphere_hit::Sphere;

fn usual() -> Reach {
    Reach::new(MAX_DEPTH)
}

fn still_life() -> (Scene<Material>, Camera) {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    (still_life_with_glass(GLASS, AIR), camera)
}

fn bits(light: Vec3) -> [u32; 3] {
    light.to_array().map(f32::to_bits)
}

mod interactive_twin {
    use super::*;

    /// Every pixel has the light that the explanation arrives at, and took as many rays.
    fn assert_agrees(
        (scene, camera): &(Scene<Material>, Camera),
        picture: &Picture,
        reach: Reach,
        size: UVec2,
    ) {
        for pixel in pixels(size) {
            let before = rays_so_far();
            let light = picture.light(pixel);
            let rays = rays_so_far() - before;
            let explained = explain(scene, camera, pixel.centre(), reach);
            assert_eq!(bits(explained.light), bits(light), "{pixel:?}\n{explained}");
            assert_eq!(explained.rays() as u64, rays, "{pixel:?}\n{explained}");
            assert_adds_up(&explained);
        }
    }

    /// A ray's light is the surface's own, and that of the rays after it by their shares; and so are the
    /// weights.
    fn assert_adds_up(explained: &Explained) {
        let End::Met(met) = &explained.end else {
            return;
        };
        let mut light = met.own;
        for onward in &met.onward {
            light += onward.share * onward.light;
            let weight = explained.weight * onward.share;
            assert_eq!(onward.weight.to_bits(), weight.to_bits(), "{explained}");
            assert_adds_up(onward);
        }
        assert_eq!(bits(explained.light), bits(light), "{explained}");
    }

    fn by_chapter_10(stage_view: &str) -> Picture {
        let mut views = shadow_acne::STAGE.views.iter();
        let view = views.find(|view| view.name == stage_view).expect("a view");
        (view.picture)(view.default_setting())
    }

    #[test]
    fn agrees_with_every_pixel_of_the_still_life() {
        let picture = by_chapter_10("still-life");
        assert_agrees(&still_life(), &picture, usual(), UVec2::new(320, 240));
    }

    #[test]
    fn agrees_with_every_pixel_of_the_planet() {
        let picture = by_chapter_10("from-surface");
        let planet = balls_on_a_planet(1.0);
        assert_agrees(&planet, &picture, usual(), UVec2::new(320, 240));
    }

    /// The book's scenes, but for coloured glass, which is chapter 11's.
    #[test]
    fn agrees_with_every_scene_and_reach() {
        for book in SCENES {
            let (Model::Plain(scene), camera) = (book.make)() else {
                continue;
            };
            let sight = (scene, camera);
            for reach in [
                usual(),
                Reach::new(0),
                Reach::new(2),
                Reach {
                    least_weight: 0.1,
                    weight: 0.5,
                    ..usual()
                },
            ] {
                let scene = sight.0.clone();
                let picture = Picture::new(move |pixel| {
                    let leaving = from_the_eye(camera.ray(pixel.centre()));
                    shadow_acne::trace(&scene, leaving, reach, from_the_surface)
                });
                assert_agrees(&sight, &picture, reach, UVec2::new(80, 60));
            }
        }
    }

    /// A point sees a lamp as it does on the way from the lamp to it: a blocker is where it is said to be.
    #[test]
    fn names_what_is_in_the_way() {
        let (scene, camera) = still_life();
        let mut blocked = 0;
        for pixel in pixels(UVec2::new(160, 120)) {
            let explained = explain(&scene, &camera, pixel.centre(), usual());
            let End::Met(met) = &explained.end else {
                continue;
            };
            assert_eq!(met.lamps.len(), scene.lights.len());
            for (lamp, light) in met.lamps.iter().zip(&scene.lights) {
                assert!(std::ptr::eq(lamp.light, light));
                let Sight::Blocked(by, at) = lamp.sight else {
                    continue;
                };
                blocked += 1;
                let Shape::Sphere(sphere) = by.shape else {
                    panic!("the floor is below everything");
                };
                let height = at.distance(sphere.centre) - sphere.radius;
                assert!(height.abs() < 1e-5, "{height}");
                // On the way: the detour over it is none.
                let [to, from] = [met.point, light.position].map(|end| at.distance(end));
                let detour = to + from - met.point.distance(light.position);
                assert!(detour.abs() < 1e-5, "{detour}");
            }
        }
        assert!(blocked > 1000, "{blocked}");
    }
}

#[test]
fn interactive_trees_are_those_in_the_book() {
    let size = UVec2::new(800, 600);
    let (scene, camera) = still_life();
    let mut numbers = Numbers::default();
    for (name, x, y) in [
        ("glass", 525, 380),
        ("mirror", 478, 268),
        ("shadow", 640, 405),
    ] {
        let pixel = Pixel { x, y, size };
        let explained = explain(&scene, &camera, pixel.centre(), usual());
        numbers.note(name, explained.to_string().trim_end());
    }
    numbers.check("14-interactive-trees");
}

mod interactive_path {
    use super::*;

    const GREY: [u8; 3] = [128; 3];

    /// The path alone, on grey.
    fn drawn(explained: &Explained, camera: &Camera, size: UVec2) -> Vec<[u8; 3]> {
        // More levels than pixels: those are not to be touched.
        let count = size.element_product() as usize;
        let mut levels = vec![GREY; count + 3 * size.x as usize + 100];
        overlay::draw(explained, camera, size, &mut levels);
        let beyond = levels.split_off(count);
        assert!(beyond.iter().all(|&level| level == GREY), "beyond the end");
        levels
    }

    /// Where something is drawn.
    fn places(levels: &[[u8; 3]], size: UVec2) -> Vec<UVec2> {
        let places = pixels(size).zip(levels);
        places
            .filter(|&(_, &level)| level != GREY)
            .map(|(pixel, _)| UVec2::new(pixel.x, pixel.y))
            .collect()
    }

    fn at(levels: &[[u8; 3]], size: UVec2, x: f32, y: f32) -> [u8; 3] {
        levels[(y.round() as u32 * size.x + x.round() as u32) as usize]
    }

    fn matt(colour: Vec3, reflectivity: f32) -> Material {
        Material {
            phong: Phong {
                colour: Pattern::Plain(colour),
                ambient: 0.1,
                diffuse: 0.8,
                specular: 0.0,
                shininess: 1,
            },
            body: Body::Opaque { reflectivity },
        }
    }

    /// A floor so far below an eye that looks straight ahead.
    fn above_a_floor(height: f32, reflectivity: f32) -> (Scene<Material>, Camera) {
        let floor = Plane::new(-height * Vec3::Y, Vec3::Y).expect("a plane");
        let scene = Scene {
            objects: vec![Object {
                name: "floor",
                shape: Shape::Plane(floor),
                material: matt(Vec3::ONE, reflectivity),
            }],
            lights: Vec::new(),
            background: Vec3::ONE,
        };
        let camera = Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
        (scene, camera)
    }

    /// The eye's own ray is a point to the eye, and a line to whoever steps aside.
    #[test]
    fn from_elsewhere_the_eyes_ray_is_a_line() {
        let size = UVec2::new(101, 101);
        let (scene, camera) = above_a_floor(1.0, 0.0);
        let explained = explain(&scene, &camera, Vec2::new(0.0, 0.5), usual());
        let ring = places(&drawn(&explained, &camera, size), size);
        // Half of the picture's half up, in the middle, and no larger than the ring.
        assert!(ring.iter().all(|place| place.x.abs_diff(50) <= 12));
        assert!(ring.iter().all(|place| place.y.abs_diff(25) <= 12));
        for aside in [Vec3::NEG_X, Vec3::X] {
            let beside = Camera::new(aside, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
            let line = places(&drawn(&explained, &beside, size), size);
            // From the side that the eye is on, half down where it leaves the picture, to the same sky.
            let side = if aside == Vec3::X { 0 } else { 100 };
            assert!(line.iter().any(|place| place.x == side), "{line:?}");
            assert!(line.len() > ring.len() + 50, "{}", line.len());
        }
    }

    /// By symmetry: a floor mirrors the pixel at a height over the horizon to the one as far under it.
    #[test]
    fn a_mirrored_ray_ends_in_the_pixel_of_the_sky_that_it_shows() {
        let size = UVec2::new(200, 160);
        let (x, y) = (150, 130);
        let top = size.y - 1 - y;
        for height in [1e-9, 1.0, 1e9] {
            let (scene, camera) = above_a_floor(height, 0.9);
            let centre = Pixel { x, y, size }.centre();
            let explained = explain(&scene, &camera, centre, usual());
            let levels = drawn(&explained, &camera, size);
            let line = places(&levels, size);
            let line: Vec<_> = line.iter().filter(|place| place.y + 12 < y).collect();
            assert_eq!(line.iter().map(|place| place.y).min(), Some(top));
            assert!(line.iter().all(|place| place.x.abs_diff(x) <= 2));
            for y in top..y - 12 {
                let [r, g, b] = levels[(y * size.x + x) as usize];
                assert!(r > 200 && g < 150 && b > 200, "row {y}: {r} {g} {b}");
            }
        }
    }

    /// From (0, −1, 2) to a lamp behind the eye the way passes above the eye, through it, or below it: the line
    /// leaves the picture at the top, stays where it starts, or leaves at the bottom. Who looks back sees it
    /// come from there, if the lamp itself is in view; through the eye, that is all there is to see.
    #[test]
    fn what_is_behind_the_eye_is_not_drawn() {
        let size = UVec2::new(101, 101);
        // The start's row: 50.5 + 50.5 / 2 − 0.5; and with the ring around it.
        let (first, last) = (75 - 12, 75 + 12);
        for (lamp, rows, rows_back) in [
            (3.0, (0, last), None),
            (1.0, (first, last), Some((25, 25))),
            // A quarter over the middle: 50 − 50.5 / 4.
            (0.5, (first, 100), Some((37, 100))),
        ] {
            let (mut scene, camera) = above_a_floor(1.0, 0.0);
            scene.lights = vec![PointLight {
                position: Vec3::new(0.0, lamp, -2.0),
                intensity: 1.0,
            }];
            let explained = explain(&scene, &camera, Vec2::new(0.0, -0.5), usual());
            let back = Camera::new(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, 1.0);
            let back = back.expect("a camera");
            for (camera, rows) in [(camera, Some(rows)), (back, rows_back)] {
                let levels = drawn(&explained, &camera, size);
                let line = places(&levels, size);
                assert!(line.iter().all(|place| place.x.abs_diff(50) <= 12));
                let Some((first, last)) = rows else {
                    assert_eq!(line, []);
                    continue;
                };
                let within = |y| (first..=last).contains(&y);
                assert!(line.iter().all(|place| within(place.y)), "{lamp}: {line:?}");
                let middle = if last == 100 {
                    90..101
                } else {
                    first..last.min(60)
                };
                let is_drawn = |row: u32| levels[(row * 101 + 50) as usize] != GREY;
                assert!(middle.into_iter().all(is_drawn), "{lamp}");
            }
        }
    }

    /// Two lamps in view, one behind a ball; all places by hand, in units of half the picture's height.
    #[test]
    fn a_shadow_ray_ends_at_the_lamp_or_at_what_is_in_the_way() {
        let size = UVec2::new(300, 300);
        let (mut scene, camera) = above_a_floor(1.0, 0.0);
        let lamp = |x| PointLight {
            position: Vec3::new(x, 1.0, 2.0),
            intensity: 1.0,
        };
        scene.lights = vec![lamp(-1.0), lamp(1.0)];
        // In the middle of the way from (0, −1, 2) to the second lamp.
        let ball = Sphere::new(Vec3::new(0.5, 0.0, 2.0), 0.2).expect("a ball");
        scene.objects.push(Object {
            name: "ball",
            shape: Shape::Sphere(ball),
            material: matt(Vec3::ONE, 0.0),
        });
        let explained = explain(&scene, &camera, Vec2::new(0.0, -0.5), usual());
        let levels = drawn(&explained, &camera, size);
        // All is in the plane z = 2.
        let seen = |x: f32, y: f32| at(&levels, size, 149.5 + 75.0 * x, 149.5 - 75.0 * y);
        let on_the_way = |part: f32| [-part, part].map(|x| seen(x, 2.0 * part - 1.0));
        for part in [0.2, 0.3, 0.38] {
            let [[r, g, b], [r2, g2, b2]] = on_the_way(part);
            assert!(r > 150 && g > 150 && b < 110, "yellow: {r} {g} {b}");
            assert!(r2 > 130 && g2 < 110 && b2 < 110, "red: {r2} {g2} {b2}");
        }
        for part in [0.45, 0.6, 0.97] {
            let [[r, g, b], beyond] = on_the_way(part);
            assert!(r > 150 && g > 150 && b < 110, "yellow: {r} {g} {b}");
            assert_eq!(beyond, GREY);
        }
        assert_eq!(on_the_way(1.05), [GREY; 2]);
    }

    /// A number of any kind.
    fn any_number() -> impl Strategy<Value = f32> {
        prop_oneof![
            3 => -10.0..10.0_f32,
            1 => any::<f32>(),
            1 => prop::sample::select(&[0.0, f32::NAN, f32::INFINITY, f32::MAX, 1e-30][..]),
        ]
    }

    fn any_vector() -> impl Strategy<Value = Vec3> {
        [any_number(), any_number(), any_number()].prop_map(Vec3::from)
    }

    /// Whatever it may be, and where it may stand, also on a lamp or in a ball.
    fn any_camera() -> impl Strategy<Value = Camera> {
        let eye = || [-6.0..6.0_f32, 0.1..6.0_f32, -8.0..8.0_f32].prop_map(Vec3::from);
        let spots: Vec<_> = still_life().0.lights.iter().map(|l| l.position).collect();
        let eye = prop_oneof![4 => eye(), 1 => prop::sample::select(spots)];
        let unit = [-1.0..1.0_f32, -1.0..1.0_f32, -1.0..1.0_f32].prop_map(Vec3::from);
        (eye, unit, 0.3..5.0_f32).prop_filter_map("a camera", |(eye, forward, f)| {
            Camera::new(eye, forward, Vec3::Y, f)
        })
    }

    fn broken_camera() -> impl Strategy<Value = Camera> {
        let axes = [any_vector(), any_vector(), any_vector()];
        (any_vector(), axes, any_number()).prop_map(
            |(eye, [right, up, forward], focal_length)| Camera {
                eye,
                right,
                up,
                forward,
                focal_length,
            },
        )
    }

    fn any_pixel() -> impl Strategy<Value = Pixel> {
        let size = [1..200_u32, 1..200_u32].prop_map(UVec2::from);
        size.prop_flat_map(|size| {
            (0..size.x, 0..size.y).prop_map(move |(x, y)| Pixel { x, y, size })
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig {
            cases: 500,
            failure_persistence: None,
            rng_seed: RngSeed::Fixed(1968),
            ..ProptestConfig::default()
        })]

        /// The ring's middle, if all of the ring is in the picture.
        #[test]
        fn the_ring_is_around_the_pixel(camera in any_camera(), pixel in any_pixel()) {
            let Pixel { x, y, size } = pixel;
            let scene = Scene { objects: Vec::new(), ..still_life().0 };
            let explained = explain(&scene, &camera, pixel.centre(), usual());
            let drawn = places(&drawn(&explained, &camera, size), size);
            let is_whole = |at: u32, size| at >= 12 && at + 12 < size;
            if is_whole(x, size.x) && is_whole(y, size.y) {
                let [least, most] = [UVec2::min, UVec2::max]
                    .map(|of| drawn.iter().copied().reduce(of).expect("a ring"));
                prop_assert_eq!(least + most, 2 * UVec2::new(x, y));
            }
        }

        /// From wherever it is looked at: from where it was clicked, from elsewhere, and from nowhere.
        #[test]
        fn no_path_makes_it_panic(
            camera in any_camera(),
            other in any_camera(),
            broken in broken_camera(),
            pixel in any_pixel(),
            size in [0..100_u32, 0..100_u32].prop_map(UVec2::from),
        ) {
            let (scene, _) = still_life();
            let explained = explain(&scene, &camera, pixel.centre(), usual());
            let levels = drawn(&explained, &camera, pixel.size);
            prop_assert!(levels.iter().any(|&level| level != GREY));
            drawn(&explained, &other, size);
            drawn(&explained, &broken, size);
        }

        /// And wherever a scene leads it.
        #[test]
        fn no_point_makes_it_panic(
            camera in any_camera(),
            pixel in any_pixel(),
            point in any_vector(),
        ) {
            let (scene, _) = still_life();
            let mut explained = explain(&scene, &camera, pixel.centre(), usual());
            let End::Met(met) = &mut explained.end else {
                return Ok(());
            };
            met.point = point;
            for onward in &mut met.onward {
                onward.ray.origin = point;
                onward.weight = point.x;
            }
            drawn(&explained, &camera, pixel.size);
        }
    }
}
