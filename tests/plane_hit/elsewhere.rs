//! A pattern belongs to its surface: it moves with it.

use ::plane_hit::Shape;
use glam::{Vec2, Vec3, vec3};

/// Whole numbers, in which nothing is rounded.
#[test]
fn a_pattern_moves_with_its_surface() {
    let from_origin = vec3(3.0, 4.0, -5.0);
    for at in [Vec3::ZERO, vec3(10.0, -20.0, 30.0), vec3(-1000.0, 7.0, 2.0)] {
        for (shape, uv) in [
            (Shape::sphere(at, 9.0), Vec2::new(3.0, -5.0)),
            (Shape::plane(at, Vec3::Y), Vec2::new(3.0, -5.0)),
            (Shape::plane(at, Vec3::NEG_Z), Vec2::new(3.0, 4.0)),
        ] {
            assert_eq!(shape.uv(at + from_origin), uv, "{shape:?}");
        }
    }
}
