//! What the race builds beside an older commit: reads the names of pictures, and how often each
//! is to be rendered, and prints the seconds that one took.

mod clock;

use anti_aliasing::regular;
use canvas::{Picture, Pixel};
use glam::{UVec2, Vec2, Vec3};
use ray_casting::views::{STILL_LIFE_FOCAL_LENGTH, still_life_camera};
use reflection::{MAX_DEPTH, Reach};
use refraction::views::{AIR, GLASS, still_life_with_glass};
use shadow_acne::{from_the_eye, from_the_surface};
use std::hint::black_box;
use transparency::views::{AMBER, tinted_still_life};

fn picture(name: &str) -> Picture {
    let camera = still_life_camera(STILL_LIFE_FOCAL_LENGTH);
    let reach = Reach::new(MAX_DEPTH);
    match name {
        "packets-4" => (packets::STAGE.views[0].picture)(4.0),
        "packets-1" => (packets::STAGE.views[0].picture)(1.0),
        "10" => {
            let scene = still_life_with_glass(GLASS, AIR);
            let light = move |point: Vec2| {
                let ray = from_the_eye(camera.ray(point));
                shadow_acne::trace(&scene, ray, reach, from_the_surface)
            };
            Picture::new(move |pixel| regular(pixel, 4, &light))
        }
        "11" => {
            let scene = tinted_still_life(AMBER);
            let light = move |point: Vec2| {
                let ray = from_the_eye(camera.ray(point));
                transparency::trace(&scene, ray, reach)
            };
            Picture::new(move |pixel| regular(pixel, 4, &light))
        }
        other => panic!("no picture {other}"),
    }
}

fn main() {
    let size = UVec2::new(800, 600);
    for line in std::io::stdin().lines() {
        let line = line.expect("a line");
        let (name, times) = line.split_once(' ').expect("a name and a number");
        let times: u32 = times.parse().expect("a number");
        let picture = picture(name);
        let mut radiance = vec![Vec3::ZERO; size.element_product() as usize];
        let start = clock::cpu_s();
        for _ in 0..times {
            for (y, row) in (0..).zip(radiance.chunks_mut(size.x as usize)) {
                picture.paint(Pixel { x: 0, y, size }, row);
            }
            black_box(&mut radiance);
        }
        println!("{}", (clock::cpu_s() - start) / f64::from(times));
    }
}
