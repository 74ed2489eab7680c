//! What exact arithmetic says that a position shows: every hit of its ray on every shape, by brute force, from the
//! numbers that camera, placements and meshes hold. Nothing here asks the program to compute.

use super::{
    number::{Dyadic, Vector, cross, dot, minus, plus, times, vector},
    root::Parameter,
};
use glam::{DVec2, DVec3};
use sightline::{
    camera::{Projection, View},
    geometry::{Ray, Sides},
    scene::{Object, Scene, Shape},
};
use std::cmp::Ordering;

/// The ray through a position. Its points are `(origin + t direction) / scale`.
#[derive(Clone, Debug)]
pub struct Line {
    pub origin: Vector,
    pub direction: Vector,
    /// The picture's height, by which everything is multiplied so that nothing is divided.
    pub scale: Dyadic,
    pub near: Dyadic,
    pub far: Dyadic,
}

impl Line {
    pub fn of(view: &View, px: DVec2) -> Self {
        let (camera, viewport) = (&view.camera, view.viewport);
        let scale = Dyadic::of(viewport.height().into());
        let twice = |at: f64, size: u32| &Dyadic::of(at).shifted(1) - &Dyadic::of(size.into());
        let half = Dyadic::of(camera.half_height());
        let right = &half * &twice(px.x, viewport.width());
        let up = &half * &-&twice(px.y, viewport.height());
        let aside = plus(
            &times(&right, &vector(camera.right())),
            &times(&up, &vector(camera.up())),
        );
        let eye = times(&scale, &vector(camera.eye()));
        let forward = times(&scale, &vector(camera.forward()));
        let lens = camera.lens();
        let (origin, direction) = match lens.projection {
            Projection::Perspective { .. } => (eye, plus(&forward, &aside)),
            Projection::Orthographic { .. } => (plus(&eye, &aside), forward),
        };
        Self {
            origin,
            direction,
            scale,
            near: Dyadic::of(lens.near),
            far: Dyadic::of(lens.far),
        }
    }

    /// A ray that is given by its numbers, all of them finite.
    pub fn given(ray: &Ray) -> Self {
        Self {
            origin: vector(ray.origin),
            direction: vector(ray.direction),
            scale: Dyadic::whole(1),
            near: Dyadic::of(ray.t_min),
            far: Dyadic::of(ray.t_max),
        }
    }

    /// The point at `t`.
    pub fn point(&self, t: &Parameter) -> DVec3 {
        t.rounded_point(&self.origin, &self.direction, &self.scale)
            .into()
    }

    /// The largest coordinate of where it starts and of the point at `t`, over the direction's: in units of `t`.
    pub fn reach(&self, t: &Parameter) -> f64 {
        let rounded = |v: &Vector| DVec3::from(v.each_ref().map(|c| c.over(&self.scale)));
        let start = rounded(&self.origin).abs().max_element();
        let size = start.max(self.point(t).abs().max_element());
        size / rounded(&self.direction).abs().max_element()
    }

    /// How far the point at `t` is from another, as nearly as `f64` has it.
    pub fn distance(&self, from: DVec3, t: &Parameter) -> f64 {
        let seen = minus(&self.origin, &times(&self.scale, &vector(from)));
        let [x, y, z] = t.rounded_point(&seen, &self.direction, &self.scale);
        x.hypot(y).hypot(z)
    }
}

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

/// A corner and two sides from it: a triangle, or a parallelogram about its middle.
struct Flat {
    corner: Vector,
    sides: [Vector; 2],
    normal: Vector,
}

/// Where a line crosses a flat: parameter and share of each side, all three over `determinant`.
struct Crossing {
    t: Dyadic,
    shares: [Dyadic; 2],
    determinant: Dyadic,
    /// Whether the line runs against the cross product of the sides.
    against: bool,
}

impl Flat {
    fn new(corner: Vector, sides: [Vector; 2]) -> Self {
        let normal = cross(&sides[0], &sides[1]);
        Self {
            corner,
            sides,
            normal,
        }
    }

    /// Cramer's rule for `origin + t direction = corner + u side + v side`; `None` within the plane or beside it.
    fn crossing(&self, line: &Line) -> Option<Crossing> {
        let along = dot(&self.normal, &line.direction);
        if along.is_zero() {
            return None;
        }
        // Seen from the corner; times `scale`, which the shares have to be divided by and t has not.
        let from_corner = minus(&line.origin, &times(&line.scale, &self.corner));
        let moment = cross(&line.direction, &from_corner);
        let [a, b] = &self.sides;
        let mut t = -&dot(&self.normal, &from_corner);
        let mut shares = [dot(b, &moment), -&dot(a, &moment)];
        let mut determinant = along.clone();
        if along.sign().is_lt() {
            t = -&t;
            shares = shares.map(|share| -&share);
            determinant = -&determinant;
        }
        Some(Crossing {
            t,
            shares,
            determinant,
            against: along.sign().is_lt(),
        })
    }
}

impl Crossing {
    /// The determinant in the shares' unit, in which it is one whole side.
    fn whole(&self, line: &Line) -> Dyadic {
        &self.determinant * &line.scale
    }

    fn parameter(&self) -> Parameter {
        Parameter::fraction(&self.t, &self.determinant)
    }

    /// In a triangle: whether on its border, and the weights of its corners.
    fn in_triangle(&self, line: &Line) -> Option<(bool, [f64; 3])> {
        let [u, v] = &self.shares;
        if u.sign().is_lt() || v.sign().is_lt() {
            return None;
        }
        let whole = self.whole(line);
        let w = &(&whole - u) - v;
        if w.sign().is_lt() {
            return None;
        }
        let weights = [&w, u, v];
        let on_border = weights.iter().any(|weight| weight.is_zero());
        Some((on_border, weights.map(|weight| weight.over(&whole))))
    }

    /// In a parallelogram about its corner, half a side to each side: whether on its border.
    fn in_parallelogram(&self, line: &Line) -> Option<bool> {
        let whole = self.whole(line);
        let mut on_border = false;
        for share in &self.shares {
            let twice = share.clone().shifted(1);
            let size = if twice.sign().is_lt() { -&twice } else { twice };
            match size.cmp(&whole) {
                Ordering::Greater => return None,
                Ordering::Equal => on_border = true,
                Ordering::Less => {}
            }
        }
        Some(on_border)
    }
}

/// A shape where it stands in the world.
enum Solid {
    /// The first one's index in its mesh.
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

    /// All hits of the whole line, from whichever side, in no order.
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
                hits.extend(ends(met.collect()));
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
                // Both are `determinant * scale` too long, and so is the radius of 1/2.
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

/// The faces of the unit cube, each about its middle, with sides whose cross product points outwards in object space.
fn faces(axes: &[Vector; 3], centre: &Vector) -> Vec<(usize, i8, Flat)> {
    let all = (0..3).flat_map(|axis| [-1_i8, 1].map(|side| (axis, side)));
    let face = |(axis, side): (usize, i8)| {
        let half = Dyadic::whole(side.into()).shifted(-1);
        let middle = plus(centre, &times(&half, &axes[axis]));
        let (mut a, mut b) = ((axis + 1) % 3, (axis + 2) % 3);
        if side < 0 {
            (a, b) = (b, a);
        }
        let flat = Flat::new(middle, [axes[a].clone(), axes[b].clone()]);
        (axis, side, flat)
    };
    all.map(face).collect()
}

/// Entry and exit of a convex solid whose faces were met, in the order of axes: of each the first face that is met there
/// from the right side. One entry where both coincide.
fn ends(met: Vec<Hit>) -> Vec<Hit> {
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
