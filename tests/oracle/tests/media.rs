//! Dielectrics that overlap, nest and touch.
//!
//! Along a line that is perpendicular to all surfaces no light is bent, and what is seen is a
//! closed form: that of a stack of plates. In a white sky, all that is clear and absorbs nothing is
//! invisible.

use crate::scenes::{ball, below, clear, object, ray, scene};
use glam::{DVec3, dvec3};
use harness::{cases, unit_vector};
use oracle::{Limit, Object, Optics, PointLight, Scene, trace};
use proptest::prelude::*;

/// The reflectance and the transmittance of a stack of plates for light from either side: from the
/// eye's, and from beyond.
#[derive(Clone, Copy)]
struct Stack {
    reflectance: [f64; 2],
    transmittance: [f64; 2],
}

impl Stack {
    fn interface(n1: f64, n2: f64) -> Self {
        let r = ((n1 - n2) / (n1 + n2)) * ((n1 - n2) / (n1 + n2));
        Self {
            reflectance: [r; 2],
            transmittance: [1.0 - r; 2],
        }
    }

    fn layer(transmittance: f64) -> Self {
        Self {
            reflectance: [0.0; 2],
            transmittance: [transmittance; 2],
        }
    }

    /// Returns this stack with another behind it: the sum of the series of bounces between the two.
    fn then(self, next: Self) -> Self {
        let [r1, back1] = self.reflectance;
        let [r2, back2] = next.reflectance;
        let [t1, out1] = self.transmittance;
        let [t2, out2] = next.transmittance;
        let series = 1.0 / (1.0 - back1 * r2);
        Self {
            reflectance: [
                r1 + t1 * r2 * out1 * series,
                back2 + out2 * back1 * t2 * series,
            ],
            transmittance: [t1 * t2 * series, out1 * out2 * series],
        }
    }
}

/// Returns the light from a white sky on both sides of plates, given by their indices, absorptions
/// and thicknesses; the first one and the last one never end, and the first absorbs nothing.
#[expect(clippy::disallowed_methods, reason = "the closed form")]
fn through(plates: &[[f64; 3]]) -> f64 {
    let stacks = plates.windows(2).map(|pair| {
        let [index, absorption, thickness] = pair[1];
        let layer = if absorption == 0.0 {
            1.0
        } else {
            (-absorption * thickness).exp()
        };
        Stack::interface(pair[0][0], index).then(Stack::layer(layer))
    });
    let stack = stacks.reduce(Stack::then).expect("two plates");
    stack.reflectance[0] + stack.transmittance[0]
}

const ENDLESS: f64 = f64::INFINITY;
const AIR: [f64; 3] = [1.0, 0.0, ENDLESS];

/// Returns what is seen straight down, from 9 above the world's origin.
fn straight_down(scene: &Scene) -> f64 {
    let limit = Limit {
        bounces: 100,
        min_throughput: 1e-13,
    };
    trace(scene, &ray(9.0 * DVec3::Y, DVec3::NEG_Y), limit).x
}

fn assert_plates(objects: Vec<Object>, plates: &[[f64; 3]]) {
    let [seen, exact] = [straight_down(&scene(objects, DVec3::ONE)), through(plates)];
    assert!((seen - exact).abs() <= 1e-10, "{seen} for {exact}");
}

fn tinted(shape: oracle::Shape, index: f64, absorption: f64) -> Object {
    clear(shape, index, DVec3::splat(absorption))
}

/// Water of index 1 over a bottom at a depth of 2: e⁻¹ of a glowing one, and of a matte one under a
/// lamp, whose light comes through the water as well, e⁻².
#[test]
#[expect(clippy::disallowed_methods, reason = "the closed form")]
fn a_half_space_of_water_absorbs_down_to_its_bottom() {
    let water = tinted(below(0.0), 1.0, 0.5);
    let bottom = object(below(-2.0), 1.0, Optics::Opaque(0.0));
    let glowing = scene(vec![water, bottom], DVec3::ZERO);
    assert!((straight_down(&glowing) - (-1.0_f64).exp()).abs() <= 1e-15);
    let mut matte = glowing;
    matte.objects[1].surface.ambient = 0.0;
    matte.objects[1].surface.diffuse = 1.0;
    matte.lights = vec![PointLight {
        position: 5.0 * DVec3::Y,
        intensity: 1.0,
    }];
    assert!((straight_down(&matte) - (-2.0_f64).exp()).abs() <= 1e-15);
}

/// The endless water below absorbs all that goes down in it, and nothing if it is colourless.
#[test]
fn no_light_comes_out_of_endless_water_that_absorbs() {
    for (absorption, exact) in [(0.5, 0.0), (0.0, 1.0)] {
        let water = tinted(below(0.0), 1.0, absorption);
        assert_eq!(straight_down(&scene(vec![water], DVec3::ONE)), exact);
    }
    assert_plates(
        vec![tinted(below(0.0), 1.33, 0.5)],
        &[AIR, [1.33, 0.5, ENDLESS]],
    );
}

/// Level with the surface the way in the water is as long as it is to the wall, and above it nothing is absorbed.
#[test]
#[expect(clippy::disallowed_methods, reason = "the closed form")]
fn a_ray_level_with_the_water_stays_in_it() {
    let wall = object(ball(3.0 * DVec3::X, 1.0), 1.0, Optics::Opaque(0.0));
    let scene = scene(vec![tinted(below(0.0), 1.33, 0.5), wall], DVec3::ZERO);
    let limit = Limit {
        bounces: 0,
        min_throughput: 0.0,
    };
    for (height, exact) in [(-0.6, (-0.5 * 2.2_f64).exp()), (0.6, 1.0)] {
        let level = ray(height * DVec3::Y, DVec3::X);
        let seen = trace(&scene, &level, limit).x;
        assert!((seen - exact).abs() <= 1e-15, "{height}: {seen}");
    }
}

/// A bubble of radius ½ in a ball of radius 1, all of index 1: half of the way is in the ball, e⁻¹.
#[test]
#[expect(clippy::disallowed_methods, reason = "the closed form")]
fn a_bubble_displaces_the_medium_around_it() {
    let objects = vec![
        tinted(ball(DVec3::ZERO, 1.0), 1.0, 1.0),
        tinted(ball(DVec3::ZERO, 0.5), 1.0, 0.0),
    ];
    let seen = straight_down(&scene(objects, DVec3::ONE));
    assert!((seen - (-1.0_f64).exp()).abs() <= 1e-15, "{seen}");
}

/// The same in glass, where the bubble has two interfaces of its own; and the other way round nothing is
/// left of it, for the later ball displaces it.
#[test]
fn a_bubble_in_tinted_glass_has_interfaces_with_the_glass() {
    let glass = tinted(ball(DVec3::ZERO, 1.0), 1.5, 1.0);
    let bubble = tinted(ball(DVec3::ZERO, 0.5), 1.0, 0.0);
    let shell = [1.5, 1.0, 0.5];
    let hollow = [AIR, shell, [1.0, 0.0, 1.0], shell, AIR];
    assert_plates(vec![glass, bubble], &hollow);
    assert_plates(vec![bubble, glass], &[AIR, [1.5, 1.0, 2.0], AIR]);
}

/// Two balls of one glass are one body where they overlap: (1 − R)/(1 + R) = 0.9231 of the light of the sky
/// beyond.
#[test]
fn balls_of_one_glass_have_no_interface_between_them() {
    let upper = tinted(ball(0.5 * DVec3::Y, 1.0), 1.5, 0.0);
    let lower = tinted(ball(-0.5 * DVec3::Y, 1.0), 1.5, 0.0);
    // The sky is black, and there is a white floor below.
    let floor = object(below(-5.0), 1.0, Optics::Opaque(0.0));
    for pair in [[upper, lower], [lower, upper]] {
        let scene = scene([&pair[..], &[floor]].concat(), DVec3::ZERO);
        let seen = straight_down(&scene);
        assert!((seen - 0.96 / 1.04).abs() <= 1e-12, "{seen}");
    }
}

/// Two lenses of one tinted glass absorb over the length of both together; of two tints, the later lens has
/// the part in the middle; of two glasses, it has the interface.
#[test]
fn the_later_of_two_lenses_has_the_part_in_both() {
    let lens =
        |y: f64, index, absorption| tinted(ball(y * DVec3::Y, 1.0), index, absorption);
    let [upper, lower] = [lens(0.5, 1.5, 0.25), lens(-0.5, 1.5, 0.25)];
    for pair in [[upper, lower], [lower, upper]] {
        assert_plates(pair.to_vec(), &[AIR, [1.5, 0.25, 3.0], AIR]);
    }
    for index in [1.5, 1.7] {
        let [upper, lower] = [lens(0.5, 1.5, 0.25), lens(-0.5, index, 1.0)];
        let [long, short] = [2.0, 1.0];
        let plates = [AIR, [1.5, 0.25, short], [index, 1.0, long], AIR];
        assert_plates(vec![upper, lower], &plates);
        let plates = [AIR, [1.5, 0.25, long], [index, 1.0, short], AIR];
        assert_plates(vec![lower, upper], &plates);
    }
}

/// A ball half in the water, which is endless or has a bottom: the ball's lower interface is with the water. If
/// the water is later, it is the ball that ends at the water's surface.
#[test]
fn a_ball_of_glass_half_in_the_water_has_water_below() {
    let glass = tinted(ball(DVec3::ZERO, 1.0), 1.5, 0.25);
    let water = tinted(below(0.0), 1.33, 0.125);
    let wet = [1.33, 0.125, ENDLESS];
    assert_plates(vec![water, glass], &[AIR, [1.5, 0.25, 2.0], wet]);
    assert_plates(vec![glass, water], &[AIR, [1.5, 0.25, 1.0], wet]);
    // Air from a depth of 3 on: the water is a layer.
    let air = tinted(below(-3.0), 1.0, 0.0);
    let layers = [AIR, [1.5, 0.25, 2.0], [1.33, 0.125, 2.0], AIR];
    assert_plates(vec![water, glass, air], &layers);
}

/// A ball of ice on its way out of a ball of drink: the ice is half in the air and half in the drink.
#[test]
fn ice_half_out_of_its_drink_has_air_above_and_drink_below() {
    let drink = tinted(ball(-2.0 * DVec3::Y, 2.0), 1.33, 0.5);
    let ice = tinted(ball(DVec3::ZERO, 0.75), 1.31, 0.0);
    let plates = [AIR, [1.31, 0.0, 1.5], [1.33, 0.5, 3.25], AIR];
    assert_plates(vec![drink, ice], &plates);
    let plates = [AIR, [1.31, 0.0, 0.75], [1.33, 0.5, 4.0], AIR];
    assert_plates(vec![ice, drink], &plates);
}

/// Nothing is between balls in touch, half-spaces back to back, and two bodies at one place.
#[test]
fn bodies_in_touch_have_one_interface() {
    let plates = [AIR, [1.5, 0.25, 2.0], [1.7, 0.5, 2.0], AIR];
    // At most heights the balls touch but for a rounding.
    for height in [0.0, 0.1, -0.3, 1.0 / 3.0, -50.0] {
        let upper = tinted(ball((height + 1.0) * DVec3::Y, 1.0), 1.5, 0.25);
        let lower = tinted(ball((height - 1.0) * DVec3::Y, 1.0), 1.7, 0.5);
        assert_plates(vec![upper, lower], &plates);
        assert_plates(vec![lower, upper], &plates);
    }
    let water = tinted(below(0.0), 1.33, 0.0);
    let mut sky = water;
    sky.shape = oracle::Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::NEG_Y,
    };
    for pair in [[water, sky], [sky, water]] {
        assert_eq!(straight_down(&scene(pair.to_vec(), DVec3::ONE)), 1.0);
    }
    let glass = ball(DVec3::ZERO, 1.0);
    let twice = vec![tinted(glass, 1.7, 0.5), tinted(glass, 1.5, 0.25)];
    assert_plates(twice, &[AIR, [1.5, 0.25, 2.0], AIR]);
}

/// An opaque ball displaces the water and the glass that it is in.
#[test]
#[expect(clippy::disallowed_methods, reason = "the closed form")]
fn an_opaque_ball_displaces_everything() {
    let core = object(ball(DVec3::ZERO, 0.5), 1.0, Optics::Opaque(0.0));
    let glass = tinted(ball(DVec3::ZERO, 1.0), 1.0, 1.0);
    let same = tinted(ball(DVec3::ZERO, 0.5), 1.5, 7.0);
    for objects in [
        vec![core, glass],
        vec![glass, core],
        vec![core, glass, same],
        vec![same, glass, core],
    ] {
        let seen = straight_down(&scene(objects, DVec3::ZERO));
        assert!((seen - (-0.5_f64).exp()).abs() <= 1e-15, "{seen}");
    }
}

/// A ray that only touches a mirror ball is reflected into the white sky.
#[test]
fn a_tangent_ray_leaves_a_mirror_ball() {
    let scene = scene(
        vec![object(ball(DVec3::ZERO, 1.0), 0.0, Optics::Opaque(1.0))],
        DVec3::ONE,
    );
    let limit = Limit {
        bounces: 1,
        min_throughput: 0.0,
    };
    let mut hits = 0;
    for i in 0..10_000 {
        let towards = dvec3(1.0, 0.3 + f64::from(i) * 1e-4, -0.7).normalize();
        let ray = ray(towards.any_orthonormal_vector() - 3.0 * towards, towards);
        hits += u32::from(scene.intersect(&ray).is_some());
        assert_eq!(trace(&scene, &ray, limit), DVec3::ONE);
    }
    assert!(hits > 1000, "{hits}");
}

/// Returns bodies of the given indices of refraction, shiny, so that each interface shows: a half-space and
/// balls that overlap.
fn bodies(
    centres: &[DVec3],
    radii: &[f64],
    indices: &[f64],
    absorption: f64,
) -> Vec<Object> {
    let balls = centres.iter().zip(radii).map(|(&c, &r)| ball(c, r));
    let shapes = [below(0.0)].into_iter().chain(balls);
    let objects = shapes.zip(indices).map(|(shape, &index)| {
        let mut object = tinted(shape, index, absorption);
        object.surface.specular = 0.5;
        object.surface.shininess = 3;
        object
    });
    objects.collect()
}

/// Returns a ray from outside towards the bodies.
fn towards(from: DVec3, aim: DVec3) -> oracle::Ray {
    ray(8.0 * from, (aim - 8.0 * from).normalize())
}

proptest! {
    #![proptest_config(cases(1_000))]

    /// In a white sky all that is clear and absorbs nothing is invisible, but for the rays that are not
    /// followed: each is at most 10⁻⁷ of the light.
    #[test]
    fn clear_bodies_are_invisible_in_a_white_sky(
        centres in [unit_vector(), unit_vector(), unit_vector()],
        radii in [0.3..1.5_f64, 0.3..1.5_f64, 0.3..1.5_f64],
        indices in [1.0..1.8_f64, 1.0..1.8_f64, 1.0..1.8_f64, 1.0..1.8_f64],
        from in unit_vector(), aim in unit_vector(),
    ) {
        let scene = scene(bodies(&centres, &radii, &indices, 0.0), DVec3::ONE);
        let limit = Limit { bounces: 200, min_throughput: 1e-7 };
        let seen = trace(&scene, &towards(from, aim), limit).x;
        prop_assert!((0.99..=1.0 + 1e-12).contains(&seen), "{seen}");
    }

    /// The order of bodies of one medium does not matter, nor that there is one more inside another: not for
    /// what is seen through them, and not for their highlights.
    #[test]
    fn bodies_of_one_medium_are_one_body(
        centres in [unit_vector(), unit_vector(), unit_vector()],
        radii in [0.3..1.5_f64, 0.3..1.5_f64, 0.3..1.5_f64],
        from in unit_vector(), aim in unit_vector(), lamp in unit_vector(),
    ) {
        let objects = bodies(&centres, &radii, &[1.5; 4], 0.25);
        let mut scene = scene(objects, DVec3::ONE);
        scene.lights = vec![PointLight { position: 9.0 * lamp, intensity: 1.0 }];
        let mut other = scene.clone();
        other.objects.reverse();
        other.objects.push(Object { shape: ball(centres[0], 0.9 * radii[0]), ..other.objects[0] });
        let limit = Limit { bounces: 3, min_throughput: 0.0 };
        let [one, two] = [&scene, &other].map(|scene| trace(scene, &towards(from, aim), limit).x);
        prop_assert!((one - two).abs() <= 1e-9, "{one} {two}");
    }
}
