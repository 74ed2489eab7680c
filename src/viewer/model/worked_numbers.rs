//! The numbers of a worked pick, in the order in which they are computed.

/// A number of a worked pick, or a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkedNumber {
    /// The clicked position, from the top left corner.
    Pixel,
    /// sx and sy.
    Ndc,
    /// The picture's middle.
    Middle,
    /// From the eye to the target.
    Length,
    /// Half of the field of view.
    Alpha,
    /// V: from the middle to the picture's upper edge.
    Upward,
    /// H: from the middle to the picture's right edge.
    Rightward,
    /// p.
    PlanePoint,
    /// The ray's direction in the world.
    Direction,
    /// Where the ray starts in object space.
    OriginObject,
    /// Its direction there.
    DirectionObject,
    /// The quadratic's coefficients A, B and C.
    Coefficient(usize),
    /// `B^2 - 4AC`.
    Discriminant,
    /// A root of the quadratic.
    Root(usize),
    /// Where the ray is inside a slab.
    Slab(usize),
    /// The last entry into a slab, or the first exit.
    Through(usize),
    /// The t of a square's or a triangle's plane.
    PlaneT,
    /// The point's coordinates in a square.
    InSquare,
    /// A share of a triangle's area.
    Share(usize),
    /// The sum of the three.
    Sum,
    /// The point in object space.
    PointObject,
    /// The normal in object space.
    NormalObject,
    /// The point in the world.
    Point,
    /// The normal in the world.
    Normal,
    /// The ray parameter in the world.
    T,
}
