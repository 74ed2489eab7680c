//! Computes a whole picture with one ray per pixel, without a graphics driver.

use super::{Beam, SceneHit, nearest::nearest};
use crate::{
    camera::{NdcSpace, View},
    colour::Srgb,
    geometry::{Ray, WorldRay, shares::on_all_cores},
    image::{Id, Image, Pixel, Rgb},
    look::{self, Background},
    scene::Scene,
};
use glam::{DVec2, DVec3};
use std::{
    sync::atomic::{AtomicBool, Ordering::Relaxed},
    time::Instant,
};

/// Side in pixels of a tile, whose rays go through the scene together.
const TILE: u32 = 16;

/// Bytes per pixel that [`raycast`] takes: while ids and colours are separated, both forms exist.
pub(crate) const RAYCAST_BYTES: usize = size_of::<(Id, Rgb)>() + size_of::<Id>() + size_of::<Rgb>();

/// Ids and shaded colours of every pixel, by the ray through its centre, on all cores. For more than a few pixels
/// build the scene's trees first.
pub fn raycast(scene: &Scene, view: &View, background: Background) -> (Image<Id>, Image<Rgb>) {
    let pixels = each_ray(scene, view, |beam, ray, px| {
        let hit = nearest(beam, ray, view.sides, None);
        id_and_colour(scene, view, background, ray, px, hit.as_ref())
    });
    let (ids, colours) = pixels.into_iter().unzip();
    let size = view.viewport;
    (Image::new(size, ids), Image::new(size, colours))
}

/// All that drawing would write for every pixel, by the ray through its centre, on all cores. `None` if that is not
/// done by `deadline`. Build the scene's trees first.
pub fn raycast_until(
    scene: &Scene,
    view: &View,
    background: Background,
    deadline: Instant,
) -> Option<Image<Pixel>> {
    let (rays, lens) = (&view.rays(), view.camera.lens());
    in_time(view, deadline, |tile| {
        let beam = Beam::of_tile(scene, rays, tile);
        move |px| {
            let ray = &rays.ray(px);
            let hit = nearest(&beam, ray, view.sides, None);
            let (id, colour) = id_and_colour(scene, view, background, ray, px, hit.as_ref());
            let t = hit.map_or(lens.far, |hit| hit.hit.t);
            #[expect(clippy::cast_possible_truncation, reason = "as depth is stored")]
            let depth = lens.ndc_depth(t) as f32;
            Pixel { id, colour, depth }
        }
    })
}

/// [`raycast_until`] of a camera's NDC, as an observer there sees it.
pub fn raycast_ndc_until(
    scene: &Scene,
    ndc: &NdcSpace,
    observer: &View,
    background: Background,
    deadline: Instant,
) -> Option<Image<Pixel>> {
    let (rays, lens) = (&observer.rays(), observer.camera.lens());
    let camera = &ndc.of.camera;
    let (back, normals) = (ndc.back(&scene.visible_bounds()), ndc.normals());
    let seen = |beam: &Beam, ray: &WorldRay| {
        let hit = nearest(beam, ray, observer.sides, None)?;
        let p_view = camera.to_view(ray.at(hit.hit.t));
        let depth = observer.camera.to_view(ndc.of_view(p_view)).z;
        let colour = colour(scene, &ndc.of, ray, &hit, |normal_world| {
            let normal = normals(p_view, camera.rotation() * normal_world);
            observer.camera.rotation() * normal
        });
        Some((id(scene, &hit), colour.0, depth))
    };
    let seen = &seen;
    in_time(observer, deadline, |_| {
        let beam = Beam::whole(scene);
        move |px| {
            let ray = ndc.ray(&rays.ray(px), back);
            let (id, colour, depth) = (ray.and_then(|ray| seen(&beam, &ray)))
                .unwrap_or_else(|| (Id::default(), behind(observer, background, px), lens.far));
            #[expect(clippy::cast_possible_truncation, reason = "as depth is stored")]
            let depth = lens.ndc_depth(depth) as f32;
            Pixel { id, colour, depth }
        }
    })
}

/// What `of_tile` makes for each tile makes each of its pixels, if all is done by `deadline`.
fn in_time<C: Fn(DVec2) -> Pixel>(
    view: &View,
    deadline: Instant,
    of_tile: impl Fn([DVec2; 2]) -> C + Sync,
) -> Option<Image<Pixel>> {
    let late = AtomicBool::new(false);
    // Asked for each ray: one may take a millisecond, where thousands of objects lie in one place.
    let is_late = &|| {
        let is_late = late.load(Relaxed) || Instant::now() >= deadline;
        if is_late {
            late.store(true, Relaxed);
        }
        is_late
    };
    let pixels = each_in_tiles(view, |tile| {
        if is_late() {
            return None;
        }
        let pixel = of_tile(tile);
        Some(move |px| {
            if is_late() {
                return Pixel::default();
            }
            pixel(px)
        })
    });
    (!late.into_inner()).then(|| Image::new(view.viewport, pixels))
}

/// The object and triangle that every pixel's ray hits, on all cores; see [`raycast`].
pub fn ids(scene: &Scene, view: &View) -> Image<Id> {
    let ids = each_ray(scene, view, |beam, ray, _| {
        id_or_none(scene, nearest(beam, ray, view.sides, None))
    });
    Image::new(view.viewport, ids)
}

/// [`ids`] by another picker, which is given pixel positions.
pub fn ids_by(
    scene: &Scene,
    view: &View,
    pick: impl Fn(DVec2) -> Option<SceneHit> + Sync,
) -> Image<Id> {
    let ids = each_in_tiles(view, |_| Some(|px| id_or_none(scene, pick(px))));
    Image::new(view.viewport, ids)
}

/// `cast` for the ray through the centre of each pixel, row by row from the top, on all cores.
pub(crate) fn each_ray<T: Clone + Default + Send>(
    scene: &Scene,
    view: &View,
    cast: impl Fn(&Beam, &WorldRay, DVec2) -> T + Sync,
) -> Vec<T> {
    let (rays, cast) = (&view.rays(), &cast);
    each_in_tiles(view, |tile| {
        let beam = Beam::of_tile(scene, rays, tile);
        Some(move |px| cast(&beam, &rays.ray(px), px))
    })
}

/// Calls `of_tile` with the corners of each tile, and the closure that it returns for each pixel centre of the tile.
/// Where `of_tile` returns `None`, the tile's pixels keep their default.
fn each_in_tiles<T: Clone + Default + Send, C: Fn(DVec2) -> T>(
    view: &View,
    of_tile: impl Fn([DVec2; 2]) -> Option<C> + Sync,
) -> Vec<T> {
    let (width, height) = (view.viewport.width(), view.viewport.height());
    let mut pixels = vec![T::default(); width as usize * height as usize];
    let corner = |x: u32, y: u32| DVec2::new(x.into(), y.into());
    let in_rows = |(top, rows): (u32, &mut [T])| {
        let bottom = (top + TILE).min(height);
        for left in (0..width).step_by(TILE as usize) {
            let right = (left + TILE).min(width);
            let Some(cast) = of_tile([corner(left, top), corner(right, bottom)]) else {
                continue;
            };
            for (y, row) in (top..bottom).zip(rows.chunks_mut(width as usize)) {
                for (x, pixel) in (left..right).zip(&mut row[left as usize..]) {
                    *pixel = cast(corner(x, y) + 0.5);
                }
            }
        }
    };
    let tops = (0..height).step_by(TILE as usize);
    let rows = pixels.chunks_mut(width as usize * TILE as usize);
    on_all_cores(tops.zip(rows), in_rows);
    pixels
}

/// The object and triangle, and the colour, of what a ray hits, or of the background.
fn id_and_colour(
    scene: &Scene,
    view: &View,
    background: Background,
    ray: &WorldRay,
    px: DVec2,
    hit: Option<&SceneHit>,
) -> (Id, Rgb) {
    let Some(hit) = hit else {
        return (Id::default(), behind(view, background, px));
    };
    let rotation = view.camera.rotation();
    let colour = colour(scene, view, ray, hit, |normal| rotation * normal);
    (id(scene, hit), colour.0)
}

/// The background's colour at a point of the picture.
fn behind(view: &View, background: Background, px: DVec2) -> Rgb {
    #[expect(clippy::cast_possible_truncation, reason = "colours need no more")]
    let down = (px.y / f64::from(view.viewport.height())) as f32;
    Srgb::from_linear(background.at(down)).0
}

fn id_or_none(scene: &Scene, hit: Option<SceneHit>) -> Id {
    hit.map_or(Id::default(), |hit| id(scene, &hit))
}

/// A hit as a picture's id.
pub(crate) fn id(scene: &Scene, hit: &SceneHit) -> Id {
    Id {
        object: u32::try_from(hit.object + 1).unwrap_or(u32::MAX),
        triangle: (hit.triangle_of_object(scene)).map_or(0, |triangle| triangle + 1),
    }
}

/// The shaded colour of a hit. `to_view` leads normals from the world to the view space of who looks at it.
fn colour(
    scene: &Scene,
    view: &View,
    ray: &Ray,
    hit: &SceneHit,
    to_view: impl Fn(DVec3) -> DVec3,
) -> Srgb {
    let object = &scene.objects()[hit.object];
    let normal = (object.placement).normal_to_world(object.shading_normal(&hit.hit));
    let normal = to_view(normal).as_vec3();
    // The geometric normal, not the interpolated one, decides which side is seen.
    let front = (ray.direction).dot(object.placement.normal_to_world(hit.hit.normal)) < 0.0;
    let albedo = match view.section {
        Some(_) if !front => look::INSIDE.to_linear(),
        _ => object.albedo(&hit.hit),
    };
    let light = look::shade(albedo, if front { normal } else { -normal });
    Srgb::from_linear(light)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::{CameraChoice, Viewport};

    /// A row so wide that sixteen such rows have more pixels than 32 bits can count.
    #[test]
    fn a_row_may_be_very_wide() {
        let size = Viewport::new(1 << 28, 1).expect("a viewport");
        let camera = CameraChoice::default().resolve(&Scene::default().bounds(), size);
        let view = View::new(camera.expect("a camera"), size);
        let pixels = each_in_tiles::<bool, fn(DVec2) -> bool>(&view, |_| None);
        assert_eq!(pixels.len(), 1 << 28);
    }
}
