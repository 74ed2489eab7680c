//! Nodes of eight boxes and leaves of eight triangles, as structures of arrays: each number is stored beside its seven
//! counterparts.

use bytemuck::{Pod, Zeroable};

/// Children of a node, and triangles of a leaf.
pub(super) const WIDTH: usize = 8;

/// A cache line: what nodes and leaves are stored in.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(super) struct CacheLine([u32; 16]);

/// Eight boxes and what is in them.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(super) struct Node {
    /// The least and the greatest corner of each box, by axis. An absent child's box is infinite and inverted, so that
    /// no ray enters it.
    pub corners: [[[f32; WIDTH]; 3]; 2],
    /// What is in each box.
    pub children: [Child; WIDTH],
    /// The rest of the cache line.
    unused: [u32; WIDTH],
}

/// Where a node or a leaf is in the tree's lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place(pub u32);

impl Place {
    /// The first node.
    pub const ROOT: Self = Self(0);

    /// The place of the node or leaf that begins in this line, which must be below `2^31`.
    pub fn new(line: usize, is_leaf: bool) -> Self {
        Self(to_u32(line << 1 | usize::from(is_leaf)))
    }

    #[inline(always)]
    pub fn is_leaf(self) -> bool {
        self.0 & 1 != 0
    }

    #[inline(always)]
    pub fn line(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// Where a child of the node in this place is.
    #[inline(always)]
    pub fn of(self, child: Child) -> Self {
        Self(self.0.wrapping_add(child.0))
    }
}

/// The distance from a node to one of its children. Being relative, it lets a small tree be put anywhere in a large
/// one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub(super) struct Child(u32);

impl Child {
    /// No child. Its box is one that no ray enters.
    pub const NONE: Self = Self(0);

    /// The distance from the node in `node` to its child in `place`, which comes after it.
    pub fn between(node: Place, place: Place) -> Self {
        Self(place.0 - node.0)
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "trees are smaller, and bins few"
)]
pub(super) fn to_u32(index: usize) -> u32 {
    index as u32
}

impl Node {
    /// A node without children.
    pub const EMPTY: Self = Self {
        corners: [[[f32::INFINITY; WIDTH]; 3], [[f32::NEG_INFINITY; WIDTH]; 3]],
        children: [Child::NONE; WIDTH],
        unused: [0; WIDTH],
    };
    /// Lines that it takes.
    pub const LINES: usize = size_of::<Self>() / size_of::<CacheLine>();

    /// A node with these boxes, by least and greatest corner, and no children yet.
    pub fn about(boxes: impl Iterator<Item = [[f32; 3]; 2]>) -> Self {
        let mut node = Self::EMPTY;
        for (lane, bounds) in boxes.enumerate() {
            for (axes, corner) in node.corners.iter_mut().zip(bounds) {
                for (lanes, x) in axes.iter_mut().zip(corner) {
                    lanes[lane] = x;
                }
            }
        }
        node
    }

    /// The node in this place.
    #[inline(always)]
    pub fn at(lines: &[CacheLine], place: Place) -> &Self {
        let lines = lines[place.line()..].first_chunk::<{ Self::LINES }>();
        bytemuck::cast_ref(lines.expect("nodes are whole"))
    }

    /// The node in this place, to change it.
    pub fn at_mut(lines: &mut [CacheLine], place: Place) -> &mut Self {
        let lines = lines[place.line()..].first_chunk_mut::<{ Self::LINES }>();
        bytemuck::cast_mut(lines.expect("nodes are whole"))
    }

    /// The cache lines that store it.
    pub fn lines(&self) -> &[CacheLine; Self::LINES] {
        bytemuck::cast_ref(self)
    }

    /// Its children and their lanes.
    pub fn children(&self) -> impl Iterator<Item = (usize, Child)> {
        let children = self.children.into_iter().enumerate();
        children.filter(|&(_, child)| child != Child::NONE)
    }

    /// The least and the greatest corner of a child's box.
    pub fn bounds(&self, child: usize) -> [[f32; 3]; 2] {
        self.corners.map(|corner| corner.map(|lanes| lanes[child]))
    }
}

/// Up to eight triangles. Lanes without one are NaN, which hits nothing.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub(super) struct Leaf {
    /// By corner and axis.
    pub corners: [[[f32; WIDTH]; 3]; 3],
    /// Which triangles of the mesh.
    pub triangles: [u32; WIDTH],
}

impl Leaf {
    /// A leaf without triangles.
    pub const EMPTY: Self = Self {
        corners: [[[f32::NAN; WIDTH]; 3]; 3],
        triangles: [u32::MAX; WIDTH],
    };
    /// Lines that it takes.
    pub const LINES: usize = size_of::<Self>() / size_of::<CacheLine>();

    /// The leaf in this place.
    #[inline(always)]
    pub fn at(lines: &[CacheLine], place: Place) -> &Self {
        let lines = lines[place.line()..].first_chunk::<{ Self::LINES }>();
        bytemuck::cast_ref(lines.expect("leaves are whole"))
    }

    /// The cache lines that store it.
    pub fn lines(&self) -> &[CacheLine; Self::LINES] {
        bytemuck::cast_ref(self)
    }

    /// The corners of one of its triangles.
    #[inline(always)]
    pub fn corners_of(&self, lane: usize) -> [[f32; 3]; 3] {
        let [a, b, c] = &self.corners;
        let corner = |[x, y, z]: &[[f32; WIDTH]; 3]| [x[lane], y[lane], z[lane]];
        [corner(a), corner(b), corner(c)]
    }

    /// The lanes that hold a triangle.
    pub fn lanes(&self) -> impl Iterator<Item = usize> {
        (0..WIDTH).filter(|&lane| !self.corners[0][0][lane].is_nan())
    }
}
