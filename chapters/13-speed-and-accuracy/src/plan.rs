//! No more than a picture needs: a plan made from a scene, a camera and a wish.

use crate::sampling::{place, point};
use anti_aliasing::hash;
use canvas::{Picture, Pixel, decode, encode, rays_so_far};
use fresnel::{fresnel, ways_on};
use glam::{Vec2, Vec3};
use plane_hit::{Object, Pattern, Plane, Shape, nearest_by};
use ray_casting::{Camera, Ray, unit};
use refraction::{Body, Material};
use shading::lit;
use shadow_acne::{Leaving, from_the_eye, from_the_surface};
use shadows::{PointLight, Scene};
use sphere_hit::{Hit, Sphere, facing};
use std::fmt;
use transparency::{Tinted, transmittance, way_inside};

// ANCHOR: surface
/// What the planner must know of a material: chapter 7's, or chapter 11's.
pub trait Surface {
    /// Its answer to light.
    fn material(&self) -> &Material;

    /// How fast its inside takes up a lamp's light on its way to elsewhere; `None` if
    /// none gets through at all.
    fn absorption(&self) -> Option<Vec3>;
}

impl Surface for Material {
    fn material(&self) -> &Material {
        self
    }

    /// Up to chapter 10 even glass throws a black shadow.
    fn absorption(&self) -> Option<Vec3> {
        None
    }
}

impl Surface for Tinted {
    fn material(&self) -> &Material {
        &self.material
    }

    fn absorption(&self) -> Option<Vec3> {
        matches!(self.material.body, Body::Clear { .. }).then_some(self.absorption)
    }
}
// ANCHOR_END: surface

// ANCHOR: plan
/// What a picture needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The error that was wished for, in levels of a screen.
    pub wish: f32,
    /// How many lamps there are whose light anything scatters.
    pub lamps: usize,
    /// The two largest reflectivities of what is opaque, the larger first.
    pub mirrors: [f32; 2],
    /// The most bounces that can matter; `None` if there is glass, in which only the
    /// light itself can tell.
    pub depth: Option<u32>,
    /// Whether anything is clear.
    pub has_glass: bool,
    /// Whether some of it has a colour.
    pub has_tints: bool,
    /// As good as the most light, of its strongest colour, that any ray brings back.
    pub brightest: f32,
    /// From how many of its radii a sphere is seen, at most: by the eye or from another.
    pub farthest: f32,
    /// How spheres are met.
    pub formula: Formula,
    /// How much light may be missing from a pixel of each level.
    tolerances: [f32; 256],
}

/// One of chapter 2's ways to meet a sphere, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub enum Formula {
    /// [`Sphere::hit_by_slide`].
    Slide,
    /// [`Sphere::hit`].
    Stable,
    /// [`Sphere::hit_in_f64`].
    InF64,
}
// ANCHOR_END: plan

/// Nobody sees half a level.
pub const WISH: f32 = 0.5;

/// How far a normal may be turned, in radians: the sharpest highlight of the book, with an
/// exponent of 200, changes by a fraction of a level.
const TURN: f32 = 1e-4;

/// The most rays that one sample is worth: in bodies of glass that overlap, as none in the
/// world do, light can be caught for ever.
const MOST_RAYS: u32 = 1 << 10;

/// How much of the brightest light the rays that are left out of a sample bring, where it
/// is one of many and only their mean counts; found by trying 1 to 1/64 in the study
/// `plan`: with less, the error grows.
const TYPICAL: f32 = 1.0 / 16.0;

/// The least share of a pixel's light that tells what is seen in it from another thing.
const LEAST_TO_TELL: f32 = 1.0 / 16.0;

/// The least samples of a pixel in which not the same is seen everywhere.
const LEAST_SAMPLES: usize = 32;

/// The most samples of a pixel.
const MOST_SAMPLES: usize = 1024;

impl Plan {
    // ANCHOR: new
    /// What a picture of `scene` by `camera` needs, to be wrong by no more than a `wish`,
    /// in levels of a screen; the wish is positive.
    #[must_use]
    pub fn new<M: Surface>(scene: &Scene<M>, camera: &Camera, wish: f32) -> Self {
        let materials = || {
            scene
                .objects
                .iter()
                .map(|object| object.material.material())
        };
        let scatters =
            |phong: &shading::Phong| phong.diffuse > 0.0 || phong.specular > 0.0;
        let is_lit = materials().any(|material| scatters(&material.phong));
        let has_glass =
            materials().any(|material| matches!(material.body, Body::Clear { .. }));

        let (background, mut faintest) = extremes(scene.background);
        // The most light that each has of its own, and the share of others' that it adds.
        let mut opaque = vec![(background, 0.0)];
        let mut highlight = 0.0;
        for material in materials() {
            let (most, least) = own_light(material, &scene.lights);
            faintest = if least < faintest { least } else { faintest };
            match material.body {
                Body::Opaque { reflectivity } => opaque.push((most, reflectivity)),
                Body::Clear { .. } if most > highlight => highlight = most,
                Body::Clear { .. } => (),
            }
        }
        let brightest = highlight + brightest(&opaque);
        let mirrors = two_largest(opaque.iter().map(|&(_, reflectivity)| reflectivity));
        let farthest = farthest(scene, camera);
        let tolerances = std::array::from_fn(|level| wish * step(level as u8));
        let allowed = tolerances[encode(Vec3::splat(faintest))[0] as usize];
        Self {
            wish,
            lamps: if is_lit { scene.lights.len() } else { 0 },
            mirrors,
            depth: (!has_glass).then(|| depth(mirrors, allowed / brightest)),
            has_glass,
            has_tints: scene.objects.iter().any(is_tinted),
            brightest,
            farthest,
            formula: Formula::cheapest(farthest),
            tolerances,
        }
    }
    // ANCHOR_END: new

    // ANCHOR: trace
    /// What a ray brings back, less what a pixel would not miss.
    ///
    /// Of all rays still to be followed, the one that brings the largest share is next.
    /// The light of the hits is added up on the way, so that it is always known how much
    /// the pixel has at least, and with it how much it may lack: a dark pixel a thirtieth
    /// of what a bright one may. Once all that is left could not bring more, nothing of it is
    /// followed.
    #[must_use]
    pub fn trace<M: Surface>(&self, scene: &Scene<M>, ray: Ray) -> Seen {
        let mut light = Vec3::ZERO;
        let mut what = 0;
        let mut to_follow = Vec::new();
        let mut next = Some(Onward {
            leaving: from_the_eye(ray),
            share: Vec3::ONE,
            bounces: 0,
        });
        let mut rays = 0;
        while let Some(Onward {
            leaving,
            share,
            bounces,
        }) = next
        {
            let meets = |object, t_max| self.meets(&leaving, object, t_max);
            match nearest_by(&scene.objects, meets) {
                None => light += share * scene.background,
                Some((object, hit)) => {
                    let share = share * self.left_after(scene, &leaving, hit.t);
                    let (shaded, lit_by) = self.shade(scene, object, &leaving, hit);
                    light += share * shaded;
                    let point = leaving.ray.at(hit.t);
                    if share.max_element() > LEAST_TO_TELL {
                        what = hash(what ^ name(scene, object, point) ^ lit_by << 16);
                    }
                    let incident = leaving.ray.direction;
                    let body = &object.material.material().body;
                    for (part, direction) in ways_on(body, incident, hit.normal, fresnel)
                    {
                        if part > 0.0 && self.depth.is_none_or(|depth| bounces < depth) {
                            to_follow.push(Onward {
                                leaving: from_the_surface(
                                    object, point, hit.normal, direction,
                                ),
                                share: part * share,
                                bounces: bounces + 1,
                            });
                        }
                    }
                }
            }
            rays += 1;
            next = self
                .take_largest(&mut to_follow, light)
                .filter(|_| rays < MOST_RAYS);
        }
        Seen { light, what }
    }

    /// Of some rays the one that brings most; `None` if all of them together bring no more
    /// than a pixel that has some `light` may lack.
    fn take_largest<'a, M>(
        &self,
        to_follow: &mut Vec<Onward<'a, M>>,
        light: Vec3,
    ) -> Option<Onward<'a, M>> {
        let (mut all, mut largest, mut place) = (0.0, 0.0, None);
        for (i, onward) in to_follow.iter().enumerate() {
            let share = onward.share.max_element();
            all += share;
            if share > largest {
                (largest, place) = (share, Some(i));
            }
        }
        if !(all * self.brightest > self.tolerance(light)) {
            return None;
        }
        canvas::count_ray();
        place.map(|place| to_follow.swap_remove(place))
    }
    // ANCHOR_END: trace

    /// How much light a pixel that has some may lack, by the darkest of its colours.
    fn tolerance(&self, light: Vec3) -> f32 {
        let darkest = Vec3::splat(light.min_element());
        self.tolerances[encode(darkest)[0] as usize]
    }

    /// Where a ray meets an object, by the plan's formula.
    fn meets<M>(
        &self,
        leaving: &Leaving<M>,
        object: &Object<M>,
        t_max: f32,
    ) -> Option<Hit> {
        let comes_from = leaving.from.is_some_and(|from| std::ptr::eq(from, object));
        match &object.shape {
            Shape::Sphere(sphere) if !comes_from => {
                self.formula.hit()(sphere, &leaving.ray, t_max)
            }
            _ => leaving.hit(object, t_max),
        }
    }

    /// What the clear things on a ray's way of some `distance` leave of its light.
    fn left_after<M: Surface>(
        &self,
        scene: &Scene<M>,
        leaving: &Leaving<M>,
        distance: f32,
    ) -> Vec3 {
        let mut left = Vec3::ONE;
        if self.has_tints {
            for object in &scene.objects {
                if let Some(absorption) = object.material.absorption() {
                    let inside = way_inside(object, leaving, distance);
                    left *= transmittance(absorption, inside);
                }
            }
        }
        left
    }

    /// The light that a hit has of its own and from the lamps, as in chapter 11, and which
    /// of those reach it, a bit for each.
    fn shade<M: Surface>(
        &self,
        scene: &Scene<M>,
        object: &Object<M>,
        leaving: &Leaving<M>,
        hit: Hit,
    ) -> (Vec3, u32) {
        let Ray {
            direction: incident,
            ..
        } = leaving.ray;
        let point = leaving.ray.at(hit.t);
        let normal = facing(hit.normal, incident);
        let phong = &object.material.material().phong;
        let colour = phong.colour.at(point);
        let mut light = phong.ambient * colour;
        let mut lit_by = 0;
        for (i, lamp) in scene.lights.iter().enumerate() {
            let PointLight {
                position,
                intensity,
            } = lamp;
            let to_light = *position - point;
            let Some(direction) = unit(to_light) else {
                continue;
            };
            let lit = lit(phong, colour, incident, normal, direction);
            if lit == Vec3::ZERO {
                continue;
            }
            canvas::count_ray();
            let shadow_ray = from_the_surface(object, point, hit.normal, direction);
            let distance = to_light.length();
            let blocks = |object: &Object<M>| {
                object.material.absorption().is_none()
                    && self.meets(&shadow_ray, object, distance).is_some()
            };
            if !scene.objects.iter().any(blocks) {
                light += *intensity * lit * self.left_after(scene, &shadow_ray, distance);
                lit_by |= 1 << (i % 16);
            }
        }
        (light, lit_by)
    }

    // ANCHOR: sample
    /// The light of a pixel, from as few samples as meet the wish.
    ///
    /// The first are its corners, which no straight edge through the pixel leaves on one
    /// side, and four places within. If all of them see the same things, and in nearly the
    /// same light, their mean is the answer. If not, only places within count: 32 of them,
    /// and twice as many each time until they are enough.
    #[must_use]
    pub fn sample(&self, pixel: Pixel, see: &dyn Fn(Vec2) -> Seen) -> Vec3 {
        let rays_before = rays_so_far();
        let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0)];
        let corners = corners.map(|corner| see(point(pixel, Vec2::from(corner))));
        let within = |i| see(point(pixel, place(pixel, i)));
        let mut seen = [corners, [0, 1, 2, 3].map(within)].concat();
        let rays = (rays_so_far() - rays_before) as f32 / seen.len() as f32;
        if seen.iter().all(|other| other.what == seen[0].what)
            && self.is_enough(&seen, rays)
        {
            return mean(&seen);
        }
        seen.drain(..corners.len());
        while seen.len() < LEAST_SAMPLES
            || seen.len() < MOST_SAMPLES && !self.is_enough(&seen, rays)
        {
            let n = seen.len() as u32;
            seen.extend((n..2 * n).map(within));
        }
        mean(&seen)
    }

    /// Whether further samples, which take so many `rays` each, would be better spent on
    /// other pixels.
    ///
    /// Where an edge crosses a pixel, N stratified samples of deviation σ leave an error
    /// of some σ N^(−3/4). One more sample lowers its square by σ² N^(−5/2), up to a
    /// factor, and the picture's RMS error is least for its cost where that, for each ray,
    /// is the same for all pixels: where σ N^(−5/4) / √rays is. For 16 samples of 4 rays,
    /// it is an eighth of the error, which stands for the wish.
    fn is_enough(&self, seen: &[Seen], rays: f32) -> bool {
        let n = seen.len() as f32;
        let n_to_five_quarters = n * n.sqrt().sqrt();
        let levels = encode(mean(seen));
        let deviation = deviation(seen);
        (0..3).all(|i| {
            let wish = self.tolerances[levels[i] as usize];
            deviation[i] / (n_to_five_quarters * rays.sqrt()) <= wish / 8.0
        })
    }
    // ANCHOR_END: sample

    // ANCHOR: picture
    /// The picture with one sample for each pixel, in its centre.
    #[must_use]
    pub fn at_centres<M>(self, scene: Scene<M>, camera: Camera) -> Picture
    where
        M: Surface + Send + Sync + 'static,
    {
        Picture::new(move |pixel| self.trace(&scene, camera.ray(pixel.centre())).light)
    }

    /// The picture, with as many samples as it needs.
    ///
    /// What is left out of one sample must be small at its brightest, for nobody averages
    /// it; of one of many, it is enough that it is small as a rule.
    #[must_use]
    pub fn picture<M>(self, scene: Scene<M>, camera: Camera) -> Picture
    where
        M: Surface + Send + Sync + 'static,
    {
        let brightest = TYPICAL * self.brightest;
        let one_of_many = Self {
            brightest,
            ..self.clone()
        };
        Picture::new(move |pixel| {
            self.sample(pixel, &|point| one_of_many.trace(&scene, camera.ray(point)))
        })
    }
    // ANCHOR_END: picture
}

/// What a ray has seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The light that it brings back.
    pub light: Vec3,
    /// What that comes from: the same number for the same things, on the same squares, in
    /// the light of the same lamps.
    pub what: u32,
}

/// A number for an object, and for the square if it has some.
fn name<M: Surface>(scene: &Scene<M>, object: &Object<M>, point: Vec3) -> u32 {
    let is_it = |other: &Object<M>| std::ptr::eq(object, other);
    let place = scene.objects.iter().position(is_it).unwrap_or_default() as u32;
    match object.material.material().phong.colour {
        Pattern::Plain(_) => place,
        Pattern::Checker(..) => {
            let square = point.floor();
            hash(place ^ hash(square.x.to_bits() ^ hash(square.z.to_bits())))
        }
    }
}

/// A ray that goes on from a hit.
struct Onward<'a, M> {
    leaving: Leaving<'a, M>,
    /// What a pixel gets of the light that it brings, by colour.
    share: Vec3,
    bounces: u32,
}

fn mean(seen: &[Seen]) -> Vec3 {
    let sum: Vec3 = seen.iter().map(|seen| seen.light).sum();
    sum / seen.len() as f32
}

/// The standard deviation of the light, for each colour.
fn deviation(seen: &[Seen]) -> Vec3 {
    let mean = mean(seen);
    let off = seen.iter().map(|seen| seen.light - mean);
    let variance = off.map(|off| off * off).sum::<Vec3>() / seen.len() as f32;
    variance.map(f32::sqrt)
}

/// How much light there is to a level of a screen from the one below it: the next is no
/// nearer.
fn step(level: u8) -> f32 {
    match level {
        0 => decode(1),
        level => decode(level) - decode(level - 1),
    }
}

fn extremes(light: Vec3) -> (f32, f32) {
    (light.max_element(), light.min_element())
}

/// The most and the least light of a material's own and of the lamps.
fn own_light(material: &Material, lights: &[PointLight]) -> (f32, f32) {
    let phong = &material.phong;
    let (most, least) = match phong.colour {
        Pattern::Plain(colour) => extremes(colour),
        Pattern::Checker(even, odd) => {
            let [(a, b), (c, d)] = [extremes(even), extremes(odd)];
            (if a > c { a } else { c }, if b < d { b } else { d })
        }
    };
    let lamps: f32 = lights.iter().map(|light| light.intensity).sum();
    let scattered = phong.diffuse * most + phong.specular;
    (
        phong.ambient * most + lamps * scattered,
        phong.ambient * least,
    )
}

fn two_largest(numbers: impl Iterator<Item = f32>) -> [f32; 2] {
    numbers.fold([0.0, 0.0], |[first, second], other| {
        if other > first {
            [other, first]
        } else if other > second {
            [first, other]
        } else {
            [first, second]
        }
    })
}

// ANCHOR: brightest
/// The most light that a ray brings back from things with light of their own and a
/// reflectivity each, none of which sees itself in itself.
///
/// Wherever it starts, a brightest path goes to and fro between two of them at last:
/// E₁ + ρ₁ (E₂ + ρ₂ (E₁ + …)) = (E₁ + ρ₁ E₂) / (1 − ρ₁ ρ₂).
fn brightest(things: &[(f32, f32)]) -> f32 {
    let mut brightest = 0.0;
    for (i, &(light, reflectivity)) in things.iter().enumerate() {
        for (j, &(other_light, other)) in things.iter().enumerate() {
            let sum = (light + reflectivity * other_light) / (1.0 - reflectivity * other);
            let most = if i == j { light } else { sum };
            brightest = if most > brightest { most } else { brightest };
        }
    }
    brightest
}
// ANCHOR_END: brightest

// ANCHOR: depth
/// How many bounces between two mirrors it takes until a ray brings no more than a share
/// of `worth` of the pixel's light.
///
/// Each two bounces multiply it by both reflectivities: no object sees itself in itself.
fn depth([first, second]: [f32; 2], worth: f32) -> u32 {
    let (mut share, mut bounces) = (1.0, 0);
    loop {
        share *= if bounces % 2 == 0 { first } else { second };
        if !(share > worth) || bounces == MOST_RAYS {
            return bounces;
        }
        bounces += 1;
    }
}
// ANCHOR_END: depth

fn is_tinted<M: Surface>(object: &Object<M>) -> bool {
    let absorption = object.material.absorption();
    absorption.is_some_and(|absorption| absorption != Vec3::ZERO)
}

// ANCHOR: formula
impl Formula {
    fn hit(self) -> fn(&Sphere, &Ray, f32) -> Option<Hit> {
        match self {
            Self::Slide => Sphere::hit_by_slide,
            Self::Stable => Sphere::hit,
            Self::InF64 => Sphere::hit_in_f64,
        }
    }

    /// How far a sphere's normal is turned, in radians, for a surface found from some
    /// `distance`, in radii: by ε D² with the slide's formula, by ε D with the stable one.
    fn turn(self, distance: f32) -> f32 {
        match self {
            Self::Slide => f32::EPSILON * distance * distance,
            Self::Stable => f32::EPSILON * distance,
            Self::InF64 => 0.0,
        }
    }

    /// The cheapest that holds up to some distance in radii.
    fn cheapest(distance: f32) -> Self {
        let holds = |formula: &Self| formula.turn(distance) <= TURN;
        let formulas = [Self::Slide, Self::Stable];
        formulas.into_iter().find(holds).unwrap_or(Self::InF64)
    }
}

/// The longest way to a sphere, in its radii: from the eye, from another sphere, or from
/// the image of one of them, or of itself, in a plane that mirrors.
fn farthest<M: Surface>(scene: &Scene<M>, camera: &Camera) -> f32 {
    let (mut spheres, mut mirrors) = (Vec::new(), Vec::new());
    for object in &scene.objects {
        match (&object.shape, object.material.material().body) {
            (Shape::Sphere(sphere), _) => spheres.push(*sphere),
            (Shape::Plane(plane), Body::Opaque { reflectivity })
                if reflectivity > 0.0 =>
            {
                mirrors.push(*plane);
            }
            _ => (),
        }
    }
    let eye = Sphere {
        centre: camera.eye,
        radius: 0.0,
    };
    let mut farthest = 0.0;
    for to in &spheres {
        for from in spheres.iter().chain([&eye]) {
            let itself = (from != to).then_some(*from);
            let images = mirrors.iter().map(|mirror| image(from, mirror));
            for from in images.chain(itself) {
                let radii = way(&from, to) / to.radius;
                farthest = if radii > farthest { radii } else { farthest };
            }
        }
    }
    farthest
}

/// What is seen of a sphere in a plane that mirrors.
fn image(sphere: &Sphere, mirror: &Plane) -> Sphere {
    let height = (sphere.centre - mirror.point).dot(mirror.normal);
    Sphere {
        centre: sphere.centre - 2.0 * height * mirror.normal,
        ..*sphere
    }
}

/// The longest way from the surface of one sphere to that of another.
///
/// From outside the first, the longest touches it: from behind, it is in its own way.
fn way(from: &Sphere, to: &Sphere) -> f32 {
    let distance = from.centre.distance(to.centre);
    let tangent = (distance + from.radius) * (distance - from.radius);
    if tangent > 0.0 {
        tangent.sqrt() + to.radius
    } else {
        distance + from.radius
    }
}
// ANCHOR_END: formula

// ANCHOR: words
/// The plan in words, a line for each decision.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self.lamps {
            0 => writeln!(f, "no lamp whose light anything scatters: no shadow rays")?,
            1 => writeln!(f, "one lamp: a shadow ray from wherever it could shine")?,
            n => writeln!(
                f,
                "{n} lamps: a shadow ray to each from wherever it could shine"
            )?,
        }
        match (self.mirrors, self.depth) {
            ([0.0, _], _) => writeln!(f, "no mirror: no reflection in one")?,
            ([a, 0.0], Some(_)) => {
                writeln!(f, "one mirror, of {a}, sees no other: one bounce")?;
            }
            ([a, 0.0], None) => writeln!(f, "one mirror, of {a}")?,
            ([a, b], Some(depth)) => {
                writeln!(f, "mirrors of {a} and {b} face each other: depth {depth}")?;
            }
            ([a, b], None) => writeln!(f, "mirrors of {a} and {b} face each other")?,
        }
        match (self.has_glass, self.has_tints) {
            (false, _) => writeln!(f, "no glass: no refraction")?,
            (true, false) => writeln!(f, "glass: reflection, refraction, Fresnel")?,
            (true, true) => {
                writeln!(
                    f,
                    "coloured glass: reflection, refraction, Fresnel, absorption"
                )?;
            }
        }
        let cut_off = |level: usize| self.tolerances[level] / self.brightest;
        if self.has_glass || self.mirrors[0] > 0.0 {
            let [dark, light] = [cut_off(0), cut_off(255)];
            writeln!(
                f,
                "no ray brings more light than {:.2}\n\
                 left out of a pixel: a share of {dark:.1e} in the dark, \
                 {light:.1e} in the light",
                self.brightest
            )?;
        }
        if self.farthest > 0.0 {
            let formula = match self.formula {
                Formula::Slide => "the slide's formula",
                Formula::Stable => "the stable formula",
                Formula::InF64 => "the formula in f64",
            };
            let farthest = self.farthest;
            writeln!(
                f,
                "spheres are seen from up to {farthest:.0} radii: {formula} holds"
            )?;
        }
        write!(
            f,
            "8 samples for a pixel where they see the same, \
             {LEAST_SAMPLES} to {MOST_SAMPLES} where they do not"
        )
    }
}
// ANCHOR_END: words
