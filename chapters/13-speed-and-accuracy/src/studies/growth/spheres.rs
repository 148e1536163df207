//! Spheres in a cloud, all tried, as in this book, or found by a tree of boxes.

use crate::pictures::camera_rays;
use crate::study::{Clock, Measurement, each};
use glam::{UVec2, Vec3};
use plane_hit::{Object, Shape, nearest};
use ray_casting::{Camera, Ray};
use sphere_hit::{FARTHEST, Hit, Sphere};

/// So many spheres in a cube whose sides are 1, with the same share of air between them.
fn cloud(count: u32) -> Vec<Object<()>> {
    let mut random = fastrand::Rng::with_seed(u64::from(count));
    let radius = 0.25 / f64::from(count).cbrt() as f32;
    let sphere = |_| Object {
        name: "sphere",
        shape: Shape::Sphere(Sphere {
            centre: anywhere(&mut random),
            radius,
        }),
        material: (),
    };
    (0..count).map(sphere).collect()
}

/// A place in a cube about the origin whose sides are 1.
pub fn anywhere(random: &mut fastrand::Rng) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| random.f32() - 0.5))
}

/// Rays from a camera, of which neighbours meet the same spheres, and rays of which they do
/// not.
fn rays() -> [(&'static str, Vec<Ray>); 2] {
    let camera = Camera::new(2.0 * Vec3::NEG_Z, Vec3::Z, Vec3::Y, 3.0).expect("a camera");
    let coherent = camera_rays(&camera, UVec2::splat(64));
    let mut random = fastrand::Rng::with_seed(13);
    let across = |_| {
        let [origin, target] = [(); 2].map(|()| anywhere(&mut random));
        Ray {
            origin,
            direction: (target - origin).normalize(),
        }
    };
    let incoherent = (0..coherent.len()).map(across).collect();
    [("camera", coherent), ("random", incoherent)]
}

/// One row for each of the two, the number of spheres, and the rays.
pub fn measure(clock: &Clock) -> Vec<Measurement> {
    let counts = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 4000];
    let mut clouds = counts.map(|count| (cloud(count), cloud(count)));
    let clouds = clouds
        .each_mut()
        .map(|(objects, sorted)| (&*objects, Tree::over(sorted)));
    let mut rows = Vec::new();
    for (name, rays) in rays() {
        // Few rays for many spheres: a short job is not interrupted.
        let few = |count: usize| -> Vec<Ray> {
            rays.iter().step_by(count.div_ceil(64)).copied().collect()
        };
        let timed = clouds.each_ref().map(|(objects, _)| few(objects.len()));
        let jobs = clouds
            .iter()
            .zip(&timed)
            .flat_map(|((objects, tree), few)| {
                let all = each(few, |ray| nearest(objects, ray));
                [all, each(&rays, |ray| tree.nearest(ray).0)]
            });
        let times = clock.least(1, &mut jobs.collect::<Vec<_>>());
        for (((objects, tree), few), times) in
            clouds.iter().zip(&timed).zip(times.chunks(2))
        {
            let (mut tests, mut wrong) = (0, 0_u32);
            for ray in &rays {
                let (found, tests_for_it) = tree.nearest(ray);
                tests += tests_for_it;
                wrong += u32::from(found != nearest(objects, ray));
            }
            let all = objects.len() as f64;
            let per_ray = |sum: u32| f64::from(sum) / rays.len() as f64;
            rows.push(Measurement {
                work: Some(all),
                ns: times[0].map(|ns| ns / few.len() as f64),
                ..Measurement::of("spheres", format!("all, {name}"), all)
            });
            rows.push(Measurement {
                work: Some(per_ray(tests)),
                wrong: Some(100.0 * per_ray(wrong)),
                ns: times[1].map(|ns| ns / rays.len() as f64),
                ..Measurement::of("spheres", format!("tree, {name}"), all)
            });
        }
    }
    rows
}

/// A yardstick, and no part of this book's tracers: a box around spheres, and in it the
/// boxes around either half of them along its longest side.
struct Tree<'a> {
    least: Vec3,
    most: Vec3,
    inside: Inside<'a>,
}

enum Inside<'a> {
    Few(&'a [Object<()>]),
    /// The first is before the second along an axis.
    Halves(usize, Box<[Tree<'a>; 2]>),
}

/// What a ray meets first, and where.
type Nearest<'a> = Option<(&'a Object<()>, Hit)>;

#[expect(clippy::disallowed_methods, reason = "no lanes, and nothing is NaN")]
impl<'a> Tree<'a> {
    /// The tree over some spheres, which it sorts.
    fn over(objects: &'a mut [Object<()>]) -> Self {
        let sphere = |object: &Object<()>| match object.shape {
            Shape::Sphere(sphere) => sphere,
            Shape::Plane(_) => unreachable!("a plane in a cloud of spheres"),
        };
        let end = |side: f32| {
            move |object| sphere(object).centre + side * sphere(object).radius
        };
        let least = objects
            .iter()
            .map(end(-1.0))
            .fold(Vec3::INFINITY, Vec3::min);
        let most = objects
            .iter()
            .map(end(1.0))
            .fold(Vec3::NEG_INFINITY, Vec3::max);
        let inside = if objects.len() <= 2 {
            Inside::Few(objects)
        } else {
            let axis = (most - least).max_position();
            let place = |object: &Object<()>| sphere(object).centre[axis];
            objects.sort_by(|a, b| place(a).total_cmp(&place(b)));
            let (first, second) = objects.split_at_mut(objects.len() / 2);
            Inside::Halves(axis, Box::new([Self::over(first), Self::over(second)]))
        };
        Self {
            least,
            most,
            inside,
        }
    }

    /// What the ray meets first, and after how many tests of boxes and spheres.
    fn nearest(&self, ray: &Ray) -> (Nearest<'a>, u32) {
        let (mut nearest, mut tests) = (None, 0);
        self.visit(ray, ray.direction.recip(), &mut nearest, &mut tests);
        (nearest, tests)
    }

    fn visit(
        &self,
        ray: &Ray,
        per_way: Vec3,
        nearest: &mut Nearest<'a>,
        tests: &mut u32,
    ) {
        let t_max = |nearest: &Nearest| nearest.map_or(FARTHEST, |(_, hit)| hit.t);
        let [a, b] =
            [self.least, self.most].map(|corner| (corner - ray.origin) * per_way);
        let enters = a.min(b).max_element().max(0.0);
        let leaves = a.max(b).min_element().min(t_max(nearest));
        *tests += 1;
        // Three roundings on either side must not make it a miss.
        // Source: Ize, "Robust BVH Ray Traversal" (JCGT 2(2), 2013).
        if !(enters <= leaves * (1.0 + 4.0 * f32::EPSILON)) {
            return;
        }
        match &self.inside {
            Inside::Few(objects) => {
                for object in *objects {
                    *tests += 1;
                    if let Some(hit) = object.shape.hit(ray, t_max(nearest)) {
                        *nearest = Some((object, hit));
                    }
                }
            }
            Inside::Halves(axis, halves) => {
                let first = usize::from(ray.direction[*axis] < 0.0);
                halves[first].visit(ray, per_way, nearest, tests);
                halves[1 - first].visit(ray, per_way, nearest, tests);
            }
        }
    }
}
