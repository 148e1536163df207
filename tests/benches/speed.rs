//! `cargo bench`: what each method costs that has a choice, and each chapter's picture, on one thread.
//!
//! A method is called a thousand times: its microseconds are nanoseconds for a call. `cargo bench reflection`
//! times one chapter's. No time is asserted anywhere: what a picture costs for certain, in rays, a test counts.

use ::canvas::Pixel;
use ::plane_hit::{Object, Plane, Shape};
use ::ray_casting::Ray;
use ::speed_and_accuracy::study::each;
use ::sphere_hit::{FARTHEST, Sphere, facing};
use divan::{Bencher, black_box};
use glam::{UVec2, Vec2, Vec3};
use light_backwards::STAGES;

fn main() {
    divan::main();
}

const CALLS: usize = 1000;

/// Times a call of each input; the same inputs every time.
fn time<T, A>(
    bencher: Bencher,
    input: impl Fn(&mut fastrand::Rng) -> T,
    call: impl Fn(&T) -> A,
) {
    let mut random = fastrand::Rng::with_seed(13);
    let inputs: Vec<T> = (0..CALLS).map(|_| input(&mut random)).collect();
    bencher.bench_local(each(&inputs, call));
}

/// A direction, all of them alike.
fn unit(random: &mut fastrand::Rng) -> Vec3 {
    loop {
        let vector = Vec3::from_array(std::array::from_fn(|_| 2.0 * random.f32() - 1.0));
        if (1e-3..1.0).contains(&vector.length_squared()) {
            return vector.normalize();
        }
    }
}

/// From a distance of 5 towards somewhere within 1.5 of the origin.
fn ray(random: &mut fastrand::Rng) -> Ray {
    let origin = 5.0 * unit(random);
    let target = 1.5 * random.f32() * unit(random);
    Ray {
        origin,
        direction: (target - origin).normalize(),
    }
}

/// A unit normal, and the unit direction of a ray that meets it from its front.
fn meeting(random: &mut fastrand::Rng) -> (Vec3, Vec3) {
    let normal = unit(random);
    (normal, facing(unit(random), normal))
}

/// Of which the compiler knows nothing.
fn ball() -> Sphere {
    black_box(Sphere {
        centre: Vec3::ZERO,
        radius: 1.0,
    })
}

mod sphere_hit {
    use super::*;

    #[divan::bench]
    fn by_slide(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.hit_by_slide(ray, FARTHEST));
    }

    #[divan::bench]
    fn stable(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.hit(ray, FARTHEST));
    }

    #[divan::bench]
    fn in_f64(bencher: Bencher) {
        let ball = ball();
        time(bencher, ray, |ray| ball.hit_in_f64(ray, FARTHEST));
    }
}

mod plane_hit {
    use super::*;

    #[divan::bench]
    fn plane(bencher: Bencher) {
        let floor = black_box(Plane {
            point: Vec3::NEG_Y,
            normal: Vec3::Y,
        });
        time(bencher, ray, |ray| floor.hit(ray, FARTHEST));
    }
}

mod shading {
    use super::*;
    use ::shading::power;

    #[divan::bench(args = [10, 50, 200])]
    fn power_of(bencher: Bencher, exponent: u32) {
        time(bencher, fastrand::Rng::f32, |&base| power(base, exponent));
    }
}

mod reflection {
    use super::*;
    use ::reflection::{reflect, reflect_by_slide};

    #[divan::bench]
    fn by_slide(bencher: Bencher) {
        time(bencher, meeting, |&(normal, incident)| {
            reflect_by_slide(incident, normal)
        });
    }

    #[divan::bench]
    fn normalised(bencher: Bencher) {
        time(bencher, meeting, |&(normal, incident)| {
            reflect(incident, normal)
        });
    }
}

mod refraction {
    use super::*;
    use ::refraction::refract;

    #[divan::bench]
    fn into_glass(bencher: Bencher) {
        time(bencher, meeting, |&(normal, incident)| {
            refract(incident, normal, black_box(1.0 / 1.5))
        });
    }

    #[divan::bench]
    fn out_of_glass(bencher: Bencher) {
        time(bencher, meeting, |&(normal, incident)| {
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
        time(bencher, fastrand::Rng::f32, |&cos_theta_i| {
            reflectance(cos_theta_i, 1.0, 1.5)
        });
    }
}

/// Of 16 samples of the pixels about an edge, without what a sample costs.
mod anti_aliasing {
    use super::*;
    use ::anti_aliasing::{adaptive, jittered, regular};
    use ::speed_and_accuracy::sampling::low_discrepancy;

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

    fn with(bencher: Bencher, sampler: fn(Pixel, u32, &dyn Fn(Vec2) -> Vec3) -> Vec3) {
        let size = UVec2::new(8, 6);
        let pixel = |random: &mut fastrand::Rng| Pixel {
            x: random.u32(0..size.x),
            y: random.u32(0..size.y),
            size,
        };
        let edge = |point: Vec2| Vec3::splat(f32::from(point.x > 0.3 * point.y));
        time(bencher, pixel, |&pixel| sampler(pixel, 4, &edge));
    }
}

/// Leaving a ball to any side, and meeting it again or not.
mod shadow_acne {
    use super::*;
    use ::shadow_acne::{
        Leave, at_the_point, by_a_fixed_offset, by_a_scaled_offset, from_the_surface,
    };

    #[divan::bench]
    fn no_step(bencher: Bencher) {
        with(bencher, at_the_point);
    }

    #[divan::bench]
    fn fixed(bencher: Bencher) {
        with(bencher, by_a_fixed_offset);
    }

    #[divan::bench]
    fn scaled(bencher: Bencher) {
        with(bencher, by_a_scaled_offset);
    }

    #[divan::bench]
    fn surface(bencher: Bencher) {
        with(bencher, from_the_surface);
    }

    fn with(bencher: Bencher, leave: Leave<()>) {
        let ball = Object {
            name: "",
            shape: Shape::Sphere(ball()),
            material: (),
        };
        let departure = |random: &mut fastrand::Rng| (unit(random), unit(random));
        time(bencher, departure, |&(normal, direction)| {
            leave(&ball, normal, normal, direction).hit(&ball, FARTHEST)
        });
    }
}

/// The first view of each chapter, as linear light: as large as where its rays are counted.
#[divan::bench(args = STAGES.map(|stage| stage.name), max_time = 1)]
fn pictures(bencher: Bencher, name: &str) {
    let stage = STAGES.into_iter().find(|stage| stage.name == name);
    let view = &stage.expect("one of them").views[0];
    let picture = (view.picture)(view.default_setting());
    let size = UVec2::new(160, 120);
    let rows: Vec<Pixel> = (0..size.y).map(|y| Pixel { x: 0, y, size }).collect();
    let paint = |&first: &Pixel| {
        let mut row = vec![Vec3::ZERO; size.x as usize];
        picture.paint(first, &mut row);
        row
    };
    bencher.bench_local(each(&rows, paint));
}
