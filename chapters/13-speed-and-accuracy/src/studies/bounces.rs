//! Chapter 6: bounce after bounce inside a mirror sphere.

use crate::chart::{Axis, Chart, Quantity};
use crate::study::{Clock, Measurement, Study, Verdict, compare, direction};
use glam::{DVec2, DVec3, Vec3};
use plane_hit::{Object, Shape};
use ray_casting::Ray;
use reflection::{bounce_inside, reflect, reflect_by_slide};
use shadow_acne::{from_the_surface, other_hit};
use sphere_hit::{FARTHEST, Sphere};

/// The slides' formulas, with the normal made a unit vector or the direction or both, in
/// f64, and chapter 10's bounce, which starts on the surface itself.
///
/// The orbits are closed, so that the right answer is one of their corners. That the
/// start is rounded to f32 is part of every method's error but f64's.
pub const STUDY: Study = Study {
    name: "bounces",
    title: "Bounces inside a mirror sphere: what is to be made a unit vector",
    measure,
    charts: &[
        Chart {
            title: "Round a star, the slides’ error grows 14-fold at each bounce (∞: lost)",
            scene: "star",
            x: Axis::new(Quantity::Setting, "bounces"),
            y: Axis::new(Quantity::Max, "largest error, in radii"),
            front: false,
        },
        Chart {
            title: "Round a hexagon it doubles",
            scene: "hexagon",
            x: Axis::new(Quantity::Setting, "bounces"),
            y: Axis::new(Quantity::Max, "largest error, in radii"),
            front: false,
        },
        Chart {
            title: "After 16 bounces, on all the orbits (∞: lost)",
            scene: "overall",
            x: Axis::new(Quantity::Ns, "nanoseconds for one bounce"),
            y: Axis::new(Quantity::Rms, "RMS error, in radii"),
            front: true,
        },
    ],
    table: include_str!("../../../../book/src/studies/bounces.csv"),
};

/// A place on the surface, a direction inwards, and how often to bounce.
type Start = ([DVec3; 2], u32);

/// Where a ray is after its bounces, and its direction.
type Walk = fn(&Start) -> [DVec3; 2];

const METHODS: [(&str, Walk); 6] = [
    ("slide", |start| {
        walk(start, |ray| bounce_inside(&SPHERE, ray, reflect_by_slide))
    }),
    ("slide in f64", |&(ray, bounces)| {
        (0..bounces).fold(ray, |ray, _| bounce_in_f64(ray))
    }),
    ("unit N", |start| {
        walk(start, |ray| {
            bounce_by_unit_normal(&SPHERE, ray, reflect_by_slide)
        })
    }),
    ("unit R", |start| {
        walk(start, |ray| bounce_inside(&SPHERE, ray, reflect))
    }),
    ("unit N and R", |start| {
        walk(start, |ray| bounce_by_unit_normal(&SPHERE, ray, reflect))
    }),
    ("from the surface", |start| {
        walk(start, bounce_from_the_surface)
    }),
];

const SPHERE: Sphere = Sphere {
    centre: Vec3::ZERO,
    radius: 1.0,
};

fn walk(&([origin, direction], bounces): &Start, bounce: fn(&Ray) -> Ray) -> [DVec3; 2] {
    let [origin, direction] = [origin, direction].map(|vector| vector.as_vec3());
    let ray = (0..bounces).fold(Ray { origin, direction }, |ray, _| bounce(&ray));
    [ray.origin, ray.direction].map(|vector| vector.as_dvec3())
}

// These are not inlined, as chapter 6's bounce from another crate is not: the difference
// in time is to be that of the methods.

/// Chapter 6's [`bounce_inside`], but that its normal is made a unit vector.
#[inline(never)]
fn bounce_by_unit_normal(
    sphere: &Sphere,
    ray: &Ray,
    reflect: fn(Vec3, Vec3) -> Vec3,
) -> Ray {
    let oc = ray.origin - sphere.centre;
    let b = ray.direction.dot(oc);
    let discriminant = b * b - (oc.dot(oc) - sphere.radius * sphere.radius);
    let point = ray.at(-b + discriminant.sqrt());
    Ray {
        origin: point,
        direction: reflect(ray.direction, (point - sphere.centre).normalize()),
    }
}

/// The same with nothing made a unit vector, in f64.
#[inline(never)]
fn bounce_in_f64([origin, direction]: [DVec3; 2]) -> [DVec3; 2] {
    let (centre, radius) = (SPHERE.centre.as_dvec3(), f64::from(SPHERE.radius));
    let oc = origin - centre;
    let b = direction.dot(oc);
    let discriminant = b * b - (oc.dot(oc) - radius * radius);
    let point = origin + (-b + discriminant.sqrt()) * direction;
    let normal = (point - centre) / radius;
    [point, direction - 2.0 * normal.dot(direction) * normal]
}

/// Chapter 10's way: to the other root, back onto the surface, and on. What has no other
/// root is lost.
#[inline(never)]
fn bounce_from_the_surface(ray: &Ray) -> Ray {
    const MIRROR: Object<()> = Object {
        name: "mirror",
        shape: Shape::Sphere(SPHERE),
        material: (),
    };
    let Some(hit) = other_hit(&SPHERE, ray, FARTHEST) else {
        return Ray {
            origin: Vec3::NAN,
            direction: Vec3::NAN,
        };
    };
    let mirrored = reflect(ray.direction, hit.normal);
    from_the_surface(&MIRROR, ray.at(hit.t), hit.normal, mirrored).ray
}

fn measure(clock: &Clock) -> Vec<Measurement> {
    let mut rows = Vec::new();
    let root_5 = 5.0_f64.sqrt();
    // How each turns about the centre from one corner to the next; the star's are five.
    let orbits = [
        (
            "star",
            DVec2::new(-(1.0 + root_5) / 4.0, ((5.0 - root_5) / 8.0).sqrt()),
        ),
        ("square", DVec2::Y),
        ("hexagon", DVec2::new(0.5, 0.75_f64.sqrt())),
    ];
    for (orbit, turn) in orbits {
        for bounces in [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64] {
            rows.extend(bounced(clock, orbit, bounces, &walks(turn, bounces)));
        }
    }
    let all = orbits.map(|(_, turn)| walks(turn, 16)).concat();
    rows.extend(bounced(clock, "overall", 16, &all));
    rows
}

/// The same polygon in a thousand planes through the centre: a start, and the place and
/// the direction at the end.
fn walks(turn: DVec2, bounces: u32) -> Vec<(Start, [DVec3; 2])> {
    let mut random = fastrand::Rng::with_seed(6);
    let walk = |_| {
        let x = direction(&mut random);
        let y = x.cross(direction(&mut random)).normalize();
        let corner = |i| {
            let place = (0..i).fold(DVec2::X, |place, _| place.rotate(turn));
            place.x * x + place.y * y
        };
        let at = |i| [corner(i), (corner(i + 1) - corner(i)).normalize()];
        ((at(0), bounces), at(bounces))
    };
    (0..1000).map(walk).collect()
}

/// The errors of the places in radii, and times for a bounce. A ray is lost if its place
/// or its direction is more than a tenth off.
fn bounced(
    clock: &Clock,
    scene: &str,
    bounces: u32,
    walks: &[(Start, [DVec3; 2])],
) -> Vec<Measurement> {
    let scene = (scene, f64::from(bounces));
    let rows = compare(clock, scene, walks, &METHODS, |_, exact, end| {
        let [error, turned] = [0, 1].map(|i| end[i].distance(exact[i]));
        let is_lost = !(error <= 0.1 && turned <= 0.1);
        Verdict::Off(if is_lost { f64::INFINITY } else { error })
    });
    let for_one = |row: Measurement| Measurement {
        wrong: row.wrong.or(Some(0.0)),
        ..row.for_one_of(bounces)
    };
    rows.into_iter().map(for_one).collect()
}
