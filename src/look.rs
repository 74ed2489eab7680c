//! Colours and light of pictures, shared by the rasteriser and the ray caster.
//!
//! Directions are in view space (x right, y up, z into the picture), colours in linear light.

use crate::colour::Srgb;
use glam::Vec3;

/// What is behind a scene: a colour at the top edge of the picture and one at its bottom edge, between which it fades.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Background(pub [Srgb; 2]);

/// A background whose luminance is above this at both edges is light: lines over it are this much darker.
const IS_LIGHT: f32 = 0.51;
/// See [`IS_LIGHT`].
const DARKER: f32 = 0.36;

impl Background {
    /// For dark rooms and dark panels.
    pub const DARK: Self = Self([Srgb([43, 48, 58]), Srgb([18, 20, 25])]);
    /// For light panels.
    pub const LIGHT: Self = Self([Srgb([226, 231, 238]), Srgb([190, 198, 209])]);
    /// For paper.
    pub const WHITE: Self = Self([Srgb::WHITE; 2]);
    /// No light at all.
    pub const BLACK: Self = Self([Srgb([0; 3]); 2]);
    /// Half of the light of white. Lines have the same colours over it as over [`Self::BLACK`].
    pub const GREY: Self = Self([Srgb([188; 3]); 2]);

    /// The linear colour of a line or an outline as it is drawn over this: darker over a light one.
    pub fn over(self, colour: Srgb) -> [f32; 3] {
        let light = self.0.map(|edge| luminance(edge.to_linear()));
        let share = if light[0].min(light[1]) > IS_LIGHT {
            DARKER
        } else {
            1.0
        };
        colour.to_linear().map(|channel| channel * share)
    }

    /// Its linear colour, `down` = 0 at the top edge and 1 at the bottom edge of the picture.
    pub fn at(self, down: f32) -> [f32; 3] {
        let [top, bottom] = self.0.map(Srgb::to_linear);
        std::array::from_fn(|i| top[i] + (bottom[i] - top[i]) * down)
    }
}

/// What a picture's user may have behind a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backdrop {
    /// [`Background::DARK`].
    Dark,
    /// [`Background::LIGHT`].
    Light,
    /// [`Background::WHITE`].
    White,
    /// Nothing: the picture has opacity.
    Transparent,
}

impl Backdrop {
    /// All, by their names.
    pub const NAMED: [(&'static str, Self); 4] = [
        ("dark", Self::Dark),
        ("light", Self::Light),
        ("white", Self::White),
        ("transparent", Self::Transparent),
    ];

    /// Its colours; `None` where it is transparent.
    pub fn colours(self) -> Option<Background> {
        match self {
            Self::Dark => Some(Background::DARK),
            Self::Light => Some(Background::LIGHT),
            Self::White => Some(Background::WHITE),
            Self::Transparent => None,
        }
    }
}

/// The selected object, and the ray that picks it.
pub const SELECTION: Srgb = Srgb([255, 170, 10]);
/// What belongs to a ray's hits: the pick's mark, its triangle, normals at hits, the line between two picks.
pub const HIT: Srgb = Srgb::WHITE;
/// The x, y and z axes, of the world or of a camera.
pub const AXES: [Srgb; 3] = [
    Srgb([240, 78, 104]),
    Srgb([112, 192, 88]),
    Srgb([92, 140, 240]),
];
/// A camera seen from outside: its frustum, and its box in NDC.
pub const CAMERA: Srgb = Srgb([110, 224, 224]);
/// Normals of faces.
pub const NORMALS: Srgb = Srgb([176, 144, 255]);
/// Boxes about objects.
pub const BOXES: Srgb = Srgb([236, 110, 226]);
/// Boxes of a mesh's tree.
pub const TREE: Srgb = Srgb([200, 158, 120]);
/// Drawn and picked differ on an outline. This and the next six can be told apart with any colour vision (Okabe & Ito
/// 2008).
pub const EDGE: Srgb = Srgb([86, 180, 233]);
/// Drawn and picked differ between surfaces of equal depth.
pub const DEPTH: Srgb = Srgb([240, 228, 66]);
/// Drawn and picked differ on a section.
pub const AT_SECTION: Srgb = Srgb([120, 90, 0]);
/// Drawn and picked differ on an outline that `f32` moves.
pub const F32_LIMIT: Srgb = Srgb([0, 158, 115]);
/// Drawn and picked differ, and the view is beyond `f32`.
pub const BEYOND_F32: Srgb = Srgb([204, 121, 167]);
/// Surfaces lie in one place.
pub const IN_ONE_PLACE: Srgb = Srgb([0, 114, 178]);
/// What is wrong: a difference that nothing explains, a method's wrong answer.
pub const WRONG: Srgb = Srgb([213, 94, 0]);

/// Back faces where a section opens a solid.
pub const INSIDE: Srgb = Srgb([156, 126, 62]);
/// Text of warnings, on dark panels and on light ones.
pub const WARNING: [Srgb; 2] = [Srgb([200, 195, 10]), Srgb([120, 46, 0])];

/// The ground's grid. It is seen on dark and on light backgrounds, since it covers only a part of what is behind it.
pub const GRID: Srgb = Srgb([128, 136, 150]);
/// Pixels of a camera seen from outside.
pub const CAMERA_PIXELS: Srgb = Srgb([74, 118, 118]);

/// Share of the tint in a selected pixel.
pub const TINT: f32 = 0.16;
/// Light added to what is under the cursor: this fraction of its own light, and this much white.
pub const LIT: [f32; 2] = [0.15, 0.03];
/// Half the width of the selection's outline, in pixels of the picture at scale factor 1.
pub const OUTLINE_PX: u32 = 2;

/// Towards the key light, above the viewer's left shoulder.
pub const KEY_DIRECTION: Vec3 = Vec3::new(-0.449_595_5, 0.719_352_9, -0.529_523_6);
/// Towards the fill light, low on the right.
pub const FILL_DIRECTION: Vec3 = Vec3::new(0.903_394_1, -0.150_565_7, -0.401_508_5);
/// Light of the key, of the fill, and from the sky and from the ground: linear red, green and blue.
pub const KEY: Vec3 = Vec3::new(1.60, 1.555, 1.49);
/// See [`KEY`].
pub const FILL: Vec3 = Vec3::new(0.20, 0.23, 0.27);
/// See [`KEY`].
pub const SKY: Vec3 = Vec3::new(0.140, 0.146, 0.156);
/// See [`KEY`].
pub const GROUND: Vec3 = Vec3::new(0.104, 0.098, 0.095);

/// The light that a surface sends to the eye. `normal_view` is the normal of the visible side, in view space, of any
/// length. `albedo` and result are linear.
///
/// The lights stand about the camera. A key light falls off with the square of the cosine, which tells small
/// differences between normals apart; a fill from the other side keeps what it leaves from being flat; sky and ground
/// tell what faces up from what faces down, and leave nothing black. Both lights dim as a surface turns from the eye,
/// so creases and silhouettes are dark.
pub fn shade(albedo: [f32; 3], normal_view: Vec3) -> [f32; 3] {
    let normal = normal_view.normalize_or_zero();
    let facing = (-normal.z).max(0.0);
    let key = normal.dot(KEY_DIRECTION).max(0.0);
    let fill = normal.dot(FILL_DIRECTION).max(0.0);
    let around = GROUND + (SKY - GROUND) * (0.5 + 0.5 * normal.y);
    let light = facing * (KEY * key * key + FILL * fill) + around;
    (Vec3::from(albedo) * light).to_array()
}

/// A linear colour tinted with the selection's at the same brightness, so that shading stays.
pub fn tinted(colour: [f32; 3]) -> [f32; 3] {
    let tint = SELECTION.to_linear();
    let brightness = luminance(colour) / luminance(tint);
    std::array::from_fn(|i| colour[i] + (tint[i] * brightness - colour[i]) * TINT)
}

/// Luminance of linear light, as Rec. 709 has it.
pub fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
