//! What can go wrong, one thing at a time.

use glam::Vec2;

/// One mistake of a tracer. [`tracer`](crate::tracer) and [`figures`](crate::figures) draw every
/// picture as if it had been made.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(
    missing_docs,
    reason = "the table of mutations says of each what it is"
)]
pub enum Fault {
    None,

    // Where a pixel is.
    FlipX,
    FlipY,
    HalfTurn,
    Transposed,
    /// The ray goes through this point of the pixel, from (0, 0) at the top left to (1, 1).
    PixelPoint(Vec2),
    /// Divided by the width and the height less one.
    SizeLessOne,
    SquarePlane,
    AspectInverted,
    /// The half-width is 1, and not the half-height.
    FitsWidth,
    /// The picture is moved by whole pixels.
    Shift(i32, i32),

    // The camera.
    FocalTimes(f32),
    FocalInverted,
    /// tan α for tan α/2.
    WholeAngle,
    /// The half angle in degrees, given to tan.
    DegreesAsRadians,
    LooksBack,
    /// Straight ahead, not at the still life.
    NotTilted,
    /// The point that is looked at, taken for the direction.
    TargetAsDirection,
    /// y of the image plane is the world's y.
    UpNotTilted,
    /// And whether the formula for the sphere takes the direction for a unit vector.
    NotNormalized(bool),
    /// All rays are parallel.
    Parallel,

    // Levels.
    Linear,
    Gamma(f32),
    EncodedTwice,
    DecodedInstead,
    /// 255 or 256 times the encoded value, not rounded.
    Truncated(f64),
    Wraps,
    Channels([usize; 3]),
    /// The mean of the levels, or their luma.
    Grey([f32; 3]),
    Negative,
    Black,
    Brighter(f32),
    ToneMapped,
    /// The scene's colours are taken for sRGB, and decoded.
    ColoursDecoded,

    // Balls and the floor.
    RadiusTimes(f32),
    RadiusUnsquared,
    FarRoot,
    FarWallOnly,
    HalfRoot,
    LastInList,
    FirstInList,
    Farthest,
    TextbookSphere,
    NormalInward,
    NormalNotNormalized,
    NormalFromOrigin,
    OneSidedPlane,
    NoFloor,
    CheckerParity,
    CheckerInSpace,
    CheckerTowardsZero,
    CheckerTimes(f32),
    CheckerStripes,
    CheckerMultiplied,

    // Light and shadow.
    NoShadows,
    BeyondLight,
    ShadowUnnormalized,
    ShadowFromEye,
    NoBias,
    Bias(f32),
    BiasInward,
    AnyShadowIsAll,
    LightsSwapped,
    LightMissing(usize),
    LightsFull,
    LightsAveraged,
    Falloff(i32),
    LightMirroredZ,
    LightsDirectional,
    NoAmbient,
    AmbientPerLight,
    AmbientWhite,
    AmbientShadowed,
    NoDiffuse,
    /// k_s is 5 where there is a highlight.
    StrongSurfaces,
    DiffuseFlat,
    DiffuseBothSides,
    DiffuseHalf,
    NoSpecular,
    SpecularColoured,
    SpecularTimesCosine,
    SpecularUnshadowed,
    HalfVector,
    ShininessTimes(f32),
    CosineUnclamped,
    ReflectedSign,
    ViewSign,
    LightUnnormalized,

    // Mirrors.
    NoMirror,
    DepthOne,
    DepthLess,
    MirrorWithoutTwo,
    MirrorSign,
    MirrorFromLight,
    MirrorMixed,
    MirrorFull,
    MirrorOnly,
    MirrorSquared,
    MirrorBlackSky,
    MirrorUnnormalized,
    MirrorTinted,
    MirrorUnlit,

    // Glass.
    RatioInverted,
    RatioSame,
    TotalBlack,
    TotalStraight,
    Unbent,
    IndexOther(f32),
    GlassDepth,
    GlassBiasWrong,
    GlassNormalUnturned,
    GlassOpaque,
    GlassNoShadow,
    GlassShadowBlack,
    GlassTinted,
    RefractSign,
    NoReflection,
    OnlyReflection,
    SchlickWrongCosine,
    Schlick,
    OnePolarization(bool),
    ConstantReflectance(f32),
    FresnelSwapped,
    TransmitsAll,
    EqualIndicesSparkle,
    FresnelAverage,
    AbsorbsAtSurface,
    AbsorbsTwice,
    AbsorbsOutside,
    AbsorbsNot,
    AbsorbsBaseTen,
    AbsorbsLinearly,
    Alone,
    PlaneWithoutInside,

    // Samples.
    OneSample,
    Corners,
    MeanOfLevels,
    ClampedSamples,
    UnclampedSamples,
    NotJittered,
    AdaptiveSamples,
    WidePixel(f32),
    FewerSamples,
}

impl Fault {
    /// Returns the same fault, stronger or weaker by some factor. `None` if it has no strength.
    #[must_use]
    pub fn scaled(self, by: f32) -> Option<Self> {
        Some(match self {
            Self::FocalTimes(x) => Self::FocalTimes(x * by),
            Self::Gamma(x) => Self::Gamma(x * by),
            Self::Brighter(x) => Self::Brighter(x * by),
            Self::RadiusTimes(x) => Self::RadiusTimes(x * by),
            Self::Bias(x) => Self::Bias(x * by),
            Self::ShininessTimes(x) => Self::ShininessTimes(x * by),
            Self::IndexOther(x) => Self::IndexOther(x * by),
            Self::ConstantReflectance(x) => Self::ConstantReflectance(x * by),
            Self::WidePixel(x) => Self::WidePixel(x * by),
            _ => return None,
        })
    }
}
