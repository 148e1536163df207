//! Random scenes, ordinary and extreme ones, for tests.

use crate::Random;
use glam::{DVec3, Vec3};
use plane_hit::{Object, Shape, Texture};
use ray_casting::{Camera, MAX_LENGTH};
use refraction::{Material, Optics};
use shading::Phong;
use shadows::{CoincidentSurfaces, PointLight, Scene};
use transparency::Absorbing;

/// Returns an ordinary scene and a camera that looks at it: balls of plastic, mirror and glass,
/// mostly on a floor, under up to three lights. If `disjoint`, no ball touches another or the
/// floor's underside.
///
/// # Panics
/// Never: all shapes and the camera are valid.
#[must_use]
pub fn ordinary(seed: u32, disjoint: bool) -> (Scene<Absorbing>, Camera) {
    let random = &mut Random::new(seed);
    let mut objects: Vec<Object<Absorbing>> = Vec::new();
    if random.chance(0.8) {
        let checker = Texture::Checker(random.colour(), random.colour());
        objects.push(Object {
            name: "floor",
            shape: Shape::plane(Vec3::ZERO, Vec3::Y),
            material: plastic(checker, random),
        });
    }
    for _ in 0..1 + random.index(7) {
        let radius = random.between(0.2, 1.2);
        let sunk = if disjoint { 0.0 } else { -0.5 };
        let height = radius + random.between(sunk, 1.5);
        let centre =
            Vec3::new(random.between(-3.0, 3.0), height, random.between(-2.0, 3.0));
        let touches = |object: &Object<Absorbing>| match object.shape {
            Shape::Sphere(other) => other.centre.distance(centre) < other.radius + radius,
            Shape::Plane(_) => false,
        };
        if disjoint && objects.iter().any(touches) {
            continue;
        }
        let material = if random.chance(0.3) {
            let eta_outside = if disjoint {
                1.0
            } else {
                random.pick(&[1.0, 1.0, 1.5])
            };
            glass(eta_outside, random)
        } else {
            plastic(Texture::Solid(random.colour()), random)
        };
        objects.push(Object {
            name: "ball",
            shape: Shape::sphere(centre, radius),
            material,
        });
    }
    let lights = (0..random.index(4)).map(|_| PointLight {
        position: Vec3::new(
            random.between(-6.0, 6.0),
            random.between(4.0, 9.0),
            random.between(-7.0, 2.0),
        ),
        intensity: random.between(0.2, 0.8),
    });
    let lights = lights.collect();
    let eye = Vec3::new(
        random.between(-3.0, 3.0),
        random.between(0.5, 4.0),
        random.between(-9.0, -5.0),
    );
    let towards = Vec3::new(random.between(-0.5, 0.5), 1.0, 0.5) - eye;
    let camera = Camera::new(eye, towards, Vec3::Y, random.between(1.0, 3.0));
    let scene = Scene {
        objects,
        lights,
        background: random.colour(),
    };
    (scene, camera.expect("it looks ahead, not up"))
}

fn plastic(colour: Texture, random: &mut Random) -> Absorbing {
    let phong = Phong {
        colour,
        ambient: random.between(0.02, 0.3),
        diffuse: random.between(0.0, 0.9),
        specular: random.between(0.0, 0.9),
        shininess: 1 + random.index(200) as u32,
    };
    let reflects = random.chance(0.33);
    let reflectivity = if reflects {
        random.between(0.1, 0.8)
    } else {
        0.0
    };
    Absorbing {
        material: Material {
            phong,
            optics: Optics::Opaque { reflectivity },
        },
        absorption: Vec3::ZERO,
    }
}

fn glass(eta_outside: f32, random: &mut Random) -> Absorbing {
    let phong = Phong {
        colour: Texture::Solid(Vec3::ONE),
        ambient: 0.0,
        diffuse: 0.0,
        specular: random.between(0.0, 0.9),
        shininess: 1 + random.index(200) as u32,
    };
    let optics = Optics::Dielectric {
        eta_inside: random.between(1.05, 2.4),
        eta_outside,
    };
    Absorbing {
        material: Material { phong, optics },
        absorption: random.between(0.0, 2.0) * random.colour(),
    }
}

/// Returns a scene of bodies that overlap, nest and touch, and a camera that looks at them: balls, most of them
/// clear, among them some of the same medium, mostly on the surface of endless water and over a checkered
/// bottom, in any order. The eye may be in the water, and a light in a ball.
///
/// # Panics
/// Never: all shapes and the camera are valid, and no two surfaces are the same.
#[must_use]
pub fn overlapping(seed: u32) -> (Scene<Absorbing>, Camera) {
    let random = &mut Random::new(seed);
    let eta_outside = random.pick(&[1.0, 1.0, 1.2]);
    let tint = random.between(0.0, 1.0) * random.colour();
    let body = |shape, random: &mut Random| {
        let material = if random.chance(0.2) {
            plastic(Texture::Solid(random.colour()), random)
        } else {
            let mut clear = glass(eta_outside, random);
            clear.material.optics = Optics::Dielectric {
                eta_inside: random.pick(&[1.0, 1.31, 1.33, 1.5, 1.5, 1.7]),
                eta_outside,
            };
            clear.absorption = random.pick(&[Vec3::ZERO, tint, clear.absorption]);
            clear
        };
        Object {
            name: "ball",
            shape,
            material,
        }
    };
    let (mut centre, mut radius) = (DVec3::ZERO, f64::from(random.between(0.6, 1.2)));
    let mut objects: Vec<Object<Absorbing>> = Vec::new();
    for _ in 0..2 + random.index(4) {
        let ball = Shape::sphere(centre.as_vec3(), radius as f32);
        objects.push(body(ball, random));
        let next = f64::from(random.between(0.3, 0.9));
        let out = random.direction();
        (centre, radius) = match random.index(5) {
            // Overlapping, touching from outside and from inside, and nested.
            0 | 1 => (centre + radius * out, next),
            2 => (centre + (radius + next) * out, next),
            3 => (centre + (1.0 - next) * radius * out, next * radius),
            _ => (centre + 0.5 * (1.0 - next) * radius * out, next * radius),
        };
    }
    let checker = Texture::Checker(random.colour(), random.colour());
    let bottom = Shape::plane(3.0 * Vec3::NEG_Y, Vec3::Y);
    objects.push(Object {
        name: "bottom",
        shape: bottom,
        material: plastic(checker, random),
    });
    if random.chance(0.7) {
        let normal = Vec3::Y + random.between(0.0, 0.3) * random.direction().as_vec3();
        let level = random.between(-1.0, 1.0) * Vec3::Y;
        let mut water = body(Shape::plane(level, normal), random);
        if let Optics::Dielectric { .. } = water.material.material.optics {
            water.name = "water";
            objects.insert(random.index(objects.len()), water);
        }
    }
    let lights = (0..1 + random.index(2)).map(|_| {
        let position = if random.chance(0.2) {
            random.direction()
        } else {
            random.direction() * 6.0
        };
        let position = position.with_y(position.y.abs()).as_vec3();
        PointLight::new(position, random.between(0.3, 0.8)).expect("a valid light")
    });
    let lights = lights.collect();
    let eye = Vec3::new(
        random.between(-2.0, 2.0),
        random.between(-1.5, 3.0),
        random.between(-7.0, -4.0),
    );
    let camera = Camera::new(eye, -eye, Vec3::Y, random.between(1.5, 3.0));
    let scene = Scene::new(objects, lights, random.colour());
    (
        scene.expect("no surface twice"),
        camera.expect("it looks ahead, not up"),
    )
}

/// Returns an extreme scene and a camera: up to five spheres that overlap, touch and contain
/// each other, and planes; mirrors and glass; all of it of any size and anywhere, over the
/// whole range of [`MAX_LENGTH`], with the camera and the lights outside, inside and on the
/// surfaces.
///
/// # Panics
/// Never: all shapes and the camera are valid.
#[must_use]
pub fn extreme(seed: u32) -> (Scene<Absorbing>, Camera) {
    let random = &mut Random::new(seed);
    // A scene of two surfaces at one place is no scene.
    std::iter::repeat_with(|| extreme_or_coincident(random))
        .find_map(Result::ok)
        .expect("some scene")
}

fn extreme_or_coincident(
    random: &mut Random,
) -> Result<(Scene<Absorbing>, Camera), CoincidentSurfaces> {
    let any = any_length(random);
    let scale = random.pick(&[1.0, 1.0, 1.0, 1.0, 1e-3, 1e3, 1e6, any]);
    let any = any_length(random);
    let away =
        random.pick(&[0.0, 0.0, 0.0, 0.0, 1.0, 1e3, 1e6, any]) * random.direction();
    let at = |p: DVec3| {
        let limit = DVec3::splat(f64::from(MAX_LENGTH));
        (scale * (p + away)).clamp(-limit, limit).as_vec3()
    };
    let length = |radius: f64| {
        let greatest = f64::from(MAX_LENGTH);
        // Rounding must not leave the range.
        (scale * radius).clamp(1.000_001 / greatest, greatest) as f32
    };

    let mut solids: Vec<Solid> = Vec::new();
    let mut last = (DVec3::ZERO, 1.0);
    for _ in 0..1 + random.index(5) {
        let next = next_solid(last, random);
        if let Solid::Ball(centre, radius) = next {
            // A sphere in a sphere in a sphere: f32 still resolves it beside its centre.
            last = (centre, if radius < 1e-3 { 1e-3 } else { radius });
        }
        solids.push(next);
    }
    let objects = solids.iter().map(|solid| Object {
        name: "",
        shape: match *solid {
            Solid::Ball(centre, radius) => Shape::sphere(at(centre), length(radius)),
            Solid::Below(point, normal) => Shape::plane(at(point), normal.as_vec3()),
        },
        material: material(random),
    });
    let objects = objects.collect();

    let eye = position(&solids, DVec3::ZERO, random);
    // At the first sphere, unless the eye is inside.
    let forward = match solids[0] {
        Solid::Ball(first, radius) if random.bool() && eye.distance(first) > radius => {
            (first - eye).normalize()
        }
        _ => random.direction(),
    };
    let up = forward.any_orthonormal_vector().as_vec3();
    let focal_length = if random.chance(0.8) {
        random.between(0.3, 3.0)
    } else {
        random.magnitude(1.0 / MAX_LENGTH, MAX_LENGTH)
    };
    let camera = Camera::new(at(eye), forward.as_vec3(), up, focal_length);
    let lights = (0..random.index(3)).map(|_| {
        let position = at(position(&solids, eye, random));
        let intensity = if random.chance(0.9) {
            random.between(0.0, 2.0)
        } else {
            random.magnitude(1.0 / MAX_LENGTH, MAX_LENGTH)
        };
        PointLight::new(position, intensity).expect("a valid light")
    });
    let lights = lights.collect();
    let background = Vec3::from_array([(); 3].map(|()| fraction(random)));
    let scene = Scene::new(objects, lights, background)?;
    Ok((scene, camera.expect("its directions are orthonormal")))
}

/// Returns a size or a distance of any order of magnitude.
fn any_length(random: &mut Random) -> f64 {
    f64::from(random.magnitude(1.0 / MAX_LENGTH, MAX_LENGTH))
}

/// A shape of an extreme scene, before it is scaled and moved.
#[derive(Clone, Copy)]
enum Solid {
    /// The sphere with this centre and radius.
    Ball(DVec3, f64),
    /// The plane through this point, with this normal.
    Below(DVec3, DVec3),
}

fn next_solid((centre, radius): (DVec3, f64), random: &mut Random) -> Solid {
    let out = random.direction();
    let r = match random.index(5) {
        0..=2 => f64::from(random.between(0.3, 2.0)),
        3 => f64::from(random.between(0.01, 0.3)),
        _ => random.pick(&[1e-3, 1.0, 10.0]),
    };
    match random.index(11) {
        // At any position.
        0..=2 => Solid::Ball(f64::from(random.between(0.0, 4.0)) * out, r),
        // Its centre on the surface of the one before.
        3 => Solid::Ball(centre + radius * out, r),
        // Touching that one in a point, from outside.
        4 => Solid::Ball(centre + (radius + r) * out, r),
        // Concentric.
        5 => Solid::Ball(centre, random.pick(&[0.2, 0.9, 0.999_999]) * radius),
        // Touching it in a point, from inside.
        6 => {
            let factor = f64::from(random.between(0.1, 0.9));
            Solid::Ball(centre + (1.0 - factor) * radius * out, factor * radius)
        }
        // Touching it, or through its centre; level or tilted.
        7 => Solid::Below(centre + radius * out, out),
        8 => Solid::Below(centre, random.pick(&[out, DVec3::Y])),
        // Very far away, and very large.
        9 => Solid::Ball(1e6 * out, 3e5),
        // Of any size, anywhere.
        _ => Solid::Ball(any_length(random) * out, any_length(random)),
    }
}

/// Returns the position of the camera or a light.
fn position(solids: &[Solid], eye: DVec3, random: &mut Random) -> DVec3 {
    let out = random.direction();
    match random.index(9) {
        0..=2 => f64::from(random.between(0.0, 6.0)) * out,
        // In a sphere, from its centre to its surface; in a plane.
        3..=5 => match random.pick(solids) {
            Solid::Ball(centre, radius) => {
                centre + random.pick(&[0.0, 0.5, 0.999_999, 1.0]) * radius * out
            }
            Solid::Below(point, normal) => {
                point + f64::from(random.between(0.0, 6.0)) * out.reject_from(normal)
            }
        },
        6 => 1e6 * out,
        7 => any_length(random) * out,
        _ => eye,
    }
}

/// Returns a number from 0 to 1; often one of the ends.
fn fraction(random: &mut Random) -> f32 {
    if random.bool() {
        random.pick(&[0.0, 0.5, 1.0])
    } else {
        random.f32()
    }
}

fn material(random: &mut Random) -> Absorbing {
    let colour = Vec3::from_array([(); 3].map(|()| fraction(random)));
    let phong = Phong {
        colour: if random.bool() {
            Texture::Checker(colour, Vec3::ZERO)
        } else {
            Texture::Solid(colour)
        },
        ambient: fraction(random),
        diffuse: fraction(random),
        specular: fraction(random),
        shininess: if random.bool() {
            random.pick(&[1, 200, 100_000, u32::MAX])
        } else {
            1 + random.index(99) as u32
        },
    };
    let eta = |random: &mut Random| {
        if random.bool() {
            random.pick(&[0.1, 1.0, 1.5, 3.0, 10.0])
        } else {
            random.between(1.0, 3.0)
        }
    };
    let optics = match random.index(3) {
        0 => Optics::Opaque {
            reflectivity: fraction(random),
        },
        1 => Optics::Dielectric {
            eta_inside: eta(random),
            eta_outside: eta(random),
        },
        _ => {
            let eta = eta(random);
            Optics::Dielectric {
                eta_inside: eta,
                eta_outside: eta,
            }
        }
    };
    let rate = |random: &mut Random| {
        if random.bool() {
            random.pick(&[0.0, 1e-6, 1e6, 1e30])
        } else {
            random.between(0.0, 5.0)
        }
    };
    Absorbing {
        material: Material { phong, optics },
        absorption: Vec3::from_array([(); 3].map(|()| rate(random))),
    }
}
