//! Builds a tree top down, on several threads.
//!
//! A job is a range of triangles. A large job makes one top node and up to eight more jobs: the range with the largest
//! surface is cut in two, again and again. A small job becomes a whole small tree, built by one thread: first a binary
//! one, out of which the best nodes are made. In the end the small trees are stored one after another, behind the top
//! nodes.

use super::{
    Bvh,
    build_primitive::BuildPrimitive,
    collapse::{BinaryTree, Index, Tree},
    node::{CacheLine, Child, Leaf, Node, Place, WIDTH},
    simd::{Instructions, with_large_pages},
    split::{Range, Whole},
    tree_ray::Frame,
};
use crate::geometry::{Aabb, shares::cores};
use glam::Vec3A;
use std::{
    sync::{
        Condvar, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    thread,
};

/// From this many triangles on, several threads build.
const WORTH_THREADS: usize = 20_000;
/// About how many jobs a thread gets: enough that none is idle for long at the end.
const JOBS_PER_THREAD: usize = 16;

/// See [`Bvh::build`].
pub(super) fn build(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    instructions: Instructions,
    stop: &AtomicBool,
) -> Option<Bvh> {
    let count = u32::try_from(triangles.len())
        .ok()
        .filter(|count| (1..=1 << 27).contains(count))?;
    let mut vertices = Vertices {
        positions,
        triangles,
        scale: 1.0,
    };
    let is_small = triangles.len() < WORTH_THREADS;
    let threads = if is_small { 1 } else { cores() };
    let mut primitives = with_large_pages(triangles.len());
    primitives.extend((0..count).map(|i| vertices.primitive(i)));
    let mut all = instructions.run(Whole(&mut primitives));
    vertices.scale = vertices.scale_within(all.bounds())?;
    #[expect(clippy::float_cmp, reason = "a power of two")]
    if vertices.scale != 1.0 {
        all = all.anew(|triangle| vertices.primitive(triangle), instructions);
    }
    let [min, max] = all.bounds();
    let site = Site {
        vertices,
        instructions,
        small: triangles.len() / (threads * JOBS_PER_THREAD),
        stop,
        progress: Mutex::new(Progress::starting_with(all)),
        news: Condvar::new(),
    };
    thread::scope(|scope| {
        // Where the system gives no more threads, those that are there do it all.
        let mut others = 1..threads;
        let start = |_| {
            thread::Builder::new()
                .spawn_scoped(scope, || site.work())
                .is_ok()
        };
        let _ = others.all(start);
        site.work();
    });
    let progress = (site.progress.into_inner()).unwrap_or_else(PoisonError::into_inner);
    let (top, grown, is_given_up) = (progress.top, progress.grown, progress.is_given_up);
    drop(primitives);
    if is_given_up {
        return None;
    }
    Some(Bvh {
        lines: assemble(top, grown),
        frame: Frame {
            bounds: Aabb {
                min: min.as_dvec3(),
                max: max.as_dvec3(),
            },
            most: min.abs().max(max.abs()).max_element(),
            scale: vertices.scale.into(),
            unscale: 1.0 / f64::from(vertices.scale),
        },
        instructions,
    })
}

/// Triangles to be built, and the child of a top node that they become.
struct Job<'a> {
    range: Range<'a>,
    /// The top node and the lane of its child; `None` for the root.
    parent: Option<(usize, usize)>,
}

/// A small tree, and the child of a top node that it becomes.
struct Grown {
    parent: (usize, usize),
    root: Place,
    lines: Vec<CacheLine>,
}

/// What the threads share.
struct Progress<'a> {
    waiting: Vec<Job<'a>>,
    /// Jobs that wait or are worked on.
    open: usize,
    top: Vec<Node>,
    grown: Vec<Grown>,
    /// Whether a job was dropped: `stop` was set.
    is_given_up: bool,
}

impl<'a> Progress<'a> {
    fn starting_with(all: Range<'a>) -> Self {
        let root = Job {
            range: all,
            parent: None,
        };
        Self {
            waiting: vec![root],
            open: 1,
            top: Vec::new(),
            grown: Vec::new(),
            is_given_up: false,
        }
    }
}

/// The top nodes, then each small tree.
fn assemble(mut top: Vec<Node>, grown: Vec<Grown>) -> Vec<CacheLine> {
    let mut line = top.len() * Node::LINES;
    for Grown {
        parent: (node, lane),
        root,
        lines,
    } in &grown
    {
        let node_place = Place::new(node * Node::LINES, false);
        let place = Place::new(line, root.is_leaf());
        top[*node].children[*lane] = Child::between(node_place, place);
        line += lines.len();
    }
    let mut all = with_large_pages(line);
    all.extend(top.iter().flat_map(Node::lines));
    for small in grown {
        all.extend_from_slice(&small.lines);
    }
    all
}

struct Site<'a> {
    vertices: Vertices<'a>,
    instructions: Instructions,
    /// Ranges up to this many triangles are built by one thread.
    small: usize,
    stop: &'a AtomicBool,
    progress: Mutex<Progress<'a>>,
    news: Condvar,
}

impl<'a> Site<'a> {
    /// Takes jobs until none is left. Each thread runs this.
    fn work(&self) {
        while let Some(job) = self.next() {
            let is_done = self.finish(job).is_some();
            let mut progress = self.lock();
            progress.is_given_up |= !is_done;
            progress.open -= 1;
            drop(progress);
            self.news.notify_all();
        }
    }

    /// Does a job; `None` where `stop` was set.
    fn finish(&self, job: Job<'a>) -> Option<()> {
        match job.parent {
            _ if self.stop.load(Ordering::Relaxed) => return None,
            Some(parent) if job.range.len() <= self.small.max(WIDTH) => {
                // This capacity is enough for almost all trees.
                let mut lines = Vec::with_capacity(job.range.len());
                let tree = BinaryTree::over(job.range, self.instructions, self.stop)?;
                let root = self.store(&tree, tree.root(), &mut lines);
                self.lock().grown.push(Grown {
                    parent,
                    root,
                    lines,
                });
            }
            parent => self.divide(job.range, parent),
        }
        Some(())
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
    fn divide(&self, range: Range<'a>, parent: Option<(usize, usize)>) {
        let parts = range.split_wide(self.instructions);
        let mut progress = self.lock();
        let index = progress.top.len();
        if let Some((node, lane)) = parent {
            let [node_place, place] = [node, index].map(|i| Place::new(i * Node::LINES, false));
            progress.top[node].children[lane] = Child::between(node_place, place);
        }
        let node = node_about(parts.iter().map(Range::bounds));
        progress.top.push(node);
        progress.open += parts.len();
        let jobs = parts.into_iter().enumerate().map(|(lane, range)| Job {
            range,
            parent: Some((index, lane)),
        });
        progress.waiting.extend(jobs);
    }

    /// Adds the nodes and leaves for a binary node's triangles to `lines`, and returns the place of the first.
    fn store(&self, tree: &BinaryTree, from: Index, lines: &mut Vec<CacheLine>) -> Place {
        let children = match tree.tree(from) {
            Tree::Leaf(primitives) => {
                let place = Place::new(lines.len(), true);
                lines.extend(self.vertices.leaf(primitives).lines());
                return place;
            }
            Tree::Node(children) => children,
        };
        let place = Place::new(lines.len(), false);
        lines.extend(node_about(children.iter().map(|&child| tree.bounds(child))).lines());
        for (lane, child) in children.into_iter().enumerate() {
            let child = self.store(tree, child, lines);
            Node::at_mut(lines, place).children[lane] = Child::between(place, child);
        }
        place
    }
}

/// A node with these boxes, and no children yet.
fn node_about(boxes: impl Iterator<Item = [Vec3A; 2]>) -> Node {
    Node::about(boxes.map(|corners| corners.map(|corner| corner.to_array())))
}

/// A mesh's vertices, scaled to the tree's unit of length.
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

    /// The power of two that scales triangles within a box so that products of coordinates neither underflow nor
    /// overflow; `None` where scaling would change a coordinate.
    fn scale_within(&self, [min, max]: [Vec3A; 2]) -> Option<f32> {
        const SAFE: f32 = 1_073_741_824.0; // 2^30
        let largest = min.abs().max(max.abs()).max_element();
        if largest == 0.0 || (1.0 / SAFE..=SAFE).contains(&largest) {
            return Some(1.0);
        }
        let biased = i32::from((largest.to_bits() >> 23) as u16);
        let exponent = (biased - 127).clamp(-126, 126);
        let (scale, unscale) = (2_f32.powi(-exponent), 2_f32.powi(exponent));
        let kept = |x: &f32| ((x * scale) * unscale).to_bits() == x.to_bits();
        let mut corners = self.triangles.as_flattened().iter();
        let are_kept = corners.all(|&i| self.positions[i as usize].iter().all(kept));
        are_kept.then_some(scale)
    }

    fn primitive(&self, triangle: u32) -> BuildPrimitive {
        let [a, b, c] = self.corners(triangle).map(Vec3A::from_array);
        BuildPrimitive::new(triangle, a.min(b).min(c), a.max(b).max(c))
    }

    fn leaf(&self, primitives: &[BuildPrimitive]) -> Leaf {
        let mut leaf = Leaf::EMPTY;
        for (lane, primitive) in primitives.iter().enumerate() {
            leaf.triangles[lane] = primitive.triangle();
            for (corner, position) in self.corners(primitive.triangle()).into_iter().enumerate() {
                for (axis, x) in position.into_iter().enumerate() {
                    leaf.corners[corner][axis][lane] = x;
                }
            }
        }
        leaf
    }
}
