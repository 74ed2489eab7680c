//! Panels: frames with two axes and a mesh, drawn by `plotters`, and marks in them.

use super::{
    Drawn, Failed,
    page::{WORDS, heading, style},
    prelude::*,
};
use plotters::element::DashedPathElement;

/// Where a line ends, in the page's pixels, with its name and colour.
pub type End = ((i32, i32), String, Ink);

/// A frame with two axes and a mesh.
pub struct Panel<'a, B: DrawingBackend> {
    /// The whole page, in whose pixels marks are drawn.
    pub page: &'a Page<B>,
    chart: ChartContext<'a, B, Cartesian2d<Axis, Axis>>,
}

/// Draws a titled panel into a part of a page, with room for labels to the right of its frame.
pub fn panel<'a, B: DrawingBackend>(
    page: &'a Page<B>,
    part: &Page<B>,
    title: &str,
    [x, y]: [Axis; 2],
    labels: i32,
) -> Result<Panel<'a, B>, Failed<B>> {
    let part = heading(part, title)?;
    let mut chart = ChartBuilder::on(&part)
        .margin(14)
        .margin_right(14 + labels)
        .x_label_area_size(108)
        .y_label_area_size(if y.name.is_empty() { 120 } else { 170 })
        .build_cartesian_2d(x.clone(), y.clone())?;
    let ticks = style(0.88 * WORDS, QUIET, Side::Middle);
    chart
        .configure_mesh()
        .bold_line_style(FAINT.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(2))
        .label_style(ticks)
        .axis_desc_style(style(WORDS, INK, Side::Middle))
        .x_desc(&x.name)
        .y_desc(&y.name)
        .draw()?;
    Ok(Panel { page, chart })
}

impl<B: DrawingBackend> Panel<'_, B> {
    /// The page's pixel at a pair of values.
    pub fn at(&self, x: f64, y: f64) -> (i32, i32) {
        self.chart.backend_coord(&(x, y))
    }

    /// The frame in the page's pixels: left, top, right and bottom.
    pub fn frame(&self) -> [i32; 4] {
        let (x, y) = self.chart.plotting_area().get_pixel_range();
        [x.start, y.start, x.end, y.end]
    }

    /// Fills the panel's width between two values of y.
    pub fn band(&self, [from, to]: [f64; 2], ink: Ink) -> Drawn<B> {
        let [left, _, right, _] = self.frame();
        let [a, b] = [from, to].map(|y| self.at(1.0, y).1);
        let area = [(left, a.min(b)), (right, a.max(b))];
        self.page.draw(&Rectangle::new(area, ink.filled()))
    }

    /// Draws a line at a value of y, with words above its right or left end.
    pub fn level(&self, y: f64, text: &str, end: Side) -> Drawn<B> {
        let [left, _, right, _] = self.frame();
        let (_, y) = self.at(1.0, y);
        let line = PathElement::new([(left, y), (right, y)], QUIET.stroke_width(2));
        self.page.draw(&line)?;
        let (x, side) = match end {
            Side::Left => (left + 12, Side::Right),
            _ => (right - 12, Side::Left),
        };
        words(self.page, text, (x, y - 28), QUIET, side)
    }

    /// The height of the room for 0, in pixels.
    fn room(&self) -> i32 {
        let [_, _, _, bottom] = self.frame();
        2 * (bottom - self.at(1.0, 0.0).1)
    }

    /// Fills the room for 0.
    pub fn none_band(&self) -> Drawn<B> {
        let [left, _, right, bottom] = self.frame();
        let area = [(left + 2, bottom - self.room()), (right, bottom - 2)];
        self.page.draw(&Rectangle::new(area, NOBODY_SEES.filled()))
    }

    /// The page's pixel at a value of x in a row of the room for 0.
    pub fn in_none(&self, x: f64, row: usize, of: usize) -> (i32, i32) {
        let [_, _, _, bottom] = self.frame();
        let [row, of] = [row, of.max(1)].map(|count| i32::try_from(count).unwrap_or(1));
        let (x, _) = self.at(x, 0.0);
        (
            x,
            bottom - self.room() + self.room() * (2 * row + 1) / (2 * of),
        )
    }

    /// Writes words to the right of a point where there is room, else to the left.
    pub fn beside(&self, text: &str, (x, y): (i32, i32), away: i32) -> Drawn<B> {
        let [_, _, right, _] = self.frame();
        if x + away + width(self.page, text)? < right {
            words(self.page, text, (x + away, y), INK, Side::Right)
        } else {
            words(self.page, text, (x - away, y), INK, Side::Left)
        }
    }

    /// Names lines at their ends, to the right of the frame.
    pub fn end_labels(&self, mut ends: Vec<End>) -> Drawn<B> {
        let [_, top, right, bottom] = self.frame();
        ends.sort_by_key(|((_, y), ..)| *y);
        let wanted: Vec<i32> = ends.iter().map(|((_, y), ..)| *y).collect();
        let places = label_places(&wanted, 46, [top + 16, bottom - 16]);
        for (((_, y), text, ink), place) in ends.into_iter().zip(places) {
            let line = [(right + 4, y), (right + 32, place)];
            self.page
                .draw(&PathElement::new(line, ink.stroke_width(2)))?;
            words(self.page, &text, (right + 40, place), INK, Side::Right)?;
        }
        Ok(())
    }

    /// Draws a line for each method through its rows, `y` against their parameter; that of the method `wide` is wider.
    /// The method's `own` rows are marked at a value of x. Returns the named lines' ends: a formula is named once, at
    /// its wide line, else at its first.
    pub fn curves(
        &self,
        rows: &[&Row],
        y: impl Fn(&Row) -> Option<f64>,
        wide: Option<(&str, Precision)>,
        (own, here): (&[&Row], f64),
    ) -> Result<Vec<End>, Failed<B>> {
        let is_wide = |info: &MethodInfo| wide == Some(info.key());
        // Sightline's covers all others except the wide one.
        let mut infos = distinct(rows.iter().map(|row| row.info));
        infos.sort_by_key(|info| (is_wide(info), info.ours, colour(info).is_some()));
        let mut ends: Vec<End> = Vec::new();
        for info in infos {
            let points = rows.iter().filter(|row| row.info == info);
            let points = points.filter_map(|row| Some([row.value, y(row)?]));
            let points: Vec<[f64; 2]> = points.collect();
            let ink = colour(&info).unwrap_or(GREY);
            let width = match (is_wide(&info), info.ours, colour(&info)) {
                (true, ..) => 12,
                (_, true, _) => 8,
                (_, _, Some(_)) => 6,
                _ => 3,
            };
            self.line(&points, ink, width, info.precision == F32)?;
            if is_wide(&info) {
                ends.retain(|(_, known, _)| known != name(&info));
            }
            let is_named = ends.iter().any(|(_, known, _)| known == name(&info));
            let has_name = colour(&info).is_some() || is_wide(&info);
            if let Some([x, y]) = points.last()
                && has_name
                && !is_named
            {
                ends.push((self.at(*x, *y), name(&info).to_owned(), ink));
            }
            for row in own.iter().filter(|row| row.info == info) {
                if let Some(y) = y(row) {
                    mark(self.page, self.at(here, y), &info, ink, 15)?;
                }
            }
        }
        Ok(ends)
    }

    /// Draws a line through pairs of values: dashed, or solid.
    pub fn line(&self, values: &[[f64; 2]], ink: Ink, width: u32, is_dashed: bool) -> Drawn<B> {
        let points = values.iter().map(|[x, y]| self.at(*x, *y));
        let points: Vec<(i32, i32)> = points.collect();
        let style = ink.stroke_width(width);
        if is_dashed {
            let dashed = DashedPathElement::new(points, 14, 12, style);
            self.page.draw(&dashed)
        } else {
            self.page.draw(&PathElement::new(points, style))
        }
    }
}

/// Marks a method's point: by a star for Sightline, by a ring in `f32`, else by a disc.
pub fn mark<B: DrawingBackend>(
    page: &Page<B>,
    (x, y): (i32, i32),
    info: &MethodInfo,
    ink: Ink,
    radius: i32,
) -> Drawn<B> {
    if info.ours {
        let corner = |i: u32| {
            let turn = f64::from(i) / 10.0 - 0.25;
            let r = f64::from(radius) * if i.is_multiple_of(2) { 1.9 } else { 0.85 };
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
            let [dx, dy] = [r * cos, r * sin].map(|d| d.round() as i32);
            (x + dx, y + dy)
        };
        return page.draw(&Polygon::new((0..10).map(corner).collect::<Vec<_>>(), ink));
    }
    page.draw(&Circle::new((x, y), radius, ink.filled()))?;
    if info.precision == F32 {
        page.draw(&Circle::new((x, y), radius - 6, WHITE.filled()))?;
    }
    Ok(())
}

/// Places for labels of a height, in order and apart, beside the wanted ones, which are sorted, and within a range.
fn label_places(wanted: &[i32], height: i32, [from, to]: [i32; 2]) -> Vec<i32> {
    let mut low = from;
    let down = wanted.iter().map(|wanted| {
        let place = low.max(*wanted);
        low = place + height;
        place
    });
    let mut places: Vec<i32> = down.collect();
    let mut high = to;
    for place in places.iter_mut().rev() {
        *place = high.min(*place);
        high = *place - height;
    }
    places
}
