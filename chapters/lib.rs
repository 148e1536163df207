//! Light, Backwards: the chapters, in the order of the book.

use canvas::Stage;

/// Every chapter's stage. The tests, the book and `cargo run` go by this list.
pub const STAGES: [&Stage; 15] = [
    &canvas::STAGE,
    &ray_casting::STAGE,
    &sphere_hit::STAGE,
    &plane_hit::STAGE,
    &shadows::STAGE,
    &shading::STAGE,
    &reflection::STAGE,
    &refraction::STAGE,
    &fresnel::STAGE,
    &anti_aliasing::STAGE,
    &shadow_acne::STAGE,
    &transparency::STAGE,
    &packets::STAGE,
    &speed_and_accuracy::STAGE,
    &interactive::STAGE,
];
