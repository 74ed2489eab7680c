//! Snapping: the vertex nearest to a position, else the nearest point of an edge, else the pick.
//!
//! Within a radius in pixels, the nearest *visible* vertex wins ([`sight`] decides, exactly). Failing that, the nearest
//! visible point of an edge: the foot of the perpendicular in the picture, or an end of what near, far and section
//! leave of the edge. The foot's fraction along the edge is rounded to `f64`. That point lies exactly on the stored
//! edge, and [`sight`] decides whether it is seen. A surface may hide the point. It is then replaced by the nearest
//! points along the edge, to either side, that this surface does not hide. Where no edge shows, the position snaps to
//! the pick.
//!
//! Corners and edges are those of the file's polygons. Edges added by triangulation do not count; if the file can no
//! longer be read to tell, none of its edges counts. Cubes and squares have corners and edges; spheres have none. Of
//! two points that are exactly as near, the one of lesser depth wins, then the one on the first object, then on the
//! first triangle.

mod along;
mod area;
mod facets;
mod record;

pub use area::object_area;
pub use record::Snap;
pub(crate) use record::SnapLine;

use super::{
    SceneHit,
    edge::{PictureSpace, Shown},
    sight::{Sight, sight},
};
use crate::{
    camera::View,
    geometry::{PlacedPoint, dyadic},
    scene::{FaceInFile, Scene},
};
use facets::{Facet, facets};
use glam::DVec2;
use num_bigint::BigInt;
use serde::Serialize;
use std::{cmp::Ordering, collections::HashMap, error::Error};

/// What a position snaps to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
pub enum SnapTo {
    /// A corner of a polygon.
    Vertex,
    /// A point of a polygon's side.
    Edge,
    /// A point of a surface.
    Face,
}

/// Where a position snaps to.
enum Snapped {
    Vertex(Candidate),
    Edge(Candidate),
    /// The pick, if any.
    Face,
}

/// Looks up a mesh's triangle in its file, by index of the object and triangle of the mesh; `None` where there is no
/// file. The error says why the file cannot tell.
///
/// Unlike all else here it need be neither `Send` nor `Sync`: it is called on the thread that snaps.
pub type Faces<'a> = dyn FnMut(usize, u32) -> Result<Option<FaceInFile>, FaceError> + 'a;

/// Why a file cannot tell about a face.
pub type FaceError = Box<dyn Error + Send + Sync>;

/// A point of a facet's side, at `share` of its length.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    facet: Facet,
    corner: usize,
    share: f64,
    away_px: f64,
}

impl Candidate {
    fn point(&self, scene: &Scene) -> PlacedPoint {
        self.facet.point(scene, self.corner, self.share)
    }

    /// As the picture shows it.
    fn shown(&self, scene: &Scene, space: &PictureSpace<BigInt>) -> Shown<BigInt> {
        space.point(&dyadic::placed(&self.point(scene)))
    }
}

/// Relative difference above which rounded distances have the order of the exact ones: each has a few roundings.
const ALIKE: f64 = 1e-12;

/// The search about one position.
struct Search<'a> {
    scene: &'a Scene,
    view: &'a View,
    space: PictureSpace<BigInt>,
    px: DVec2,
    radius_px: f64,
}

/// Finds where a position snaps to.
fn snapped(
    scene: &Scene,
    view: &View,
    (px, radius_px): (DVec2, f64),
    faces: &mut Faces,
) -> Snapped {
    if let Ok(space) = PictureSpace::new(view, px) {
        let search = Search {
            scene,
            view,
            space,
            px,
            radius_px,
        };
        let facets = facets(scene, view, px, radius_px);
        if let Some(vertex) = search.vertex(&facets) {
            return Snapped::Vertex(vertex);
        }
        if let Some(edge) = search.edge(&facets, faces) {
            return Snapped::Edge(edge);
        }
    }
    Snapped::Face
}

impl Search<'_> {
    fn vertex(&self, facets: &[Facet]) -> Option<Candidate> {
        let candidates = sides(facets).filter_map(|(facet, corner)| {
            let [a, _] = self.roughly(facet, corner);
            let is_far = a.is_some_and(|a| !(a.distance(self.px) <= self.radius_px + 1.0));
            if is_far {
                None
            } else {
                self.candidate(facet, corner, 0.0)
            }
        });
        self.first(candidates.collect(), |_, _| Vec::new(), |_| true)
    }

    fn edge(&self, facets: &[Facet], faces: &mut Faces) -> Option<Candidate> {
        let candidates = sides(facets).filter_map(|(facet, corner)| {
            let is_near = match self.roughly(facet, corner) {
                [Some(a), Some(b)] => {
                    let along = b - a;
                    let share = ((self.px - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                    // True, too, where both ends are one point and the share is NaN.
                    !(self.px.distance(a + share * along) > self.radius_px + 1.0)
                }
                _ => true,
            };
            let nearest = is_near.then(|| self.nearest_and_ends(facet, corner));
            let [share, ..] = nearest.flatten()?;
            self.candidate(facet, corner, share)
        });
        let beside = |hidden: &Candidate, by: &SceneHit| self.beside(hidden, by);
        self.first(candidates.collect(), beside, |candidate| {
            let Some(triangle) = candidate.facet.triangle else {
                return true;
            };
            match faces(candidate.facet.object, triangle) {
                Ok(None) => true,
                Ok(Some(face)) => side_of(&face, triangle, candidate.corner).is_some(),
                // Triangulation may have added this edge.
                Err(_) => false,
            }
        })
    }

    /// Both ends in the picture, by `f64`; `None` for an end behind the eye or without a finite position.
    fn roughly(&self, facet: &Facet, corner: usize) -> [Option<DVec2>; 2] {
        let placement = &self.scene.objects()[facet.object].placement;
        facet.side(corner).map(|end| {
            let world = placement.point_to_world(facet.origin + end);
            let px = self.view.project(world)?.px;
            px.is_finite().then_some(px)
        })
    }

    /// A point of a side, if it is within the radius.
    fn candidate(&self, facet: &Facet, corner: usize, share: f64) -> Option<Candidate> {
        let mut candidate = Candidate {
            facet: *facet,
            corner,
            share,
            away_px: 0.0,
        };
        let shown = candidate.shown(self.scene, &self.space);
        if !shown.w.sign().is_gt() {
            return None;
        }
        candidate.away_px = shown.distance_px().ok()?;
        (candidate.away_px <= self.radius_px).then_some(candidate)
    }

    /// The nearest candidate that is seen and counts. `beside` replaces a hidden one by others farther away.
    fn first(
        &self,
        mut candidates: Vec<Candidate>,
        beside: impl Fn(&Candidate, &SceneHit) -> Vec<Candidate>,
        mut counts: impl FnMut(&Candidate) -> bool,
    ) -> Option<Candidate> {
        // Nearest last.
        candidates.sort_by(|a, b| self.order(b, a));
        // Several triangles share a vertex: each point is looked up once.
        let mut known = HashMap::new();
        while let Some(candidate) = candidates.pop() {
            let point = candidate.point(self.scene);
            // Different points may round to one; their shares then differ.
            let at = point.object().to_array().map(f64::to_bits);
            let sight = *known
                .entry((candidate.facet.object, at, candidate.share.to_bits()))
                .or_insert_with(|| sight(self.scene, self.view, &point));
            match sight {
                Sight::Seen(_) if counts(&candidate) => return Some(candidate),
                Sight::Hidden(by) => {
                    for other in beside(&candidate, &by) {
                        let place = candidates.partition_point(|c| self.order(c, &other).is_gt());
                        candidates.insert(place, other);
                    }
                }
                _ => {}
            }
        }
        None
    }

    fn order(&self, a: &Candidate, b: &Candidate) -> Ordering {
        let name = |c: &Candidate| (c.facet.object, c.facet.triangle, c.corner);
        if (a.away_px - b.away_px).abs() > ALIKE * (a.away_px + b.away_px) {
            return a.away_px.total_cmp(&b.away_px);
        }
        let [(a_shown, a_weight), (b_shown, b_weight)] = [a, b].map(|which| self.shown(which));
        let squared = |shown: &Shown<BigInt>| shown.u.squared().plus(&shown.v.squared());
        let [a_away, b_away] = [
            squared(&a_shown).times(&b_shown.w.squared()),
            squared(&b_shown).times(&a_shown.w.squared()),
        ];
        let by_depth = || {
            let [a, b] = [(&a_shown, &b_weight), (&b_shown, &a_weight)];
            let [a, b] = [a, b].map(|(of, weight)| of.depth.times(weight));
            a.minus(&b).sign()
        };
        let by_place = a_away.minus(&b_away).sign().then_with(by_depth);
        by_place.then_with(|| name(a).cmp(&name(b)))
    }
}

/// Each side of facets, with the index of its first corner.
fn sides(facets: &[Facet]) -> impl Iterator<Item = (&Facet, usize)> {
    let corners = |facet: &Facet| 0..facet.corners().len();
    (facets.iter()).flat_map(move |facet| corners(facet).map(move |corner| (facet, corner)))
}

/// The indices in a polygon of the ends of a triangle's side; `None` for a side that triangulation added. Corners are
/// compared by position, not by index: a polygon may name a vertex twice, and a triangle may use either. A polygon with
/// a hole does so at both ends of the bridge to the hole.
fn side_of(face: &FaceInFile, triangle: u32, corner: usize) -> Option<[usize; 2]> {
    let number = triangle.checked_sub(face.triangles.start)?;
    let corners = face.corners.get(number as usize)?;
    let at = |place: usize| face.vertices[place].position;
    let ends = [corner, corner + 1].map(|corner| at(corners[corner % 3] as usize));
    let count = face.vertices.len();
    let mut sides = (0..count).map(|place| [place, (place + 1) % count]);
    sides.find_map(|[a, b]| match [at(a), at(b)] {
        side if side == ends => Some([a, b]),
        [to, from] if [from, to] == ends => Some([b, a]),
        _ => None,
    })
}
