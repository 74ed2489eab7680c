//! Finds surfaces in one place: surfaces that drawing cannot tell from the picked one by depth at a position.
//!
//! A pick's order is exact, a depth buffer's is not. Two surfaces that a position's ray hits are *in one place* there
//! if the depth buffer may order them either way. This is decided by the bounds by which [`compare`](super::compare)
//! explains the class *depth*; a bound above a ceiling counts as the ceiling. So a pixel of the class *depth* that
//! shows one surface and picks another has both in one place at its centre. There is one exception, on a grid coarser
//! than the common one: two triangles of one mesh that touch nearby.
//!
//! Which surfaces count as two:
//!
//! * Surfaces of two objects, or two triangles of one mesh: identical ones, both sides of a thin sheet, or any others
//!   within the bounds.
//! * Not two triangles of one mesh that touch there and do not overlap: they are one surface that continues or turns.
//!   They touch in an edge or a corner that they share, and also where a corner of one lies exactly on an edge of the
//!   other (a T-junction), along all that the two edges have in common. They touch *there* if drawing may move that
//!   point or segment onto the position. Where several meet, a triangle joins the first surface that has a triangle
//!   which it touches there, and none which it overlaps. Two triangles with a common corner also count once if only
//!   rounding sideways makes them equally deep: it moves both alike.
//! * Not the near and the far side of one cube or sphere, which share a name.
//! * Not the near plane or the empty buffer, which the class *depth* includes: they have no name.

use super::{
    OUTLINE_CEILING_PX,
    face::{Face, Surfaces},
    surface::{Depths, Surface},
    view_ray::ViewRay,
};
use crate::{
    camera::View,
    geometry::{Sphere, WorldRay},
    image::Image,
    pick::{self, Beam, InOnePlace, SceneHit},
    render::Rasteriser,
    scene::{Scene, Shape},
};
use glam::{DVec2, DVec3};
use std::collections::HashSet;

/// If the cosine between a ray and a face's normal is at least this, the slope in `f64` is at least half the true one:
/// under a matrix of condition 1e14 a normal is off by some hundredths.
const LEAST_COSINE: f64 = 1.0 / 16.0;

/// A patch is compared with so many patches of a sheet, the latest ones. At the tip of a fan, more may meet.
const MOST_COMPARED: usize = 64;

/// Finds where surfaces of a scene lie in one place, in a view.
pub struct Places<'a> {
    surfaces: Surfaces<'a>,
}

/// What was hit: a face of a batch, or its sphere (without a face).
#[derive(Clone, PartialEq)]
struct Patch {
    batch: usize,
    face: Option<Face>,
}

/// What a patch counts as.
#[derive(Clone, Copy)]
enum Counted {
    /// Not in one place with the picked surface.
    Not,
    /// A surface by itself, whose outline is elsewhere.
    Apart,
    /// The first patch of a sheet.
    NewSheet(usize),
    /// One more patch of a sheet that counts already.
    OfSheet(usize),
}

/// The surfaces whose outlines pass a position. Each is a sheet of patches that touch there, none of which overlaps
/// another.
struct Sheets<'a> {
    surfaces: &'a Surfaces<'a>,
    px: DVec2,
    all: Vec<Vec<Patch>>,
}

impl Sheets<'_> {
    /// Adds a patch to the first sheet from this index on that it goes on, or else as a new one.
    fn join(&mut self, from: usize, patch: &Patch) -> Counted {
        let goes_on = |sheet: &Vec<Patch>| {
            let mut latest = sheet.iter().rev().take(MOST_COMPARED);
            let mut others = latest.clone();
            others.any(|other| patch.touches(other, self.surfaces, self.px))
                && !latest.any(|other| patch.overlaps(other))
        };
        let found = (self.all.iter().skip(from)).position(goes_on);
        if let Some(sheet) = found.map(|at| from + at) {
            self.all[sheet].push(patch.clone());
            return Counted::OfSheet(sheet);
        }
        self.all.push(vec![patch.clone()]);
        Counted::NewSheet(self.all.len() - 1)
    }

    /// What a patch with this surface counts as.
    fn count(&mut self, surface: &Surface, patch: &Patch) -> Counted {
        if surface.outline.reason().is_some() {
            self.join(0, patch)
        } else {
            Counted::Apart
        }
    }
}

/// The surfaces that drawing cannot tell from the picked one at a pixel position; `None` where there are none, or no
/// pick. It assumes the common rasteriser's grid, so that the answer is the same on every device.
pub fn in_one_place(scene: &Scene, view: &View, px: DVec2) -> Option<InOnePlace> {
    let places = Places::new(scene, view, Rasteriser::COMMON);
    InOnePlace::of(scene, &places.at(px))
}

impl<'a> Places<'a> {
    /// For a scene in a view, as this rasteriser draws it.
    pub fn new(scene: &'a Scene, view: &View, rasteriser: Rasteriser) -> Self {
        Self {
            surfaces: Surfaces::new(scene, view, rasteriser),
        }
    }

    /// The nearest hit at a pixel position and the hits in one place with it, from front to back. Empty where nothing
    /// else is in one place with it, or nothing is hit.
    pub fn at(&self, px: DVec2) -> Vec<SceneHit> {
        let (scene, view) = (self.surfaces.scene, self.surfaces.space.view());
        self.on_ray(&Beam::whole(scene), &view.ray(px), px, usize::MAX)
    }

    /// [`Places::at`] by the ray through the position, which belongs to a beam; ends when `most` hits are found.
    fn on_ray(&self, beam: &Beam, ray: &WorldRay, px: DVec2, most: usize) -> Vec<SceneHit> {
        let (scene, view) = (self.surfaces.scene, self.surfaces.space.view());
        let reach = Reach::new(&self.surfaces, ray, px);
        // Filter: most hits lie too far behind.
        let hits = pick::all_near(beam, ray, view.sides, |first| {
            let (reach, least) = (&reach, reach.nearness(first)[1]);
            move |hit: &SceneHit| reach.nearness(hit)[0] >= least
        });
        let Some((first, near)) = hits.split_first() else {
            return Vec::new();
        };
        if near.is_empty() {
            return Vec::new();
        }
        let nearest = Patch::of(scene, first);
        let Some(picked) = self.surfaces.of_hit(px, first, nearest.face.as_ref()) else {
            return Vec::new();
        };
        let mut sheets = Sheets {
            surfaces: &self.surfaces,
            px,
            all: Vec::new(),
        };
        let first_is = sheets.count(&picked, &nearest);
        let (mut found, mut last, mut last_is) = (vec![*first], nearest.clone(), first_is);
        let mut solids = HashSet::from([first.object]);
        for hit in near {
            if hit.hit.on_triangle.is_none() && !solids.insert(hit.object) {
                continue;
            }
            let patch = Patch::of(scene, hit);
            // Identical triangles follow each other and have the same surface.
            let is_same = patch.face.is_some() && patch == last;
            last_is = match last_is {
                Counted::OfSheet(sheet) | Counted::NewSheet(sheet) if is_same => {
                    sheets.join(sheet + 1, &patch)
                }
                known if is_same => known,
                _ => {
                    let surface = self.surfaces.of_hit(px, hit, patch.face.as_ref());
                    let surface = surface.filter(|other| {
                        picked.stored.is_in_one_place(&other.stored)
                            && (picked.stored.is_in_one_place_unmoved(&other.stored)
                                || !nearest.shares_a_corner(&patch))
                    });
                    surface.map_or(Counted::Not, |surface| sheets.count(&surface, &patch))
                }
            };
            last = patch;
            let counts = matches!(last_is, Counted::Apart | Counted::NewSheet(_));
            found.extend(counts.then_some(*hit));
            if found.len() >= most {
                break;
            }
        }
        if found.len() > 1 { found } else { Vec::new() }
    }

    /// The pixels at whose centres surfaces lie in one place, row by row from the top; on all cores. Pixels after
    /// `stop` returns true are left out.
    pub fn pixels(&self, stop: impl Fn() -> bool + Sync) -> Vec<[u32; 2]> {
        let view = self.surfaces.space.view();
        let marked = pick::each_ray(self.surfaces.scene, view, |beam, ray, px| {
            !stop() && !self.on_ray(beam, ray, px, 2).is_empty()
        });
        let marked = Image::new(view.viewport, marked);
        let marked = marked.positions().filter(|&(x, y)| marked.at(x, y));
        marked.map(|(x, y)| [x, y]).collect()
    }
}

impl Patch {
    fn of(scene: &Scene, hit: &SceneHit) -> Self {
        Self {
            batch: scene.batch_of(hit.object).start,
            face: Face::of_hit(&scene.objects()[hit.object], &hit.hit),
        }
    }

    /// Both faces, if they belong to one batch.
    fn faces_of_batch<'a>(&'a self, other: &'a Self) -> Option<[&'a Face; 2]> {
        let faces = [self.face.as_ref()?, other.face.as_ref()?];
        (self.batch == other.batch).then_some(faces)
    }

    fn shares_a_corner(&self, other: &Self) -> bool {
        (self.faces_of_batch(other)).is_some_and(|[a, b]| a.shares_a_corner(b))
    }

    fn overlaps(&self, other: &Self) -> bool {
        (self.faces_of_batch(other)).is_some_and(|[a, b]| a.overlaps(b))
    }

    /// Whether both touch at a position on the outlines of both.
    fn touches(&self, other: &Self, surfaces: &Surfaces, px: DVec2) -> bool {
        let faces = self.faces_of_batch(other);
        faces.is_some_and(|faces| surfaces.touch(px, self.batch, faces))
    }
}

/// Estimates how near and how far a hit's surface may be drawn with bounds capped at their ceilings. The estimate is
/// generous and needs only the hit.
struct Reach<'a> {
    scene: &'a Scene,
    view: &'a View,
    depths: Depths,
    ray: ViewRay,
    ray_world: &'a WorldRay<'a>,
}

impl<'a> Reach<'a> {
    fn new(surfaces: &'a Surfaces, ray_world: &'a WorldRay<'a>, px: DVec2) -> Self {
        let view = surfaces.space.view();
        Self {
            scene: surfaces.scene,
            view,
            depths: Depths::new(&surfaces.space),
            ray: ViewRay::new(view, px),
            ray_world,
        }
    }

    /// The nearest and the farthest, as nearness: more is nearer.
    fn nearness(&self, SceneHit { object, hit }: &SceneHit) -> [f64; 2] {
        let object = &self.scene.objects()[*object];
        let aside = if matches!(object.shape, Shape::Sphere) {
            // A sphere's depth changes by no more than its radius.
            let ray = object.placement.ray_to_object(self.ray_world);
            Sphere::RADIUS / ray.direction.abs().max_element()
        } else {
            self.aside(hit.t, object.placement.normal_to_world(hit.normal))
        };
        let off = aside + hit.t_error + f64::EPSILON * hit.t.abs();
        let past_near = hit.t - self.view.camera.lens().near;
        let [near, far] = [past_near - off, past_near + off];
        let most = |end: f64| {
            // The ceiling grows towards one end, or towards both.
            let ceiling = self.depths.ceiling(past_near).max(self.depths.ceiling(end));
            // Stored values change less with depth behind the surface than at it.
            ceiling + aside * self.depths.stored_per_depth(past_near)
        };
        let nearest = self.depths.nearness(near) + most(near);
        let farthest = self.depths.nearness(far) - most(far);
        [
            // At and behind the eye the depth is undefined.
            if self.depths.w(near) > 0.0 && nearest.is_finite() {
                nearest
            } else {
                f64::INFINITY
            },
            if farthest.is_finite() {
                farthest
            } else {
                f64::NEG_INFINITY
            },
        ]
    }

    /// The most by which moving a flat surface aside may change its view depth, given depth and normal.
    fn aside(&self, depth: f64, normal_world: DVec3) -> f64 {
        let normal = self.view.camera.rotation() * normal_world;
        let cosine = self.ray.direction.normalize().dot(normal).abs();
        if cosine > LEAST_COSINE {
            4.0 * OUTLINE_CEILING_PX * self.ray.slope(depth, normal).length()
        } else {
            f64::INFINITY
        }
    }
}
