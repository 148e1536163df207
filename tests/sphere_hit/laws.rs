//! The textbook's formula, the stable one, and the same in f64.

use crate::aimed::{Aimed, aimed};
use ::ray_casting::{Ray, SKY};
use ::sphere_hit::{Hit, STAGE, Sphere, T_MAX, face_forward};
use canvas::Pixel;
use glam::{Vec3, vec3};
use harness::{
    EPS, SMALL, cases, magnitude, render_at, special, special_vector, ulp, unit_vector,
};
use proptest::prelude::*;
use std::cmp::Ordering;

type Method = fn(&Sphere, &Ray, f32) -> Option<Hit>;

/// Returns the hit by the textbook's formula.
fn textbook(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<Hit> {
    with_normal(sphere, ray, sphere.distance_quadratic(ray, t_max))
}

/// Returns the hit by the stable formula.
fn stable(sphere: &Sphere, ray: &Ray, t_max: f32) -> Option<Hit> {
    with_normal(sphere, ray, sphere.distance(ray, t_max))
}

fn with_normal(sphere: &Sphere, ray: &Ray, t: Option<f32>) -> Option<Hit> {
    let normal = |t| sphere.normal(ray.at(t));
    t.map(|t| Hit {
        t,
        normal: normal(t),
    })
}

const METHODS: [Method; 3] = [textbook, stable, Sphere::hit_in_f64];
/// The two that are exact from far away.
const STABLE_METHODS: [Method; 2] = [stable, Sphere::hit_in_f64];

const UNIT_SPHERE: Sphere = Sphere {
    centre: Vec3::ZERO,
    radius: 1.0,
};

fn ray(origin: Vec3, direction: Vec3) -> Ray {
    Ray { origin, direction }
}

/// Returns the distance to the unit sphere from `origin`, along −z.
fn t_from(method: Method, origin: Vec3) -> Option<f64> {
    let hit = method(&UNIT_SPHERE, &ray(origin, Vec3::NEG_Z), T_MAX)?;
    Some(f64::from(hit.t))
}

/// A sphere of radius 10⁶ whose highest point is the origin.
const GROUND: Sphere = Sphere {
    centre: vec3(0.0, -1e6, 0.0),
    radius: 1e6,
};

/// r = 1, o = (0, 0, 5), d = (0, 0, −1): t = 5 − 1, and everything is a whole number.
#[test]
fn a_ray_through_the_centre_hits_the_near_pole() {
    let hit = Hit {
        t: 4.0,
        normal: Vec3::Z,
    };
    let ray = ray(vec3(0.0, 0.0, 5.0), Vec3::NEG_Z);
    for method in METHODS {
        assert_eq!(method(&UNIT_SPHERE, &ray, T_MAX), Some(hit));
    }
}

/// r = 13, o = (5, −20, 0), d = (0, 1, 0): 5² + 12² = 13², so t = 20 ∓ 12. The far hit is the
/// first one for a ray that starts inside.
#[test]
fn a_pythagorean_triple_gives_whole_distances() {
    let sphere = Sphere::new(Vec3::ZERO, 13.0).expect("a sphere");
    for method in METHODS {
        let near = method(&sphere, &ray(vec3(5.0, -20.0, 0.0), Vec3::Y), T_MAX);
        let near = near.expect("a hit");
        assert_eq!(near.t, 8.0);
        let normal = vec3(5.0, -12.0, 0.0) / 13.0;
        assert!(near.normal.distance(normal) <= 2.0 * f32::EPSILON);
        let far = method(&sphere, &ray(vec3(5.0, -10.0, 0.0), Vec3::Y), T_MAX);
        assert_eq!(far.expect("a hit").t, 22.0);
    }
}

/// o = (1, 0, 5): both roots are 5.
#[test]
fn a_tangent_touches_in_one_point() {
    let hit = Hit {
        t: 5.0,
        normal: Vec3::X,
    };
    let ray = ray(vec3(1.0, 0.0, 5.0), Vec3::NEG_Z);
    for method in METHODS {
        assert_eq!(method(&UNIT_SPHERE, &ray, T_MAX), Some(hit));
    }
}

/// o = (1 + 2⁻²³, 0, 5) misses the sphere by the last bit of an f32.
#[test]
fn the_last_bit_tells_a_miss_from_a_tangent_but_not_by_the_textbook() {
    let origin = vec3(1.0_f32.next_up(), 0.0, 5.0);
    for method in STABLE_METHODS {
        assert_eq!(t_from(method, origin), None);
    }
    assert_eq!(t_from(textbook, origin), Some(5.0));
}

/// o = (1 − 2⁻²⁴, 0, 5): t = 5 − √(1 − x²) = 4.99965473302.
#[test]
fn a_grazing_hit_is_found_where_the_textbook_finds_a_tangent() {
    let origin = vec3(1.0_f32.next_down(), 0.0, 5.0);
    for method in STABLE_METHODS {
        let t = t_from(method, origin).expect("a hit");
        assert!((t - 4.999_654_733_02).abs() <= ulp(t));
    }
    assert_eq!(t_from(textbook, origin), Some(5.0));
}

/// o = (0.5, 0, 10⁴): t = 10⁴ − √¾ = 9999.13397460. The textbook's is wrong by √¾ of a
/// radius.
#[test]
fn from_ten_thousand_radii_the_textbook_is_wrong_by_most_of_a_radius() {
    let origin = vec3(0.5, 0.0, 1e4);
    for method in STABLE_METHODS {
        let t = t_from(method, origin).expect("a hit");
        assert!((t - 9_999.133_974_60).abs() <= ulp(t));
    }
    assert_eq!(t_from(textbook, origin), Some(1e4));
}

/// o = (1.5, 0, 10⁴) misses by half a radius.
#[test]
fn from_ten_thousand_radii_the_textbook_hits_what_it_should_miss() {
    let origin = vec3(1.5, 0.0, 1e4);
    for method in STABLE_METHODS {
        assert_eq!(t_from(method, origin), None);
    }
    assert!(t_from(textbook, origin).is_some());
}

/// o = (0.5, 0, 10⁶): t = 10⁶ − √¾ = 999999.133975, within the last bit of an f32, 1/16.
#[test]
fn from_a_million_radii_the_last_bit_is_a_sixteenth() {
    let origin = vec3(0.5, 0.0, 1e6);
    for method in STABLE_METHODS {
        let t = t_from(method, origin).expect("a hit");
        assert!((t - 999_999.133_975).abs() <= 0.0625);
    }
    assert_eq!(t_from(textbook, origin), Some(1e6));
}

/// From o = (0, 1, 0) along (0, −1, 0).
#[test]
fn straight_down_a_ground_of_radius_a_million_is_one_away() {
    for method in METHODS {
        let hit = method(&GROUND, &ray(Vec3::Y, Vec3::NEG_Y), T_MAX);
        assert_eq!(hit.expect("a hit").t, 1.0);
    }
}

/// The same ground along (0.6, −0.8, 0), as f32 rounds it: t = 1.25000033294. The bar of the
/// stable formula is eight units in the last place of 10⁶, half a unit of length; in f64 it
/// is the last bit of t.
#[test]
fn aslant_the_distance_to_that_ground_is_exact_in_f64() {
    let ray = ray(Vec3::Y, vec3(0.6, -0.8, 0.0));
    let error = |method: Method| {
        let t = method(&GROUND, &ray, T_MAX).expect("a hit").t;
        (f64::from(t) - 1.250_000_332_94).abs()
    };
    assert!(error(Sphere::hit_in_f64) <= 0.51 * ulp(1.25));
    assert!(error(stable) <= 8.0 * ulp(1e6));
}

/// o = (0.5, 0, 0), d = (1, 0, 0): t = 0.5, and the normal that faces the ray is −x.
#[test]
fn from_inside_the_far_root_is_the_hit_and_its_normal_faces_the_ray() {
    let ray = ray(vec3(0.5, 0.0, 0.0), Vec3::X);
    for method in METHODS {
        let hit = method(&UNIT_SPHERE, &ray, T_MAX).expect("a hit");
        assert_eq!((hit.t, hit.normal), (0.5, Vec3::X));
        assert_eq!(face_forward(hit.normal, ray.direction), Vec3::NEG_X);
    }
}

/// o = (0, 0, 5), d = (0, 0, 1): the roots are −6 and −4.
#[test]
fn a_sphere_behind_the_ray_is_missed() {
    let ray = ray(vec3(0.0, 0.0, 5.0), Vec3::Z);
    for method in METHODS {
        assert_eq!(method(&UNIT_SPHERE, &ray, T_MAX), None);
    }
}

/// Along d = (0, 0, −2) from 4 away t is 2. In the textbook's formula b = −10 and c = 24, and
/// t = 10 − √76 = 1.28.
#[test]
fn a_direction_of_length_two_halves_the_distance_but_not_by_the_textbook() {
    let ray = ray(vec3(0.0, 0.0, 5.0), vec3(0.0, 0.0, -2.0));
    for method in STABLE_METHODS {
        assert_eq!(method(&UNIT_SPHERE, &ray, T_MAX).expect("a hit").t, 2.0);
    }
    let wrong = 10.0 - 76.0_f32.sqrt();
    assert_eq!(UNIT_SPHERE.distance_quadratic(&ray, T_MAX), Some(wrong));
}

/// r = 10⁻³, o = (r/2, 0, 10): t = 10 − √¾ r = 9.99913397456.
#[test]
fn ten_away_a_sphere_of_a_thousandth_is_far_away() {
    let sphere = Sphere::new(Vec3::ZERO, 1e-3).expect("a sphere");
    let ray = ray(vec3(0.5e-3, 0.0, 10.0), Vec3::NEG_Z);
    for method in STABLE_METHODS {
        let t = f64::from(method(&sphere, &ray, T_MAX).expect("a hit").t);
        assert!((t - 9.999_133_974_56).abs() <= ulp(t));
    }
    assert_eq!(sphere.distance_quadratic(&ray, T_MAX), Some(10.0));
}

/// d = 0; NaN in d; an infinite o; r = NaN.
#[test]
fn a_ray_or_a_sphere_that_is_not_finite_has_no_hit_nor_has_a_zero_direction() {
    let no_sphere = Sphere {
        radius: f32::NAN,
        ..UNIT_SPHERE
    };
    for method in METHODS {
        let is_hit = |sphere, origin, direction| {
            method(&sphere, &ray(origin, direction), T_MAX).is_some()
        };
        let origin = vec3(0.0, 0.0, 5.0);
        assert!(!is_hit(UNIT_SPHERE, origin, Vec3::ZERO));
        assert!(!is_hit(UNIT_SPHERE, origin, vec3(0.0, 0.0, f32::NAN)));
        assert!(!is_hit(
            UNIT_SPHERE,
            vec3(0.0, 0.0, f32::INFINITY),
            Vec3::NEG_Z
        ));
        assert!(!is_hit(no_sphere, origin, Vec3::NEG_Z));
    }
}

#[test]
fn a_sphere_whose_radius_is_not_positive_or_that_is_not_finite_is_refused() {
    for radius in [0.0, -0.0, -1.0, f32::INFINITY, f32::NAN] {
        assert_eq!(Sphere::new(Vec3::ZERO, radius), None);
    }
    for x in [f32::INFINITY, f32::NEG_INFINITY, f32::NAN] {
        assert_eq!(Sphere::new(vec3(0.0, x, 0.0), 1.0), None);
    }
}

/// Returns the error of t, in ulps of D or r, whichever is larger; `None` for a wrong miss.
fn error_in_ulps(aimed: &Aimed, method: Method) -> Option<f64> {
    let [near, _] = aimed.exact().expect("a chord");
    let unit = ulp(aimed.distance().max(f64::from(aimed.sphere.radius)));
    Some((f64::from(aimed.hit(method)?.t) - near.t).abs() / unit)
}

/// Returns whether a method takes a hit for a miss, or a miss for a hit, farther than `margin`
/// from the silhouette, in radii.
fn is_wrong_beyond(aimed: &Aimed, method: Method, margin: f64) -> bool {
    let approach = aimed.approach();
    (approach - 1.0).abs() > margin && aimed.hit(method).is_some() != (approach < 1.0)
}

/// Approaches all over the sphere and beside it, and as many so near its edge that rounding
/// matters.
fn any_approach() -> impl Strategy<Value = f64> {
    let near_edge = (magnitude(-8.0..0.0), any::<bool>());
    let near_edge =
        near_edge.prop_map(|(by, more)| if more { 1.0 + by } else { 1.0 - by });
    prop_oneof![0.0..2.0, near_edge]
}

proptest! {
    #![proptest_config(cases(20_000))]

    /// D/r from 1.5 to 10⁵, b/r up to 0.95. The two errors of f32 are those of o − c and of t d,
    /// a rounding of D each; at 0.95 the half chord multiplies them by three.
    #[test]
    fn the_stable_formula_is_within_eight_ulps(
        aimed in aimed(magnitude(0.177..5.0), 0.0..0.95)
    ) {
        let error = error_in_ulps(&aimed, stable);
        prop_assert!(error.is_some_and(|error| error <= 8.0), "{error:?} ulp");
    }

    /// It takes a hit for a miss, or a miss for a hit, only within ε D/r of the edge, up to
    /// D/r = 10⁶.
    #[test]
    fn the_stable_formula_keeps_the_silhouette(
        aimed in aimed(magnitude(0.177..6.0), any_approach())
    ) {
        prop_assert!(!is_wrong_beyond(&aimed, stable, EPS * aimed.distance_in_radii()));
    }

    /// In f64 t is the exact one, rounded: half an ulp, and no wrong hit or miss at all, up to
    /// D/r = 10⁷.
    #[test]
    fn in_f64_every_hit_and_every_miss_is_right(
        aimed in aimed(magnitude(0.02..7.0), any_approach())
    ) {
        let hit = aimed.hit(Sphere::hit_in_f64);
        match aimed.exact() {
            None => prop_assert_eq!(hit, None),
            Some([near, _]) => {
                let hit = hit.expect("a hit");
                prop_assert!((f64::from(hit.t) - near.t).abs() <= 0.51 * ulp(near.t));
                // Three coordinates rounded to f32, by 2⁻²⁵ each: √3 · 2⁻²⁵ < 10⁻⁷ rad.
                prop_assert!(hit.normal.as_dvec3().distance(near.normal) <= 1e-7);
            }
        }
    }

    /// The same from inside, where the far root is the hit.
    #[test]
    fn in_f64_the_far_side_is_right_from_inside(aimed in aimed(0.0..0.99, 0.0..0.99)) {
        let [_, far] = aimed.exact().expect("a chord");
        let hit = aimed.hit(Sphere::hit_in_f64).expect("a hit");
        prop_assert!((f64::from(hit.t) - far.t).abs() <= 0.51 * ulp(far.t));
        prop_assert!(hit.normal.as_dvec3().distance(far.normal) <= 1e-7);
    }

    /// The same on a ground of 10² to 10⁷, from 1 above it, to hits 1 to 30 away.
    #[test]
    fn in_f64_a_huge_ground_is_right(
        radius in magnitude(2.0..7.0), sideways in unit_vector(), distance in 1.0..30.0_f64
    ) {
        let radius = radius as f32;
        let sphere = Sphere { centre: vec3(0.0, -radius, 0.0), radius };
        let sideways = (sideways.with_y(0.0) * distance).as_vec3();
        let direction = (sideways - Vec3::Y).normalize();
        let aimed = Aimed { ray: Ray { origin: Vec3::Y, direction }, sphere };
        let hit = aimed.hit(Sphere::hit_in_f64);
        match aimed.exact() {
            None => prop_assert_eq!(hit, None),
            Some([near, _]) => {
                let t = f64::from(hit.expect("a hit").t);
                prop_assert!((t - near.t).abs() <= 0.51 * ulp(near.t));
            }
        }
    }
}

/// Returns 40 × 40 rays from `distance_in_radii` away through a square of 2.5 radii.
fn rays_from(distance_in_radii: f32) -> impl Iterator<Item = Aimed> {
    let origin = vec3(0.36, 0.48, -0.8) * distance_in_radii;
    let [right, up] = [vec3(0.8, -0.6, 0.0), vec3(0.48, 0.64, 0.6)];
    (0..1600).map(move |i| {
        let [x, y] = [i % 40, i / 40].map(|i| (i as f32 - 19.5) / 16.0);
        Aimed {
            ray: Ray {
                origin,
                direction: (x * right + y * up - origin).normalize(),
            },
            sphere: UNIT_SPHERE,
        }
    })
}

/// The bug: the textbook's t from 10³ and 10⁴ radii, where the bar is eight ulps. Measured:
/// 7,762 and 1,023, an ulp being eight times as long the second time.
#[test]
fn from_a_thousand_radii_the_textbook_is_a_thousand_ulps_wrong() {
    for distance in [1e3, 1e4] {
        let worst = |method: Method| {
            let chords = rays_from(distance).filter(|aimed| aimed.approach() <= 0.95);
            let errors = chords.filter_map(|aimed| error_in_ulps(&aimed, method));
            errors.fold(0.0, f64::max)
        };
        assert!(worst(textbook) > 1e3);
        assert!(worst(stable) <= 8.0);
        assert!(worst(Sphere::hit_in_f64) <= 0.51);
    }
}

/// The bug: the textbook's silhouette is wrong by far more than ε D/r: by about ε (D/r)².
/// Measured: 84 and 780 of 1,600 rays.
#[test]
fn from_a_thousand_radii_the_textbook_loses_the_silhouette() {
    for (distance, at_least) in [(1e3, 50), (1e4, 700)] {
        let margin = EPS * f64::from(distance);
        let wrong = |method: Method| {
            let rays = rays_from(distance);
            rays.filter(|aimed| is_wrong_beyond(aimed, method, margin))
                .count()
        };
        assert!(wrong(textbook) > at_least);
        assert_eq!(wrong(stable), 0);
        assert_eq!(wrong(Sphere::hit_in_f64), 0);
    }
}

/// The limit of f32: from 10¹⁷ radii the rounding of t is larger than the sphere, and the
/// point of the hit falls next to its centre, where no normal is left. In f64 there is one.
#[test]
fn from_too_far_away_for_a_normal_there_is_still_a_hit() {
    let ray = ray(vec3(1e17, 1e-20, 0.0), Vec3::NEG_X);
    let hit = stable(&UNIT_SPHERE, &ray, T_MAX).expect("a hit");
    assert_eq!((hit.t, hit.normal), (1e17, Vec3::Y));
    let hit = UNIT_SPHERE.hit_in_f64(&ray, T_MAX).expect("a hit");
    assert_eq!((hit.t, hit.normal), (1e17, vec3(1.0, 1e-20, 0.0)));
}

/// Returns whether the length is 1, to 4 ε.
fn is_unit(vector: Vec3) -> bool {
    (vector.as_dvec3().length() - 1.0).abs() <= 4.0 * EPS
}

/// Returns whether t is finite, ahead and less than `t_max`, and the normal a unit vector.
fn is_sound(Hit { t, normal }: Hit, t_max: f32) -> bool {
    t.is_finite() && t > 0.0 && t < t_max && is_unit(normal)
}

/// Returns positive numbers, from the least to the greatest.
fn positive() -> impl Strategy<Value = f32> {
    magnitude(-44.8..38.5).prop_map(|x| x as f32)
}

/// Returns numbers of either sign and any magnitude.
fn any_number() -> impl Strategy<Value = f32> {
    (positive(), any::<bool>())
        .prop_map(|(x, is_negative)| if is_negative { -x } else { x })
}

proptest! {
    #![proptest_config(cases(200_000))]

    /// Zero, subnormal, huge, infinite and NaN in every field, whether or not
    /// [`Sphere::new`] accepts the radius.
    #[test]
    fn a_hit_of_any_numbers_is_ahead_and_its_normal_a_unit_vector(
        origin in special_vector(), direction in special_vector(),
        centre in special_vector(), radius in special(), t_max in special(),
    ) {
        let sphere = Sphere { centre, radius };
        let ray = Ray { origin, direction };
        for method in METHODS {
            for t_max in [t_max, T_MAX, f32::INFINITY] {
                let hit = method(&sphere, &ray, t_max);
                prop_assert!(hit.is_none_or(|hit| is_sound(hit, t_max)), "{hit:?}");
            }
        }
    }

    /// At the surface and anywhere else, at the centre, too.
    #[test]
    fn at_any_finite_point_the_normal_of_any_sphere_is_a_unit_vector(
        centre in [any_number(), any_number(), any_number()],
        point in [any_number(), any_number(), any_number()],
        direction in unit_vector(), radius in positive(),
    ) {
        let sphere = Sphere { centre: centre.into(), radius };
        let on_surface = sphere.centre + radius * direction.as_vec3();
        for point in [point.into(), on_surface, sphere.centre] {
            let normal = sphere.normal(point);
            prop_assert!(is_unit(normal), "{normal} at {point}");
        }
    }

    /// As long as rounding leaves some digits of the difference: to 2 ε of the point's
    /// distance from the origin of the world, in radii.
    #[test]
    fn the_normal_is_the_exact_one(
        out in unit_vector(), away in unit_vector(), far in magnitude(-3.0..6.0),
        radius in magnitude(-30.0..30.0),
    ) {
        let radius = radius as f32;
        let sphere = Sphere { centre: (far * f64::from(radius) * away).as_vec3(), radius };
        let point = (sphere.centre.as_dvec3() + f64::from(radius) * out).as_vec3();
        let error = sphere.normal(point).as_dvec3().distance(out);
        prop_assert!(error <= 2.0 * EPS * (1.0 + far), "{error:e}");
    }

    /// It is the same normal or the opposite one, and never along the ray.
    #[test]
    fn a_face_forward_normal_faces_the_ray(
        normal in unit_vector(), incident in unit_vector()
    ) {
        let [normal, incident] = [normal, incident].map(|v| v.as_vec3());
        let facing = face_forward(normal, incident);
        prop_assert!(facing == normal || facing == -normal);
        prop_assert!(facing.dot(incident) <= 0.0);
    }
}

/// The exact signs of what the views `miss`, `tangent` and `two-hits` show.
#[test]
fn the_three_discriminants_have_their_signs() {
    let sign = |height| {
        let origin = vec3(-1.1, height, 0.0);
        oracle::exact::discriminant(origin, Vec3::X, vec3(0.1, 0.0, 0.0), 0.5)
    };
    let signs = [0.75, 0.5, 0.25].map(sign);
    assert_eq!(signs, [Ordering::Less, Ordering::Equal, Ordering::Greater]);
}

/// Returns the number of pixels of a view from afar in which hit and miss are confused, and
/// the number of the disc's pixels.
fn wrong_and_all_pixels(view: &str, distance: f32) -> [usize; 2] {
    let canvas = render_at(&STAGE, view, distance, SMALL);
    let [mut wrong, mut disc] = [0; 2];
    for (pixel, radiance) in Pixel::all(SMALL).zip(canvas.radiance) {
        // The focal length makes the disc's radius four fifths of the picture's half-height.
        let is_disc = pixel.centre().length() < 0.8;
        disc += usize::from(is_disc);
        wrong += usize::from(is_disc != (radiance != SKY));
    }
    [wrong, disc]
}

/// The views `far-textbook` and `far-stable`. From 10³ radii the textbook's formula loses
/// more than a twentieth of the disc (measured: 2,132 of 28,968 pixels), from 10⁴ all of it.
#[test]
fn from_afar_the_textbook_loses_the_disc_and_the_stable_formula_keeps_it() {
    let [frayed, disc] = wrong_and_all_pixels("far-textbook", 1e3);
    assert!(20 * frayed > disc, "{frayed} of {disc}");
    let [lost, disc] = wrong_and_all_pixels("far-textbook", 1e4);
    assert_eq!(lost, disc);
    for distance in [1e3, 1e4] {
        assert_eq!(wrong_and_all_pixels("far-stable", distance)[0], 0);
    }
}
