//! Perspective and orthographic projection, near and far planes, and the depth buffer's values.

use super::CameraError;
use crate::geometry::range;
use glam::{DMat4, DVec2, DVec4};
use serde::{Deserialize, Serialize};

/// How view space becomes the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Perspective or orthographic.
    pub projection: Projection,
    /// View depth of the near plane, which still belongs to the picture. Above 0 in perspective.
    pub near: f64,
    /// View depth of the far plane, which does not belong to the picture.
    pub far: f64,
    /// What the depth buffer stores.
    pub depth: DepthMapping,
}

/// Which projection, and how wide it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Straight lines through the eye.
    Perspective {
        /// Vertical field of view in radians, in (0, pi).
        fov_y: f64,
    },
    /// Parallel lines along F.
    Orthographic {
        /// Full height of the picture in world units.
        height: f64,
    },
}

/// From view depth to the depth buffer's [0, 1].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DepthMapping {
    /// Near becomes 1 and far 0. In perspective, the steps of a floating-point buffer then grow in proportion to the
    /// depth.
    #[default]
    Reversed,
    /// Near becomes 0 and far 1, as taught in courses.
    Standard,
}

impl std::fmt::Display for DepthMapping {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Reversed => "reversed",
            Self::Standard => "standard",
        })
    }
}

impl Lens {
    /// The lens, checked, and as cameras store it: near and far are [`stored`](range::stored).
    ///
    /// # Errors
    /// When the field of view lies outside (0, 180) degrees, a number is beyond the range of numbers (of the field of
    /// view, the tangent of half of it; of the height, also half of it), near is not positive in perspective or far not
    /// above the least number, or near does not lie before far.
    pub fn stored(self) -> Result<Self, CameraError> {
        let plane = |plane| range::stored(plane).ok_or(CameraError::PlaneOutOfRange(plane));
        let (near, far) = (plane(self.near)?, plane(self.far)?);
        let has_size = |number: f64| (range::LEAST..=range::LARGEST).contains(&number);
        let top = self.half_extent(1.0).y;
        match self.projection {
            Projection::Perspective { fov_y }
                if !(fov_y > 0.0 && fov_y < std::f64::consts::PI && has_size(top)) =>
            {
                return Err(CameraError::FieldOfView(fov_y.to_degrees()));
            }
            Projection::Orthographic { height } if !(has_size(top) && has_size(height)) => {
                return Err(CameraError::Height(height));
            }
            _ => {}
        }
        if !self.is_orthographic() && far <= range::LEAST {
            return Err(CameraError::FarTooSmall(self.far));
        }
        if !self.is_orthographic() && near <= 0.0 {
            return Err(CameraError::NearTooSmall(self.near));
        }
        if !(near < far) {
            return Err(CameraError::NearNotBeforeFar { near, far });
        }
        Ok(Self { near, far, ..self })
    }

    /// Whether all lines of sight are parallel.
    pub fn is_orthographic(&self) -> bool {
        matches!(self.projection, Projection::Orthographic { .. })
    }

    /// Half the picture's width and height: in world units for orthographic projection, at view depth 1 in
    /// perspective (so `tan(fov_y / 2)` high).
    pub fn half_extent(&self, aspect: f64) -> DVec2 {
        let top = match self.projection {
            Projection::Perspective { fov_y } => libm::tan(0.5 * fov_y),
            Projection::Orthographic { height } => 0.5 * height,
        };
        DVec2::new(top * aspect, top)
    }

    /// Clip-space w at a view depth. There the picture's half extent is [`Lens::half_extent`] times w.
    pub fn w(&self, depth: f64) -> f64 {
        match self.projection {
            Projection::Perspective { .. } => depth,
            Projection::Orthographic { .. } => 1.0,
        }
    }

    /// The third row of the projection matrix, `(a, b)`: clip z is `a * depth + b`. NDC z is clip z divided by
    /// [`Lens::w`].
    pub fn depth_row(&self) -> (f64, f64) {
        let Self {
            near: n, far: f, ..
        } = *self;
        let range = f - n;
        let far_share = f / range;
        match (self.projection, self.depth) {
            (Projection::Perspective { .. }, DepthMapping::Standard) => (far_share, -far_share * n),
            (Projection::Perspective { .. }, DepthMapping::Reversed) => (-n / range, far_share * n),
            (Projection::Orthographic { .. }, DepthMapping::Standard) => (1.0 / range, -n / range),
            (Projection::Orthographic { .. }, DepthMapping::Reversed) => (-1.0 / range, far_share),
        }
    }

    /// What the depth buffer stores for a view depth: NDC z, to within a few roundings, and in [0, 1] between the
    /// planes.
    pub fn ndc_depth(&self, depth: f64) -> f64 {
        let Self { near, far, .. } = *self;
        let range = far - near;
        let [to_near, to_far] = [depth - near, far - depth].map(|way| way / range);
        let [from_near, from_far] = match self.projection {
            Projection::Perspective { .. } => [far / depth * to_near, near / depth * to_far],
            Projection::Orthographic { .. } => [to_near, to_far],
        };
        match self.depth {
            DepthMapping::Reversed => from_far,
            // In this half the complement rounds less, and it never exceeds 1.
            DepthMapping::Standard if from_far < 0.5 => 1.0 - from_far,
            DepthMapping::Standard => from_near,
        }
    }

    /// The resolution of a 32-bit floating-point depth buffer at `depth`: the step in view depth from the stored value
    /// to the next value away from the eye. Infinite where no value follows up to the far plane.
    pub fn depth_step(&self, depth: f64) -> f64 {
        #[expect(clippy::cast_possible_truncation, reason = "what the buffer stores")]
        let stored = self.ndc_depth(depth) as f32;
        let next = match self.depth {
            DepthMapping::Reversed => stored.next_down(),
            DepthMapping::Standard => stored.next_up(),
        };
        if (0.0..=1.0).contains(&next) {
            self.depth_at(next.into()) - self.depth_at(stored.into())
        } else {
            f64::INFINITY
        }
    }

    /// The view depth at an NDC z: the inverse of [`Lens::ndc_depth`], to within the roundings of [`Lens::depth_row`].
    pub(crate) fn depth_at(&self, ndc_z: f64) -> f64 {
        let (a, b) = self.depth_row();
        match self.projection {
            Projection::Perspective { .. } => b / (ndc_z - a),
            Projection::Orthographic { .. } => (ndc_z - b) / a,
        }
    }

    /// From view to clip space, for column vectors; `aspect` is width over height.
    pub fn projection(&self, aspect: f64) -> DMat4 {
        let half = self.half_extent(aspect);
        let (a, b) = self.depth_row();
        let (w_from_z, w) = match self.projection {
            Projection::Perspective { .. } => (1.0, 0.0),
            Projection::Orthographic { .. } => (0.0, 1.0),
        };
        DMat4::from_cols(
            DVec4::new(1.0 / half.x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, 1.0 / half.y, 0.0, 0.0),
            DVec4::new(0.0, 0.0, a, w_from_z),
            DVec4::new(0.0, 0.0, b, w),
        )
    }
}
