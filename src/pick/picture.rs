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
use std::thread;

/// Ids and shaded colours of every pixel, by the ray through its centre, on all cores. For more than a few pixels
/// build the scene's trees first.
#[must_use]
pub fn raycast(scene: &Scene, view: &View) -> (Image<Id>, Image<Rgb>) {
    let (width, height) = (view.viewport.width(), view.viewport.height());
    let mut pixels = vec![(Id::default(), [0; 3]); width as usize * height as usize];
    let threads = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let mut rows: Vec<_> = (0..height).zip(pixels.chunks_mut(width as usize)).collect();
    // Every thread takes each n-th row: neighbouring rows cost alike.
    let mut shares: Vec<Vec<_>> = (0..threads).map(|_| Vec::new()).collect();
    for (i, row) in rows.drain(..).enumerate() {
        shares[i % threads].push(row);
    }
    thread::scope(|scope| {
        for share in shares {
            scope.spawn(move || {
                for (y, row) in share {
                    for (x, pixel) in (0..width).zip(row) {
                        *pixel = cast(scene, view, x, y);
                    }
                }
            });
        }
    });
    let (ids, colours) = pixels.into_iter().unzip();
    (
        Image::new(view.viewport, ids),
        Image::new(view.viewport, colours),
    )
}

fn cast(scene: &Scene, view: &View, x: u32, y: u32) -> (Id, Rgb) {
    let ray = view.ray(DVec2::new(f64::from(x), f64::from(y)) + 0.5);
    if let Some(hit) = closest(scene, &ray, view.sides) {
        return (id(scene, &hit), colour(scene, view, &ray, &hit).0);
    }
    #[expect(clippy::cast_precision_loss, reason = "colours need no more")]
    let down = (y as f32 + 0.5) / view.viewport.height() as f32;
    (Id::default(), Srgb::from_linear(look::background(down)).0)
}

/// The id that a picture holds for a hit.
fn id(scene: &Scene, hit: &SceneHit) -> Id {
    let triangles = scene.objects()[hit.object].shape.triangles();
    let first = triangles.map_or(0, |triangles| triangles.start);
    Id {
        object: u32::try_from(hit.object + 1).unwrap_or(u32::MAX),
        triangle: hit.hit.on_triangle.map_or(0, |at| at.triangle - first + 1),
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
