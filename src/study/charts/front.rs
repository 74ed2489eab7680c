//! Speed against accuracy: how far off the worst wrong answer of a triangle test and of a sphere test is, and how often
//! a whole pick is wrong, each against the time.

use super::prelude::*;
use crate::study::methods::picks::gpu;

/// A method's place in a panel.
#[derive(Clone, Copy)]
struct Point {
    info: MethodInfo,
    ns: f64,
    error: f64,
    /// Where it comes from: time and error near the origin.
    near: Option<[f64; 2]>,
}

/// A point with its pixel, and with that of where it comes from.
type Placed = (Point, (i32, i32), Option<(i32, i32)>);

/// Draws the chart.
pub fn draw<B: DrawingBackend>(page: &Page<B>, report: &Report) -> Drawn<B> {
    let [triangle, sphere] = ["triangle", "sphere"].map(|key| tests(report, key));
    let picks = picks(report);
    let adapter = gpu().map_or("no adapter", |gpu| gpu.adapter_name());
    let lines = [
        "Left: how far off the worst wrong answer is, ties aside. Right: how many picks are wrong; arrows from the origin to 5e6 radii away. Ring: f32; \
         disc: f64 or exact; grey: others."
            .to_owned(),
        format!("{}. Ids are drawn by {adapter}.", about(report, "triangle", false)),
    ];
    let rest = head(page, &message(&triangle, &picks), &lines)?;
    let parts = rest.split_evenly((1, 3));
    let both = || triangle.iter().chain(&sphere);
    let x = Axis::powers_of_ten("time of one test (ns)", both().map(|point| point.ns))
        .wider([0.2, 0.5]);
    for (title, points, part) in [
        ("Ray against triangle", &triangle, &parts[0]),
        ("Ray against sphere", &sphere, &parts[1]),
    ] {
        let y = Axis::between("worst wrong answer (px)", [-20.0, 4.0]);
        let y = y.with_rows(rows(points), "never");
        let panel = panel(page, part, title, [x.clone(), y], 0)?;
        panel.band([1.0, 1e4], WARNING)?;
        panel.none_band()?;
        panel.level(1.0, "one pixel", Side::Right)?;
        panel.level(1.0 / 256.0, "the rasteriser's grid", Side::Right)?;
        marks(&panel, points, |info| colour(info).is_some())?;
    }
    let times = picks
        .iter()
        .flat_map(|point| [point.ns, point.near.map_or(point.ns, |near| near[0])]);
    let x = Axis::powers_of_ten("time of one pick (ns)", times).wider([0.3, 0.5]);
    let y = Axis::between("wrong picks (%)", [-2.0, 2.0]).with_rows(rows(&picks), "never");
    let panel = panel(page, &parts[2], "Whole pick", [x, y], 0)?;
    panel.none_band()?;
    marks(&panel, &picks, |_| true)
}

/// The methods of a step that were timed, the fastest first.
fn tests(report: &Report, key: &str) -> Vec<Point> {
    let all = report.summaries_of(key);
    // A test for directions of one length is wrong for all others.
    let fair = all
        .iter()
        .filter(|of| of.method.info.name != "plain, for unit directions");
    let points = fair.filter_map(|summary| {
        Some(Point {
            info: summary.method.info,
            ns: summary.ns()?,
            error: summary.own_error(),
            near: None,
        })
    });
    let mut points: Vec<Point> = points.collect();
    points.sort_by(|a, b| a.ns.total_cmp(&b.ns));
    points
}

/// The whole picks that were timed, far away, and near the origin where that differs. Those that become wrong come
/// first, then those that are wrong near the origin, each the fastest first: no arrow crosses a name.
fn picks(report: &Report) -> Vec<Point> {
    let all = report.summaries_of("pick");
    let points = all.iter().filter_map(|summary| {
        let (near, far) = (summary.method, summary.rows.last()?);
        Some(Point {
            info: far.info,
            ns: far.time?.ns,
            error: far.wrong_percent(),
            near: (near.wrong() != far.wrong()).then_some([near.time?.ns, near.wrong_percent()]),
        })
    });
    let mut points: Vec<Point> = points.collect();
    let rank = |point: &Point| (point.error == 0.0, point.near.is_none());
    points.sort_by(|a, b| rank(a).cmp(&rank(b)).then(a.ns.total_cmp(&b.ns)));
    points
}

/// What never being wrong costs, in this run.
fn message(triangle: &[Point], picks: &[Point]) -> String {
    let ns = |points: &[Point], name: &str, precision: Precision| {
        let is_it = |point: &&Point| point.info.key() == (name, precision);
        points.iter().find(is_it).map(|point| point.ns)
    };
    let ratio = |ours: Option<f64>, theirs: Option<f64>| {
        ours.zip(theirs).map(|(ours, theirs)| ours / theirs)
    };
    let ours = triangle.iter().find(|point| point.info.ours);
    let test = ratio(
        ours.map(|point| point.ns),
        ns(triangle, "Moeller-Trumbore", F64),
    );
    let [one, as_it_runs] = ["Sightline's, a triangle at a time", "Sightline's"].map(|name| {
        let ours = ns(picks, name, Precision::Exact);
        ratio(ours, ns(picks, "f64 throughout", F64))
    });
    match (test, one, as_it_runs) {
        (Some(test), Some(one), Some(as_it_runs)) => format!(
            "Never wrong takes {test:.1} times f64's time for a triangle, {one:.1} for a pick, {as_it_runs:.1} as it runs"
        ),
        _ => "What never being wrong costs".to_owned(),
    }
}

/// How many points have a place where nothing is wrong.
fn rows(points: &[Point]) -> usize {
    points
        .iter()
        .filter(|point| point.is_somewhere_right())
        .count()
}

impl Point {
    fn is_somewhere_right(&self) -> bool {
        self.error == 0.0 || self.near.is_some_and(|[_, error]| error == 0.0)
    }

    fn ink(&self) -> Ink {
        colour(&self.info).unwrap_or(GREY)
    }
}

/// Draws points, joins a named formula's two, and names each named formula once, at its most precise point.
fn marks<B: DrawingBackend>(
    panel: &Panel<'_, B>,
    points: &[Point],
    is_named: fn(&MethodInfo) -> bool,
) -> Drawn<B> {
    let (page, rows) = (panel.page, rows(points));
    let mut row = 0;
    let placed = points.iter().map(|point| {
        let own_row = row;
        row += usize::from(point.is_somewhere_right());
        let place = |ns: f64, error: f64| match error {
            0.0 => panel.in_none(ns, own_row, rows),
            _ => panel.at(ns, error),
        };
        let near = point.near.map(|[ns, error]| place(ns, error));
        (*point, place(point.ns, point.error), near)
    });
    let mut placed: Vec<Placed> = placed.collect();
    // The grey ones first, and rings before discs.
    placed.sort_by_key(|(point, ..)| (colour(&point.info).is_some(), point.info.precision));
    for (point, at, near) in &placed {
        if let Some(near) = near.filter(|near| near.1 != at.1) {
            arrow(page, near, *at, point.ink())?;
        }
        let is_pair = |(other, ..): &&Placed| {
            other.info.name == point.info.name && other.info.precision < point.info.precision
        };
        let pair = placed
            .iter()
            .find(is_pair)
            .filter(|_| is_named(&point.info));
        if let Some((_, other, _)) = pair {
            page.draw(&PathElement::new(
                [*other, *at],
                point.ink().stroke_width(5),
            ))?;
        }
    }
    for (point, at, near) in &placed {
        if let Some(near) = near.filter(|near| near.1 != at.1) {
            page.draw(&Circle::new(near, 8, point.ink().filled()))?;
        }
        mark(page, *at, &point.info, point.ink(), 15)?;
    }
    // Outside the band a name hangs from its point, the leftmost one lowest, so that no line crosses a name.
    placed.sort_by_key(|(_, (x, _), _)| -x);
    let has_better = |of: &Point| {
        let is_better = |(other, ..): &Placed| {
            other.info.name == of.info.name && other.info.precision > of.info.precision
        };
        placed.iter().any(is_better)
    };
    let hung = placed
        .iter()
        .filter(|(point, ..)| point.error > 0.0 && is_named(&point.info) && !has_better(point));
    let mut low = 0;
    for (point, (x, y), _) in hung {
        low = low.max(y + 12) + 60;
        page.draw(&PathElement::new(
            [(*x, y + 15), (*x, low)],
            point.ink().stroke_width(2),
        ))?;
        panel.beside(name(&point.info), (*x, low), 12)?;
    }
    for (point, at, _) in placed.iter().filter(|(point, ..)| point.error == 0.0) {
        panel.beside(name(&point.info), *at, 36)?;
    }
    Ok(())
}

/// A line with a tip.
fn arrow<B: DrawingBackend>(
    page: &Page<B>,
    from: (i32, i32),
    to: (i32, i32),
    ink: Ink,
) -> Drawn<B> {
    let [dx, dy] = [to.0 - from.0, to.1 - from.1].map(f64::from);
    let length = libm::hypot(dx, dy).max(1.0);
    let [ux, uy] = [dx / length, dy / length];
    let corner = |back: f64, aside: f64| {
        #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
        let [x, y] = [-back * ux - aside * uy, -back * uy + aside * ux].map(|d| d.round() as i32);
        (to.0 + x, to.1 + y)
    };
    page.draw(&PathElement::new([from, to], ink.stroke_width(5)))?;
    let tip = [corner(48.0, 20.0), corner(14.0, 0.0), corner(48.0, -20.0)];
    page.draw(&PathElement::new(tip, ink.stroke_width(5)))
}
