//! Axis-aligned bounding boxes.

use glam::DVec3;

/// An axis-aligned bounding box. Unions start from [`Aabb::EMPTY`], which holds nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Smallest coordinates.
    pub min: DVec3,
    /// Largest coordinates.
    pub max: DVec3,
}

/// Holds nothing: [`Aabb::EMPTY`].
impl Default for Aabb {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The smallest box about the points; empty for none.
impl FromIterator<DVec3> for Aabb {
    fn from_iter<T: IntoIterator<Item = DVec3>>(points: T) -> Self {
        Self::around(points)
    }
}

impl Aabb {
    /// The box that holds nothing: `min` above `max`.
    pub const EMPTY: Self = Self {
        min: DVec3::INFINITY,
        max: DVec3::NEG_INFINITY,
    };

    /// The smallest box about the points; empty for none.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().fold(Self::EMPTY, Self::including)
    }

    /// The box grown to hold `point`.
    pub fn including(self, point: DVec3) -> Self {
        let [min, max] = [point; 2];
        self.union(Self { min, max })
    }

    /// The smallest box that holds both.
    pub fn union(self, other: Self) -> Self {
        let (min, max) = (self.min.min(other.min), self.max.max(other.max));
        Self { min, max }
    }

    /// The box about the origin that reaches so far along each axis, to both sides.
    pub(crate) fn of_half_size(max: DVec3) -> Self {
        Self { min: -max, max }
    }

    /// The box grown by `room` on each side.
    pub fn grown(self, room: DVec3) -> Self {
        Self {
            min: self.min - room,
            max: self.max + room,
        }
    }

    /// Whether it holds no point at all.
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The same box, or that from -1 to 1 on each axis if it holds nothing: what stands for an empty scene.
    pub(crate) fn or_unit(self) -> Self {
        if self.is_empty() {
            Self::of_half_size(DVec3::ONE)
        } else {
            self
        }
    }

    /// Whether all of another box is in it.
    pub fn holds(&self, other: &Self) -> bool {
        other.min.cmpge(self.min).all() && other.max.cmple(self.max).all()
    }

    /// The middle. Meaningless when empty.
    pub fn center(&self) -> DVec3 {
        0.5 * (self.min + self.max)
    }

    /// Half the diagonal: the radius of the circumscribed sphere. Zero for a point.
    pub fn radius(&self) -> f64 {
        (0.5 * (self.max - self.min)).length()
    }

    /// Decimal places to write coordinates with: down to a millionth of the radius, about the precision of vertices. 6
    /// for a box without size.
    pub fn decimal_places(&self) -> usize {
        let radius = if self.is_empty() { 0.0 } else { self.radius() };
        let size = if radius > 0.0 { radius } else { 1.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped"
        )]
        let places = (6.0 - libm::log10(size).floor()).clamp(0.0, 330.0) as usize;
        places
    }

    /// The eight corners.
    pub fn corners(&self) -> [DVec3; 8] {
        let [a, b] = [self.min, self.max];
        std::array::from_fn(|i| {
            DVec3::new(
                if i & 1 == 0 { a.x } else { b.x },
                if i & 2 == 0 { a.y } else { b.y },
                if i & 4 == 0 { a.z } else { b.z },
            )
        })
    }
}
