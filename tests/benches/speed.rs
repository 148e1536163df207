//! `cargo bench`: what each method costs that has a choice, and each chapter's picture, on one thread.
//!
//! A method is called a thousand times: its microseconds are nanoseconds for a call. `cargo bench reflection`
//! times one chapter's. No time is asserted anywhere: what a picture costs for certain, in rays, a test counts.

use ::canvas::Pixel;
use ::measure::Random;
use ::plane_hit::{Object, Plane, Shape};
use ::ray_casting::Ray;
use ::speed_and_accuracy::study::each;
use ::sphere_hit::{Sphere, T_MAX, face_forward};
use ::stages::STAGES;
use divan::{Bencher, black_box};
use glam::{UVec2, Vec2, Vec3};

fn main() {
    divan::main();
}

const CALLS: usize = 1000;

/// Times a call of each input; the same inputs every time.
fn time<T, A>(
    bencher: Bencher,
    input: impl Fn(&mut Random) -> T,
    call: impl Fn(&T) -> A,
) {
    let mut random = Random::new(13);
    let inputs: Vec<T> = (0..CALLS).map(|_| input(&mut random)).collect();
    bencher.bench_local(each(&inputs, call));
}

fn unit(random: &mut Random) -> Vec3 {
    random.direction().as_vec3()
}

/// From a distance of 5 towards somewhere within 1.5 of the origin.
fn ray(random: &mut Random) -> Ray {
    let origin = 5.0 * unit(random);
    let target = 1.5 * random.f32() * unit(random);
    Ray {
        origin,
        direction: (target - origin).normalize(),
    }
}

/// A unit normal, and the unit direction of a ray that hits its surface from the front.
fn hit(random: &mut Random) -> (Vec3, Vec3) {
    let normal = unit(random);
    (normal, face_forward(unit(random), normal))
}

/// A sphere of which the compiler knows nothing.
fn ball() -> Sphere {
    black_box(Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    })
}

mod sphere_hit {
    use super::*;

    #[divan::bench]
    fn quadratic(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.distance_quadratic(ray, T_MAX));
    }

    #[divan::bench]
    fn stable(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.distance(ray, T_MAX));
    }

    #[divan::bench]
    fn in_f64(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.hit_in_f64(ray, T_MAX));
    }
}

mod plane_hit {
    use super::*;

    #[divan::bench]
    fn plane(bencher: Bencher) {
        let floor = black_box(Plane::new(Vec3::NEG_Y, Vec3::Y).expect("a plane"));
        time(bencher, ray, |ray| floor.distance(ray, T_MAX));
    }
}

mod shading {
    use super::*;

    #[divan::bench(args = [10, 50, 200])]
    fn powi(bencher: Bencher, exponent: u32) {
        time(bencher, Random::f32, |&base| {
            ::shading::powi(base, exponent)
        });
    }
}

mod reflection {
    use super::*;
    use ::reflection::{reflect, reflect_unnormalized};

    #[divan::bench]
    fn unnormalized(bencher: Bencher) {
        time(bencher, hit, |&(normal, incident)| {
            reflect_unnormalized(incident, normal)
        });
    }

    #[divan::bench]
    fn normalized(bencher: Bencher) {
        time(bencher, hit, |&(normal, incident)| {
            reflect(incident, normal)
        });
    }
}

mod refraction {
    use super::*;
    use ::refraction::refract;

    #[divan::bench]
    fn into_glass(bencher: Bencher) {
        time(bencher, hit, |&(normal, incident)| {
            refract(incident, normal, black_box(1.0 / 1.5))
        });
    }

    #[divan::bench]
    fn out_of_glass(bencher: Bencher) {
        time(bencher, hit, |&(normal, incident)| {
            refract(incident, normal, black_box(1.5))
        });
    }
}

mod fresnel {
    use super::*;
    use ::fresnel::{Reflectance, fresnel, schlick};

    #[divan::bench]
    fn exact(bencher: Bencher) {
        with(bencher, fresnel);
    }

    #[divan::bench]
    fn by_schlick(bencher: Bencher) {
        with(bencher, schlick);
    }

    fn with(bencher: Bencher, reflectance: Reflectance) {
        time(bencher, Random::f32, |&cos_theta_i| {
            reflectance(cos_theta_i, 1.0, 1.5)
        });
    }
}

/// Of 16 samples of the pixels about an edge, without what a sample costs.
mod anti_aliasing {
    use super::*;
    use ::anti_aliasing::sobol::low_discrepancy;
    use ::anti_aliasing::{Sampler, adaptive, jittered, regular};

    #[divan::bench]
    fn on_a_grid(bencher: Bencher) {
        with(bencher, regular);
    }

    #[divan::bench]
    fn by_jitter(bencher: Bencher) {
        with(bencher, jittered);
    }

    #[divan::bench]
    fn by_need(bencher: Bencher) {
        with(bencher, adaptive);
    }

    #[divan::bench]
    fn by_sobol(bencher: Bencher) {
        with(bencher, low_discrepancy);
    }

    fn with(bencher: Bencher, sampler: Sampler) {
        let pixels: Vec<Pixel> = Pixel::all(UVec2::new(8, 6)).collect();
        let edge = |point: Vec2| Vec3::splat(f32::from(point.x > 0.3 * point.y));
        time(
            bencher,
            |random| random.pick(&pixels),
            |&pixel| sampler(pixel, 4, &edge),
        );
    }
}

/// Leaving a ball to any side, and hitting it again or not.
mod shadow_acne {
    use super::*;
    use ::shadow_acne::{
        SpawnRay, from_surface, with_fixed_offset, with_scaled_offset, without_offset,
    };
    use ::shadows::Interaction;

    #[divan::bench]
    fn no_offset(bencher: Bencher) {
        with(bencher, without_offset);
    }

    #[divan::bench]
    fn fixed(bencher: Bencher) {
        with(bencher, with_fixed_offset);
    }

    #[divan::bench]
    fn scaled(bencher: Bencher) {
        with(bencher, with_scaled_offset);
    }

    #[divan::bench]
    fn surface(bencher: Bencher) {
        with(bencher, from_surface);
    }

    fn with(bencher: Bencher, spawn: SpawnRay) {
        let ball = [Object {
            name: "",
            shape: Shape::Sphere(ball()),
            material: (),
        }];
        let hit = |random: &mut Random| {
            let outward = unit(random);
            let (origin, direction) = (2.0 * outward, -outward);
            let at = Interaction::new(&ball, &Ray { origin, direction }, (0, 1.0));
            (at, unit(random))
        };
        time(bencher, hit, |(at, direction)| {
            let shape = &ball[0].shape;
            spawn(at, *direction).distance(0, shape, T_MAX)
        });
    }
}

/// The first view of each chapter, as linear light: as large as where its rays are counted.
#[divan::bench(args = STAGES.map(|stage| stage.name), max_time = 1)]
fn pictures(bencher: Bencher, name: &str) {
    let stage = STAGES.into_iter().find(|stage| stage.name == name);
    let view = stage.expect("one of them").hero();
    let picture = (view.picture)(view.default_setting());
    let size = UVec2::new(160, 120);
    let rows: Vec<Pixel> = Pixel::all(size).filter(|pixel| pixel.x == 0).collect();
    let render = |&first: &Pixel| {
        let mut row = vec![Vec3::ZERO; size.x as usize];
        picture.render_span(first, &mut row);
        row
    };
    bencher.bench_local(each(&rows, render));
}
