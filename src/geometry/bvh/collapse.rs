//! Makes nodes of eight out of a binary tree, at the least expected cost (Ylitie, Karras & Laine, "Efficient Incoherent
//! Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017).
//!
//! A node costs its surface area, since rays enter it in proportion to that. A leaf costs nothing, since every choice
//! has the same leaves. Dynamic programming finds, for each binary node, the least cost of covering it by a forest of
//! at most k trees, for k from 1 to 7. A single tree is a leaf, or a node of up to eight trees. A forest of several is
//! shared out between both children of the binary node, at the least cost.

use super::{build_primitive::BuildPrimitive, node::WIDTH, simd::Instructions, split::Range};
use glam::Vec3A;
use std::sync::atomic::{AtomicBool, Ordering};

/// A binary tree over a range of triangles, cut down to leaves.
pub(super) struct BinaryTree<'a> {
    /// Each comes after its parts: the root is the last.
    nodes: Vec<BinaryNode<'a>>,
}

/// A node of a [`BinaryTree`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Index(usize);

struct BinaryNode<'a> {
    bounds: [Vec3A; 2],
    costs: Costs,
    content: Content<'a>,
}

enum Content<'a> {
    Leaf(&'a [BuildPrimitive]),
    Parts([Index; 2]),
}

/// A single tree over a binary node.
pub(super) enum Tree<'a> {
    /// Up to eight triangles.
    Leaf(&'a [BuildPrimitive]),
    /// A node over up to eight trees.
    Node(Vec<Index>),
}

/// The least cost of covering a binary node with at most one tree, with at most two, and so on.
type Costs = [f32; WIDTH - 1];

impl<'a> BinaryTree<'a> {
    /// Cuts the range; `None` where `stop` was set meanwhile.
    pub fn over(range: Range<'a>, instructions: Instructions, stop: &AtomicBool) -> Option<Self> {
        // Almost always enough: leaves are seldom less than half full.
        let mut tree = Self {
            nodes: Vec::with_capacity(range.len() / 2),
        };
        tree.cut(range, instructions, stop)?;
        Some(tree)
    }

    pub fn root(&self) -> Index {
        Index(self.nodes.len() - 1)
    }

    /// The corners of the box about a node.
    pub fn bounds(&self, node: Index) -> [Vec3A; 2] {
        self.nodes[node.0].bounds
    }

    /// A single tree over a binary node.
    pub fn tree(&self, node: Index) -> Tree<'a> {
        match self.nodes[node.0].content {
            Content::Leaf(primitives) => Tree::Leaf(primitives),
            Content::Parts(parts) => {
                let mut children = Vec::with_capacity(WIDTH);
                let (_, shares) = self.best_shares(parts, WIDTH);
                self.cover_both(parts, shares, &mut children);
                Tree::Node(children)
            }
        }
    }

    /// Adds the nodes over a range, and returns the last of them; `None` where `stop` was set.
    fn cut(
        &mut self,
        range: Range<'a>,
        instructions: Instructions,
        stop: &AtomicBool,
    ) -> Option<Index> {
        let bounds = range.bounds();
        let area = range.area();
        let (costs, content) = if range.len() <= WIDTH {
            ([0.0; WIDTH - 1], Content::Leaf(range.primitives))
        } else if stop.load(Ordering::Relaxed) {
            return None;
        } else {
            let [a, b] = range.split(instructions);
            let parts = [
                self.cut(a, instructions, stop)?,
                self.cut(b, instructions, stop)?,
            ];
            (self.costs(area, parts), Content::Parts(parts))
        };
        self.nodes.push(BinaryNode {
            bounds,
            costs,
            content,
        });
        Some(self.root())
    }

    /// The costs of a binary node with this surface.
    fn costs(&self, area: f32, parts: [Index; 2]) -> Costs {
        let mut costs = [area + self.best_shares(parts, WIDTH).0; WIDTH - 1];
        for trees in 2..WIDTH {
            costs[trees - 1] = costs[trees - 2].min(self.best_shares(parts, trees).0);
        }
        costs
    }

    /// The least cost of covering both parts with at most so many trees, and how many of these each part gets.
    fn best_shares(&self, parts: [Index; 2], trees: usize) -> (f32, [usize; 2]) {
        let [first, second] = parts.map(|part| &self.nodes[part.0].costs);
        let mut best = (f32::INFINITY, [1, trees - 1]);
        for of_first in 1..trees {
            let of_second = trees - of_first;
            let cost = first[of_first - 1] + second[of_second - 1];
            if cost < best.0 {
                best = (cost, [of_first, of_second]);
            }
        }
        best
    }

    /// Covers each part with at most so many trees, and adds these.
    fn cover_both(&self, parts: [Index; 2], most: [usize; 2], into: &mut Vec<Index>) {
        for (part, most) in parts.into_iter().zip(most) {
            self.cover(part, most, into);
        }
    }

    /// Covers a node with at most so many trees, and adds these.
    fn cover(&self, node: Index, most: usize, into: &mut Vec<Index>) {
        let BinaryNode { costs, content, .. } = &self.nodes[node.0];
        match *content {
            Content::Parts(parts) if most > 1 => {
                let (cost, shares) = self.best_shares(parts, most);
                if cost < costs[most - 2] {
                    self.cover_both(parts, shares, into);
                } else {
                    self.cover(node, most - 1, into);
                }
            }
            _ => into.push(node),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{
        bvh::{simd::Simd, split::Whole},
        random::Random,
    };

    /// The least cost of a tree over a node, found by trying all that a node of eight may hold.
    fn least_cost(tree: &BinaryTree, node: Index) -> f32 {
        let covers = match tree.nodes[node.0].content {
            Content::Leaf(_) => return 0.0,
            Content::Parts(parts) => covers_of_both(tree, parts),
        };
        let costs = covers.iter().map(|cover| {
            let costs = cover.iter().map(|&node| least_cost(tree, node));
            costs.sum::<f32>()
        });
        area(tree, node) + costs.fold(f32::INFINITY, f32::min)
    }

    /// All ways to cover two nodes with at most eight nodes.
    fn covers_of_both(tree: &BinaryTree, parts: [Index; 2]) -> Vec<Vec<Index>> {
        let [first, second] = parts.map(|part| covers(tree, part));
        let pairs = (first.iter()).flat_map(|a| second.iter().map(|b| [&**a, &**b].concat()));
        pairs.filter(|cover| cover.len() <= WIDTH).collect()
    }

    /// All ways to cover a node: by itself, or by what covers its parts.
    fn covers(tree: &BinaryTree, node: Index) -> Vec<Vec<Index>> {
        let mut all = vec![vec![node]];
        if let Content::Parts(parts) = tree.nodes[node.0].content {
            all.extend(covers_of_both(tree, parts));
        }
        all
    }

    fn area(tree: &BinaryTree, node: Index) -> f32 {
        let [min, max] = tree.bounds(node);
        let size = max - min;
        size.x * size.y + size.y * size.z + size.z * size.x
    }

    /// The cost of the tree as it is made, and how many leaves it has.
    fn made(tree: &BinaryTree, node: Index) -> (f32, usize) {
        let Tree::Node(children) = tree.tree(node) else {
            return (0.0, 1);
        };
        assert!((2..=WIDTH).contains(&children.len()));
        let below = children.into_iter().map(|child| made(tree, child));
        below.fold((area(tree, node), 0), |a, b| (a.0 + b.0, a.1 + b.1))
    }

    /// No choice of nodes costs less, over triangles scattered evenly and unevenly; no leaf is lost.
    #[test]
    fn no_nodes_cost_less() {
        let mut random = Random(11);
        let instructions = Instructions::of(Simd::fastest()).expect("it is available");
        let mut gained = 0;
        for round in 0..40_u32 {
            let mut primitives: Vec<_> = (0..70 + round)
                .map(|i| {
                    let spread = if round % 2 == 0 { 1.0 } else { f64::from(i) };
                    let corner = (spread * random.point()).as_vec3a();
                    BuildPrimitive::new(i, corner, corner + random.point().abs().as_vec3a())
                })
                .collect();
            let all = instructions.run(Whole(&mut primitives));
            let tree = BinaryTree::over(all, instructions, &AtomicBool::new(false));
            let tree = tree.expect("nobody stops it");
            let is_leaf = |node: &&BinaryNode| matches!(node.content, Content::Leaf(_));
            let leaves = tree.nodes.iter().filter(is_leaf).count();
            let (cost, kept) = made(&tree, tree.root());
            assert_eq!(kept, leaves);
            let least = least_cost(&tree, tree.root());
            let is_least = (cost - least).abs() <= 1e-5 * least;
            assert!(is_least, "round {round}: {cost}, but {least} is possible");
            gained += usize::from(leaves > WIDTH);
        }
        assert!(gained >= 30, "in {gained} of 40 there was a choice");
    }
}
