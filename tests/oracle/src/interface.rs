//! Reflection and refraction at the smooth interface of two media, by the light's wave
//! vector.

use glam::DVec3;

/// The reflected and the refracted ray at an interface.
#[derive(Clone, Copy, Debug)]
pub struct Interface {
    /// The reflected direction, a unit vector.
    pub reflected: DVec3,
    /// The refracted direction, a unit vector; `None` for total internal reflection.
    pub refracted: Option<DVec3>,
    /// The fraction of unpolarised light that is reflected.
    pub reflectance: f64,
}

impl Interface {
    /// Returns the reflection and refraction of light along `incident` at a surface whose `normal` faces it, from a medium
    /// of the first index into one of the second. Both vectors are unit vectors.
    ///
    /// A wave's vector k is as long as the index, n₁ here and n₂ beyond, and its part along the surface
    /// is the same on both sides: that is Snell's law. Its part across the surface, q, makes up for the
    /// rest: q₁² + n₂² − n₁² = q₂². From q₁ and q₂ follow Fresnel's amplitudes.
    ///
    /// Source: Hecht, Optics, ch. 4; Born and Wolf, Principles of Optics, 1.5.
    #[must_use]
    pub fn new(incident: DVec3, normal: DVec3, [n1, n2]: [f64; 2]) -> Self {
        let k = n1 * incident;
        let q1 = -normal.dot(k);
        let along = k + q1 * normal;
        let reflected = (along + q1 * normal).normalize();
        let q2_squared = q1 * q1 + (n2 - n1) * (n2 + n1);
        if !(q2_squared > 0.0) {
            return Self {
                reflected,
                refracted: None,
                reflectance: 1.0,
            };
        }
        let q2 = q2_squared.sqrt();
        let across = (q1 - q2) / (q1 + q2);
        let [p1, p2] = [n2 * n2 * q1, n1 * n1 * q2];
        let parallel = (p1 - p2) / (p1 + p2);
        Self {
            reflected,
            refracted: Some((along - q2 * normal).normalize()),
            reflectance: (across * across + parallel * parallel) / 2.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;
    use std::f64::consts::FRAC_1_SQRT_2;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-10
    }

    /// 0.6 · 1.5 = 0.9, and √(1 − 0.81); from 1 to 1.5 at 45° √2/3; and 0.8 · 1.5 > 1 cannot leave.
    #[test]
    fn sines_times_indices_are_the_same_on_both_sides() {
        let out = Interface::new(dvec3(0.6, -0.8, 0.0), DVec3::Y, [1.5, 1.0]);
        let t = out.refracted.expect("a way out");
        assert!(close(t.x, 0.9) && close(t.y, -0.19_f64.sqrt()) && t.z == 0.0);
        let incident = FRAC_1_SQRT_2 * dvec3(1.0, -1.0, 0.0);
        let into = Interface::new(incident, DVec3::Y, [1.0, 1.5]);
        let t = into.refracted.expect("a way in");
        assert!(close(t.x, 2.0_f64.sqrt() / 3.0) && close(t.y, -7.0_f64.sqrt() / 3.0));
        let back = Interface::new(dvec3(0.8, -0.6, 0.0), DVec3::Y, [1.5, 1.0]);
        assert!(back.refracted.is_none() && back.reflectance == 1.0);
        assert!(back.reflected.distance(dvec3(0.8, 0.6, 0.0)) <= 1e-15);
    }

    /// ((1.5 − 1) / (1.5 + 1))² = 0.04 straight on, and 0.0502399110 at 45°, as printed in the tables; both
    /// ways alike at angles that belong together; nothing between equal media, however grazing.
    #[test]
    fn reflectances_are_those_of_the_tables() {
        let at = |cosine: f64, indices| {
            let incident = dvec3((1.0 - cosine * cosine).sqrt(), -cosine, 0.0);
            Interface::new(incident, DVec3::Y, indices).reflectance
        };
        assert!(close(at(1.0, [1.0, 1.5]), 0.04) && close(at(1.0, [1.5, 1.0]), 0.04));
        assert!(close(at(FRAC_1_SQRT_2, [1.0, 1.5]), 0.050_239_911_0));
        assert!(close(at(0.8, [1.5, 1.0]), 0.114_141_100_221));
        assert!(close(at(0.19_f64.sqrt(), [1.0, 1.5]), 0.114_141_100_221));
        for cosine in [1.0, 0.3, 1e-8, 1e-150] {
            assert_eq!(at(cosine, [1.5, 1.5]), 0.0);
        }
    }
}
