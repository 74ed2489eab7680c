//! A camera that flags or a scene file give in part. Framing the scene fills in the rest.

use super::{
    Camera, CameraError, DepthMapping, Framed, Framing, Lens, Orbit, Projection, SectionChoice,
    UpAxis, Viewport, fit_near_far, in_range, unit,
};
use crate::geometry::Aabb;
use glam::DVec3;
use serde::{Deserialize, Deserializer, Serialize, de::Error};
use std::cell::LazyCell;

/// The parts of a camera that the user chose; `None` leaves a field to the next source. World space and units; angles
/// in degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(
    deny_unknown_fields,
    default,
    expecting = "a camera, which begins with [camera]"
)]
pub struct CameraChoice {
    /// Where the eye stands.
    #[serde(deserialize_with = "some_vector")]
    pub eye: Option<DVec3>,
    /// What it looks at.
    #[serde(deserialize_with = "some_vector")]
    pub target: Option<DVec3>,
    /// Which way it looks, in place of a target.
    #[serde(deserialize_with = "some_vector")]
    pub look: Option<DVec3>,
    /// Which way is up in the picture; need not be perpendicular to the line of sight.
    #[serde(deserialize_with = "some_vector")]
    pub up: Option<DVec3>,
    /// Vertical field of view in degrees.
    pub fov: Option<f64>,
    /// Full height of an orthographic picture, in place of a field of view.
    pub ortho: Option<f64>,
    /// Near plane's view depth.
    pub near: Option<f64>,
    /// Far plane's view depth.
    pub far: Option<f64>,
    /// What the depth buffer stores.
    pub depth: Option<DepthMapping>,
    /// Which world axis points up.
    pub up_axis: Option<UpAxis>,
    /// The plane that cuts the world; [`Scene::section`](crate::scene::Scene::section) resolves it.
    pub section: Option<SectionChoice>,
}

/// Reads an array of exactly `N` values. Plain arrays would ignore extra ones.
pub(crate) fn exactly<'de, const N: usize, T: Deserialize<'de>, D: Deserializer<'de>>(
    from: D,
) -> Result<[T; N], D::Error> {
    let values = Vec::<T>::deserialize(from)?;
    let count = values.len();
    let expected = format!("exactly {N}");
    values
        .try_into()
        .map_err(|_| D::Error::invalid_length(count, &expected.as_str()))
}

/// Reads a vector into an optional field.
pub(crate) fn some_vector<'de, D: Deserializer<'de>>(from: D) -> Result<Option<DVec3>, D::Error> {
    exactly(from).map(|vector| Some(DVec3::from_array(vector)))
}

impl CameraChoice {
    /// Vertical field of view where none is given, in degrees.
    pub const FOV: f64 = 45.0;

    /// These choices, and `other`'s for the fields without one. Target and look count as one field, and so do field of
    /// view and orthographic height.
    pub fn or(self, other: Self) -> Self {
        let aims = self.target.is_some() || self.look.is_some();
        let narrows = self.fov.is_some() || self.ortho.is_some();
        Self {
            eye: self.eye.or(other.eye),
            target: if aims { self.target } else { other.target },
            look: if aims { self.look } else { other.look },
            up: self.up.or(other.up),
            fov: if narrows { self.fov } else { other.fov },
            ortho: if narrows { self.ortho } else { other.ortho },
            near: self.near.or(other.near),
            far: self.far.or(other.far),
            depth: self.depth.or(other.depth),
            up_axis: self.up_axis.or(other.up_axis),
            section: self.section.or(other.section),
        }
    }

    /// The camera as chosen. Framing `framed` decides the fields that are `None`.
    ///
    /// # Errors
    /// When the choices make no camera; see [`CameraError`].
    pub fn resolve(&self, framed: &impl Framed, viewport: Viewport) -> Result<Camera, CameraError> {
        let up_axis = self.up_axis.unwrap_or_default();
        let fov_y = self.fov.unwrap_or(Self::FOV).to_radians();
        let mut lens = Lens {
            projection: match self.ortho {
                Some(height) => Projection::Orthographic { height },
                None => Projection::Perspective { fov_y },
            },
            // Any valid planes will do: they are fitted once there is a camera.
            near: 1.0,
            far: 2.0,
            depth: self.depth.unwrap_or_default(),
        };
        lens.stored()?;
        let look = self.look.map(|look| in_range(look, "direction"));
        let look = look.transpose()?;
        let bounds_world = framed.bounds();
        check_size(&bounds_world)?;
        let framing = Framing {
            fov_y,
            aspect: viewport.aspect(),
            is_parallel: self.ortho.is_some(),
            filled: Framing::FILLED,
        };
        // Where the camera itself stands, what is framed is not asked.
        let orbit = LazyCell::new(|| {
            let looked_along = look.and_then(unit);
            let to_eye = looked_along.map(|look| up_axis.frame().transpose() * -look);
            let mut orbit = Orbit::new(up_axis, to_eye.unwrap_or(Orbit::FROM));
            orbit.frame(framed, &framing);
            orbit
        });
        let camera = |up: DVec3| match (look, self.target) {
            (Some(look), _) => {
                let along = unit(look).map_or(look, |unit| unit * orbit.distance());
                let eye = self.eye.unwrap_or_else(|| orbit.target() - along);
                Camera::looking(eye, along, up, lens)
            }
            (None, target) => {
                // What is seen from a given eye is not centred where framing would stand.
                let middle = || match self.eye {
                    Some(_) if !bounds_world.is_empty() => bounds_world.center(),
                    _ => orbit.target(),
                };
                let target = target.unwrap_or_else(middle);
                let from_target = || orbit.eye() - orbit.target();
                let eye = self.eye.unwrap_or_else(|| target + from_target());
                Camera::new(eye, target, up, lens)
            }
        };
        let (above, towards) = (up_axis.up(), up_axis.frame().z_axis);
        let camera = match camera(self.up.unwrap_or(above)) {
            // Looking straight down or up: the picture is turned as in an orbit at that pitch.
            Err(CameraError::UpAlongForward) if self.up.is_none() => {
                let is_down = camera(towards)?.forward().dot(above) < 0.0;
                camera(if is_down { -towards } else { towards })?
            }
            camera => camera?,
        };
        (lens.near, lens.far) = fit_near_far(&camera, &bounds_world, self.near, self.far);
        camera.with_lens(lens)
    }
}

/// Whether a scene in this box is neither too large nor too small for any view. An empty box is not, nor is a point.
///
/// # Errors
/// [`CameraError::SceneSize`].
pub(crate) fn check_size(bounds_world: &Aabb) -> Result<(), CameraError> {
    let size = 2.0 * bounds_world.radius();
    // Framing moves back by more than the scene's size.
    let (least, most) = (100.0 * Orbit::DISTANCES.0, 0.01 * Orbit::DISTANCES.1);
    if bounds_world.is_empty() || size == 0.0 || (least..=most).contains(&size) {
        Ok(())
    } else {
        Err(CameraError::SceneSize(size))
    }
}
