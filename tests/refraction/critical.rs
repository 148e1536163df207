//! The critical angle itself.

use ::refraction::refract;
use glam::{Vec3, vec3};

/// sinθᵢ = ½ and η = 2: η² sin²θᵢ is exactly 1, and cosθₜ would be 0. A ray that would run along
/// the surface has not left, so all light is reflected; a bit less, and there is a T.
#[test]
fn at_the_critical_angle_all_light_is_reflected() {
    let incident = vec3(0.5, -0.75_f32.sqrt(), 0.0);
    assert_eq!(refract(incident, Vec3::Y, 2.0), None);
    let refracted = refract(incident, Vec3::Y, 2.0_f32.next_down()).expect("it leaves");
    assert!(refracted.y < 0.0 && refracted.x > 0.999_999, "{refracted}");
}
