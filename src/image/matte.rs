//! A picture on any backdrop, also on none: then it has opacity.

use super::{Image, Rgb, Rgba};
use crate::{
    camera::Viewport,
    colour::Srgb,
    look::{Backdrop, Background},
};

/// A finished picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Picture {
    /// On a background.
    Opaque(Image<Rgb>),
    /// Without one.
    Matte(Image<Rgba>),
}

impl Picture {
    /// What `draw` draws, on a backdrop. For a transparent one it draws twice: on black, and on grey.
    ///
    /// # Errors
    /// Those of `draw`.
    ///
    /// # Panics
    /// When it draws pictures of several sizes.
    pub fn on<E>(
        backdrop: Backdrop,
        mut draw: impl FnMut(Background) -> Result<Image<Rgb>, E>,
    ) -> Result<Self, E> {
        Ok(match backdrop.colours() {
            Some(background) => Self::Opaque(draw(background)?),
            None => Self::Matte(matte(&draw(Background::BLACK)?, &draw(Background::GREY)?)),
        })
    }

    /// Width and height.
    pub fn size(&self) -> Viewport {
        match self {
            Self::Opaque(image) => image.size(),
            Self::Matte(image) => image.size(),
        }
    }

    /// All pixels, row by row from the top.
    pub fn to_rgba(&self) -> Vec<Rgba> {
        match self {
            Self::Opaque(image) => image
                .pixels()
                .iter()
                .map(|&[r, g, b]| [r, g, b, 255])
                .collect(),
            Self::Matte(image) => image.pixels().to_vec(),
        }
    }
}

/// What stands in front of a background, from a picture of it on black and one on grey. Where these are equal it is
/// opaque; where they differ as the backgrounds do nothing is there. An edge or a faint line covers a part of its pixel.
/// It is the method of two known backgrounds (Smith and Blinn, *Blue Screen Matting*, SIGGRAPH 1996), in linear light.
fn matte(on_black: &Image<Rgb>, on_grey: &Image<Rgb>) -> Image<Rgba> {
    assert_eq!(on_black.size(), on_grey.size(), "pictures of one view");
    let grey: f32 = Background::GREY.at(0.0).iter().sum();
    let pairs = on_black.pixels().iter().zip(on_grey.pixels());
    let pixels = pairs.map(|(black, other)| {
        let [black, other] = [black, other].map(|pixel| Srgb(*pixel).to_linear());
        let seen_through = (0..3).map(|i| other[i] - black[i]).sum::<f32>() / grey;
        let opacity = (1.0 - seen_through).clamp(0.0, 1.0);
        let whole = |part: f32| if opacity > 0.0 { part / opacity } else { 0.0 };
        let [r, g, b] = Srgb::from_linear(black.map(whole)).0;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "from 0 to 255"
        )]
        let alpha = (opacity * 255.0).round() as u8;
        [r, g, b, alpha]
    });
    Image::new(on_black.size(), pixels.collect())
}
