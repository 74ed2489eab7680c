//! One camera for drawing and picking: the GPU's matrices and a click's rays come from the same value, in `f64`.
//!
//! View space is left-handed: x = R right, y = U up, z = F forward, so `det(View) = -1`. A pixel `(i, j)` has
//! its centre at `(i + 0.5, j + 0.5)`, the origin is the top left corner and y runs down.

mod choice;
mod fit;
mod framing;
mod lens;
mod ndc;
mod orbit;
mod section_choice;
mod view;

pub use choice::CameraChoice;
pub(crate) use choice::{check_size, exactly, some_vector};
pub use fit::fit_near_far;
pub(crate) use fit::least_near;
pub use framing::{Framed, Framing};
pub use lens::{DepthMapping, Lens, Projection};
pub use ndc::NdcSpace;
pub use orbit::{Orbit, UpAxis};
pub use section_choice::{SectionChoice, SectionWordError};
pub use view::{View, Viewport, pixel_centre};

use crate::geometry::{PixelGrid, WorldRay, range};
use glam::{DMat3, DMat4, DVec2, DVec3};

/// Where the eye stands, where it looks and through which lens. Always valid: axes are orthonormal, near lies
/// before far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: DVec3,
    target: DVec3,
    up_hint: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    lens: Lens,
    /// The lens's half extent for aspect 1, computed once: a tangent costs as much as the rest of a ray.
    half_height: f64,
}

/// Why a camera is refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CameraError {
    /// Eye, target, direction or up has a number beyond the range of numbers; see [`range`].
    #[error("the numbers of the camera's {0} must be at most 1.29e33 in size")]
    OutOfRange(&'static str),
    /// There is no direction to look along.
    #[error(
        "the camera looks nowhere: its eye and target are the same point, or its direction is zero"
    )]
    NoDirection,
    /// Right is undefined.
    #[error("the camera's up vector is zero or points along the line of sight")]
    UpAlongForward,
    /// Outside (0, 180) degrees, or so small that its tangent would be stored as 0.
    #[error("the field of view must lie between 1e-31 and 180 degrees, not {0:?}")]
    FieldOfView(f64),
    /// It or its half is not in the range of numbers.
    #[error("the orthographic height must lie between 1.6e-33 and 1.29e33, not {0:?}")]
    Height(f64),
    /// Perspective shows nothing at or behind the eye.
    #[error("near must be at least 7.8e-34 in perspective, not {0:?}")]
    NearTooSmall(f64),
    /// Perspective shows nothing up to such a plane.
    #[error("far must be more than 7.8e-34 in perspective, not {0:?}")]
    FarTooSmall(f64),
    /// Near or far is beyond the range of numbers.
    #[error("near and far must be numbers up to 1.29e33, not {0:?}")]
    PlaneOutOfRange(f64),
    /// Near has to come first.
    #[error("near must be less than far, not {near:?} and {far:?}")]
    NearNotBeforeFar {
        /// Near plane's view depth.
        near: f64,
        /// Far plane's view depth.
        far: f64,
    },
    /// Too large or too small for any view.
    #[error("the scene is {0:.0e} units across; views hold scenes of 1e-25 to 5e30")]
    SceneSize(f64),
    /// A picture without pixels.
    #[error("the picture must be at least 1 pixel wide and high, not {0}x{1}")]
    EmptyViewport(u32, u32),
}

/// A world point as the picture shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Normalised device coordinates: x, y in [-1, 1], y up; z in [0, 1] by the lens's depth mapping.
    pub ndc: DVec3,
    /// Position in pixels.
    pub px: DVec2,
    /// View depth: distance along F, in world units.
    pub depth: f64,
}

impl Camera {
    /// A camera at `eye` that looks at `target`. `up` need not be perpendicular to the line of sight, nor a unit
    /// vector.
    ///
    /// # Errors
    /// When a number is beyond the range of numbers, eye and target coincide, up lies along the line of sight, or the
    /// lens is not valid.
    pub fn new(eye: DVec3, target: DVec3, up: DVec3, lens: Lens) -> Result<Self, CameraError> {
        let (eye, target) = (in_range(eye, "eye")?, in_range(target, "target")?);
        let along = target - eye;
        Self::facing([eye, target], along, up, lens)
    }

    /// A camera at `eye` that looks along `direction`; its target lies at the direction's end.
    ///
    /// # Errors
    /// As [`Camera::new`].
    pub fn looking(
        eye: DVec3,
        direction: DVec3,
        up: DVec3,
        lens: Lens,
    ) -> Result<Self, CameraError> {
        let eye = in_range(eye, "eye")?;
        let direction = in_range(direction, "direction")?;
        let target = in_range(eye + direction, "target")?;
        Self::facing([eye, target], direction, up, lens)
    }

    /// A camera at an eye with a target, both stored, that looks along `direction`.
    fn facing(
        [eye, target]: [DVec3; 2],
        direction: DVec3,
        up: DVec3,
        lens: Lens,
    ) -> Result<Self, CameraError> {
        let lens = lens.stored()?;
        let up = in_range(up, "up vector")?;
        let forward = unit(direction).ok_or(CameraError::NoDirection)?;
        let right = unit(up).and_then(|up| {
            let right = forward.cross(up);
            // The cross product of two parallel unit vectors is only rounding error.
            (right.length() > 4.0 * f64::EPSILON).then(|| right.normalize())
        });
        // If up is close to the line of sight, rounding error makes `right` oblique; this makes it perpendicular again.
        let right = right.map(|right| (right - right.dot(forward) * forward).normalize());
        let right = right.ok_or(CameraError::UpAlongForward)?;
        let [right, up_axis, forward] = [right, right.cross(forward), forward].map(stored_axis);
        Ok(Self {
            eye,
            target,
            up_hint: up,
            right,
            up: up_axis,
            forward,
            lens,
            half_height: lens.half_extent(1.0).y,
        })
    }

    /// The same view through another lens.
    ///
    /// # Errors
    /// When the lens is not valid.
    pub fn with_lens(self, lens: Lens) -> Result<Self, CameraError> {
        let lens = lens.stored()?;
        Ok(Self {
            lens,
            half_height: lens.half_extent(1.0).y,
            ..self
        })
    }

    /// World position of the eye.
    pub fn eye(&self) -> DVec3 {
        self.eye
    }

    /// World point in the middle of the picture.
    pub fn target(&self) -> DVec3 {
        self.target
    }

    /// Up as it was given. [`Camera::new`] with eye, target, this up and the lens makes the same camera again; to the
    /// bit, if it came from [`Camera::new`].
    pub fn up_hint(&self) -> DVec3 {
        self.up_hint
    }

    /// Unit vector R: to the right in the picture.
    pub fn right(&self) -> DVec3 {
        self.right
    }

    /// Unit vector U: upwards in the picture.
    pub fn up(&self) -> DVec3 {
        self.up
    }

    /// Unit vector F: into the picture.
    pub fn forward(&self) -> DVec3 {
        self.forward
    }

    /// Projection, near, far and depth mapping.
    pub fn lens(&self) -> &Lens {
        &self.lens
    }

    /// Half the picture's height: at view depth 1 in perspective (the tangent of half the field of view), in world
    /// units in orthographic projection.
    pub fn half_height(&self) -> f64 {
        self.half_height
    }

    /// The rows R, U, F: from world to view directions.
    pub fn rotation(&self) -> DMat3 {
        DMat3::from_cols(self.right, self.up, self.forward).transpose()
    }

    /// The view matrix V = O T, from world to view space.
    pub fn view(&self) -> DMat4 {
        let [turn, shift] = self.view_factors();
        turn * shift
    }

    /// The factors O and T of the view matrix: T moves the eye to the origin, then O, whose rows are R, U and F, turns.
    pub fn view_factors(&self) -> [DMat4; 2] {
        let turn = DMat4::from_mat3(self.rotation());
        [turn, DMat4::from_translation(-self.eye)]
    }

    /// Projection for a picture of this shape; see [`Lens::projection`].
    pub fn projection(&self, viewport: Viewport) -> DMat4 {
        self.lens.projection(viewport.aspect())
    }

    /// A world point in view space: x right, y up, z forward.
    pub fn to_view(&self, point_world: DVec3) -> DVec3 {
        self.rotation() * (point_world - self.eye)
    }

    /// The data from which the ray of each pixel is computed.
    pub fn pixel_grid(&self, viewport: Viewport) -> PixelGrid {
        PixelGrid {
            eye: self.eye,
            right: self.right,
            up: self.up,
            forward: self.forward,
            half_height: self.half_height,
            size_px: [viewport.width(), viewport.height()],
            is_orthographic: self.lens.is_orthographic(),
        }
    }

    /// The world-space ray through a pixel position; see [`PixelGrid::ray`]. Its `t` is view depth. Its interval runs
    /// from the near plane to the far plane.
    pub fn ray(&self, viewport: Viewport, px: DVec2) -> WorldRay<'static> {
        let Lens { near, far, .. } = self.lens;
        self.pixel_grid(viewport).ray(px, [near, far])
    }

    /// [`Lens::half_extent`].
    fn half_extent(&self, viewport: Viewport) -> DVec2 {
        DVec2::new(self.half_height * viewport.aspect(), self.half_height)
    }

    /// NDC x and y of a point that lies off the line of sight by `aside`, at clip-space w `w`.
    fn ndc_of(&self, viewport: Viewport, aside: DVec2, w: f64) -> DVec2 {
        aside / (self.half_extent(viewport) * w)
    }

    /// Where the picture shows a world point, not clipped; `None` at or behind the eye in perspective.
    pub fn project(&self, viewport: Viewport, point_world: DVec3) -> Option<Projected> {
        let view = self.to_view(point_world);
        let w = self.lens.w(view.z);
        if !(w > 0.0) {
            return None;
        }
        let ndc = self.ndc_of(viewport, view.truncate(), w);
        Some(Projected {
            ndc: ndc.extend(self.lens.ndc_depth(view.z)),
            px: viewport.ndc_to_px(ndc),
            depth: view.z,
        })
    }
}

/// The unit vector along `v`; `None` where it has no length.
fn unit(v: DVec3) -> Option<DVec3> {
    let size = v.abs().max_element();
    (size > 0.0).then(|| (v / size).normalize())
}

fn in_range(vector: DVec3, name: &'static str) -> Result<DVec3, CameraError> {
    range::stored_vector(vector).ok_or(CameraError::OutOfRange(name))
}

/// An axis of length 1 whose least components are 0.
fn stored_axis(axis: DVec3) -> DVec3 {
    range::stored_vector(axis).unwrap_or(axis)
}
