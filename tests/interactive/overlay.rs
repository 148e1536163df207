//! The path of an explained ray: it is drawn where it is.

use canvas::Pixel;
use glam::{UVec2, Vec2, Vec3};
use harness::cases;
use interactive::explain::{Explained, Outcome, budget, explain};
use interactive::overlay::Overlay;
use plane_hit::{Object, Shape, Texture};
use proptest::prelude::*;
use ray_casting::Camera;
use refraction::scene::{AIR, GLASS, still_life_with_glass};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{PointLight, Scene};

fn still_life() -> Scene<Material> {
    still_life_with_glass(GLASS, AIR)
}

const GREY: [u8; 3] = [128; 3];

/// The path alone, on grey: drawn at once or span by span, it is the same.
fn drawn(explained: &Explained, camera: &Camera, size: UVec2) -> Vec<[u8; 3]> {
    // More levels than pixels: those are not to be touched.
    let count = size.element_product() as usize;
    let mut levels = vec![GREY; count + 3 * size.x as usize + 100];
    let overlay = Overlay::new(explained, camera, size);
    overlay.draw(size, &mut levels);
    let beyond = levels.split_off(count);
    assert!(beyond.iter().all(|&level| level == GREY), "beyond the end");
    let mut by_spans = vec![GREY; count];
    for (first, span) in Pixel::all(size).step_by(7).zip(by_spans.chunks_mut(7)) {
        overlay.draw_span(first, span);
    }
    assert!(by_spans == levels, "by spans");
    levels
}

/// Returns the pixels in which something is drawn.
fn positions(levels: &[[u8; 3]], size: UVec2) -> Vec<UVec2> {
    let positions = Pixel::all(size).zip(levels);
    positions
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
            colour: Texture::Solid(colour),
            ambient: 0.1,
            diffuse: 0.8,
            specular: 0.0,
            shininess: 1,
        },
        optics: Optics::Opaque { reflectivity },
    }
}

/// A floor so far below an eye that looks straight ahead.
fn above_a_floor(height: f32, reflectivity: f32) -> (Scene<Material>, Camera) {
    let scene = Scene {
        objects: vec![Object {
            name: "floor",
            shape: Shape::plane(-height * Vec3::Y, Vec3::Y),
            material: matt(Vec3::ONE, reflectivity),
        }],
        lights: Vec::new(),
        background: Vec3::ONE,
    };
    let camera = Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
    (scene, camera)
}

/// The eye's own ray is a point to the eye, and a line from anywhere else.
#[test]
fn from_elsewhere_the_eyes_ray_is_a_line() {
    let size = UVec2::new(101, 101);
    let (scene, camera) = above_a_floor(1.0, 0.0);
    let explained = explain(&scene, &camera, Vec2::new(0.0, 0.5), budget());
    let ring = positions(&drawn(&explained, &camera, size), size);
    // Half of the picture's half up, in the middle, and no larger than the ring.
    assert!(ring.iter().all(|position| position.x.abs_diff(50) <= 12));
    assert!(ring.iter().all(|position| position.y.abs_diff(25) <= 12));
    for aside in [Vec3::NEG_X, Vec3::X] {
        let beside = Camera::new(aside, Vec3::Z, Vec3::Y, 1.0).expect("a camera");
        let line = positions(&drawn(&explained, &beside, size), size);
        // From the side that the eye is on, half down where it leaves the picture, to the same sky.
        let side = if aside == Vec3::X { 0 } else { 100 };
        assert!(line.iter().any(|position| position.x == side), "{line:?}");
        assert!(line.len() > ring.len() + 50, "{}", line.len());
    }
}

/// By symmetry: a floor reflects the pixel at a height over the horizon to the one as far under it.
#[test]
fn a_reflected_ray_ends_in_the_pixel_of_the_sky_that_it_shows() {
    let size = UVec2::new(200, 160);
    let (x, y) = (150, 130);
    let top = size.y - 1 - y;
    for height in [1e-9, 1.0, 1e9] {
        let (scene, camera) = above_a_floor(height, 0.9);
        let centre = Pixel { x, y, size }.centre();
        let explained = explain(&scene, &camera, centre, budget());
        let levels = drawn(&explained, &camera, size);
        let line = positions(&levels, size);
        let line: Vec<_> = line.iter().filter(|position| position.y + 12 < y).collect();
        assert_eq!(line.iter().map(|position| position.y).min(), Some(top));
        assert!(line.iter().all(|position| position.x.abs_diff(x) <= 2));
        for y in top..y - 12 {
            let [r, g, b] = levels[(y * size.x + x) as usize];
            assert!(r > 200 && g < 150 && b > 200, "row {y}: {r} {g} {b}");
        }
    }
}

/// From (0, −1, 2) to a light behind the eye the line passes above the eye, through it, or below it: the line
/// leaves the picture at the top, stays where it starts, or leaves at the bottom. Who looks back sees it
/// come from there, if the light itself is in view; through the eye, that is all there is to see.
#[test]
fn what_is_behind_the_eye_is_not_drawn() {
    let size = UVec2::new(101, 101);
    // The start's row: 50.5 + 50.5 / 2 − 0.5; and with the ring around it.
    let (first, last) = (75 - 12, 75 + 12);
    for (light, rows, rows_back) in [
        (3.0, (0, last), None),
        (1.0, (first, last), Some((25, 25))),
        // A quarter over the middle: 50 − 50.5 / 4.
        (0.5, (first, 100), Some((37, 100))),
    ] {
        let (mut scene, camera) = above_a_floor(1.0, 0.0);
        scene.lights = vec![PointLight {
            position: Vec3::new(0.0, light, -2.0),
            intensity: 1.0,
        }];
        let explained = explain(&scene, &camera, Vec2::new(0.0, -0.5), budget());
        let back = Camera::new(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y, 1.0);
        let back = back.expect("a camera");
        for (camera, rows) in [(camera, Some(rows)), (back, rows_back)] {
            let levels = drawn(&explained, &camera, size);
            let line = positions(&levels, size);
            assert!(line.iter().all(|position| position.x.abs_diff(50) <= 12));
            let Some((first, last)) = rows else {
                assert_eq!(line, []);
                continue;
            };
            let within = |y| (first..=last).contains(&y);
            assert!(
                line.iter().all(|position| within(position.y)),
                "{light}: {line:?}"
            );
            let middle = if last == 100 {
                90..101
            } else {
                first..last.min(60)
            };
            let is_drawn = |row: u32| levels[(row * 101 + 50) as usize] != GREY;
            assert!(middle.into_iter().all(is_drawn), "{light}");
        }
    }
}

/// Two lights in view, one behind a ball; all positions by hand, in units of half the picture's height.
#[test]
fn a_shadow_ray_ends_at_the_light_or_at_what_is_in_the_way() {
    let size = UVec2::new(300, 300);
    let (mut scene, camera) = above_a_floor(1.0, 0.0);
    let light = |x| PointLight {
        position: Vec3::new(x, 1.0, 2.0),
        intensity: 1.0,
    };
    scene.lights = vec![light(-1.0), light(1.0)];
    // In the middle between (0, −1, 2) to the second light.
    let ball = Shape::sphere(Vec3::new(0.5, 0.0, 2.0), 0.2);
    scene.objects.push(Object {
        name: "ball",
        shape: ball,
        material: matt(Vec3::ONE, 0.0),
    });
    let explained = explain(&scene, &camera, Vec2::new(0.0, -0.5), budget());
    let levels = drawn(&explained, &camera, size);
    // All is in the plane z = 2.
    let seen = |x: f32, y: f32| at(&levels, size, 149.5 + 75.0 * x, 149.5 - 75.0 * y);
    let between = |part: f32| [-part, part].map(|x| seen(x, 2.0 * part - 1.0));
    for part in [0.2, 0.3, 0.38] {
        let [[r, g, b], [r2, g2, b2]] = between(part);
        assert!(r > 150 && g > 150 && b < 110, "yellow: {r} {g} {b}");
        assert!(r2 > 130 && g2 < 110 && b2 < 110, "red: {r2} {g2} {b2}");
    }
    for part in [0.45, 0.6, 0.97] {
        let [[r, g, b], beyond] = between(part);
        assert!(r > 150 && g > 150 && b < 110, "yellow: {r} {g} {b}");
        assert_eq!(beyond, GREY);
    }
    assert_eq!(between(1.05), [GREY; 2]);
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

/// Returns cameras in any position and direction, also on a light or in a ball.
fn any_camera() -> impl Strategy<Value = Camera> {
    let eye = || [-6.0..6.0_f32, 0.1..6.0_f32, -8.0..8.0_f32].prop_map(Vec3::from);
    let spots: Vec<_> = still_life().lights.iter().map(|l| l.position).collect();
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
    #![proptest_config(cases(500))]

    /// The ring's middle, if all of the ring is in the picture.
    #[test]
    fn the_ring_is_around_the_pixel(camera in any_camera(), pixel in any_pixel()) {
        let Pixel { x, y, size } = pixel;
        let scene = Scene { objects: Vec::new(), ..still_life() };
        let explained = explain(&scene, &camera, pixel.centre(), budget());
        let drawn = positions(&drawn(&explained, &camera, size), size);
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
        let scene = still_life();
        let explained = explain(&scene, &camera, pixel.centre(), budget());
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
        let scene = still_life();
        let mut explained = explain(&scene, &camera, pixel.centre(), budget());
        let Outcome::Hit(hit) = &mut explained.outcome else {
            return Ok(());
        };
        hit.at.point = point;
        for next in &mut hit.secondary {
            next.ray.origin = point;
            next.throughput = point.x;
        }
        drawn(&explained, &camera, pixel.size);
    }
}
