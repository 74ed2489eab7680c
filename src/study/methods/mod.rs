//! The registry: every known method, once. Tests, the study, its charts and its tables read this and nothing else.
//!
//! A file a step. Methods of one formula in two precisions are one generic function and two entries.

pub mod boxes;
pub mod clipping;
pub mod depth;
pub mod normals;
pub mod object_space;
pub mod picks;
pub mod planes;
pub mod rays;
pub mod spheres;
pub mod triangles;
pub mod usual;

use super::step::{About, Case, Method, Precision};

/// What is known about a method without running it.
#[derive(Clone, Copy, Debug)]
pub struct MethodInfo {
    /// The step that it does.
    pub step: About,
    /// Its name.
    pub name: &'static str,
    /// What it computes with.
    pub precision: Precision,
    /// Where it is from.
    pub source: &'static str,
    /// Whether it is what this program does.
    pub ours: bool,
}

impl MethodInfo {
    /// What is known about a method.
    #[must_use]
    pub fn of<C: Case>(method: &Method<C>) -> Self {
        Self {
            step: C::ABOUT,
            name: method.name,
            precision: method.precision,
            source: method.source,
            ours: method.ours,
        }
    }
}

/// Something that is done for each step.
pub trait Visitor {
    /// Does it for one.
    fn visit<C: Case>(&mut self);
}

/// The steps of a pick, in order: the one list of them.
pub fn each_step(visitor: &mut impl Visitor) {
    visitor.visit::<rays::PixelCase>();
    visitor.visit::<object_space::PlacedCase>();
    visitor.visit::<triangles::TriangleCase>();
    visitor.visit::<spheres::SphereCase>();
    visitor.visit::<boxes::BoxCase>();
    visitor.visit::<planes::PlaneCase>();
    visitor.visit::<clipping::ClipCase>();
    visitor.visit::<normals::NormalCase>();
    visitor.visit::<depth::DepthCase>();
    visitor.visit::<picks::PickCase>();
}

/// Every method of every step.
#[must_use]
pub fn registry() -> Vec<MethodInfo> {
    let mut list = List(Vec::new());
    each_step(&mut list);
    list.0
}

struct List(Vec<MethodInfo>);

impl Visitor for List {
    fn visit<C: Case>(&mut self) {
        self.0.extend(C::METHODS.iter().map(MethodInfo::of));
    }
}
