//! A whole picture by casting a ray a pixel: needs no graphics driver.

use super::{SceneHit, closest};
use crate::{
    camera::View,
    colour::Srgb,
    geometry::Ray,
    image::{Id, Image, Rgb},
    look,
    scene::Scene,
};
use glam::DVec2;
use std::{num::NonZero, thread};

/// Ids and shaded colours of every pixel, by the ray through its centre, on all cores. For more than a few pixels
/// build the scene's trees first.
#[must_use]
pub fn raycast(scene: &Scene, view: &View) -> (Image<Id>, Image<Rgb>) {
    let pixels = each_pixel(view, |px| cast(scene, view, px));
    let (ids, colours) = pixels.into_iter().unzip();
    (
        Image::new(view.viewport, ids),
        Image::new(view.viewport, colours),
    )
}

/// The object and triangle that every pixel's ray hits, on all cores; see [`raycast`].
#[must_use]
pub fn ids(scene: &Scene, view: &View) -> Image<Id> {
    ids_by(scene, view, |px| closest(scene, view.ray(px), view.sides))
}

/// [`ids`] by another way to pick at a pixel position.
#[must_use]
pub fn ids_by(
    scene: &Scene,
    view: &View,
    pick: impl Fn(DVec2) -> Option<SceneHit> + Sync,
) -> Image<Id> {
    let id_at = |px| pick(px).map_or(Id::default(), |hit| id(scene, &hit));
    Image::new(view.viewport, each_pixel(view, id_at))
}

/// What `cast` says about the centre of each pixel, row by row from the top, on all cores.
#[must_use]
pub fn each_pixel<T: Clone + Default + Send>(
    view: &View,
    cast: impl Fn(DVec2) -> T + Sync,
) -> Vec<T> {
    let (width, height) = (view.viewport.width(), view.viewport.height());
    let mut pixels = vec![T::default(); width as usize * height as usize];
    let threads = thread::available_parallelism().map_or(1, NonZero::get);
    // Every thread takes each n-th row: neighbouring rows cost alike.
    let mut shares: Vec<Vec<_>> = (0..threads).map(|_| Vec::new()).collect();
    for (y, row) in (0..height).zip(pixels.chunks_mut(width as usize)) {
        shares[y as usize % threads].push((y, row));
    }
    thread::scope(|scope| {
        for share in shares {
            scope.spawn(|| {
                for (y, row) in share {
                    for (x, pixel) in (0..width).zip(row) {
                        *pixel = cast(DVec2::new(f64::from(x), f64::from(y)) + 0.5);
                    }
                }
            });
        }
    });
    pixels
}

fn cast(scene: &Scene, view: &View, px: DVec2) -> (Id, Rgb) {
    let ray = view.ray(px);
    if let Some(hit) = closest(scene, ray, view.sides) {
        return (id(scene, &hit), colour(scene, view, &ray, &hit).0);
    }
    #[expect(clippy::cast_possible_truncation, reason = "colours need no more")]
    let down = (px.y / f64::from(view.viewport.height())) as f32;
    (Id::default(), Srgb::from_linear(look::background(down)).0)
}

/// The id that a picture holds for a hit.
fn id(scene: &Scene, hit: &SceneHit) -> Id {
    Id {
        object: u32::try_from(hit.object + 1).unwrap_or(u32::MAX),
        triangle: (hit.triangle_of_object(scene)).map_or(0, |triangle| triangle + 1),
    }
}

fn colour(scene: &Scene, view: &View, ray: &Ray, hit: &SceneHit) -> Srgb {
    let object = &scene.objects()[hit.object];
    let rotation = view.camera.rotation();
    let to_view = |normal| (rotation * object.placement.normal_to_world(normal)).as_vec3();
    let normal = to_view(object.shading_normal(&hit.hit));
    // Which side is seen is for the surface to say, not for its interpolated normal.
    let front = ray
        .direction
        .dot(object.placement.normal_to_world(hit.hit.normal))
        < 0.0;
    let light = look::shade(
        object.albedo(&hit.hit),
        if front { normal } else { -normal },
    );
    Srgb::from_linear(light)
}
