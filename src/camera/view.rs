//! The picture's size, and everything besides the scene that decides what a pixel shows.

use super::{Camera, CameraError, Lens, Projected};
use crate::geometry::{
    Aabb, PixelRays, PlacedPoint, Section, Sides, ThroughPoint, WorldRay, clip_points,
};
use glam::{DVec2, DVec3};

/// The size of the picture in physical pixels, at least 1 x 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Viewport {
    width: u32,
    height: u32,
}

impl Viewport {
    /// The default size: 1280 x 720.
    pub const DEFAULT: Self = Self {
        width: 1280,
        height: 720,
    };

    /// The most pixels along a side that a user may ask for. More is surely a typing error.
    pub const LARGEST_SIDE: u32 = 16_384;

    /// Takes width and height in pixels.
    ///
    /// # Errors
    /// When either is zero.
    pub fn new(width: u32, height: u32) -> Result<Self, CameraError> {
        if width == 0 || height == 0 {
            return Err(CameraError::EmptyViewport(width, height));
        }
        Ok(Self { width, height })
    }

    /// Width in pixels.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Width and height in pixels.
    pub fn size_px(self) -> DVec2 {
        DVec2::new(self.width.into(), self.height.into())
    }

    /// Width over height.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }

    /// A pixel position in NDC: x and y in [-1, 1] within the picture, y up.
    pub fn px_to_ndc(self, px: DVec2) -> DVec2 {
        let from_corner = 2.0 * px / self.size_px();
        DVec2::new(from_corner.x - 1.0, 1.0 - from_corner.y)
    }

    /// An NDC position in pixels.
    pub(crate) fn ndc_to_px(self, ndc: DVec2) -> DVec2 {
        0.5 * DVec2::new(ndc.x + 1.0, 1.0 - ndc.y) * self.size_px()
    }

    /// Whether a pixel position lies within the picture: `0 <= x < width`, `0 <= y < height`.
    pub fn contains(self, px: DVec2) -> bool {
        px.cmpge(DVec2::ZERO).all() && px.cmplt(self.size_px()).all()
    }
}

/// Everything besides the scene that decides which surface a pixel shows; drawing and picking share it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Where the eye stands and where it looks.
    pub camera: Camera,
    /// The picture's size.
    pub viewport: Viewport,
    /// Whether back faces show.
    pub sides: Sides,
    /// The plane that cuts the world, in world space; `None` if nothing does.
    pub section: Option<Section>,
}

impl View {
    /// A camera's view of both sides of all surfaces, not cut.
    pub fn new(camera: Camera, viewport: Viewport) -> Self {
        Self {
            camera,
            viewport,
            sides: Sides::Both,
            section: None,
        }
    }

    /// Projects a world-space segment: its two ends in pixels. The segment is clipped by the near plane and by nothing
    /// else. `None` if nothing is left.
    pub fn project_segment(&self, a: DVec3, b: DVec3) -> Option<[DVec2; 2]> {
        let [a, b, ..] = self.past_near(&[a, b])[..] else {
            return None;
        };
        Some([self.project(a)?.px, self.project(b)?.px])
    }

    /// The part of a world-space polygon or segment that does not lie in front of the near plane; see [`clip_points`].
    pub(crate) fn past_near(&self, corners: &[DVec3]) -> Vec<DVec3> {
        let near = self.camera.lens().near;
        clip_points(corners, |p| self.camera.to_view(p).z - near)
    }

    /// The same view with no section.
    pub fn uncut(&self) -> Self {
        Self {
            section: None,
            ..*self
        }
    }

    /// The world-space ray through a pixel position; see [`Camera::ray`].
    pub fn ray(&self, px: DVec2) -> WorldRay<'static> {
        self.rays().ray(px)
    }

    /// The data of the ray through a point of a shape.
    pub fn through(&self, point: &PlacedPoint) -> ThroughPoint {
        let Lens { near, far, .. } = *self.camera.lens();
        ThroughPoint {
            grid: self.camera.pixel_grid(self.viewport),
            point: *point,
            interval: [near, far],
        }
    }

    /// The world-space rays through all pixels; each equals that of [`View::ray`].
    pub fn rays(&self) -> PixelRays {
        let Lens { near, far, .. } = *self.camera.lens();
        let rays = self.camera.pixel_grid(self.viewport).rays([near, far]);
        rays.cut_by(self.section)
    }

    /// The world-space vector from the eye to the point at view depth `t` on the ray through a pixel position.
    pub fn offset_from_eye(&self, px: DVec2, t: f64) -> DVec3 {
        let grid = self.camera.pixel_grid(self.viewport);
        let aside = grid.aside(px);
        if grid.is_orthographic {
            aside + t * grid.forward
        } else {
            t * (grid.forward + aside)
        }
    }

    /// Half the picture's extent, to the right and upwards; see [`Lens::half_extent`](super::Lens::half_extent).
    pub fn half_extent(&self) -> DVec2 {
        self.camera.half_extent(self.viewport)
    }

    /// The pixel position of a point that lies off the line of sight by `aside` (to the right and upwards), at
    /// clip-space w `w`; see [`Lens::w`](super::Lens::w).
    pub(crate) fn px_of(&self, aside: DVec2, w: f64) -> DVec2 {
        let ndc = self.camera.ndc_of(self.viewport, aside, w);
        self.viewport.ndc_to_px(ndc)
    }

    /// How many pixels wide a length across the line of sight looks at a world point; `None` where it lies beside or
    /// behind the eye.
    pub(crate) fn px_across(&self, length: f64, point_world: DVec3) -> Option<f64> {
        let w = (self.camera.lens()).w(self.camera.to_view(point_world).z);
        let px = |aside| self.px_of(DVec2::new(aside, 0.0), w).x;
        (w > 0.0).then(|| px(length) - px(0.0))
    }

    /// Where the picture shows a world point; see [`Camera::project`].
    pub fn project(&self, point_world: DVec3) -> Option<Projected> {
        self.camera.project(self.viewport, point_world)
    }

    /// The corners of the view volume in world space: near plane, then far plane, each from the top left clockwise.
    pub fn frustum_corners(&self) -> [DVec3; 8] {
        let [width, height] = self.viewport.size_px().to_array();
        let corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)];
        std::array::from_fn(|i| {
            let ray = self.camera.ray(self.viewport, corners[i % 4].into());
            ray.at(if i < 4 { ray.t_min } else { ray.t_max })
        })
    }

    /// Whether part of a world-space box may be in the picture: false if the box is empty, lies outside one of the view
    /// volume's six planes or is cut away by the section.
    pub(crate) fn may_see(&self, bounds_world: &Aabb) -> bool {
        let lens = self.camera.lens();
        let half = self.half_extent();
        let excess = bounds_world.corners().map(|corner| {
            let p = self.camera.to_view(corner);
            let w = lens.w(p.z);
            let (x, y) = (half.x * w, half.y * w);
            [
                p.x - x,
                -p.x - x,
                p.y - y,
                -p.y - y,
                p.z - lens.far,
                lens.near - p.z,
                self.section.map_or(0.0, |section| -section.side(corner)),
            ]
        });
        !bounds_world.is_empty()
            && (0..7).all(|plane| excess.iter().any(|corner| corner[plane] <= 0.0))
    }
}

/// The centre of the pixel that holds a position. A click at the position picks at this centre.
pub fn pixel_centre(px: DVec2) -> DVec2 {
    px.floor() + 0.5
}
