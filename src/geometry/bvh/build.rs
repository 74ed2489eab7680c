//! How a tree is built: top down, on several threads.
//!
//! Ranges of triangles are jobs until they are small, and each makes a node and up to eight jobs more; a thread builds
//! a small one alone. In the end the small trees are put behind each other.

use super::{
    Bvh,
    node::{Child, Node, Packet, Plane, WIDTH},
    ray::Place,
    split::{Leaf, Range},
};
use crate::geometry::Aabb;
use glam::Vec4;
use std::{
    num::NonZero,
    sync::{
        Condvar, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    thread,
};

/// Triangles from which on a tree is built by several threads.
const WORTH_THREADS: usize = 20_000;
/// Jobs for each thread, about: enough that none is idle for long at the end.
const JOBS_PER_THREAD: usize = 16;

/// See [`Bvh::build`].
pub(super) fn build(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    stop: &AtomicBool,
) -> Option<Bvh> {
    let count = u32::try_from(triangles.len())
        .ok()
        .filter(|count| (1..=1 << 30).contains(count))?;
    let vertices = Vertices {
        positions,
        triangles,
        scale: scale(positions)?,
    };
    let threads = if triangles.len() < WORTH_THREADS {
        1
    } else {
        thread::available_parallelism().map_or(1, NonZero::get)
    };
    let mut leaves: Vec<Leaf> = (0..count).map(|i| vertices.leaf(i)).collect();
    let all = Range::new(&mut leaves);
    let [min, max] = all.bounds().map(Vec4::truncate);
    let site = Site {
        vertices,
        small: triangles.len() / (threads * JOBS_PER_THREAD),
        stop,
        progress: Mutex::new(Progress::starting_with(all)),
        news: Condvar::new(),
    };
    thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(|| site.work());
        }
        site.work();
    });
    let progress = (site.progress.into_inner()).unwrap_or_else(PoisonError::into_inner);
    let Progress { top, done, .. } = progress;
    drop(leaves);
    if stop.load(Ordering::Relaxed) {
        return None;
    }
    let (nodes, packets) = assemble(top, done);
    Some(Bvh {
        nodes,
        packets,
        place: Place {
            bounds: Aabb {
                min: min.as_dvec3(),
                max: max.as_dvec3(),
            },
            most: min.abs().max(max.abs()).max_element(),
            scale: vertices.scale.into(),
        },
    })
}

/// The power of two that brings coordinates to where products of them neither vanish nor overflow; `None` where it would
/// change one of them.
fn scale(positions: &[[f32; 3]]) -> Option<f32> {
    const SAFE: f32 = 1_073_741_824.0; // 2^30
    let coordinates = positions.as_flattened();
    let largest = coordinates.iter().fold(0.0_f32, |m, x| m.max(x.abs()));
    if largest == 0.0 || (1.0 / SAFE..=SAFE).contains(&largest) {
        return Some(1.0);
    }
    #[expect(clippy::cast_possible_truncation, reason = "within 150")]
    let exponent = (largest.log2() as i32).clamp(-126, 126);
    let (scale, unscale) = (2_f32.powi(-exponent), 2_f32.powi(exponent));
    let kept = |x: &f32| ((x * scale) * unscale).to_bits() == x.to_bits();
    coordinates.iter().all(kept).then_some(scale)
}

/// Triangles that become the given child of one of the top nodes.
struct Job<'a> {
    range: Range<'a>,
    depth: usize,
    /// Node and lane; none for the root.
    parent: Option<(usize, usize)>,
}

/// A small tree on its own.
#[derive(Default)]
struct Grown {
    nodes: Vec<Node>,
    packets: Vec<Packet>,
}

/// A child of a top node, and what hangs there.
struct Done {
    parent: (usize, usize),
    root: Child,
    grown: Grown,
}

/// What the threads share.
struct Progress<'a> {
    waiting: Vec<Job<'a>>,
    /// Jobs that wait or are worked on.
    open: usize,
    top: Vec<Node>,
    done: Vec<Done>,
}

impl<'a> Progress<'a> {
    fn starting_with(all: Range<'a>) -> Self {
        let root = Job {
            range: all,
            depth: 0,
            parent: None,
        };
        Self {
            waiting: vec![root],
            open: 1,
            top: Vec::new(),
            done: Vec::new(),
        }
    }
}

/// The top nodes, then each small tree.
fn assemble(mut nodes: Vec<Node>, done: Vec<Done>) -> (Vec<Node>, Vec<Packet>) {
    let mut packets = Vec::new();
    nodes.reserve_exact(done.iter().map(|done| done.grown.nodes.len()).sum());
    packets.reserve_exact(done.iter().map(|done| done.grown.packets.len()).sum());
    for Done {
        parent: (node, lane),
        root,
        grown,
    } in done
    {
        let before = (nodes.len(), packets.len());
        nodes[node].children[lane] = root.shifted(before.0, before.1);
        packets.extend(grown.packets);
        nodes.extend(grown.nodes.into_iter().map(|mut node| {
            node.children = (node.children).map(|child| child.shifted(before.0, before.1));
            node
        }));
    }
    (nodes, packets)
}

struct Site<'a> {
    vertices: Vertices<'a>,
    /// Triangles up to which a range is one thread's.
    small: usize,
    stop: &'a AtomicBool,
    progress: Mutex<Progress<'a>>,
    news: Condvar,
}

impl<'a> Site<'a> {
    /// What each thread does, until no job is left.
    fn work(&self) {
        while let Some(job) = self.next() {
            match job.parent {
                _ if self.stop.load(Ordering::Relaxed) => {}
                Some(parent) if job.range.len() <= self.small.max(WIDTH) => {
                    let mut grown = Grown::default();
                    let root = self.grow(&mut grown, job.range, job.depth);
                    let done = Done {
                        parent,
                        root,
                        grown,
                    };
                    self.lock().done.push(done);
                }
                parent => self.divide(job.range, job.depth, parent),
            }
            self.lock().open -= 1;
            self.news.notify_all();
        }
    }

    /// The largest job that waits; `None` when all are done.
    fn next(&self) -> Option<Job<'a>> {
        let mut progress = self.lock();
        loop {
            let waiting = progress.waiting.iter().enumerate();
            if let Some((largest, _)) = waiting.max_by_key(|(_, job)| job.range.len()) {
                return Some(progress.waiting.swap_remove(largest));
            }
            if progress.open == 0 {
                return None;
            }
            progress = (self.news.wait(progress)).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn lock(&self) -> MutexGuard<'_, Progress<'a>> {
        self.progress.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Makes a top node and a job for each of its children.
    fn divide(&self, range: Range<'a>, depth: usize, parent: Option<(usize, usize)>) {
        let parts = range.split_wide(depth);
        let mut progress = self.lock();
        let index = progress.top.len();
        if let Some((node, lane)) = parent {
            progress.top[node].children[lane] = Child::node(index);
        }
        progress.top.push(node_of(&parts));
        progress.open += parts.len();
        let jobs = parts.into_iter().enumerate().map(|(lane, range)| Job {
            range,
            depth: depth + 1,
            parent: Some((index, lane)),
        });
        progress.waiting.extend(jobs);
    }

    /// Adds what becomes of `range` to `grown`.
    fn grow(&self, grown: &mut Grown, range: Range, depth: usize) -> Child {
        if range.len() <= WIDTH {
            grown.packets.push(self.vertices.packet(range.leaves()));
            return Child::packet(grown.packets.len() - 1);
        }
        let index = grown.nodes.len();
        if self.stop.load(Ordering::Relaxed) {
            return Child::NONE;
        }
        let parts = range.split_wide(depth);
        grown.nodes.push(node_of(&parts));
        for (lane, part) in parts.into_iter().enumerate() {
            let child = self.grow(grown, part, depth + 1);
            grown.nodes[index].children[lane] = child;
        }
        Child::node(index)
    }
}

/// A node with the boxes of `parts`, of which nothing is known yet but that.
fn node_of(parts: &[Range]) -> Node {
    let mut node = Node::EMPTY;
    for (lane, part) in parts.iter().enumerate() {
        for (side, corner) in [Plane::MIN, Plane::MAX].into_iter().zip(part.bounds()) {
            for (plane, x) in side.into_iter().zip(corner.to_array()) {
                node.planes[plane as usize][lane] = x;
            }
        }
    }
    node
}

/// Vertices in the tree's lengths.
#[derive(Clone, Copy)]
struct Vertices<'a> {
    positions: &'a [[f32; 3]],
    triangles: &'a [[u32; 3]],
    scale: f32,
}

impl Vertices<'_> {
    fn corners(&self, triangle: u32) -> [[f32; 3]; 3] {
        self.triangles[triangle as usize]
            .map(|i| self.positions[i as usize].map(|x| x * self.scale))
    }

    fn leaf(&self, triangle: u32) -> Leaf {
        let [a, b, c] = self
            .corners(triangle)
            .map(|[x, y, z]| Vec4::new(x, y, z, 0.0));
        Leaf::new(triangle, a.min(b).min(c), a.max(b).max(c))
    }

    fn packet(&self, leaves: &[Leaf]) -> Packet {
        let mut packet = Packet::EMPTY;
        for (lane, leaf) in leaves.iter().enumerate() {
            packet.triangles[lane] = leaf.triangle();
            for (corner, position) in self.corners(leaf.triangle()).into_iter().enumerate() {
                for (axis, x) in position.into_iter().enumerate() {
                    packet.corners[corner][axis][lane] = x;
                }
            }
        }
        packet
    }
}
