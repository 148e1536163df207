//! Whatever the scene: every pixel is finite, nothing panics, and the recursion ends.
//!
//! Ten thousand scenes of spheres that overlap, touch and contain each other, of planes, mirrors and glass,
//! small and large, near and far, with the camera and the lamps outside, inside and on the surfaces.

use canvas::{Canvas, Picture, View};
use fresnel::fresnel;
use glam::{DVec3, UVec2, Vec3};
use light_backwards::STAGES;
use plane_hit::{Object, Pattern, Plane, Shape};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;
use ray_casting::Camera;
use reflection::{LEAST_WEIGHT, MAX_DEPTH, Mirror, Reach};
use refraction::{Body, Material, redirect};
use shading::Phong;
use shadow_acne::{
    Leave, at_the_point, by_a_fixed_offset, by_a_scaled_offset, from_the_eye,
    from_the_surface,
};
use shadows::{PointLight, Scene};
use sphere_hit::Sphere;
use transparency::Tinted;

const SIZE: UVec2 = UVec2::new(8, 6);

/// A direction, whichever.
fn unit() -> impl Strategy<Value = DVec3> {
    let cube = [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64].prop_map(DVec3::from);
    cube.prop_map(|v| v.try_normalize().unwrap_or(DVec3::Y))
}

/// Radii of the scene's own size, small and very small.
fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![3 => 0.3..2.0_f64, 1 => 0.01..0.3_f64, 1 => select(&[1e-3, 1.0, 10.0][..])]
}

/// Where a shape is, next to the sphere before it.
#[derive(Clone, Copy, Debug)]
enum Next {
    /// Anywhere.
    Anywhere(DVec3, f64),
    /// Its centre on the other's surface.
    Overlapping(DVec3, f64),
    /// Side by side, in one point.
    Touching(DVec3, f64),
    /// Inside, with the same centre, and a share of the radius; 1 is the very same sphere.
    Nested(f64),
    /// Inside, in one point.
    TouchingInside(DVec3, f64),
    /// A plane that touches the sphere.
    TangentPlane(DVec3),
    /// A plane through its centre.
    PlaneThrough(DVec3),
    /// Very far away, and very large.
    FarAway(DVec3),
}

fn next() -> impl Strategy<Value = Next> {
    let place = || (unit(), 0.0..4.0_f64).prop_map(|(out, distance)| distance * out);
    prop_oneof![
        3 => (place(), radius()).prop_map(|(at, r)| Next::Anywhere(at, r)),
        1 => (unit(), radius()).prop_map(|(out, r)| Next::Overlapping(out, r)),
        1 => (unit(), radius()).prop_map(|(out, r)| Next::Touching(out, r)),
        1 => select(&[0.2, 0.9, 0.999_999, 1.0][..]).prop_map(Next::Nested),
        1 => (unit(), 0.1..0.9_f64).prop_map(|(out, share)| Next::TouchingInside(out, share)),
        1 => unit().prop_map(Next::TangentPlane),
        1 => unit().prop_map(Next::PlaneThrough),
        1 => unit().prop_map(Next::FarAway),
    ]
}

/// A number from 0 to 1; often one of the ends.
fn share() -> impl Strategy<Value = f32> {
    prop_oneof![select(&[0.0_f32, 0.5, 1.0][..]), 0.0..=1.0_f32]
}

fn index() -> impl Strategy<Value = f32> {
    prop_oneof![select(&[1.0_f32, 1.5, 3.0][..]), 1.0..3.0_f32]
}

fn body() -> impl Strategy<Value = Body> {
    let clear = |inside, outside| Body::Clear { inside, outside };
    prop_oneof![
        share().prop_map(|reflectivity| Body::Opaque { reflectivity }),
        (index(), index()).prop_map(move |(inside, outside)| clear(inside, outside)),
        index().prop_map(move |index| clear(index, index)),
    ]
}

fn phong() -> impl Strategy<Value = Phong> {
    let colour = [share(), share(), share()].prop_map(Vec3::from);
    let pattern = (colour, any::<bool>()).prop_map(|(colour, is_chequered)| {
        if is_chequered {
            Pattern::Checker(colour, Vec3::ZERO)
        } else {
            Pattern::Plain(colour)
        }
    });
    let shininess = prop_oneof![select(&[1, 200, 1000][..]), 1..100_u32];
    (pattern, [share(), share(), share()], shininess).prop_map(
        |(colour, [ambient, diffuse, specular], shininess)| Phong {
            colour,
            ambient,
            diffuse,
            specular,
            shininess,
        },
    )
}

fn tinted() -> impl Strategy<Value = Tinted> {
    let absorption = prop_oneof![select(&[0.0_f32, 1e-6, 1e6, 1e30][..]), 0.0..5.0_f32];
    let absorption = [absorption.clone(), absorption.clone(), absorption];
    let material = (phong(), body()).prop_map(|(phong, body)| Material { phong, body });
    (material, absorption).prop_map(|(material, absorption)| Tinted {
        material,
        absorption: absorption.into(),
    })
}

/// Where the camera or a lamp is.
#[derive(Clone, Copy, Debug)]
enum Spot {
    /// Anywhere.
    Anywhere(DVec3),
    /// In a sphere, at its centre or away from it, up to 1 for its surface.
    In(usize, DVec3, f64),
    /// Very far away.
    FarAway(DVec3),
    /// Where the camera is; the camera itself is at the origin then.
    AtTheEye,
}

fn spot() -> impl Strategy<Value = Spot> {
    let from_centre = select(&[0.0, 0.5, 0.999_999, 1.0][..]);
    prop_oneof![
        3 => (unit(), 0.0..6.0_f64).prop_map(|(out, distance)| Spot::Anywhere(distance * out)),
        3 => (0..5_usize, unit(), from_centre).prop_map(|(which, out, far)| Spot::In(which, out, far)),
        1 => unit().prop_map(Spot::FarAway),
        1 => Just(Spot::AtTheEye),
    ]
}

/// A scene, and where it is looked at from.
#[derive(Clone, Debug)]
struct Seen {
    scene: Scene<Tinted>,
    camera: Camera,
}

/// All of it is `scale` times as large, and as many scene sizes away from the origin of the world.
fn seen() -> impl Strategy<Value = Seen> {
    let scale = prop_oneof![2 => Just(1.0), 1 => select(&[1e-3, 1e3, 1e6][..])];
    let away = prop_oneof![3 => Just(0.0), 1 => select(&[1.0, 1e3, 1e6][..])];
    let objects = prop::collection::vec((next(), tinted()), 1..=5);
    let lamps = prop::collection::vec((spot(), 0.0..2.0_f32), 0..=2);
    let background = [share(), share(), share()].prop_map(Vec3::from);
    let camera = (spot(), unit(), any::<bool>(), 0.3..3.0_f32);
    (scale, away, unit(), objects, lamps, background, camera).prop_map(
        |(scale, away, side, objects, lamps, background, camera)| {
            let at = |p: DVec3| (scale * (p + away * side)).as_vec3();
            let balls = balls(objects.iter().map(|(next, _)| *next));
            let shapes =
                objects
                    .iter()
                    .zip(&balls)
                    .map(|((next, _), &(centre, radius))| {
                        let plane = |point: DVec3, normal: &DVec3| {
                            let plane = Plane::new(at(point), normal.as_vec3());
                            Shape::Plane(plane.expect("a plane"))
                        };
                        match next {
                            Next::TangentPlane(out) => plane(centre + radius * *out, out),
                            Next::PlaneThrough(out) => plane(centre, out),
                            _ => {
                                let sphere =
                                    Sphere::new(at(centre), (scale * radius) as f32);
                                Shape::Sphere(sphere.expect("a sphere"))
                            }
                        }
                    });
            let materials = objects.iter().map(|(_, material)| *material);
            let objects = shapes.zip(materials).map(|(shape, material)| Object {
                name: "",
                shape,
                material,
            });
            let (eye, forward, is_aimed, focal_length) = camera;
            let place = |spot, eye| match spot {
                Spot::Anywhere(place) => place,
                Spot::FarAway(out) => 1e6 * out,
                Spot::AtTheEye => eye,
                Spot::In(which, out, far) => {
                    let (centre, radius) = balls[which % balls.len()];
                    centre + far * radius * out
                }
            };
            let eye = place(eye, DVec3::ZERO);
            // At the first sphere, unless it is inside of that.
            let forward = if is_aimed && eye.distance(balls[0].0) > balls[0].1 {
                (balls[0].0 - eye).normalize()
            } else {
                forward
            };
            let up = forward.any_orthonormal_vector().as_vec3();
            let camera = Camera::new(at(eye), forward.as_vec3(), up, focal_length);
            let lights = lamps.iter().map(|&(spot, intensity)| PointLight {
                position: at(place(spot, eye)),
                intensity,
            });
            Seen {
                scene: Scene {
                    objects: objects.collect(),
                    lights: lights.collect(),
                    background,
                },
                camera: camera.expect("a camera"),
            }
        },
    )
}

/// Centre and radius of each shape; a plane has those of the sphere before it.
fn balls(shapes: impl Iterator<Item = Next>) -> Vec<(DVec3, f64)> {
    let mut balls = Vec::new();
    let (mut centre, mut radius) = (DVec3::ZERO, 1.0);
    for next in shapes {
        (centre, radius) = match next {
            Next::Anywhere(at, r) => (at, r),
            Next::Overlapping(out, r) => (centre + radius * out, r),
            Next::Touching(out, r) => (centre + (radius + r) * out, r),
            Next::Nested(share) => (centre, share * radius),
            Next::TouchingInside(out, share) => {
                (centre + (1.0 - share) * radius * out, share * radius)
            }
            Next::TangentPlane(_) | Next::PlaneThrough(_) => (centre, radius),
            Next::FarAway(out) => (1e6 * out, 3e5),
        };
        balls.push((centre, radius));
        // A sphere in a sphere in a sphere: never smaller than f32 can tell from its centre.
        if radius < 1e-3 {
            radius = 1e-3;
        }
    }
    balls
}

impl Seen {
    fn with<M>(&self, material: impl Fn(&Tinted) -> M) -> Scene<M> {
        let objects = self.scene.objects.iter().map(|object| Object {
            name: object.name,
            shape: object.shape,
            material: material(&object.material),
        });
        Scene {
            objects: objects.collect(),
            lights: self.scene.lights.clone(),
            background: self.scene.background,
        }
    }

    fn mirrors(&self) -> Scene<Mirror> {
        self.with(|Tinted { material, .. }| Mirror {
            phong: material.phong,
            reflectivity: match material.body {
                Body::Opaque { reflectivity } => reflectivity,
                Body::Clear { .. } => 1.0,
            },
        })
    }

    fn clear(&self) -> Scene<Material> {
        self.with(|tinted| tinted.material)
    }
}

/// What a chapter makes of a scene.
type Chapter = fn(&Seen, Reach) -> Picture;

fn reflection(seen: &Seen, reach: Reach) -> Picture {
    let (scene, camera) = (seen.mirrors(), seen.camera);
    Picture::new(move |pixel| {
        ::reflection::trace(&scene, &camera.ray(pixel.centre()), reach)
    })
}

fn refraction(seen: &Seen, reach: Reach) -> Picture {
    let (scene, camera) = (seen.clear(), seen.camera);
    Picture::new(move |pixel| {
        ::refraction::trace(&scene, &camera.ray(pixel.centre()), reach, redirect)
    })
}

fn with_fresnel(seen: &Seen, reach: Reach) -> Picture {
    let (scene, camera) = (seen.clear(), seen.camera);
    Picture::new(move |pixel| {
        ::fresnel::trace(&scene, &camera.ray(pixel.centre()), reach, fresnel)
    })
}

fn leaving(seen: &Seen, reach: Reach, leave: Leave<Material>) -> Picture {
    let (scene, camera) = (seen.clear(), seen.camera);
    Picture::new(move |pixel| {
        let ray = from_the_eye(camera.ray(pixel.centre()));
        ::shadow_acne::trace(&scene, ray, reach, leave)
    })
}

fn transparency(seen: &Seen, reach: Reach) -> Picture {
    let (scene, camera) = (seen.scene.clone(), seen.camera);
    Picture::new(move |pixel| {
        let ray = from_the_eye(camera.ray(pixel.centre()));
        ::transparency::trace(&scene, ray, reach)
    })
}

/// Those whose rays never part.
const UNBRANCHED: [(&str, Chapter); 2] =
    [("reflection", reflection), ("refraction", refraction)];

/// Those whose rays part at a border: the two that are right at any size, and others, which take turns.
const BRANCHED: [(&str, Chapter); 6] = [
    ("from the surface", |seen, reach| {
        leaving(seen, reach, from_the_surface)
    }),
    ("transparency", transparency),
    ("fresnel", with_fresnel),
    ("at the point", |seen, reach| {
        leaving(seen, reach, at_the_point)
    }),
    ("by a fixed offset", |seen, reach| {
        leaving(seen, reach, by_a_fixed_offset)
    }),
    ("by a scaled offset", |seen, reach| {
        leaving(seen, reach, by_a_scaled_offset)
    }),
];

/// Paints it, and sees that every pixel is finite and that it took no more than so many rays for each.
fn check(
    name: &str,
    chapter: Chapter,
    seen: &Seen,
    most: u64,
) -> Result<(), TestCaseError> {
    let canvas = Canvas::paint(&chapter(seen, Reach::new(MAX_DEPTH)), SIZE);
    for (i, light) in canvas.light.iter().enumerate() {
        prop_assert!(light.is_finite(), "{name}: {light} in pixel {i}");
    }
    // From every point that a ray meets there is one more to each lamp.
    let most = most * u64::from(SIZE.x * SIZE.y) * (1 + seen.scene.lights.len() as u64);
    prop_assert!(
        canvas.rays <= most,
        "{name}: {} rays, not {most}",
        canvas.rays
    );
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 10_000,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(1980),
        ..ProptestConfig::default()
    })]

    /// At most a camera ray and `MAX_DEPTH` more where rays never part. Where they do, the shares of one pixel's
    /// rays at any depth add up to 1 at most, and each is more than `LEAST_WEIGHT`: fewer than 2048 of them.
    #[test]
    fn every_pixel_of_any_scene_is_finite_and_done_with_in_time(
        seen in seen(), one_of_the_others in select(&BRANCHED[2..]),
    ) {
        let depth = u64::from(MAX_DEPTH);
        let widest = (1.0 / LEAST_WEIGHT) as u64;
        for (name, chapter) in UNBRANCHED {
            check(name, chapter, &seen, 1 + depth)?;
        }
        for (name, chapter) in [BRANCHED[0], BRANCHED[1], one_of_the_others] {
            check(name, chapter, &seen, 1 + depth * widest)?;
        }
    }
}

/// All chapters that follow rays.
fn chapters() -> impl Iterator<Item = (&'static str, Chapter)> {
    UNBRANCHED.into_iter().chain(BRANCHED)
}

/// The rays of a single pixel between two mirrors that face each other, without a lamp.
fn rays_between_mirrors(chapter: Chapter, reflectivity: f32, depth: u32) -> u64 {
    let phong = Phong {
        colour: Pattern::Plain(Vec3::ONE),
        ambient: 0.1,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1,
    };
    let body = Body::Opaque { reflectivity };
    let material = Material { phong, body };
    let wall = |normal: Vec3| Object {
        name: "",
        shape: Shape::Plane(Plane::new(-normal, normal).expect("a plane")),
        material: Tinted {
            material,
            absorption: Vec3::ZERO,
        },
    };
    let seen = Seen {
        scene: Scene {
            objects: vec![wall(Vec3::Z), wall(Vec3::NEG_Z)],
            lights: vec![],
            background: Vec3::ZERO,
        },
        camera: Camera::new(Vec3::ZERO, Vec3::Z, Vec3::Y, 1.0).expect("a camera"),
    };
    Canvas::paint(&chapter(&seen, Reach::new(depth)), UVec2::ONE).rays
}

/// Nothing is lost between perfect mirrors, and only the depth ends it: one camera ray, and one for each bounce.
#[test]
fn between_perfect_mirrors_the_depth_ends_the_recursion() {
    for (name, chapter) in chapters() {
        for depth in 0..=MAX_DEPTH {
            let rays = rays_between_mirrors(chapter, 1.0, depth);
            assert_eq!(rays, u64::from(depth) + 1, "{name}");
        }
    }
}

/// Of half the light at each bounce 2⁻¹⁰ are left after ten: more than `LEAST_WEIGHT`, which 2⁻¹¹ is not.
#[test]
fn between_half_mirrors_the_weight_ends_the_recursion() {
    for (name, chapter) in chapters() {
        assert_eq!(rays_between_mirrors(chapter, 0.5, MAX_DEPTH), 11, "{name}");
    }
}

/// A floor that slopes, so that no component of anything is zero, met exactly at the origin of the world,
/// and a lamp there, or so near that the square of its distance is zero in f32.
#[test]
fn a_lamp_in_the_very_point_that_is_seen_gives_no_light() {
    let slope = Vec3::new(0.5, 0.7, -0.6);
    let phong = Phong {
        colour: Pattern::Plain(Vec3::ONE),
        ambient: 0.1,
        diffuse: 0.8,
        specular: 0.5,
        shininess: 50,
    };
    let body = Body::Opaque { reflectivity: 0.0 };
    let floor = Object {
        name: "",
        shape: Shape::Plane(Plane::new(Vec3::ZERO, slope).expect("a plane")),
        material: Tinted {
            material: Material { phong, body },
            absorption: Vec3::ZERO,
        },
    };
    for distance in [0.0, 1e-45, 1e-40, 1e-30, 1e-24] {
        let seen = Seen {
            scene: Scene {
                objects: vec![floor.clone()],
                lights: vec![PointLight {
                    position: distance * Vec3::new(1.0, 1.0, -1.0),
                    intensity: 1.0,
                }],
                background: Vec3::ZERO,
            },
            camera: Camera::new(4.0 * Vec3::NEG_Z, Vec3::Z, Vec3::Y, 1.0)
                .expect("a camera"),
        };
        for (name, chapter) in chapters() {
            let picture = chapter(&seen, Reach::new(MAX_DEPTH));
            let light = Canvas::paint(&picture, UVec2::ONE).light[0];
            assert_eq!(light, Vec3::splat(0.1), "{name}: a lamp at {distance}");
        }
    }
}

/// Settings from one end of a view's knob to the other, about so many, that a turn of the knob can reach.
fn settings(view: &View, count: usize) -> Vec<f32> {
    let Some(knob) = &view.knob else {
        return vec![view.default_setting()];
    };
    let mut settings = vec![knob.min];
    while let Some(&last) = settings.last() {
        if last == knob.max {
            break;
        }
        settings.push(knob.turned(last, true));
    }
    let step = settings.len().div_ceil(count);
    settings.into_iter().step_by(step).collect()
}

/// Between the settings that the pictures pin, too.
#[test]
fn no_view_has_a_pixel_that_is_not_finite_however_its_knob_is_turned() {
    for stage in STAGES {
        for view in stage.views {
            for setting in settings(view, 8) {
                let picture = (view.picture)(setting);
                let light = Canvas::paint(&picture, UVec2::new(40, 30)).light;
                let name = stage.picture_name(view, setting);
                assert!(light.iter().all(|light| light.is_finite()), "{name}");
            }
        }
    }
}
