//! Inputs of the chapters' formulas, always the same, with their exact results.

use crate::Random;
use glam::{DVec2, DVec3, Vec3};
use oracle::{Interface, exact};
use plane_hit::Plane;
use ray_casting::Ray;
use sphere_hit::{Sphere, T_MAX};

/// The exact distance of a ray to a sphere that it hits, and how near the ray comes to the
/// centre, in radii.
pub type SphereHit = Option<(f64, f64)>;

/// Returns 2000 rays, each from the origin to the target that `ends` returns, with their
/// exact hits on a sphere.
pub fn sphere_rays(
    sphere: Sphere,
    ends: impl Fn(&mut Random) -> [DVec3; 2],
) -> Vec<((Sphere, Ray), SphereHit)> {
    let mut random = Random::new(2);
    let ray = |_| {
        let [from, to] = ends(&mut random);
        let (origin, direction) = (from.as_vec3(), (to - from).as_vec3().normalize());
        let Sphere { centre, radius } = sphere;
        let both = exact::sphere(origin, direction, centre, radius);
        let mut hits = both.into_iter().flatten().filter(|hit| hit.t > 0.0);
        let approach = exact::approach(origin, direction, centre, radius);
        let exact = hits.next().map(|hit| (hit.t, approach));
        ((sphere, Ray { origin, direction }), exact)
    };
    (0..2000).map(ray).collect()
}

/// Returns the ends of a ray from a `distance` to somewhere on a disc of one and a half radii
/// about the origin.
pub fn from_afar(random: &mut Random, distance: f64) -> [DVec3; 2] {
    let out = random.direction();
    let across = out.cross(random.direction()).normalize();
    [distance * out, 1.5 * random.f64().sqrt() * across]
}

/// Returns the ends of a ray from inside the unit sphere.
pub fn from_inside(random: &mut Random) -> [DVec3; 2] {
    let origin = 0.99 * random.f64() * random.direction();
    [origin, origin + random.direction()]
}

/// Returns the ends of a ray from a height of 1 to a point on the ground 1 to 30 away.
pub fn towards_the_ground(random: &mut Random) -> [DVec3; 2] {
    let along = (random.direction() * DVec3::new(1.0, 0.0, 1.0)).normalize();
    [DVec3::Y, (1.0 + 29.0 * random.f64()) * along]
}

/// Returns a tilted plane at a `distance` from the origin of the world, stored by a point that
/// is `aside` of the eye, and a ray from the eye, 1 above the plane; with the exact t.
///
/// # Panics
/// If f32 cannot represent the plane.
pub fn plane_ray(
    random: &mut Random,
    [distance, aside, d_dot_n]: [f64; 3],
) -> ((Plane, Ray), f64) {
    let normal = random.direction();
    let mut along = |normal: DVec3| normal.cross(random.direction()).normalize();
    let [below, aside] = [distance * along(DVec3::Y), aside * along(normal)];
    let plane = Plane::new((below + aside).as_vec3(), normal.as_vec3());
    let plane = plane.expect("a plane");
    let down = (1.0 - d_dot_n * d_dot_n).sqrt() * along(normal) - d_dot_n * normal;
    let (origin, direction) = ((below + normal).as_vec3(), down.as_vec3());
    let t = exact::plane(origin, direction, plane.point, plane.normal);
    ((plane, Ray { origin, direction }), t.expect("a hit"))
}

/// Returns a point of a floor at height −1, at about a `distance`, as a ray from 3 above the
/// floor hits it, and whether its square is even.
///
/// # Panics
/// If f32 cannot represent the ray.
pub fn floor_point(random: &mut Random, distance: f64) -> (Vec3, bool) {
    let floor = Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane");
    let away = distance * (0.5 + random.f64());
    let along = DVec3::Y.cross(random.direction()).normalize();
    let direction = (away * along - 3.0 * DVec3::Y).as_vec3().normalize();
    let origin = 2.0 * Vec3::Y;
    let t = exact::plane(origin, direction, floor.point, floor.normal);
    let exact = (t.expect("a hit") * direction.as_dvec3()).floor();
    let ray = Ray { origin, direction };
    let t = floor.distance(&ray, T_MAX).expect("a hit");
    (ray.at(t), (exact.x + exact.z) % 2.0 == 0.0)
}

/// A position on the unit sphere, and a direction.
pub type Corner = [DVec3; 2];

/// Returns the same closed polygon in a thousand planes through the centre: a corner with a
/// number of bounces to come, and the corner after these. From one corner to the next it turns
/// by `turn`, a complex number of length 1.
#[must_use]
pub fn orbits(turn: DVec2, bounces: u32) -> Vec<((Corner, u32), Corner)> {
    let mut random = Random::new(6);
    let orbit = |_| {
        let x = random.direction();
        let y = x.cross(random.direction()).normalize();
        let position = |i| {
            let position = (0..i).fold(DVec2::X, |position, _| position.rotate(turn));
            position.x * x + position.y * y
        };
        let corner = |i| [position(i), (position(i + 1) - position(i)).normalize()];
        ((corner(0), bounces), corner(bounces))
    };
    (0..1000).map(orbit).collect()
}

/// An incident direction, a normal that faces it, and η = ηᵢ/ηₜ.
pub type Refraction = (Vec3, Vec3, f32);

/// Returns 5000 refractions about random normals, of some cosines of the angle of incidence,
/// with the exact directions: those of the very unit vectors, which the inputs are up to
/// rounding. `None` for total internal reflection.
pub fn refractions(
    mut cosine_and_eta: impl FnMut(&mut Random) -> (f64, f32),
) -> Vec<(Refraction, Option<DVec3>)> {
    let mut random = Random::new(7);
    let refraction = |_| {
        let (cosine, eta) = cosine_and_eta(&mut random);
        let normal = random.direction();
        let aside = normal.cross(random.direction()).normalize();
        let incident = (1.0 - cosine * cosine).sqrt() * aside - cosine * normal;
        let [incident, normal] = [incident, normal].map(|vector| vector.as_vec3());
        let unit = |vector: Vec3| vector.as_dvec3().normalize();
        let interface = Interface::new(unit(incident), unit(normal), [eta.into(), 1.0]);
        ((incident, normal, eta), interface.refracted)
    };
    (0..5000).map(refraction).collect()
}

/// Returns cosines of the angle of incidence with the two indices, and the exact reflectances:
/// all angles, each as often as on the disc that a ball is seen as, so that the squares of the
/// sines are evenly spaced.
#[must_use]
pub fn on_a_disc(eta_i: f32, eta_t: f32) -> Vec<([f32; 3], f64)> {
    let case = |i| {
        let cosine = (1.0 - f64::from(i) / 10_000.0).sqrt() as f32;
        let c = f64::from(cosine);
        let incident = DVec3::new(((1.0 - c) * (1.0 + c)).sqrt(), -c, 0.0);
        let interface = Interface::new(incident, DVec3::Y, [eta_i, eta_t].map(f64::from));
        ([cosine, eta_i, eta_t], interface.reflectance)
    };
    (0..=10_000).map(case).collect()
}
