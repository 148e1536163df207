//! The chapters, in the order of the book.

pub mod fuzz;
pub mod tracers;

use canvas::Stage;

/// Every chapter's stage, in the order of the book. The book and the tests of all chapters
/// use this list.
pub const STAGES: [&Stage; 16] = [
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
    &interactive::STAGE,
    &speed_and_accuracy::STAGE,
    &plan::STAGE,
];
