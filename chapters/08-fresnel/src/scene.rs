// ANCHOR: scene
//! The reflectance alone, as a shade of grey.

use crate::Reflectance;
use glam::Vec3;
use plane_hit::{Object, nearest};
use ray_casting::Ray;
use refraction::{Interface, Material, Optics};
use shadows::Interaction;

/// The colour of all that is not a dielectric.
const BACKDROP: Vec3 = Vec3::new(0.05, 0.1, 0.2);

/// Returns the reflectance of the dielectric that a ray hits, as a shade of grey, or the colour
/// of the backdrop.
pub fn reflectance_along(
    ray: &Ray,
    objects: &[Object<Material>],
    reflectance: Reflectance,
) -> Vec3 {
    let Some(hit) = nearest(objects, ray) else {
        return BACKDROP;
    };
    let at = Interaction::new(objects, ray, hit);
    let Optics::Dielectric {
        eta_inside,
        eta_outside,
    } = objects[at.index].material.optics
    else {
        return BACKDROP;
    };
    let Interface { eta_i, eta_t } = Interface::new(&at, eta_inside, eta_outside);
    let cos_theta_i = -at.normal.dot(at.incident);
    Vec3::splat(reflectance(cos_theta_i, eta_i, eta_t))
}
// ANCHOR_END: scene
