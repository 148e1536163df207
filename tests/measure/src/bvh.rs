//! A cloud of spheres, and a bounding volume hierarchy (BVH) over it: for comparison, and no
//! part of the book's tracers.

use crate::Random;
use crate::pictures::camera_rays;
use glam::{UVec2, Vec3};
use packets::{LANES, Lanes, Packet, Vec3x16};
use plane_hit::{Object, Shape};
use ray_casting::{Camera, Ray};
use sphere_hit::{Sphere, T_MAX};

/// Returns spheres in a cube whose sides are 1. They fill the same fraction of it for any
/// `count`.
#[must_use]
pub fn cloud(count: u32) -> Vec<Object<()>> {
    let mut random = Random::new(count);
    let radius = 0.25 / f64::from(count).cbrt() as f32;
    let sphere = |_| Object {
        name: "sphere",
        shape: Shape::sphere(anywhere(&mut random), radius),
        material: (),
    };
    (0..count).map(sphere).collect()
}

/// Returns a random point in a cube about the origin whose sides are 1.
pub fn anywhere(random: &mut Random) -> Vec3 {
    random.colour() - 0.5
}

/// Returns two sets of rays, each with its name: a camera's, of which neighbours hit the same
/// spheres, and as many of which neighbours do not.
///
/// # Panics
/// Never: there is such a camera.
#[must_use]
pub fn rays() -> [(&'static str, Vec<Ray>); 2] {
    let camera = Camera::new(2.0 * Vec3::NEG_Z, Vec3::Z, Vec3::Y, 3.0).expect("a camera");
    let coherent = camera_rays(&camera, UVec2::splat(64));
    let mut random = Random::new(13);
    let across = |_| {
        let [origin, target] = [(); 2].map(|()| anywhere(&mut random));
        let direction = (target - origin).normalize();
        Ray { origin, direction }
    };
    let incoherent = (0..coherent.len()).map(across).collect();
    [("camera", coherent), ("random", incoherent)]
}

/// Returns the same rays in packets; their number is a multiple of [`LANES`].
#[must_use]
pub fn packets(rays: &[Ray]) -> Vec<Packet> {
    let lanes = |rays: &[Ray; LANES], vector: fn(&Ray) -> Vec3| {
        let [x, y, z] =
            [0, 1, 2].map(|axis| Lanes::new(rays.map(|ray| vector(&ray)[axis])));
        Vec3x16 { x, y, z }
    };
    let (packets, _) = rays.as_chunks();
    let packets = packets.iter().map(|rays| Packet {
        origin: lanes(rays, |ray| ray.origin),
        direction: lanes(rays, |ray| ray.direction),
        origin_object: None,
        enters: Lanes::splat(0.0),
        active: Lanes::splat(0.0).simd_eq(0.0),
    });
    packets.collect()
}

/// A bounding volume hierarchy: a box around spheres, and in it the boxes around either
/// half of them along its longest side.
pub struct Bvh {
    min: Vec3,
    max: Vec3,
    node: Node,
}

enum Node {
    /// A leaf: indices and spheres.
    Leaf(Vec<(usize, Sphere)>),
    /// The first is before the second along an axis.
    Inner(usize, Box<[Bvh; 2]>),
}

#[expect(clippy::disallowed_methods, reason = "no lanes, and nothing is NaN")]
impl Bvh {
    /// Returns the hierarchy over a list of spheres.
    ///
    /// # Panics
    /// If one of the objects is not a sphere.
    #[must_use]
    pub fn new(objects: &[Object<()>]) -> Self {
        let spheres = objects.iter().map(|object| match object.shape {
            Shape::Sphere(sphere) => sphere,
            Shape::Plane(_) => panic!("a plane in a cloud of spheres"),
        });
        Self::over(spheres.enumerate().collect())
    }

    fn over(mut spheres: Vec<(usize, Sphere)>) -> Self {
        let end = |side: f32| {
            move |(_, sphere): &(usize, Sphere)| sphere.centre + side * sphere.radius
        };
        let min = spheres
            .iter()
            .map(end(-1.0))
            .fold(Vec3::INFINITY, Vec3::min);
        let max = spheres
            .iter()
            .map(end(1.0))
            .fold(Vec3::NEG_INFINITY, Vec3::max);
        let node = if spheres.len() <= 2 {
            Node::Leaf(spheres)
        } else {
            let axis = (max - min).max_position();
            spheres.sort_by(|(_, a), (_, b)| a.centre[axis].total_cmp(&b.centre[axis]));
            let second = spheres.split_off(spheres.len() / 2);
            Node::Inner(axis, Box::new([Self::over(spheres), Self::over(second)]))
        };
        Self { min, max, node }
    }

    /// Returns the index of the sphere that the ray hits first, and the distance. `None` if it
    /// hits nothing. Counts one ray.
    #[must_use]
    pub fn nearest(&self, ray: &Ray) -> Option<(usize, f32)> {
        canvas::count_ray();
        let mut nearest = None;
        self.visit(ray, ray.direction.recip(), &mut nearest);
        nearest
    }

    fn visit(&self, ray: &Ray, reciprocal: Vec3, nearest: &mut Option<(usize, f32)>) {
        let t_max = |nearest: &Option<(usize, f32)>| nearest.map_or(T_MAX, |(_, t)| t);
        let [a, b] =
            [self.min, self.max].map(|corner| (corner - ray.origin) * reciprocal);
        let enters = a.min(b).max_element().max(0.0);
        let leaves = a.max(b).min_element().min(t_max(nearest));
        // Three roundings on either side must not make it a miss.
        // Source: Ize, "Robust BVH Ray Traversal" (JCGT 2(2), 2013).
        if !(enters <= leaves * (1.0 + 4.0 * f32::EPSILON)) {
            return;
        }
        match &self.node {
            Node::Leaf(spheres) => {
                for (index, sphere) in spheres {
                    if let Some(t) = sphere.distance(ray, t_max(nearest)) {
                        *nearest = Some((*index, t));
                    }
                }
            }
            Node::Inner(axis, halves) => {
                let first = usize::from(ray.direction[*axis] < 0.0);
                halves[first].visit(ray, reciprocal, nearest);
                halves[1 - first].visit(ray, reciprocal, nearest);
            }
        }
    }
}
