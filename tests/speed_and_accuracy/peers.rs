//! Other people's tracers: what can be said of them where they are not installed.

use crate::found::{POV_RAY, Peers, TINYRAYTRACER, traced_s};
use crate::tinyraytracer::{BUDGET, SIZE, ppm, scene};
use glam::{UVec2, Vec2, Vec3};
use harness::bits;
use measure::pictures::{frame, packet_picture, scalar_picture};
use packets::LANES;
use sphere_hit::T_MAX;
use std::ffi::OsStr;
use std::fs;

/// Its point (x, y, z), of which ours is half, is seen at √3 (x, y)/−z; a ball's centre, a radius before.
#[test]
fn tinyraytracers_balls_are_where_it_has_them() {
    let (scene, camera) = scene();
    let theirs = [
        ("ivory", [-3.0, 0.0, -16.0], 2.0),
        ("glass", [-1.0, -1.5, -12.0], 2.0),
        ("rubber", [1.5, -0.5, -18.0], 3.0),
        ("mirror", [7.0, 5.0, -18.0], 4.0),
        ("board", [0.5, -4.0, -10.5], 0.0),
    ];
    for (name, [x, y, z], radius) in theirs {
        let object = scene.objects.iter().find(|object| object.name == name);
        let ray = camera.ray(3.0_f32.sqrt() * Vec2::new(x, y) / -z);
        let t = object.expect("an object").shape.distance(&ray, T_MAX);
        let before = (Vec3::new(x, y, z).length() - radius) / 2.0;
        let error = t.expect("a hit") - before;
        assert!(error.abs() <= 1e-5, "{name} is {error} off");
    }
}

/// Its colours are by `(int(.5*x + 1000) + int(.5*z)) & 1`, for z < 0.
#[test]
fn tinyraytracers_squares_have_its_colours() {
    let (scene, _) = scene();
    let board = scene.objects.iter().find(|object| object.name == "board");
    let texture = board.expect("a board").material.phong.colour;
    for x in -10..10 {
        for z in -30..-10 {
            let [x, z] = [x, z].map(|i| i as f32 + 0.5);
            let theirs = if ((0.5 * x + 1000.0) as i32 + (0.5 * z) as i32) & 1 == 1 {
                Vec3::new(0.3, 0.3, 0.3)
            } else {
                Vec3::new(0.3, 0.2, 0.1)
            };
            let ours = texture.value(Vec2::new(x, z) / 2.0);
            assert_eq!(ours, theirs, "at {x}, {z}");
        }
    }
}

#[test]
fn tinyraytracers_picture_has_the_same_bits_in_packets() {
    let (scene, camera) = scene();
    // Not whole packets.
    let size = SIZE / 5;
    assert_ne!(size.x as usize % LANES, 0);
    let scalar = scalar_picture(scene.clone(), camera, BUDGET, 1);
    let packets = packet_picture(scene, camera, BUDGET, 1);
    let [scalar, packets] = [scalar, packets].map(|picture| frame(&picture, size, LANES));
    assert!(scalar.iter().map(bits).eq(packets.iter().map(bits)));
}

#[test]
fn a_ppm_dims_what_is_too_bright_and_keeps_its_colour() {
    let radiance = [Vec3::new(2.0, 1.0, 0.0), Vec3::new(1.0, 0.5, 0.004)];
    let file = ppm(UVec2::new(1, 2), &radiance);
    assert_eq!(file, b"P6\n1 2\n255\n\xff\x7f\x00\xff\x7f\x01");
}

/// The end of what version 3.7 says.
#[test]
fn povrays_time_is_that_of_its_tracing() {
    let said = "Parse Time: 0 hours 0 minutes  0 seconds (0.001 seconds)
              using 1 thread(s) with 0.000 CPU-seconds total
            Trace Time:       0 hours  0 minutes  5 seconds (5.998 seconds)
              using 1 thread(s) with 5.967 CPU-seconds total
            POV-Ray finished";
    assert_eq!(traced_s(said), Some(5.998));
    assert_eq!(traced_s("Cannot open the file (5.998 s)."), None);
}

#[test]
fn who_is_missing_is_said_in_a_line_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = folder.path().to_str().expect("UTF-8");
    let find = |source: &str, path: &str| Peers::find(source, OsStr::new(path));
    let peers = find("none", "").expect("none is right");
    assert!(peers.povray.is_none() && peers.tinyraytracer.is_none());
    let [pov_ray, tinyraytracer] = &peers.missing[..] else {
        panic!("{peers:?}");
    };
    assert!(pov_ray.starts_with(POV_RAY) && pov_ray.contains("no povray"));
    assert!(tinyraytracer.starts_with(TINYRAYTRACER), "{tinyraytracer}");

    for wrong in [name, "", "/nowhere"] {
        let line = find(wrong, "").expect_err("no source").to_string();
        assert!(line.contains("tinyraytracer.cpp"), "{line}");
    }

    fs::write(folder.path().join("tinyraytracer.cpp"), "").expect("a file");
    let lines = find(name, "").expect("a source").missing;
    assert_eq!(lines.len(), 2, "{lines:?}");
    assert!(lines[1].contains("there is no g++"), "{lines:?}");

    // A program is found by its name in any of the folders.
    for program in ["povray", "g++"] {
        fs::write(folder.path().join(program), "").expect("a file");
    }
    let peers = find(name, &format!("/nowhere:{name}")).expect("all");
    assert_eq!(peers.missing, [""; 0]);
    assert!(peers.povray.is_some() && peers.tinyraytracer.is_some());
}
