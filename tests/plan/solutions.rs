//! The exercises' solutions, as the book prints them.

// ANCHOR: exercise-3
pub fn bounces_allowed(reflectivity: f32, least_throughput: f32) -> u32 {
    let (mut bounces, mut throughput) = (0, 1.0);
    while throughput > least_throughput {
        throughput *= reflectivity;
        bounces += 1;
    }
    bounces
}
// ANCHOR_END: exercise-3

// ANCHOR: exercise-4
pub fn probability_of_a_miss(radius: f32, samples: u32) -> f32 {
    let of_one = 1.0 - std::f32::consts::PI * radius * radius;
    shading::powi(of_one, samples)
}
// ANCHOR_END: exercise-4
