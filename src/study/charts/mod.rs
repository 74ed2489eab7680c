//! The study's charts. Each has one message, which its title says in the run's own numbers.
//!
//! `plotters` draws them, axes and meshes included, on any of its backends: as SVG, as pixels, in the window.

mod axis;
mod colours;
mod cost;
mod depth_buffer;
mod front;
mod heat;
mod page;
mod panel;
mod shared_edge;
mod stability;

pub use stability::family;

use super::run::Report;
use page::Page;
use plotters::{
    drawing::DrawingAreaErrorKind,
    prelude::{BitMapBackend, DrawingBackend, IntoDrawingArea, SVGBackend},
};

/// What the charts import.
mod prelude {
    pub use super::{
        Drawn,
        axis::Axis,
        colours::{FAINT, GREY, INK, Ink, NOBODY_SEES, QUIET, WARNING, colour, name},
        page::{Page, Side, about, head, legend, small_words, width, words},
        panel::{Panel, mark, panel},
    };
    pub use crate::study::prelude::*;
    pub use plotters::prelude::*;
}

/// What a drawing function returns on a backend.
pub type Drawn<B> = Result<(), Failed<B>>;
/// What fails on a backend.
pub type Failed<B> = DrawingAreaErrorKind<<B as DrawingBackend>::ErrorType>;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
#[error("cannot draw the chart: {0}")]
pub struct DrawError(String);

/// A chart of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chart {
    /// How far off the worst wrong answer is, against the time.
    Front,
    /// From which value of each parameter on each method fails.
    Heat,
    /// Rays at the edge of two triangles that hit neither.
    SharedEdge,
    /// Errors against the parameters that make them worse.
    Stability,
    /// What the depth buffer tells apart.
    Depth,
    /// The time against the share of hits, and of rays that `f64` can't decide.
    Cost,
}

impl Chart {
    /// Every chart.
    pub const ALL: [Self; 6] = [
        Self::Front,
        Self::Heat,
        Self::SharedEdge,
        Self::Stability,
        Self::Depth,
        Self::Cost,
    ];
    /// Width and height in the backend's pixels: twice those of a PNG file, which is averaged for smooth edges.
    pub const SIZE: (u32, u32) = (3200, 1800);

    /// The name of its files, without the extension.
    pub const fn stem(self) -> &'static str {
        match self {
            Self::Front => "front",
            Self::Heat => "heat",
            Self::SharedEdge => "shared_edge",
            Self::Stability => "stability",
            Self::Depth => "depth",
            Self::Cost => "cost",
        }
    }

    /// Draws a report's chart on a backend of [`Self::SIZE`].
    ///
    /// # Errors
    /// When the backend refuses, or the typeface is none.
    pub fn draw<B: DrawingBackend>(self, report: &Report, on: B) -> Result<(), DrawError> {
        page::register_typeface()?;
        let page: Page<B> = on.into_drawing_area();
        let drawn = match self {
            Self::Front => front::draw(&page, report),
            Self::Heat => heat::draw(&page, report),
            Self::SharedEdge => shared_edge::draw(&page),
            Self::Stability => stability::draw(&page, report),
            Self::Depth => depth_buffer::draw(&page),
            Self::Cost => cost::draw(&page, report),
        };
        let drawn = drawn.and_then(|()| page.present());
        drawn.map_err(|error| DrawError(error.to_string()))
    }

    /// As an SVG file's text.
    ///
    /// # Errors
    /// When the drawing library refuses.
    pub fn svg(self, report: &Report) -> Result<String, DrawError> {
        let mut text = String::new();
        self.draw(report, SVGBackend::with_string(&mut text, Self::SIZE))?;
        Ok(text)
    }

    /// As pixels, row by row from the top: half of [`Self::SIZE`].
    ///
    /// # Errors
    /// When the drawing library refuses.
    pub fn pixels(self, report: &Report) -> Result<Vec<[u8; 3]>, DrawError> {
        let (width, height) = Self::SIZE;
        let mut fine = vec![0_u8; width as usize * height as usize * 3];
        self.draw(report, BitMapBackend::with_buffer(&mut fine, Self::SIZE))?;
        let (fine, _) = fine.as_chunks::<3>();
        let pixel = |(x, y): (u32, u32)| {
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)]
                .map(|(i, j)| fine[((2 * y + j) * width + 2 * x + i) as usize]);
            std::array::from_fn(|channel| {
                let sum: u16 = four.iter().map(|pixel| u16::from(pixel[channel])).sum();
                u8::try_from(sum / 4).unwrap_or(u8::MAX)
            })
        };
        let all = (0..height / 2).flat_map(|y| (0..width / 2).map(move |x| (x, y)));
        Ok(all.map(pixel).collect())
    }
}
