//! The exact truth of what a position shows: every hit of its ray on every shape, by brute force. It starts from the
//! numbers that camera, placements and meshes hold. The program computes nothing here.

use super::{
    flat::{Flat, faces},
    line::Line,
    number::{Dyadic, Vector, cross, dot, minus, plus, times, vector},
    root::Parameter,
};
use sightline::{
    geometry::Sides,
    scene::{Object, Scene, Shape},
};
use std::cmp::Ordering;

/// One hit.
#[derive(Clone, Debug)]
pub struct Hit {
    /// Index of the object.
    pub object: usize,
    /// Index among the triangles of the mesh.
    pub triangle: Option<u32>,
    pub front: bool,
    pub t: Parameter,
    /// The outward normal of a cube's face, in its object space.
    pub face: Option<[i8; 3]>,
    /// Weights of a triangle's corners.
    pub barycentric: Option<[f64; 3]>,
    /// Whether it lies on an edge, a rim or a silhouette.
    pub on_border: bool,
}

/// A shape where it stands in the world.
enum Solid {
    /// The first triangle's index in its mesh, and all triangles.
    Triangles(u32, Vec<Flat>),
    Square(Flat),
    /// Faces with their axis and side, in the order of axes.
    Cube(Vec<(usize, i8, Flat)>),
    Sphere {
        centre: Vector,
        /// Rows of the inverse matrix times the determinant.
        adjugate: [Vector; 3],
        determinant: Dyadic,
    },
}

struct Placed {
    object: usize,
    mirrored: bool,
    solid: Solid,
}

/// All visible shapes of a scene.
pub struct World(Vec<Placed>);

impl World {
    pub fn of(scene: &Scene) -> Self {
        let visible = scene.objects().iter().enumerate();
        let visible = visible.filter(|(_, object)| object.visible);
        Self(visible.map(|(i, object)| Placed::of(i, object)).collect())
    }

    /// All hits of the whole line, from either side, in no order.
    pub fn line_hits(&self, line: &Line) -> Vec<Hit> {
        let mut hits = Vec::new();
        for placed in &self.0 {
            placed.collect(line, &mut hits);
        }
        hits
    }

    /// All hits that count, in order.
    pub fn hits(&self, line: &Line, sides: Sides) -> Vec<Hit> {
        let mut hits = self.line_hits(line);
        hits.retain(|hit| {
            hit.t.compare_to(&line.near).is_ge()
                && hit.t.compare_to(&line.far).is_lt()
                && line.side(&hit.t).is_ge()
                && (sides == Sides::Both || hit.front)
        });
        hits.sort_by(|a, b| {
            let order = a.t.compare(&b.t);
            order.then((a.object, a.triangle).cmp(&(b.object, b.triangle)))
        });
        hits
    }
}

impl Placed {
    fn of(index: usize, object: &Object) -> Self {
        let model = object.placement.model();
        let axes = [
            vector(model.matrix3.x_axis),
            vector(model.matrix3.y_axis),
            vector(model.matrix3.z_axis),
        ];
        let centre = vector(model.translation);
        let determinant = dot(&axes[0], &cross(&axes[1], &axes[2]));
        assert!(!determinant.is_zero(), "a singular placement");
        let mirrored = determinant.sign().is_lt();
        let solid = match &object.shape {
            Shape::Sphere => Solid::Sphere {
                centre,
                adjugate: std::array::from_fn(|i| cross(&axes[(i + 1) % 3], &axes[(i + 2) % 3])),
                determinant,
            },
            Shape::Square => {
                let [x, y, _] = axes;
                Solid::Square(Flat::new(centre, [x, y]))
            }
            Shape::Cube => Solid::Cube(faces(&axes, &centre)),
            Shape::Mesh { mesh, part } => {
                let data = mesh.data();
                let range = data.parts[*part].triangles.clone();
                let origin = vector(data.origin);
                let to_world = |vertex: u32| {
                    let stored = data.positions[vertex as usize].map(f64::from);
                    let local = plus(&origin, &vector(stored));
                    let [x, y, z]: [Vector; 3] =
                        std::array::from_fn(|i| times(&local[i], &axes[i]));
                    plus(&plus(&x, &y), &plus(&z, &centre))
                };
                let triangles = &data.triangles[range.start as usize..range.end as usize];
                let flats = triangles.iter().map(|corners| {
                    let [a, b, c] = corners.map(to_world);
                    let sides = [minus(&b, &a), minus(&c, &a)];
                    Flat::new(a, sides)
                });
                Solid::Triangles(range.start, flats.collect())
            }
        };
        Self {
            object: index,
            mirrored,
            solid,
        }
    }

    /// Adds all hits of the whole line.
    fn collect(&self, line: &Line, hits: &mut Vec<Hit>) {
        let hit = |front, t| Hit {
            object: self.object,
            triangle: None,
            front,
            t,
            face: None,
            barycentric: None,
            on_border: false,
        };
        match &self.solid {
            Solid::Triangles(first, flats) => {
                for (triangle, flat) in (*first..).zip(flats) {
                    if let Some(crossing) = flat.crossing(line)
                        && let Some((on_border, weights)) = crossing.in_triangle(line)
                    {
                        hits.push(Hit {
                            triangle: Some(triangle),
                            barycentric: Some(weights),
                            on_border,
                            ..hit(crossing.against != self.mirrored, crossing.parameter())
                        });
                    }
                }
            }
            Solid::Square(flat) => {
                if let Some(crossing) = flat.crossing(line)
                    && let Some(on_border) = crossing.in_parallelogram(line)
                {
                    hits.push(Hit {
                        on_border,
                        ..hit(crossing.against != self.mirrored, crossing.parameter())
                    });
                }
            }
            Solid::Cube(faces) => {
                let met = faces.iter().filter_map(|(axis, side, flat)| {
                    let crossing = flat.crossing(line)?;
                    let on_border = crossing.in_parallelogram(line)?;
                    let mut face = [0; 3];
                    face[*axis] = *side;
                    Some(Hit {
                        face: Some(face),
                        on_border,
                        ..hit(crossing.against != self.mirrored, crossing.parameter())
                    })
                });
                hits.extend(ends(&met.collect::<Vec<_>>()));
            }
            Solid::Sphere {
                centre,
                adjugate,
                determinant,
            } => {
                let from_centre = minus(&line.origin, &times(&line.scale, centre));
                let into_object =
                    |v: &Vector| -> Vector { std::array::from_fn(|i| dot(&adjugate[i], v)) };
                let (o, d) = (into_object(&from_centre), into_object(&line.direction));
                // Both are times `determinant * scale`, and so is the radius of 1/2.
                let radius = (determinant * &line.scale).shifted(-1);
                let a = dot(&d, &d);
                let b = dot(&o, &d);
                let c = &dot(&o, &o) - &radius.square();
                let discriminant = &b.square() - &(&a * &c);
                let p = -&b;
                match discriminant.sign() {
                    Ordering::Less => {}
                    Ordering::Equal => hits.push(Hit {
                        on_border: true,
                        ..hit(false, Parameter::fraction(&p, &a))
                    }),
                    Ordering::Greater => {
                        for (sign, front) in [(-1, true), (1, false)] {
                            let root =
                                Parameter::root(p.clone(), sign, discriminant.clone(), a.clone());
                            hits.push(hit(front, root));
                        }
                    }
                }
            }
        }
    }
}

/// Entry and exit of a convex solid, from the faces met in the order of axes. Of several faces met at one end, the
/// first that the line crosses in the right direction counts. If both ends coincide, only the entry is returned.
fn ends(met: &[Hit]) -> Vec<Hit> {
    let Some(first) = met.iter().min_by(|a, b| a.t.compare(&b.t)).cloned() else {
        return Vec::new();
    };
    let last = met.iter().max_by(|a, b| a.t.compare(&b.t)).cloned();
    let last = last.expect("there is a first");
    let touches = first.t.compare(&last.t).is_eq();
    let at = |end: &Hit, front: bool| {
        let there = met.iter().filter(|hit| hit.t.compare(&end.t).is_eq());
        let mut right = there.filter(|hit| hit.front == front);
        right
            .next()
            .cloned()
            .expect("a line enters and leaves by faces")
    };
    let mut hits = vec![at(&first, true)];
    if !touches {
        hits.push(at(&last, false));
    }
    hits
}
