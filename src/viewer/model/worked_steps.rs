//! How each number of a worked pick is made, what it means, and what Sightline's own pick has for it.

use super::{
    hits::RayHits,
    state::State,
    worked_marks::{Marks, WorkedMark},
    worked_numbers::WorkedNumber,
};
use crate::{
    camera::Projection,
    pick::Pick,
    study::worked::{Areas, OnPlane, Quadratic, WorkedHit, WorkedPick, WorkedShape, through_all},
};
use glam::DVec3;

/// What a step of the working is about, and its numbers.
pub struct WorkedStep {
    /// A few words.
    pub title: String,
    /// The numbers.
    pub rows: Vec<WorkedRow>,
}

/// A number of the working.
pub struct WorkedRow {
    /// Which.
    pub number: WorkedNumber,
    /// How it is computed: `name = formula`.
    pub formula: &'static str,
    /// What it means.
    pub about: &'static str,
    /// By the course's formula: one number, or a vector's.
    pub values: Vec<f64>,
    /// What Sightline's own pick has for it, where it has it.
    pub own: Option<Vec<f64>>,
    /// What it is in the world.
    pub marks: Vec<WorkedMark>,
}

impl State {
    /// The pick, worked out; `None` where nothing is picked.
    fn worked(&self) -> Option<(WorkedPick, &RayHits, &Pick)> {
        let hits = self.hits()?;
        let pick = hits.pick()?;
        let worked = WorkedPick::of(&self.scene, &hits.view, hits.px, pick)?;
        Some((worked, hits, pick))
    }

    /// Whether the course's formula finds the pick. Rounding may take it.
    pub fn is_worked_out(&self) -> bool {
        self.worked()
            .is_some_and(|(worked, ..)| worked.hit.is_some())
    }

    /// The number of the working that the cursor rests on, or whose mark in the picture it rests on.
    pub fn worked_number(&self) -> Option<WorkedNumber> {
        self.worked_number
    }

    /// The steps of the working; none where nothing is picked.
    pub fn worked_steps(&self) -> Vec<WorkedStep> {
        let Some((worked, hits, pick)) = self.worked() else {
            return Vec::new();
        };
        let mut steps = to_ray(&worked, hits);
        steps.push(step(
            format!("Into object space: {}", pick.object),
            vec![
                row(WorkedNumber::OriginObject, "o' = inverse(M) o", "where the ray starts, as the object sees it", worked.origin_object),
                row(WorkedNumber::DirectionObject, "d' = inverse(M) d", "the ray's direction as the object sees it, made 1 long again: so t is another there than in the world", worked.direction_object),
            ],
        ));
        steps.push(of_shape(&worked.shape, pick.barycentric));
        steps.extend(
            worked
                .hit
                .map(|hit| to_world(&hit, pick, worked.origin_world)),
        );
        let marks = Marks::new(&worked, hits, pick, &self.scene);
        for row in steps.iter_mut().flat_map(|step| &mut step.rows) {
            row.marks = marks.of(row.number);
        }
        steps
    }
}

/// From the pixel to the ray.
fn to_ray(worked: &WorkedPick, hits: &RayHits) -> Vec<WorkedStep> {
    let (camera, plane) = (&hits.view.camera, &worked.plane);
    let own = hits.view.uncut().ray(hits.px).direction.normalize();
    let pixel = step(
            "From the pixel to NDC".to_owned(),
            vec![
                row(WorkedNumber::Pixel, "(X, Y)", "the clicked position: the pixel's centre, from the top left corner", hits.px.to_array()),
                row(WorkedNumber::Ndc, "x = 2X/W - 1, y = 1 - 2Y/H", "the same from -1 to 1, y upwards: what P and the division by w make of whatever this pixel shows", plane.ndc)
                    .beside(hits.view.viewport.px_to_ndc(hits.px).to_array()),
            ],
        );
    let half = |number, formula, about, at: usize| {
        row(number, formula, about, DVec3::from(plane.half[at]))
    };
    let ray = match camera.lens().projection {
            Projection::Perspective { fov_y } => vec![
                row(WorkedNumber::Middle, "target", "what the camera looks at: the middle of the picture, where its plane is laid", DVec3::from(plane.middle)),
                row(WorkedNumber::Length, "len = |target - eye|", "how far away that plane is", [camera.target().distance(camera.eye())]),
                row(WorkedNumber::Alpha, "alpha = fov / 2", "the angle between the middle of the picture and its upper edge, in degrees", [0.5 * fov_y.to_degrees()]),
                half(WorkedNumber::Upward, "V = len tan(alpha) U", "from the middle of the picture to its upper edge", 1),
                half(WorkedNumber::Rightward, "H = len tan(alpha) aspect R", "from the middle of the picture to its right edge", 0),
                row(WorkedNumber::PlanePoint, "p = target + x H + y V", "the pixel as a point in the world", DVec3::from(plane.point)),
                row(WorkedNumber::Direction, "d = (p - eye) / |p - eye|", "the ray's direction, 1 long: eye + t d. Sightline's own keeps its length, so that t is depth; here it is made 1 long too", worked.direction_world).beside(own),
            ],
            Projection::Orthographic { .. } => vec![
                row(WorkedNumber::Middle, "eye", "the middle of the picture, whose plane is laid through the eye", DVec3::from(plane.middle)),
                half(WorkedNumber::Upward, "V = height / 2 U", "from the middle of the picture to its upper edge", 1),
                half(WorkedNumber::Rightward, "H = aspect height / 2 R", "from the middle of the picture to its right edge", 0),
                row(WorkedNumber::PlanePoint, "p = eye + x H + y V", "the pixel as a point in the world: there its ray starts", DVec3::from(plane.point)),
                row(WorkedNumber::Direction, "d = F", "the direction of all rays, 1 long: p + t d", worked.direction_world).beside(own),
            ],
        };
    vec![pixel, step("From NDC to the ray".to_owned(), ray)]
}

/// The hit, back in the world.
fn to_world(hit: &WorkedHit, pick: &Pick, origin_world: DVec3) -> WorkedStep {
    let (point, normal) = (pick.point_object, pick.normal_object);
    step(
        "Back to the world".to_owned(),
        vec![
            row(WorkedNumber::PointObject, "P' = o' + t d'", "the point in object space", hit.point_object).beside(point),
            row(WorkedNumber::Point, "P = M P'", "the point in the world", hit.point_world).beside(pick.point_world),
            row(WorkedNumber::NormalObject, "n'", "the outward normal in object space, 1 long", hit.normal_object).beside(normal),
            row(WorkedNumber::Normal, "n = inverse(M)^T n'", "the outward normal in the world: by the inverse transpose, made 1 long again; M itself would tilt it", hit.normal_world).beside(pick.normal_world),
            row(WorkedNumber::T, "t = |P - o|", "the ray parameter in the world, whose direction is 1 long: the least t of all objects wins", [hit.t_world])
                .beside([pick.point_world.distance(origin_world)]),
        ],
    )
}

fn step(title: String, rows: Vec<WorkedRow>) -> WorkedStep {
    WorkedStep { title, rows }
}

fn row(
    number: WorkedNumber,
    formula: &'static str,
    about: &'static str,
    values: impl Into<Values>,
) -> WorkedRow {
    WorkedRow {
        number,
        formula,
        about,
        values: values.into().0,
        own: None,
        marks: Vec::new(),
    }
}

/// One number or several.
struct Values(Vec<f64>);

impl From<DVec3> for Values {
    fn from(v: DVec3) -> Self {
        Self(v.to_array().to_vec())
    }
}

impl<const N: usize> From<[f64; N]> for Values {
    fn from(values: [f64; N]) -> Self {
        Self(values.to_vec())
    }
}

impl WorkedRow {
    /// The row with Sightline's own value.
    fn beside(mut self, own: impl Into<Values>) -> Self {
        self.own = Some(own.into().0);
        self
    }
}

/// What is computed for the shape.
fn of_shape(shape: &WorkedShape, weights: Option<[f64; 3]>) -> WorkedStep {
    match shape {
        WorkedShape::Sphere(quadratic) => of_sphere(quadratic),
        WorkedShape::Cube(slabs) => of_cube(slabs),
        WorkedShape::Square(on_plane) => of_square(on_plane),
        WorkedShape::Triangle(areas) => of_triangle(areas, weights),
    }
}

fn of_sphere(quadratic: &Quadratic<f64>) -> WorkedStep {
    let roots = quadratic.roots.unwrap_or([f64::NAN; 2]);
    step(
        "Sphere: |o' + t d'| = 1/2".to_owned(),
        vec![
            row(
                WorkedNumber::Coefficient(0),
                "A = d' . d'",
                "the direction's length, squared",
                [quadratic.a],
            ),
            row(
                WorkedNumber::Coefficient(1),
                "B = 2 o' . d'",
                "-B / 2A is the t at which the ray passes the centre closest",
                [quadratic.b],
            ),
            row(
                WorkedNumber::Coefficient(2),
                "C = o' . o' - 1/4",
                "the distance of the ray's start from the centre, squared, less the radius squared",
                [quadratic.c],
            ),
            row(
                WorkedNumber::Discriminant,
                "D = B^2 - 4AC",
                "above 0 the ray meets the sphere twice, at 0 it touches it, below 0 it misses; its root over A is the chord",
                [quadratic.discriminant],
            ),
            row(
                WorkedNumber::Root(0),
                "t0 = (-B - root(D)) / 2A",
                "where the ray comes in: the front",
                [roots[0]],
            ),
            row(
                WorkedNumber::Root(1),
                "t1 = (-B + root(D)) / 2A",
                "where it leaves: the back",
                [roots[1]],
            ),
        ],
    )
}

fn of_cube(slabs: &[[f64; 2]; 3]) -> WorkedStep {
    let [enter, leave] = through_all(slabs);
    let by = |side: usize| move |a: &usize, b: &usize| slabs[*a][side].total_cmp(&slabs[*b][side]);
    let last_entered = (0..3).max_by(by(0)).unwrap_or_default();
    let first_left = (0..3).min_by(by(1)).unwrap_or_default();
    let about = "between which values of t the ray is inside the slab, from -1/2 to 1/2";
    let entries = [
        "t0: the last entry, into x",
        "t0: the last entry, into y",
        "t0: the last entry, into z",
    ];
    let exits = [
        "t1: the first exit, from x",
        "t1: the first exit, from y",
        "t1: the first exit, from z",
    ];
    step(
        "Cube: three slabs".to_owned(),
        vec![
            row(
                WorkedNumber::Slab(0),
                "x: (-1/2 - o'x) / d'x, (1/2 - o'x) / d'x",
                about,
                slabs[0],
            ),
            row(WorkedNumber::Slab(1), "y: the same", about, slabs[1]),
            row(WorkedNumber::Slab(2), "z: the same", about, slabs[2]),
            row(
                WorkedNumber::Through(0),
                entries[last_entered],
                "the greatest of the three first values: from here on the ray is inside all slabs",
                [enter],
            ),
            row(
                WorkedNumber::Through(1),
                exits[first_left],
                "the least of the three second values. The ray misses the cube where this is below the last entry",
                [leave],
            ),
        ],
    )
}

fn of_square(on_plane: &OnPlane<f64>) -> WorkedStep {
    step(
        "Square: its plane, z = 0".to_owned(),
        vec![
            row(
                WorkedNumber::PlaneT,
                "t = N . (S - o') / N . d'",
                "where the ray meets the plane through the middle S with the normal N",
                [on_plane.t],
            ),
            row(
                WorkedNumber::InSquare,
                "x, y of the point",
                "along the sides, from the middle: in the square both are within 1/2",
                on_plane.along,
            ),
        ],
    )
}

fn of_triangle(areas: &Areas<f64>, weights: Option<[f64; 3]>) -> WorkedStep {
    let about = "the area of the point's triangle with the side opposite the corner, over the whole area: the corner's weight";
    let share = |at: usize, formula| {
        let row = row(WorkedNumber::Share(at), formula, about, [areas.shares[at]]);
        match weights {
            Some(weights) => row.beside([weights[at]]),
            None => row,
        }
    };
    step(
        "Triangle: its plane, then three areas".to_owned(),
        vec![
            row(
                WorkedNumber::PlaneT,
                "t = N . (v1 - o') / N . d'",
                "where the ray meets the plane of the triangle; N = (v2 - v1) x (v3 - v1)",
                [areas.t],
            ),
            share(0, "S1 = area(P' v2 v3) / area"),
            share(1, "S2 = area(P' v3 v1) / area"),
            share(2, "S3 = area(P' v1 v2) / area"),
            row(
                WorkedNumber::Sum,
                "S1 + S2 + S3",
                "1 inside, more outside. The test for equality is a test of rounding: one digit off, and the course's formula misses",
                [areas.sum],
            ),
        ],
    )
}
