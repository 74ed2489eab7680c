//! Speed against wrong answers for a triangle, a sphere and a whole pick: three large panels.

use super::prelude::*;

/// The steps that are shown, and whether their panels share one time axis.
const STEPS: [(&str, bool); 3] = [("triangle", true), ("sphere", true), ("pick", false)];
/// The frames' top and bottom, the left end of the first frame, and the gap between two frames.
const TOP: f64 = 148.0;
const BOTTOM: f64 = 836.0;
const LEFT: f64 = 100.0;
const GAP: f64 = 40.0;
/// Height of a line in the band of methods that are never wrong.
const ROW: f64 = 30.0;

/// One formula in one precision.
struct Point<'a> {
    row: &'a Row,
    /// On the ordinary workload, in nanoseconds.
    ns: f64,
    /// On the workload that takes longest.
    slowest: f64,
    /// Wrong answers in per cent: over all workloads, on the median workload, on the worst one with more than ties, and
    /// on the worst one.
    wrong: [f64; 4],
}

impl<'a> Point<'a> {
    fn new(of: &Summary<'a>) -> Option<Self> {
        let rows = || of.rows.iter().copied();
        let mut percents: Vec<f64> = rows().map(Row::wrong_percent).collect();
        percents.sort_by(f64::total_cmp);
        // A wrongly picked triangle has no distance, so it is no tie.
        let is_apart = |row: &&Row| row.worst_wrong > 0.0 || row.info.step.wrong_unit.is_empty();
        let apart = rows().filter(is_apart).map(Row::wrong_percent);
        let apart = apart.fold(0.0, f64::max);
        let all = 100.0 * of.wrong_rate();
        Some(Self {
            row: of.method,
            ns: of.ns()?,
            slowest: of.slowest()?.1.ns,
            wrong: [all, percents[percents.len() / 2], apart, *percents.last()?],
        })
    }

    fn is_never_wrong(&self) -> bool {
        self.wrong[0] == 0.0
    }

    fn name(&self) -> &'a str {
        if self.row.info.ours {
            "Sightline"
        } else {
            self.row.info.name
        }
    }
}

/// The chart.
pub fn chart(report: &Report) -> Picture {
    let lines = [
        "Lower: more accurate; left: faster. Point: all workloads together, time on the ordinary one. Bars: from the middle workload to the \
         worst, and to the slowest.",
        "Dashed: ties only, rays exactly through an edge or an outline. Ring: f32, disc: f64 or exact, joined where the formula is one; \
         star: Sightline.",
    ];
    let title = "How often each method is wrong, and how long it takes";
    let mut picture = page(900.0, title, &lines);
    let panels = STEPS.iter().filter_map(|(key, is_shared)| {
        let step = report.steps().into_iter().find(|step| step.key == *key)?;
        let all = report.summaries(step);
        let mut points: Vec<_> = all.iter().filter_map(Point::new).collect();
        points.sort_by(|a, b| a.ns.total_cmp(&b.ns));
        (!points.is_empty()).then_some((step.name, *is_shared, points))
    });
    let panels: Vec<(&str, bool, Vec<Point<'_>>)> = panels.collect();
    let all = || panels.iter().flat_map(|(_, _, points)| points);
    let wrong = all().flat_map(|point| [point.wrong[0], point.wrong[3]]);
    let wrong: Vec<f64> = wrong.filter(|wrong| *wrong > 0.0).collect();
    let rows = panels.iter().map(|(_, _, points)| never(points).len());
    let band = BOTTOM - ROW * count(rows.max().unwrap_or(0)) - 8.0;
    let y = Axis::new(&wrong, [band - 4.0, TOP + 6.0]);
    let shared = panels.iter().filter(|(_, is_shared, _)| *is_shared);
    let shared = span(shared.flat_map(|(_, _, points)| points));
    let width = (WIDTH - LEFT - 24.0 - 2.0 * GAP) / 3.0;
    for ((name, is_shared, points), place) in panels.iter().zip((0..).map(f64::from)) {
        let left = LEFT + place * (width + GAP);
        let span = if *is_shared { shared } else { span(points) };
        let panel = Panel {
            x: Axis::between(libm::log10, span, [left, left + width]),
            y,
            from: [left, TOP],
            to: [left + width, BOTTOM],
        };
        let at_first = |words: &'static str| if place == 0.0 { words } else { "" };
        let [y_name, never] = ["wrong answers (%)", "never"].map(at_first);
        picture.rectangle([left, band], panel.to, NEVER);
        panel.draw(&mut picture, "", ["time (ns)", y_name], "");
        picture.text([left, TOP - 20.0], Anchor::Left, 24.0, INK, *name);
        let at = [left - 6.0, 0.5 * (band + BOTTOM)];
        picture.text(at, Anchor::Right, 15.0, QUIET, never);
        draw(&mut picture, &panel, band, points);
    }
    picture
}

/// The names of the formulas that are never wrong.
fn never<'a>(points: &[Point<'a>]) -> Vec<&'a str> {
    let never = points.iter().filter(|point| point.is_never_wrong());
    distinct(never.map(|point| point.row.info.name))
}

/// The logarithms of the first and last time on an axis. Methods that are far slower than most stand at the axis's end,
/// and their labels name their times.
fn span<'a>(points: impl IntoIterator<Item = &'a Point<'a>>) -> [f64; 2] {
    let mut times: Vec<f64> = points
        .into_iter()
        .map(|point| libm::log10(point.ns))
        .collect();
    times.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (times.first(), times.last()) else {
        return [0.0, 1.0];
    };
    let end = if last - first > 3.0 {
        last + 0.2
    } else {
        last.min(times[times.len() / 2] + 0.8) + 0.5
    };
    [first - 0.2, end]
}

/// A point with its place and colour.
type Placed<'a> = (&'a Point<'a>, [f64; 2], Colour);

/// Draws a panel's points, which are in order of time.
fn draw(picture: &mut Picture, panel: &Panel, band: f64, points: &[Point<'_>]) {
    let never = never(points);
    let names = distinct(points.iter().map(|point| point.row.info.name));
    let position = |names: &[&str], point: &Point<'_>| {
        let known = names.iter().position(|name| *name == point.row.info.name);
        known.unwrap_or(0)
    };
    let mut places = LabelPlaces::new(panel.from, [panel.to[0], band - 2.0]);
    let placed = points.iter().map(|point| {
        let colour = COLOURS[position(&names, point) % COLOURS.len()];
        let colour = if point.row.info.ours { [0; 3] } else { colour };
        let mut at = panel.at(point.ns, point.wrong[0]);
        if point.is_never_wrong() {
            at[1] = band + 4.0 + ROW * (count(position(&never, point)) + 0.5);
        }
        (point, at, colour)
    });
    let mut placed: Vec<Placed<'_>> = placed.collect();
    for each in &placed {
        bars(picture, panel, band, each, &mut places);
    }
    for (i, (point, at, colour)) in placed.iter().enumerate() {
        let is_pair = |(other, ..): &&Placed<'_>| other.row.info.name == point.row.info.name;
        if let Some((_, other, _)) = placed[i + 1..].iter().find(is_pair) {
            picture.line(vec![*at, *other], *colour, 3, false);
        }
    }
    // Rings first, so that a disc inside a ring leaves both visible.
    placed.sort_by_key(|(point, ..)| (point.row.info.ours, point.row.info.precision));
    for (point, at, colour) in &placed {
        let (shape, radius, filled) = match (point.row.info.ours, point.row.info.precision) {
            (true, _) => (Shape::Star, 9.0, true),
            (false, Precision::F32) => (Shape::Circle, 7.0, false),
            (false, _) => (Shape::Circle, 5.0, true),
        };
        picture.point(*at, shape, radius, *colour, filled);
        places.take_point(*at, radius);
    }
    // A formula's name stands at its most precise point.
    let mut named: Vec<&str> = Vec::new();
    for (point, at, colour) in placed.iter().rev() {
        let name = point.name();
        if named.contains(&name) {
            continue;
        }
        named.push(name);
        let is_off = |ns: f64| panel.x.at(ns) >= panel.to[0];
        let words = match (is_off(point.ns), is_off(point.slowest)) {
            (true, _) => format!("{name}, {}", time(point.ns)),
            (false, true) => format!("{name}, up to {}", time(point.slowest)),
            (false, false) => name.to_owned(),
        };
        if at[1] > band {
            in_band(picture, panel, point, *at, &words);
        } else {
            places.label(picture, *at, &words, *colour);
        }
    }
}

/// A time with its unit and about two digits.
fn time(ns: f64) -> String {
    let (value, unit) = match ns {
        ..1e3 => (ns, "ns"),
        ..1e6 => (ns / 1e3, "us"),
        _ => (ns / 1e6, "ms"),
    };
    let places = usize::from(value < 10.0);
    format!("{value:.places$} {unit}")
}

/// Writes words to the right of a point and its bar where there is room, else to the left.
fn in_band(picture: &mut Picture, panel: &Panel, point: &Point<'_>, at: [f64; 2], words: &str) {
    let end = panel.x.at(point.slowest).max(at[0] + 8.0) + 12.0;
    let (x, anchor) = if end + text_width(words, 17.0) < panel.to[0] {
        (end, Anchor::Left)
    } else {
        (at[0] - 19.0, Anchor::Right)
    };
    picture.text([x, at[1]], anchor, 17.0, INK, words);
}

/// Draws a bar from the median workload to the worst, dashed where only ties are wrong; and one to the slowest
/// workload, which ends in an arrow where that is beyond the axis.
fn bars(
    picture: &mut Picture,
    panel: &Panel,
    band: f64,
    (point, at, colour): &Placed<'_>,
    places: &mut LabelPlaces,
) {
    let y = |wrong: f64| if wrong > 0.0 { panel.y.at(wrong) } else { band };
    let [_, middle, apart, worst] = point.wrong;
    let x = at[0];
    if worst > 0.0 {
        let [from, ties, to] = [middle, apart.max(middle), worst].map(|wrong| [x, y(wrong)]);
        picture.line(vec![from, ties], *colour, 1, false);
        picture.line(vec![ties, to], *colour, 1, true);
        picture.line(vec![[x - 5.0, to[1]], [x + 5.0, to[1]]], *colour, 2, false);
        places.take_line([from, to]);
    }
    let slowest = [panel.x.at(point.slowest), at[1]];
    if slowest[0] - x > 12.0 {
        picture.line(vec![*at, slowest], *colour, 1, false);
        let [x, y] = slowest;
        if x < panel.to[0] {
            picture.line(vec![[x, y - 5.0], [x, y + 5.0]], *colour, 2, false);
        } else {
            let tip = vec![[x - 8.0, y - 5.0], slowest, [x - 8.0, y + 5.0]];
            picture.line(tip, *colour, 2, false);
        }
        places.take_line([*at, slowest]);
    }
}
