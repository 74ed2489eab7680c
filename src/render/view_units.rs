//! How the GPU counts view space: its unit of length, and the plane from which it counts depth.

use crate::{
    camera::{DepthMapping, Projection, View},
    geometry::binary::power_of_two_below,
};

/// View depth of the plane where the depth buffer stores 0, from which *buffer depth* counts: the far plane in
/// reversed mapping, the near plane in standard mapping. Clip z is buffer depth times a factor, so that no digits
/// cancel.
pub fn depth_origin(view: &View) -> f64 {
    let lens = view.camera.lens();
    match lens.depth {
        DepthMapping::Reversed => lens.far,
        DepthMapping::Standard => lens.near,
    }
}

/// View units per world unit, a power of two. It brings what the picture shows into `f32`'s range, however large or
/// small the scene is. In perspective it puts 1 between the w of near and of far: an NVIDIA H100 draws nothing where the
/// square of w leaves that range.
pub fn view_unit(view: &View) -> f64 {
    let lens = view.camera.lens();
    // Geometric means of what may be far apart: of the planes, or of the picture's height and depth.
    let size = match lens.projection {
        Projection::Perspective { .. } => lens.near.sqrt() * lens.far.sqrt(),
        Projection::Orthographic { height } => height.sqrt() * (lens.far - lens.near).sqrt(),
    };
    power_of_two_below(size).recip()
}
