//! The outlines of data points.

/// The shape of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Round.
    Circle,
    /// Four sides, upright.
    Square,
    /// On its side.
    Triangle,
    /// Four sides, on a corner.
    Diamond,
    /// On its tip.
    Wedge,
    /// Two crossing bars.
    Cross,
    /// Five points: Sightline's.
    Star,
}

/// The closed outlines of a point about a middle; `r` is half its width.
pub fn outlines(shape: Shape, [x, y]: [f64; 2], r: f64) -> Vec<Vec<[f64; 2]>> {
    let ring = |corners: u32, from_turn: f64, radius: &dyn Fn(u32) -> f64| {
        let corner = |i: u32| {
            let turn = from_turn + f64::from(i) / f64::from(corners);
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            [x + radius(i) * cos, y + radius(i) * sin]
        };
        (0..corners).map(corner).collect::<Vec<_>>()
    };
    let bar = |dx: f64, dy: f64| {
        let (w, h) = (dx * r, dy * r);
        vec![[x - w, y - h], [x + w, y + h]]
    };
    match shape {
        Shape::Circle => vec![ring(24, 0.0, &|_| r)],
        Shape::Square => vec![ring(4, 0.125, &|_| 1.25 * r)],
        Shape::Diamond => vec![ring(4, 0.0, &|_| 1.2 * r)],
        Shape::Triangle => vec![ring(3, -0.25, &|_| 1.25 * r)],
        Shape::Wedge => vec![ring(3, 0.25, &|_| 1.25 * r)],
        Shape::Cross => vec![bar(0.9, 0.9), bar(0.9, -0.9)],
        Shape::Star => vec![ring(10, -0.25, &|i| {
            if i % 2 == 0 { 1.7 * r } else { 0.75 * r }
        })],
    }
}
