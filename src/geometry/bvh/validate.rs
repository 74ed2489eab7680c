//! Whether a tree is what it says that it is.

use super::{
    Bvh,
    node::{Child, WIDTH},
    ray::Place,
};

impl Bvh {
    /// Checks that the tree holds each of `triangles` once, with its corners to the bit, that every box covers what is
    /// below it, and that each node and packet is reached once.
    ///
    /// # Errors
    /// What is wrong, for whoever repairs the builder.
    pub fn validate(&self, positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Result<(), String> {
        let mut seen = vec![false; triangles.len()];
        let (mut nodes, mut packets) = (0, 0);
        let Place { bounds, scale, .. } = self.place;
        let everywhere = [bounds.min, bounds.max].map(|v| v.as_vec3().to_array());
        // Each with the box that it must lie in.
        let mut open = vec![(Child::node(0), everywhere)];
        while let Some((child, bounds)) = open.pop() {
            if child == Child::NONE {
                return Err("a box leads nowhere".into());
            }
            if child.is_packet() {
                packets += 1;
                let packet = (self.packets.get(child.index()))
                    .ok_or_else(|| format!("{child:?} does not exist"))?;
                for (triangle, corners) in packet.iter() {
                    let place = seen.get_mut(triangle as usize);
                    let place = place.ok_or_else(|| format!("{triangle} does not exist"))?;
                    if std::mem::replace(place, true) {
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
            nodes += 1;
            let node = (self.nodes.get(child.index()))
                .ok_or_else(|| format!("{child:?} does not exist"))?;
            for lane in 0..WIDTH {
                let inner = node.bounds(lane);
                if node.children[lane] == Child::NONE && inner[0] > inner[1] {
                    continue;
                }
                if !inner.iter().all(|&corner| holds(bounds, corner)) {
                    return Err(format!("a box of {child:?} is outside of the node's own"));
                }
                open.push((node.children[lane], inner));
            }
        }
        if (nodes, packets) != (self.nodes.len(), self.packets.len()) {
            return Err("some nodes or packets are not reached once".into());
        }
        let lost = seen.iter().position(|seen| !seen);
        lost.map_or(Ok(()), |lost| Err(format!("triangle {lost} is lost")))
    }
}

fn holds([min, max]: [[f32; 3]; 2], corner: [f32; 3]) -> bool {
    (0..3).all(|axis| min[axis] <= corner[axis] && corner[axis] <= max[axis])
}
