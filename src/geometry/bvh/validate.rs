//! Checks that a tree is well formed.

use super::{
    Bvh,
    node::{Child, Leaf, Node, Place, WIDTH},
    split::DEEPEST,
    tree_ray::Frame,
};

impl Bvh {
    /// Checks that the tree holds each of `triangles` once, with its corners to the bit; that every box covers what is
    /// below it; that each node and leaf is reached once; and that none is too deep for a walk's stack.
    ///
    /// # Errors
    /// What is wrong, for whoever repairs the builder.
    pub fn validate(&self, positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Result<(), String> {
        let mut seen = vec![false; triangles.len()];
        let mut lines = 0;
        let Frame { bounds, scale, .. } = self.frame;
        let everywhere = [bounds.min, bounds.max].map(|v| v.as_vec3().to_array());
        // Places, each with the box that it must lie in and its depth.
        let mut open = vec![(Place::ROOT, everywhere, 0)];
        while let Some((place, bounds, depth)) = open.pop() {
            if depth > DEEPEST {
                return Err(format!("{place:?} is {depth} nodes deep"));
            }
            if place.is_leaf() {
                lines += Leaf::LINES;
                let leaf = Leaf::at(&self.lines, place);
                for lane in leaf.lanes() {
                    let (triangle, corners) = (leaf.triangles[lane], leaf.corners_of(lane));
                    let found = seen.get_mut(triangle as usize);
                    let found =
                        found.ok_or_else(|| format!("triangle {triangle} does not exist"))?;
                    if std::mem::replace(found, true) {
                        return Err(format!("triangle {triangle} is there twice"));
                    }
                    let scaled = |i: u32| positions[i as usize].map(|x| scale * f64::from(x));
                    if corners.map(|corner| corner.map(f64::from))
                        != triangles[triangle as usize].map(scaled)
                    {
                        return Err(format!("triangle {triangle} has moved"));
                    }
                    if !corners.iter().all(|&corner| holds(bounds, corner)) {
                        return Err(format!("triangle {triangle} is outside of its box"));
                    }
                }
                continue;
            }
            lines += Node::LINES;
            let node = Node::at(&self.lines, place);
            for lane in 0..WIDTH {
                let inner = node.bounds(lane);
                let child = node.children[lane];
                let is_empty = inner[0] > inner[1];
                if (child == Child::NONE) != is_empty {
                    return Err("a child has no box, or a box has no child".into());
                }
                if is_empty {
                    continue;
                }
                if !inner.iter().all(|&corner| holds(bounds, corner)) {
                    return Err(format!("a box of {place:?} is outside of the node's own"));
                }
                open.push((place.of(child), inner, depth + 1));
            }
        }
        if lines != self.lines.len() {
            return Err("some nodes or leaves are not reached exactly once".into());
        }
        let lost = seen.iter().position(|seen| !seen);
        lost.map_or(Ok(()), |lost| Err(format!("triangle {lost} is lost")))
    }
}

fn holds([min, max]: [[f32; 3]; 2], corner: [f32; 3]) -> bool {
    (0..3).all(|axis| min[axis] <= corner[axis] && corner[axis] <= max[axis])
}
