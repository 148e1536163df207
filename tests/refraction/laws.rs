//! Refracted directions, total internal reflection, and the path of light through a ball.

use ::plane_hit::{Shape, nearest};
use ::ray_casting::scene::still_life_camera;
use ::ray_casting::{Camera, Ray};
use ::reflection::{MAX_DEPTH, PathBudget, reflect};
use ::refraction::scene::{AIR, GLASS, close_up, still_life_with_glass};
use ::refraction::{
    Interface, Optics, STAGE, refract, refract_or_reflect, refract_without_inverting,
    refract_without_total_reflection, spawn_ray,
};
use ::shadows::{Interaction, SHADOW_BIAS};
use ::sphere_hit::{Sphere, T_MAX, face_forward};
use canvas::Pixel;
use glam::{DVec3, Vec3, dvec3, vec3};
use harness::{EPS, SMALL, cases, magnitude, render, unit_vector};
use proptest::prelude::*;
use std::f32::consts::FRAC_1_SQRT_2;

/// Returns the hit, at the origin, of a ray along `incident` on a surface with this outward
/// normal.
fn at(incident: Vec3, outward: Vec3) -> Interaction {
    Interaction {
        index: 0,
        shape: Shape::plane(Vec3::ZERO, outward),
        t: 1.0,
        point: Vec3::ZERO,
        incident,
        outward,
        normal: face_forward(outward, incident),
    }
}

/// Returns the direction in which all light goes on.
fn direction(incident: Vec3, outward: Vec3, eta_inside: f32, eta_outside: f32) -> Vec3 {
    let (weight, direction) =
        refract_or_reflect(&at(incident, outward), eta_inside, eta_outside);
    assert_eq!(weight, 1.0);
    direction
}

/// Returns a direction towards the surface y = 0, at an angle from its normal.
#[expect(clippy::disallowed_methods, reason = "a test makes no picture")]
fn at_angle(theta: f64) -> DVec3 {
    dvec3(theta.sin(), -theta.cos(), 0.0)
}

/// Returns the angle between two directions, by its tangent: its cosine cannot tell small
/// ones apart.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

fn is_close(v: Vec3, x: f64, y: f64) -> bool {
    v.as_dvec3().distance(dvec3(x, y, 0.0)) <= 4e-7
}

/// 0.6 · 1.5 = 0.9, so T = (0.9, −√0.19, 0), to 4·10⁻⁷, three ε and a half.
#[test]
fn leaving_glass_a_ray_is_refracted_away_from_the_normal() {
    let refracted = refract(vec3(0.6, -0.8, 0.0), Vec3::Y, 1.5).expect("it leaves");
    assert!(is_close(refracted, 0.9, -0.435_889_894_35), "{refracted}");
}

/// 0.8 · 1.5 > 1. There is no T, and the light is reflected: R = (0.8, 0.6, 0). The bug has
/// no light go on.
#[test]
fn beyond_the_critical_angle_all_light_is_reflected() {
    let incident = vec3(0.8, -0.6, 0.0);
    assert_eq!(refract(incident, Vec3::Y, 1.5), None);
    // The ray comes from inside the object: its outward normal is −Y.
    let reflected = direction(incident, Vec3::NEG_Y, 1.5, 1.0);
    assert!(is_close(reflected, 0.8, 0.6), "{reflected}");
    let at = at(incident, Vec3::NEG_Y);
    let (weight, _) = refract_without_total_reflection(&at, 1.5, 1.0);
    assert_eq!(weight, 0.0);
}

/// On entering 0.6/1.5 = 0.4, as it should be; on leaving it should be 0.6 · 1.5 = 0.9, but is
/// 0.4 again.
#[test]
fn without_inverting_the_ratio_a_ray_is_refracted_alike_on_leaving() {
    let incident = vec3(0.6, -0.8, 0.0);
    for outward in [Vec3::Y, Vec3::NEG_Y] {
        let at = at(incident, outward);
        let (weight, refracted) = refract_without_inverting(&at, 1.5, 1.0);
        assert_eq!(weight, 1.0);
        assert!(is_close(refracted, 0.4, -0.84_f64.sqrt()), "{refracted}");
    }
    let entering = direction(incident, Vec3::Y, 1.5, 1.0);
    assert!(is_close(entering, 0.4, -0.84_f64.sqrt()), "{entering}");
}

/// At 45°, sinθₜ = √½/1.5 = √2/3.
#[test]
fn entering_glass_a_ray_is_refracted_towards_the_normal() {
    let incident = FRAC_1_SQRT_2 * vec3(1.0, -1.0, 0.0);
    let refracted = refract(incident, Vec3::Y, 1.0 / 1.5).expect("it enters");
    assert!(is_close(refracted, 0.471_404_520_79, -0.881_917_103_69));
}

/// For all indices, to the last bit.
#[test]
fn along_the_normal_a_ray_goes_straight_on() {
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        for eta in [0.3, 1.0 / 1.5, 1.5, 3.0] {
            assert_eq!(refract(-axis, axis, eta), Some(-axis));
        }
    }
}

/// Returns the exact answer for unit vectors along a direction and a normal of f32.
fn exactly(incident: Vec3, normal: Vec3, eta_i: f32, eta_t: f32) -> oracle::Interface {
    let [incident, normal] = [incident, normal].map(|v| v.as_dvec3().normalize());
    oracle::Interface::new(incident, normal, [eta_i, eta_t].map(f64::from))
}

fn sine(direction: Vec3, normal: Vec3) -> f64 {
    let [direction, normal] = [direction, normal].map(|v| v.as_dvec3().normalize());
    direction.cross(normal).length()
}

proptest! {
    #![proptest_config(cases(50_000))]

    /// Bit for bit, grazing rays as well.
    #[test]
    fn equal_indices_leave_a_ray_as_it_is(
        incident in unit_vector(), normal in unit_vector(), index in 1.0..3.0_f32,
        grazing in -1e-4..0.0_f64,
    ) {
        let [aside, outward] = [incident.reject_from(normal).normalize(), normal];
        for incident in [incident, (aside + grazing * outward).normalize()] {
            let [incident, outward] = [incident, outward].map(|v| v.as_vec3());
            prop_assert_eq!(direction(incident, outward, index, index), incident);
        }
    }

    /// A ray starts at a distance of the bias from the surface, on the side to which it goes.
    #[test]
    fn a_spawned_ray_starts_on_the_side_to_which_it_goes(
        incident in unit_vector(), outward in unit_vector(), direction in unit_vector(),
    ) {
        let [incident, outward, direction] = [incident, outward, direction].map(|v| v.as_vec3());
        let ray = spawn_ray(&at(incident, outward), direction);
        prop_assert_eq!(ray.direction, direction);
        prop_assert!(ray.origin == SHADOW_BIAS * outward || ray.origin == -SHADOW_BIAS * outward);
        prop_assert!(ray.origin.dot(direction) >= 0.0);
    }

    /// ηᵢ sinθᵢ = ηₜ sinθₜ to 8 ε of the larger index; T is a unit vector to 4 ε, on the other
    /// side, and in the plane of the other two.
    #[test]
    fn snells_law_holds(
        incident in unit_vector(), normal in unit_vector(),
        eta_i in 1.0..3.0_f32, eta_t in 1.0..3.0_f32,
    ) {
        let [incident, normal] = [incident, normal].map(|v| v.as_vec3());
        let normal = face_forward(normal, incident);
        let Some(refracted) = refract(incident, normal, eta_i / eta_t) else {
            return Ok(());
        };
        let larger = f64::from(if eta_i > eta_t { eta_i } else { eta_t });
        let sines = [(eta_i, incident), (eta_t, refracted)]
            .map(|(eta, direction)| f64::from(eta) * sine(direction, normal));
        prop_assert!((sines[0] - sines[1]).abs() <= 8.0 * EPS * larger);
        prop_assert!((refracted.as_dvec3().length() - 1.0).abs() <= 4.0 * EPS);
        prop_assert!(refracted.dot(normal) <= 0.0);
        let volume = incident.cross(refracted).as_dvec3().dot(normal.as_dvec3());
        prop_assert!(volume.abs() <= 4.0 * EPS);
    }

    /// Into a denser medium and back: the angle is as it was, but for the errors of Snell's law,
    /// twice 8 ε, over the cosine by which they turn the ray.
    #[test]
    fn the_path_of_light_can_be_reversed(
        incident in unit_vector(), normal in unit_vector(),
        eta_i in 1.0..3.0_f32, denser in 1.0..3.0_f32,
    ) {
        let [incident, normal] = [incident, normal].map(|v| v.as_vec3());
        let normal = face_forward(normal, incident);
        let eta_t = eta_i * denser;
        let refracted = refract(incident, normal, eta_i / eta_t).expect("it enters");
        let cosine = f64::from(-incident.dot(normal));
        let Some(back) = refract(-refracted, -normal, eta_t / eta_i) else {
            // Only along the surface, where cos²θ = 1 − sin²θ is no more than its rounding.
            prop_assert!(cosine * cosine <= 16.0 * EPS);
            return Ok(());
        };
        let bar = 16.0 * EPS * f64::from(denser) / cosine + 8.0 * EPS;
        prop_assert!(angle(back.as_dvec3(), -incident.as_dvec3()) <= bar);
    }

    /// At an angle δ from the critical one Snell's law itself turns an error of ε into ε/√δ: the
    /// bar is 2 ε/√δ + 8 ε. From δ = 10⁻⁶ on total internal reflection is decided right, on
    /// both sides.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "a test makes no picture")]
    fn near_the_critical_angle_the_error_is_the_laws_own(
        delta in magnitude(-6.0..-1.0), index in 1.1..3.0_f64, turn in 0.0..6.3_f64,
    ) {
        let index = f64::from(index as f32);
        let critical = (1.0 / index).asin();
        let turned = |theta: f64| {
            let flat = at_angle(theta);
            dvec3(flat.x * turn.cos(), flat.y, flat.x * turn.sin()).as_vec3()
        };
        let inside = turned(critical - delta);
        let refracted = refract(inside, Vec3::Y, index as f32).expect("it leaves");
        let exact = exactly(inside, Vec3::Y, index as f32, 1.0).refracted.expect("it leaves");
        let error = angle(refracted.as_dvec3(), exact);
        prop_assert!(error <= 2.0 * EPS / delta.sqrt() + 8.0 * EPS, "{error:e}");
        prop_assert_eq!(refract(turned(critical + delta), Vec3::Y, index as f32), None);
    }

    /// A ray that hits a ball from outside enters it, one from inside leaves it. Beyond 1 − 10⁻⁶
    /// radii from the centre, the angle is too grazing to tell.
    #[test]
    fn a_ray_enters_from_outside_and_leaves_from_inside(
        out in unit_vector(), aside in unit_vector(), away in unit_vector(),
        distance in 1.5..1e3_f64, approach in 0.0..1.0_f64, inside in 0.0..0.999_f32,
        radius in magnitude(-3.0..6.0), far in 0.0..1.0_f64,
    ) {
        let centre = (far * distance * radius * away).as_vec3();
        let ball = Sphere { centre, radius: radius as f32 };
        let origin = (centre.as_dvec3() + distance * radius * out).as_vec3();
        let to_centre = (centre - origin).as_dvec3();
        let aside = aside.reject_from(to_centre).normalize();
        let direction = (to_centre + approach * radius * aside).normalize().as_vec3();
        let outer = Ray { origin, direction };
        let inner = Ray { origin: centre + inside * ball.radius * Vec3::X, direction };
        let interface = |ray: &Ray| {
            let hit = ball.hit_in_f64(ray, T_MAX).expect("a hit");
            let Interface { eta_i, eta_t } = Interface::new(&at(direction, hit.normal), 1.5, 1.0);
            (eta_i, eta_t)
        };
        let approach = oracle::exact::approach(origin, direction, centre, ball.radius);
        if approach <= 1.0 - 1e-6 {
            prop_assert_eq!(interface(&outer), (1.0, 1.5));
        }
        prop_assert_eq!(interface(&inner), (1.5, 1.0));
    }
}

/// Through a slab of thickness 1 and index 1.5 at 45°: it leaves in the direction in which it
/// came, shifted by sin(θᵢ − θₜ) / cosθₜ = 0.329142308. The direction inside has an error of
/// some ε, and so has the shift.
#[test]
fn a_slab_shifts_a_ray_and_does_not_turn_it() {
    let incident = FRAC_1_SQRT_2 * vec3(1.0, -1.0, 0.0);
    let inside = direction(incident, Vec3::Y, 1.5, 1.0);
    let out = direction(inside, Vec3::NEG_Y, 1.5, 1.0);
    assert!(f64::from(out.distance(incident)) <= 4.0 * EPS);
    let inside = inside.as_dvec3();
    let path = inside / -inside.y;
    let shift = path.reject_from(incident.as_dvec3().normalize()).length();
    assert!((shift - 0.329_142_308).abs() <= 4.0 * EPS, "{shift}");
}

/// Returns the far end of a chord of the unit ball at the origin that begins at `point` of its
/// surface.
fn chord_end(point: Vec3, direction: Vec3) -> Vec3 {
    (point - 2.0 * direction.dot(point) * direction).normalize()
}

/// Returns the direction in which a ray leaves the unit ball that it hit along −z, at a
/// distance `b` from the centre, after some internal reflections.
fn through_a_ball(b: f64, index: f32, reflections: u32) -> DVec3 {
    let ball = Sphere::new(Vec3::ZERO, 1.0).expect("a sphere");
    let ray = Ray {
        origin: vec3(b as f32, 0.0, 5.0),
        direction: Vec3::NEG_Z,
    };
    let entry = ball.hit_in_f64(&ray, T_MAX).expect("a hit").normal;
    let mut inside = direction(ray.direction, entry, index, AIR);
    let mut point = chord_end(entry, inside);
    for _ in 0..reflections {
        inside = reflect(inside, point);
        point = chord_end(point, inside);
    }
    direction(inside, point, index, AIR).as_dvec3()
}

/// Returns the angle by which a ray has been turned, in degrees.
fn deviation(out: DVec3) -> f64 {
    angle(out, DVec3::NEG_Z).to_degrees()
}

/// At b = 0.5 and an index of 1.5 by 2 (θᵢ − θₜ) = 21.0575587°, and through the centre not at
/// all.
#[test]
fn a_ball_lens_turns_a_ray_by_twice_the_difference_of_its_angles() {
    let error = (deviation(through_a_ball(0.5, 1.5, 0)) - 21.057_558_7).to_radians();
    assert!(error.abs() <= 8.0 * EPS, "{error:e}");
    assert_eq!(through_a_ball(0.0, 1.5, 0), DVec3::NEG_Z);
}

/// With an index of 4/3 and one reflection a ray at b = √((4 − n²)/3) = 0.86066 is turned by
/// 137.970341°, and on either side by more: there the rainbow is bright. The second derivative
/// is 2b/(1 − b²)^1.5 − 4b/(n² − b²)^1.5 = 9.78 there, and a step of 0.01 turns the ray by 0.028°
/// more, give or take the third order.
#[test]
fn the_rainbow_is_where_the_deviation_is_least() {
    let at = |b| deviation(through_a_ball(b, 4.0 / 3.0, 1));
    let b = 0.860_662_965_82;
    let least = at(b);
    assert!(
        (least - 137.970_341).to_radians().abs() <= 16.0 * EPS,
        "{least}"
    );
    for step in [-0.01, 0.01] {
        let more = at(b + step) - least;
        assert!((more - 0.028).abs() <= 0.002, "{more}");
    }
}

/// Returns how many camera rays of the still life with a clear ball are totally reflected on
/// their path, and how many hit the ball at all. They are followed as `trace` follows them, by
/// the same functions.
fn totally_reflected(eta_inside: f32, eta_outside: f32, camera: &Camera) -> [usize; 2] {
    let objects = still_life_with_glass(eta_inside, eta_outside).objects;
    let [mut reflected, mut clear] = [0, 0];
    for pixel in Pixel::all(SMALL) {
        let mut ray = camera.ray(pixel.centre());
        let mut budget = Some(PathBudget::new(MAX_DEPTH));
        let [mut is_reflected, mut is_clear] = [false, false];
        while let (Some(left), Some(hit)) = (budget, nearest(&objects, &ray)) {
            let at = Interaction::new(&objects, &ray, hit);
            let (weight, direction) = match objects[at.index].material.optics {
                Optics::Opaque { reflectivity } => {
                    (reflectivity, reflect(at.incident, at.normal))
                }
                Optics::Dielectric { .. } => {
                    is_clear = true;
                    let Interface { eta_i, eta_t } =
                        Interface::new(&at, eta_inside, eta_outside);
                    let refracted = refract(at.incident, at.normal, eta_i / eta_t);
                    is_reflected |= refracted.is_none();
                    refract_or_reflect(&at, eta_inside, eta_outside)
                }
            };
            budget = left.attenuated(weight);
            ray = spawn_ray(&at, direction);
        }
        reflected += usize::from(is_reflected);
        clear += usize::from(is_clear);
    }
    [reflected, clear]
}

/// A ray that has entered a ball of glass in air hits its surface again at the angle of
/// refraction at which it has entered, and leaves: none of the camera rays of the views
/// `glass` and `ball` is totally reflected. A bubble is hit at any angle from outside, and
/// beyond the critical one, sinθ = 2/3, it reflects: the rim of its disc, 1 − 4/9 of it.
/// Measured: 12,134 of 21,430.
#[test]
fn a_ball_in_air_never_shows_total_internal_reflection_and_a_bubble_does() {
    let still_life = still_life_camera();
    for index in [1.01, 1.33, GLASS, 2.42, 3.0] {
        for camera in [still_life, close_up()] {
            let [reflected, clear] = totally_reflected(index, AIR, &camera);
            assert!(clear > 1_000);
            assert_eq!(reflected, 0, "index {index}");
        }
    }
    let [reflected, clear] = totally_reflected(AIR, GLASS, &close_up());
    let fraction = reflected as f64 / clear as f64;
    assert!((fraction - 5.0 / 9.0).abs() < 0.02, "{fraction}");
}

/// In the view `failed-total` the bubble's rim is black, in `bubble` nothing is. In
/// `failed-ratio` all of the ball differs from `ball`, and nothing else. Measured: 11,776
/// black pixels, and 21,176 that differ.
#[test]
fn the_failed_refractions_show_and_the_right_one_has_neither_fault() {
    let levels = |view| render(&STAGE, view, SMALL).levels;
    let black = |view| {
        let levels = levels(view).into_iter();
        levels.filter(|levels| *levels == [0; 3]).count()
    };
    assert!(black("failed-total") > 11_000);
    assert_eq!(black("bubble"), 0);
    let [ball, ratio] = ["ball", "failed-ratio"].map(levels);
    let differ = ball.iter().zip(&ratio).filter(|(a, b)| a != b).count();
    assert!((20_000..22_000).contains(&differ), "{differ}");
}
