//! The studies, in the order of the chapters that they belong to.

pub mod acne;
pub mod bounces;
pub mod fresnel;
pub mod growth;
pub mod highlight;
pub mod packets;
pub mod plane;
pub mod recursion;
pub mod refraction;
pub mod sampling;
pub mod sphere;
pub mod threads;

use crate::study::Study;

/// Every study of the chapter.
pub const STUDIES: [&Study; 12] = [
    &sphere::STUDY,
    &plane::STUDY,
    &bounces::STUDY,
    &refraction::STUDY,
    &fresnel::STUDY,
    &highlight::STUDY,
    &recursion::STUDY,
    &sampling::STUDY,
    &acne::STUDY,
    &growth::STUDY,
    &packets::STUDY,
    &threads::STUDY,
];
