//! A picture of where drawn and picked differ.

use super::{Class, Disagreement};
use crate::{
    colour::Srgb,
    image::{Image, Rgb},
};

/// What each class is painted in, and the colour's name: apart for all kinds of sight (Okabe & Ito 2008).
pub const COLOURS: [(Class, Srgb, &str); 4] = [
    (Class::Edge, Srgb([86, 180, 233]), "blue"),
    (Class::Depth, Srgb([240, 228, 66]), "yellow"),
    (Class::F32Limit, Srgb([0, 158, 115]), "green"),
    (Class::Unexplained, Srgb([213, 94, 0]), "orange"),
];

/// The picture in grey with each pixel that differs in its class's colour, and about it a paler ring of a pixel so that
/// it can be seen. Rings cover no pixel that differs itself.
#[must_use]
pub fn paint(colours: &Image<Rgb>, disagreements: &[Disagreement]) -> Image<Rgb> {
    let mut picture = colours.clone();
    for pixel in picture.pixels_mut() {
        *pixel = grey(*pixel);
    }
    let size = picture.size();
    let mut sorted: Vec<&Disagreement> = disagreements.iter().collect();
    // The gravest last, over the others.
    sorted.sort_by_key(|at| at.class);
    let width = size.width() as usize;
    let pixels = picture.pixels_mut();
    for reach in [1, 0] {
        for at in &sorted {
            let [x, y] = at.pixel;
            for j in y.saturating_sub(reach)..=(y + reach).min(size.height() - 1) {
                for i in x.saturating_sub(reach)..=(x + reach).min(size.width() - 1) {
                    let colour = colour(at.class).0;
                    pixels[j as usize * width + i as usize] = if reach == 0 {
                        colour
                    } else {
                        colour.map(|c| c / 2)
                    };
                }
            }
        }
    }
    picture
}

/// What a class is painted in.
#[must_use]
pub fn colour(class: Class) -> Srgb {
    let of_class = COLOURS.iter().find(|(other, ..)| *other == class);
    of_class.map_or(Srgb::WHITE, |(_, colour, _)| *colour)
}

/// As bright, paler.
fn grey(pixel: Rgb) -> Rgb {
    // Luma of Rec. 709, of the encoded values: good enough to tell shapes.
    let [r, g, b] = pixel.map(u32::from);
    let luma = (2126 * r + 7152 * g + 722 * b) / 10_000;
    [u8::try_from(64 + luma / 2).unwrap_or(u8::MAX); 3]
}
