//! A chart as a list of marks, drawn as SVG and pixels by `plotters`.

use super::point_shapes::{Shape, outlines};
use num_traits::ToPrimitive;
use plotters::{
    coord::Shift,
    element::DashedPathElement,
    prelude::*,
    style::{
        FontStyle, FontTransform, register_font,
        text_anchor::{HPos, Pos, VPos},
    },
};

/// An sRGB colour.
pub type Colour = [u8; 3];

/// Text and axes.
pub const INK: Colour = [0x22, 0x22, 0x22];
/// Lines that only guide the eye.
pub const FAINT: Colour = [0xdd, 0xdd, 0xdd];
/// Secondary text.
pub const QUIET: Colour = [0x55, 0x55, 0x55];
/// Okabe & Ito's colours, which people of every colour vision tell apart, without yellow, which is hard to see on
/// white, and black, which is Sightline's.
pub const COLOURS: [Colour; 7] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xcc, 0x79, 0xa7],
    [0x56, 0xb4, 0xe9],
    [0xe6, 0x9f, 0x00],
    [0x88, 0x88, 0x88],
];

/// Lengths of a dashed line's dashes and gaps, in pixels.
pub const DASH: [u32; 2] = [6, 5];

/// The shapes of methods other than Sightline's, in the order of their use.
pub const SHAPES: [Shape; 6] = [
    Shape::Circle,
    Shape::Square,
    Shape::Triangle,
    Shape::Diamond,
    Shape::Wedge,
    Shape::Cross,
];

/// The point of a text that lies at its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The middle of its left side.
    Left,
    /// Its middle.
    Middle,
    /// The middle of its right side.
    Right,
}

/// One drawn thing. Positions are in pixels from the top left corner.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// Connected segments.
    Line {
        /// Corners.
        points: Vec<[f64; 2]>,
        /// Its colour.
        colour: Colour,
        /// In pixels.
        width: u32,
        /// Dashed or solid.
        dashed: bool,
    },
    /// A data point.
    Point {
        /// Its middle.
        at: [f64; 2],
        /// Its shape.
        shape: Shape,
        /// Half its width.
        radius: f64,
        /// Its colour.
        colour: Colour,
        /// Filled, or only an outline.
        filled: bool,
    },
    /// A filled rectangle.
    Rectangle {
        /// Top left corner.
        from: [f64; 2],
        /// Bottom right corner.
        to: [f64; 2],
        /// Its colour.
        colour: Colour,
    },
    /// One line of text.
    Text {
        /// Its position.
        at: [f64; 2],
        /// The point of it that lies there.
        anchor: Anchor,
        /// Font size.
        size: f64,
        /// Its colour.
        colour: Colour,
        /// Turned so that it reads upwards.
        upwards: bool,
        /// What it says.
        text: String,
    },
}

/// A chart as a list of marks.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Later ones cover earlier ones.
    pub marks: Vec<Mark>,
}

/// The width of a line of text, in pixels.
pub fn text_width(text: &str, size: f64) -> f64 {
    let known = register_typeface().ok();
    let measured = known.and_then(|()| (FONT, size).into_font().box_size(text).ok());
    measured.map_or(0.0, |(width, _)| f64::from(width))
}

/// Registers the typeface; doing so again changes nothing.
fn register_typeface() -> Result<(), DrawError> {
    register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT)
        .map_err(|_| DrawError("the typeface is not one".to_owned()))
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[error("cannot draw the chart: {0}")]
pub struct DrawError(String);

/// The family name of the embedded typeface, which SVG viewers know as well.
const FONT: &str = "sans-serif";

impl Picture {
    /// An empty white picture of a size in whole pixels.
    pub(super) fn new(width: f64, height: f64) -> Self {
        let [width, height] = [width, height].map(|side| side.to_u32().unwrap_or(0));
        Self {
            width,
            height,
            marks: Vec::new(),
        }
    }

    /// Adds a line of text.
    pub fn text(
        &mut self,
        at: [f64; 2],
        anchor: Anchor,
        size: f64,
        colour: Colour,
        text: impl Into<String>,
    ) {
        self.marks.push(Mark::Text {
            at,
            anchor,
            size,
            colour,
            upwards: false,
            text: text.into(),
        });
    }

    /// Adds a line of text that reads upwards, with its middle at a position.
    pub fn text_upwards(&mut self, at: [f64; 2], size: f64, colour: Colour, text: &str) {
        self.text(at, Anchor::Middle, size, colour, text);
        if let Some(Mark::Text { upwards, .. }) = self.marks.last_mut() {
            *upwards = true;
        }
    }

    /// Adds a line.
    pub fn line(&mut self, points: Vec<[f64; 2]>, colour: Colour, width: u32, dashed: bool) {
        self.marks.push(Mark::Line {
            points,
            colour,
            width,
            dashed,
        });
    }

    /// Adds a point.
    pub fn point(&mut self, at: [f64; 2], shape: Shape, radius: f64, colour: Colour, filled: bool) {
        self.marks.push(Mark::Point {
            at,
            shape,
            radius,
            colour,
            filled,
        });
    }

    /// Adds rows of `columns` equal squares from a top left corner: one rectangle for each run of one colour.
    pub fn map(&mut self, colours: &[Colour], columns: usize, [left, top]: [f64; 2], side: f64) {
        for (y, row) in (0..).map(f64::from).zip(colours.chunks(columns)) {
            let mut x = 0.0;
            for run in row.chunk_by(PartialEq::eq) {
                let end = x + count(run.len());
                let corner = |x: f64, y: f64| [left + side * x, top + side * y];
                self.rectangle(corner(x, y), corner(end, y + 1.0), run[0]);
                x = end;
            }
        }
    }

    /// Adds a rectangle.
    pub fn rectangle(&mut self, from: [f64; 2], to: [f64; 2], colour: Colour) {
        self.marks.push(Mark::Rectangle { from, to, colour });
    }

    /// As an SVG file's text.
    ///
    /// # Errors
    /// When the drawing library refuses.
    pub fn svg(&self) -> Result<String, DrawError> {
        let mut text = String::new();
        {
            let size = (self.width, self.height);
            let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
            self.draw(&area, 1.0)?;
        }
        Ok(text)
    }

    /// As pixels, row by row from the top.
    ///
    /// # Errors
    /// When the drawing library refuses.
    pub fn pixels(&self) -> Result<Vec<[u8; 3]>, DrawError> {
        // Drawn larger and averaged, for smooth edges.
        const FINER: u32 = 2;
        let (width, height) = (self.width * FINER, self.height * FINER);
        let mut fine = vec![0_u8; width as usize * height as usize * 3];
        {
            let area = BitMapBackend::with_buffer(&mut fine, (width, height)).into_drawing_area();
            self.draw(&area, f64::from(FINER))?;
        }
        let (fine, _) = fine.as_chunks::<3>();
        let pixel = |(x, y): (u32, u32)| {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)]
                .map(|(i, j)| fine[((FINER * y + j) * width + FINER * x + i) as usize]);
            std::array::from_fn(|channel| {
                let sum: u16 = four.iter().map(|pixel| u16::from(pixel[channel])).sum();
                u8::try_from(sum / 4).unwrap_or(u8::MAX)
            })
        };
        let all = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        Ok(all.map(pixel).collect())
    }

    fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, Shift>,
        scale: f64,
    ) -> Result<(), DrawError> {
        register_typeface()?;
        let failed = |error: DrawingAreaErrorKind<B::ErrorType>| DrawError(error.to_string());
        area.fill(&WHITE).map_err(failed)?;
        for mark in &self.marks {
            draw_mark(area, mark, scale).map_err(failed)?;
        }
        area.present().map_err(failed)
    }
}

fn draw_mark<B: DrawingBackend>(
    area: &DrawingArea<B, Shift>,
    mark: &Mark,
    scale: f64,
) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
    let rgb = |[r, g, b]: Colour| RGBColor(r, g, b);
    let whole = |at: f64| (at * scale).round().to_i32().unwrap_or(0);
    let px = |[x, y]: [f64; 2]| (whole(x), whole(y));
    let wide = |width: u32| (f64::from(width) * scale).to_u32().unwrap_or(0);
    match mark {
        Mark::Line {
            points,
            colour,
            width,
            dashed,
        } => {
            let style = rgb(*colour).stroke_width(wide(*width));
            let points: Vec<_> = points.iter().copied().map(px).collect();
            if *dashed {
                let [on, off] = DASH.map(wide);
                area.draw(&DashedPathElement::new(points, on, off, style))
            } else {
                area.draw(&PathElement::new(points, style))
            }
        }
        Mark::Rectangle { from, to, colour } => {
            area.draw(&Rectangle::new([px(*from), px(*to)], rgb(*colour).filled()))
        }
        Mark::Point {
            at,
            shape,
            radius,
            colour,
            filled,
        } => {
            for outline in outlines(*shape, *at, *radius) {
                let corners: Vec<_> = outline.into_iter().map(px).collect();
                let fill = if *filled { rgb(*colour) } else { WHITE };
                area.draw(&Polygon::new(corners.clone(), fill))?;
                let closed: Vec<_> = corners.iter().chain(corners.first()).copied().collect();
                let style = rgb(*colour).stroke_width(wide(2));
                area.draw(&PathElement::new(closed, style))?;
            }
            Ok(())
        }
        Mark::Text {
            at,
            anchor,
            size,
            colour,
            upwards,
            text,
        } => {
            let h_pos = match anchor {
                Anchor::Left => HPos::Left,
                Anchor::Middle => HPos::Center,
                Anchor::Right => HPos::Right,
            };
            let transform = if *upwards {
                FontTransform::Rotate270
            } else {
                FontTransform::None
            };
            let style = (FONT, size * scale)
                .into_font()
                .transform(transform)
                .color(&rgb(*colour))
                .pos(Pos::new(h_pos, VPos::Center));
            area.draw(&Text::new(text.as_str(), px(*at), style))
        }
    }
}

/// A count as a floating-point number.
pub fn count(of: usize) -> f64 {
    u32::try_from(of).map_or(0.0, f64::from)
}
