//! The table of mutations: what probably went wrong, in a reader's words, and the page about it.

use crate::fault::Fault::{self, *};
use glam::Vec2;

/// A row of the table.
#[derive(Debug)]
pub struct Mutation {
    /// A short name, lower case with hyphens.
    pub name: &'static str,
    /// The cause, in one line.
    pub cause: &'static str,
    /// The page that explains it, and the place on it: `04-shadows.md#the-maths`.
    pub page: &'static str,
    /// The fault, at some strengths.
    pub faults: &'static [Fault],
}

/// A row for each cause; of causes that draw the same picture, the likeliest first, and the special before
/// the general.
macro_rules! mutations {
    ($($name:literal $cause:literal $page:literal [$($fault:expr),+])*) => {
        &[$(Mutation { name: $name, cause: $cause, page: $page, faults: &[$($fault),+] }),*]
    };
}

/// All rows.
pub const MUTATIONS: &[Mutation] = mutations! {
    // Where a pixel is.
    "flip-x" "left and right have changed places: the camera's right points left, or a world whose z points towards you" "01-ray-casting.md#what-goes-wrong" [FlipX]
    "flip-y" "top and bottom have changed places: rows are counted downwards, y goes up" "01-ray-casting.md#what-goes-wrong" [FlipY]
    "half-turn" "the picture is turned upside down, left and right as well: the factors of the camera's first cross product are swapped" "01-ray-casting.md#what-goes-wrong" [HalfTurn]
    "transposed" "x and y of a pixel have changed places" "01-ray-casting.md#where-is-a-pixel" [Transposed]
    "pixel-corner" "rays go through the corners of the pixels, not their centres: half a pixel is missing" "01-ray-casting.md#where-is-a-pixel" [PixelPoint(Vec2::ZERO), PixelPoint(Vec2::ONE), PixelPoint(Vec2::new(0.0, 0.5)), PixelPoint(Vec2::new(0.5, 0.0)), PixelPoint(Vec2::new(0.0, 1.0)), PixelPoint(Vec2::new(1.0, 0.0)), PixelPoint(Vec2::new(1.0, 0.5)), PixelPoint(Vec2::new(0.5, 1.0))]
    "size-less-one" "a pixel's place is divided by the width less one, not by the width" "01-ray-casting.md#where-is-a-pixel" [SizeLessOne]
    "shifted" "the picture is moved by whole pixels: a count begins at 1" "01-ray-casting.md#where-is-a-pixel" [Shift(1, 0), Shift(-1, 0), Shift(0, 1), Shift(0, -1), Shift(1, 1), Shift(-1, -1), Shift(1, -1), Shift(-1, 1), Shift(2, 0), Shift(-2, 0), Shift(0, 2), Shift(0, -2)]
    "square-plane" "balls are eggs: the image plane is a square, and the picture is not" "01-ray-casting.md#what-goes-wrong" [SquarePlane]
    "aspect-inverted" "the aspect ratio divides where it should multiply" "01-ray-casting.md#what-goes-wrong" [AspectInverted]
    "fits-width" "the image plane is 2 wide, and should be 2 high" "01-ray-casting.md#where-is-a-pixel" [FitsWidth]

    // The camera.
    "focal-inverted" "the focal length is tan α, and should be 1 / tan α" "01-ray-casting.md#the-camera" [FocalInverted]
    "whole-angle" "the field of view is twice as large: its tangent is that of the whole angle, not of half of it" "01-ray-casting.md#the-camera" [WholeAngle]
    "degrees" "the field of view's tangent is given degrees, and wants radians" "01-ray-casting.md#the-camera" [DegreesAsRadians]
    "focal-length" "the focal length, and with it the field of view, is another one" "01-ray-casting.md#the-camera" [FocalTimes(0.5), FocalTimes(2.0), FocalTimes(0.65), FocalTimes(0.8), FocalTimes(1.25), FocalTimes(1.55)]
    "looks-back" "the camera looks the other way" "01-ray-casting.md#the-camera" [LooksBack]
    "not-tilted" "the camera looks straight along z, and should look where its forward points" "01-ray-casting.md#the-camera" [NotTilted]
    "target-as-direction" "the point to look at was taken for the direction: subtract the eye" "01-ray-casting.md#the-camera" [TargetAsDirection]
    "up-not-tilted" "the camera's up is the world's: it must be perpendicular to forward" "01-ray-casting.md#the-camera" [UpNotTilted]
    "not-normalized" "the camera's rays are not unit vectors" "01-ray-casting.md#what-goes-wrong" [NotNormalized(false), NotNormalized(true)]
    "parallel" "all rays are parallel: the pixel's place was added to the eye, not to the direction" "01-ray-casting.md#the-idea" [Parallel]

    // Levels.
    "linear" "light was written into the file without encoding" "00-canvas.md#what-goes-wrong" [Linear]
    "gamma" "light was encoded by a power, like 1/2.2, and not by sRGB's formula" "inside-the-canvas.md#from-light-to-levels" [Gamma(2.2), Gamma(2.0), Gamma(1.8), Gamma(1.6), Gamma(2.4)]
    "encoded-twice" "light was encoded twice" "inside-the-canvas.md#from-light-to-levels" [EncodedTwice]
    "decoded" "light was decoded, and should be encoded" "inside-the-canvas.md#from-light-to-levels" [DecodedInstead]
    "truncated" "levels are cut off to whole numbers, not rounded" "00-canvas.md#what-goes-wrong" [Truncated(255.0), Truncated(256.0), Truncated(255.999)]
    "wraps" "light above 1 wraps around: clamp it before it becomes a byte" "inside-the-canvas.md#from-light-to-levels" [Wraps]
    "channels" "red, green and blue have changed places" "00-canvas.md#the-code" [Channels([2, 1, 0]), Channels([0, 2, 1]), Channels([1, 0, 2]), Channels([1, 2, 0]), Channels([2, 0, 1])]
    "grey" "the colours are lost: all three channels are the same" "00-canvas.md#the-code" [Grey([0.299, 0.587, 0.114]), Grey([0.333, 0.334, 0.333]), Grey([0.2126, 0.7152, 0.0722])]
    "negative" "light and dark have changed places" "inside-the-canvas.md#from-light-to-levels" [Negative]
    "black" "the whole picture is black: every pixel is NaN, or the rows are never put on the canvas" "00-canvas.md#the-code" [Black]
    "too-bright" "there is more than full light: flat white patches" "05-shading.md#what-goes-wrong" [StrongSurfaces, Brighter(1.5), Brighter(2.0), Brighter(3.0), Brighter(0.5)]
    "tone-mapped" "light is compressed, like v / (1 + v); the book clamps it" "inside-the-canvas.md#from-light-to-levels" [ToneMapped]
    "colours-decoded" "the scene's colours were taken for sRGB and decoded; the book's are linear" "inside-the-canvas.md#from-light-to-levels" [ColoursDecoded]

    // Balls and the floor.
    "radius" "balls are of another size: the radius was taken for the diameter, or the diameter for the radius" "02-sphere-hit.md#the-maths" [RadiusTimes(0.5), RadiusTimes(2.0), RadiusTimes(0.7), RadiusTimes(1.4)]
    "radius-unsquared" "the radius is not squared" "02-sphere-hit.md#the-maths" [RadiusUnsquared]
    "far-root" "the two roots are tried in the wrong order: you see the far wall of a ball, from within" "02-sphere-hit.md#the-maths" [FarRoot, FarWallOnly]
    "last-in-list" "what is later in the list covers what is near: t_max stays where it was" "03-plane-hit.md#the-code" [LastInList]
    "not-nearest" "what is far away covers what is near: the first object in the list that is hit is taken, or the farthest" "03-plane-hit.md#the-code" [FirstInList, Farthest]
    "textbook-sphere" "two huge squares are subtracted: the textbook's formula for the sphere" "02-sphere-hit.md#what-goes-wrong" [TextbookSphere]
    "normal-inward" "the normals point inwards" "05-shading.md#what-goes-wrong" [NormalInward]
    "normal-length" "the normal is not a unit vector: divide it by the radius" "02-sphere-hit.md#the-code" [NormalNotNormalized]
    "normal-from-origin" "the normal goes from the world's origin, and should go from the ball's centre" "02-sphere-hit.md#the-code" [NormalFromOrigin]
    "no-floor" "the plane is not hit: the sign of its t is wrong, or only its other side counts" "03-plane-hit.md#the-maths" [NoFloor]
    "one-sided-plane" "a plane is hit from one of its sides only" "03-plane-hit.md#the-maths" [OneSidedPlane]
    "checker-parity" "the dark and the light squares have changed places" "03-plane-hit.md#the-code" [CheckerParity]
    "checker-in-space" "the squares are counted in space, with a coordinate that is whole all over the floor" "03-plane-hit.md#what-goes-wrong" [CheckerInSpace]
    "checker-towards-zero" "the squares next to an axis are twice as large: rounded towards zero, not down" "03-plane-hit.md#exercises" [CheckerTowardsZero]
    "checker-size" "the squares are of another size" "03-plane-hit.md#the-code" [CheckerTimes(0.5), CheckerTimes(2.0), CheckerTimes(0.25), CheckerTimes(3.0), CheckerTimes(4.0), CheckerTimes(10.0)]
    "checker-stripes" "the floor has stripes: one of the two coordinates is not used" "03-plane-hit.md#the-code" [CheckerStripes]
    "checker-product" "the numbers of the squares are multiplied, and should be added" "03-plane-hit.md#the-code" [CheckerMultiplied]

    // Light and shadow.
    "no-shadows" "there are no shadows: every light reaches everything" "04-shadows.md" [NoShadows]
    "beyond-light" "what is beyond a light occludes it too" "04-shadows.md#what-goes-wrong" [BeyondLight]
    "shadow-length" "t is compared with a distance, but the shadow ray's direction is not a unit vector" "04-shadows.md#what-goes-wrong" [ShadowUnnormalized]
    "shadow-sign" "shadow rays go away from the light" "04-shadows.md#the-maths" [ShadowFromEye]
    "no-bias" "shadow acne: rays start at the computed point, on either side of the surface" "10-shadow-acne.md#the-idea" [NoBias]
    "bias" "the fixed offset from the surface does not fit the size of the scene" "10-shadow-acne.md#what-goes-wrong" [Bias(0.3), Bias(0.1), Bias(0.03), Bias(0.01), Bias(1e-4), Bias(1e-6)]
    "bias-inward" "rays start below the surface: the offset has the wrong sign" "04-shadows.md#the-maths" [BiasInward]
    "one-shadow-is-all" "one hidden light darkens a point as if all were hidden" "04-shadows.md#the-maths" [AnyShadowIsAll]
    "lights-swapped" "the lights' intensities have changed places" "04-shadows.md#the-code" [LightsSwapped]
    "light-missing" "one of the lights is missing" "04-shadows.md#the-code" [LightMissing(0), LightMissing(1)]
    "lights-full" "every light has the intensity 1" "04-shadows.md#the-code" [LightsFull]
    "lights-averaged" "the light is divided by the number of lights" "05-shading.md#the-maths" [LightsAveraged]
    "falloff" "light fades with distance; the book's does not" "04-shadows.md#the-code" [Falloff(1), Falloff(2), Falloff(3)]
    "light-place" "the lights are in another place: a sign of their z" "04-shadows.md#the-code" [LightMirroredZ]
    "lights-far" "a light's position was taken for its direction: its light is parallel" "04-shadows.md#the-code" [LightsDirectional]
    "no-ambient" "the ambient light is missing" "05-shading.md#the-maths" [NoAmbient]
    "ambient-per-light" "the ambient light is added once for every light" "05-shading.md#the-maths" [AmbientPerLight]
    "ambient-white" "the ambient light is not multiplied by the colour" "05-shading.md#the-maths" [AmbientWhite]
    "ambient-shadowed" "the ambient light is missing where no light arrives" "05-shading.md#the-maths" [AmbientShadowed]
    "no-diffuse" "the diffuse light is missing" "05-shading.md#the-maths" [NoDiffuse]
    "diffuse-flat" "the diffuse light lacks the cosine N·L" "05-shading.md#the-maths" [DiffuseFlat]
    "diffuse-both-sides" "the absolute value of N·L is taken: the dark side is lit" "04-shadows.md#the-maths" [DiffuseBothSides]
    "diffuse-half" "the cosine N·L is halved and raised by a half: no terminator" "05-shading.md#the-maths" [DiffuseHalf]
    "no-specular" "the highlights are missing" "05-shading.md#the-maths" [NoSpecular]
    "specular-coloured" "the highlights have the surface's colour, and should have the light's" "05-shading.md#the-code" [SpecularColoured]
    "specular-cosine" "the highlights are multiplied by N·L" "05-shading.md#the-maths" [SpecularTimesCosine]
    "specular-unshadowed" "highlights appear in the shadow" "05-shading.md#the-maths" [SpecularUnshadowed]
    "half-vector" "highlights are too wide: the half vector, with an exponent that was meant for the mirror direction" "05-shading.md#what-goes-wrong" [HalfVector]
    "shininess" "the exponent of the highlights is another one" "05-shading.md#the-maths" [ShininessTimes(0.0), ShininessTimes(0.25), ShininessTimes(0.5), ShininessTimes(2.0), ShininessTimes(4.0)]
    "cosine-unclamped" "a highlight on the dark side: a negative cosine, raised to an even power" "05-shading.md#what-goes-wrong" [CosineUnclamped]
    "reflected-sign" "the light's mirror direction has the wrong sign" "05-shading.md#the-maths" [ReflectedSign, ViewSign]
    "light-length" "the direction to the light is not a unit vector" "05-shading.md#the-code" [LightUnnormalized]

    // Mirrors.
    "no-mirror" "mirrors reflect nothing" "06-reflection.md#the-code" [NoMirror]
    "depth-one" "mirrors end in the dark: one bounce is too small a depth" "06-reflection.md#the-maths" [DepthOne]
    "depth-less" "the depth is less by one: a bounce is counted too early" "06-reflection.md#the-maths" [DepthLess]
    "mirror-without-two" "the 2 in I − 2 (N·I) N is missing" "06-reflection.md#what-goes-wrong" [MirrorWithoutTwo]
    "mirror-sign" "the mirror direction is I + 2 (N·I) N, and should be I − 2 (N·I) N" "06-reflection.md#the-maths" [MirrorSign, MirrorFromLight]
    "mirror-length" "directions are no longer unit vectors after a bounce, and the error feeds itself" "06-reflection.md#what-goes-wrong" [MirrorUnnormalized]
    "mirror-mixed" "a mirror's own light is multiplied by 1 − k_r; the book adds what is reflected" "06-reflection.md#the-code" [MirrorMixed]
    "mirror-full" "what is reflected is not multiplied by k_r" "06-reflection.md#the-code" [MirrorFull]
    "mirror-only" "a mirror shows only what is reflected, without its own light" "06-reflection.md#the-code" [MirrorOnly]
    "mirror-squared" "what is reflected is multiplied by k_r twice" "06-reflection.md#the-code" [MirrorSquared]
    "mirror-black-sky" "the sky is black in mirrors and glass" "06-reflection.md#the-code" [MirrorBlackSky]
    "mirror-tinted" "what is reflected is multiplied by the mirror's colour" "06-reflection.md#the-code" [MirrorTinted]
    "mirror-unlit" "what mirrors and glass show is not lit: flat colours" "06-reflection.md#the-code" [MirrorUnlit]

    // Glass.
    "ratio-inverted" "the ratio of the indices is upside down" "07-refraction.md#the-maths" [RatioInverted]
    "ratio-same" "the ratio of the indices is not inverted on leaving" "07-refraction.md#what-goes-wrong" [RatioSame]
    "normal-unturned" "inside glass the normal is not turned to face the ray" "07-refraction.md#the-code" [GlassNormalUnturned]
    "total-black" "total internal reflection is forgotten, and its light is lost" "07-refraction.md#what-goes-wrong" [TotalBlack]
    "total-straight" "under total internal reflection the ray goes straight on, and should be reflected" "07-refraction.md#what-goes-wrong" [TotalStraight]
    "unbent" "glass does not bend the light" "07-refraction.md#the-code" [Unbent]
    "index" "glass has another index of refraction" "07-refraction.md#the-maths" [IndexOther(1.2), IndexOther(1.33), IndexOther(1.4), IndexOther(1.6), IndexOther(1.75), IndexOther(2.0), IndexOther(2.42)]
    "refract-sign" "the refracted ray is bent to the wrong side" "07-refraction.md#the-maths" [RefractSign]
    "glass-depth" "rays end inside the glass: the depth allows one bounce only" "07-refraction.md#the-code" [GlassDepth]
    "glass-bias" "glass is black: the offset is on the wrong side, and the ray enters again and again" "07-refraction.md#the-code" [GlassBiasWrong]
    "glass-opaque" "glass is opaque" "07-refraction.md#the-code" [GlassOpaque]
    "glass-no-shadow" "glass has no shadow" "11-transparency.md#the-idea" [GlassNoShadow]
    "glass-tinted" "some light is lost at every surface of the glass" "07-refraction.md#the-code" [GlassTinted]
    "no-reflection" "glass does not reflect" "08-fresnel.md#the-idea" [NoReflection]
    "only-reflection" "glass transmits nothing" "08-fresnel.md#the-code" [OnlyReflection]
    "schlick-wrong-cosine" "Schlick's formula with the wrong cosine: on leaving, total reflection is missed" "08-fresnel.md#what-goes-wrong" [SchlickWrongCosine]
    "schlick" "Schlick's approximation in place of Fresnel's formulas" "08-fresnel.md#the-maths" [Schlick]
    "one-polarization" "only one of the two polarisations is reflected" "08-fresnel.md#the-maths" [OnePolarization(true), OnePolarization(false)]
    "amplitudes" "the amplitudes are not squared" "08-fresnel.md#the-maths" [FresnelAverage]
    "constant-reflectance" "glass reflects the same fraction at every angle" "08-fresnel.md#the-idea" [ConstantReflectance(0.04), ConstantReflectance(0.1), ConstantReflectance(0.2), ConstantReflectance(0.35), ConstantReflectance(0.5)]
    "fresnel-swapped" "reflectance and transmittance have changed places" "08-fresnel.md#the-code" [FresnelSwapped]
    "transmits-all" "what is reflected is not subtracted from what is transmitted" "08-fresnel.md#what-goes-wrong" [TransmitsAll]
    "sparkle" "a ball of index 1 sparkles: 0/0 at grazing angles" "08-fresnel.md#what-goes-wrong" [EqualIndicesSparkle]
    "glass-shadow-black" "clear glass has an opaque shadow" "11-transparency.md#the-idea" [GlassShadowBlack]
    "absorbs-at-surface" "the glass is coloured at its surface, and not along the path" "11-transparency.md#what-goes-wrong" [AbsorbsAtSurface]
    "absorbs-twice" "the absorption is counted twice" "11-transparency.md#what-goes-wrong" [AbsorbsTwice]
    "absorbs-outside" "it is the air that absorbs: the absorption is that of the wrong side" "11-transparency.md#what-goes-wrong" [AbsorbsOutside]
    "absorbs-not" "the glass does not absorb" "11-transparency.md#the-maths" [AbsorbsNot]
    "absorbs-base" "the transmittance is a power of ten, and should be one of e" "11-transparency.md#the-maths" [AbsorbsBaseTen]
    "absorbs-linearly" "the transmittance is 1 − a d, and should be e^(−a d)" "11-transparency.md#the-maths" [AbsorbsLinearly]
    "alone" "bodies that overlap do not displace each other" "11-transparency.md#what-goes-wrong" [Alone]

    "plane-without-inside" "the ground of a lake is seen without the water's colour: a plane has no inside" "11-transparency.md#what-goes-wrong" [PlaneWithoutInside]

    // Samples.
    "one-sample" "there is one ray for each pixel" "09-anti-aliasing.md#the-idea" [OneSample]
    "fewer-samples" "there are fewer samples than there should be" "09-anti-aliasing.md#the-code" [FewerSamples]
    "sample-corners" "samples are in the corners of their cells, not in the middle" "09-anti-aliasing.md#the-code" [Corners]
    "mean-of-levels" "levels were averaged, and not light" "09-anti-aliasing.md#what-goes-wrong" [MeanOfLevels]
    "clamped-samples" "each sample is clamped to white before the mean is taken" "09-anti-aliasing.md#what-goes-wrong" [ClampedSamples]
    "unclamped-samples" "stairs around a lamp: it is brighter than white, and its samples are not clamped" "09-anti-aliasing.md#what-goes-wrong" [UnclampedSamples]
    "not-jittered" "rings near the horizon: the samples are on a regular grid" "09-anti-aliasing.md#what-goes-wrong" [NotJittered]
    "adaptive-samples" "small things are missing: they fall between an adaptive sampler's first rays" "09-anti-aliasing.md#what-goes-wrong" [AdaptiveSamples]
    "wide-pixel" "samples come from more than the pixel: the picture is blurred" "09-anti-aliasing.md#the-code" [WidePixel(2.0), WidePixel(3.0)]
    "half-root" "both roots are half of what they should be: 2a and b are mixed up" "02-sphere-hit.md#the-maths" [HalfRoot]
};

/// Returns the row called `name`.
#[must_use]
pub fn named(name: &str) -> Option<&'static Mutation> {
    MUTATIONS.iter().find(|mutation| mutation.name == name)
}

/// Returns the row of a fault that the book shows.
#[must_use]
pub fn of(fault: Fault) -> Option<&'static Mutation> {
    MUTATIONS
        .iter()
        .find(|mutation| mutation.faults.contains(&fault))
}
