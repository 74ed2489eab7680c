//! Lists which method breaks on which scene of the gallery. Tests and window read this list.

use super::{
    prelude::*,
    scene_rays::px_angle,
    swap::{AnyStep, Swap},
};
use crate::{camera::View, scene::Scene};
use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, PoisonError},
};

/// A method that breaks on a scene.
#[derive(Clone, Copy, Debug)]
pub struct Break {
    /// The scene's name in the gallery.
    pub exhibit: &'static str,
    /// The step.
    pub step: AnyStep,
    /// The method.
    pub method: &'static str,
    /// Its precision.
    pub precision: Precision,
    /// The step's family whose parameter stresses the method as the scene does.
    pub family: &'static str,
    /// The parameter's value on the scene.
    pub value: f64,
    /// A lower bound of what goes wrong on the scene's own rays: the wrong decisions in per cent or, where all
    /// decisions are right, the worst error of a value in the step's unit.
    pub least: f64,
}

impl Break {
    /// The method, to pick by; `None` where the registry has no such method.
    pub fn swap(&self) -> Option<Swap> {
        let (step, key) = (self.step, (self.method, self.precision));
        let method = step.methods().iter().position(|known| known.key() == key)?;
        Some(Swap { step, method })
    }
}

/// A break as one line: the step's case, the scene, the method, the family at its value, the least that goes wrong.
macro_rules! broken {
    ($case:ty: $exhibit:literal, $method:literal $precision:ident, $family:literal $value:expr, $least:expr) => {
        Break {
            exhibit: $exhibit,
            step: AnyStep::of::<$case>(),
            method: $method,
            precision: $precision,
            family: $family,
            value: $value,
            least: $least,
        }
    };
}

/// Every known break.
pub static BREAKS: [Break; 13] = [
    broken!(TriangleCase: "far_facets", "Moeller-Trumbore" F32, "far away" 5e5, 2.0),
    broken!(PixelCase: "far_from_the_origin", "target + sx H + sy V - eye" F32,
        "eye far from the origin" 4.7e5, 1.0),
    broken!(PixelCase: "far_from_the_origin", "inverse(P V), near - eye" F32,
        "eye far from the origin" 4.7e5, 10.0),
    broken!(PlacedCase: "far_from_the_origin", "inverse(M)" F32, "far from the origin" 4.7e5, 1.0),
    broken!(PixelCase: "far_over_near", "inverse(P V), far - near" F32,
        "far plane" 1e8, f64::INFINITY),
    broken!(DepthCase: "far_over_near", "standard, 32-bit float" F32, "far plane" 1e8, 1e-4),
    broken!(SphereCase: "small_and_far", "plain quadratic" F32, "far away" 3e3, 0.2),
    broken!(NormalCase: "stretched", "M n" F64, "stretched" 10.0, 60.0),
    broken!(NormalCase: "mirrored", "cofactors" F64, "mirrored" 4.0 / 3.0, 179.0),
    broken!(ClipCase: "wide_lens", "by distance" F64, "field of view" 1.19, 50.0),
    broken!(BoxCase: "along_a_face", "slabs by min and max" F64, "starts on a slab" 2.0, 0.1),
    broken!(SquareCase: "edge_on", "N . (S - o)" F32, "grazing" 1e-4, 1e-4),
    broken!(TriangleCase: "needles", "areas, sum == 1" F32, "slivers" 1e-2, 5.0),
];

/// What breaks on a scene of the gallery.
pub fn breaks_on(exhibit: &str) -> impl Iterator<Item = &'static Break> {
    BREAKS.iter().filter(move |known| known.exhibit == exhibit)
}

/// The rows of all methods of a break's step, in the break's family and on the view's own rays (the family [`SCENE`]).
/// Errors in pixels are converted to pixels of the view. `None` once `go_on`, which is asked now and then, says no.
pub fn rows(of: &Break, scene: &Scene, view: View, go_on: &dyn Fn() -> bool) -> Option<Vec<Row>> {
    // Enough that some go through the one column of pixels on which `along_a_face` breaks.
    const RAYS: usize = 6000;
    let camera = &view.camera;
    let px = px_angle(&view, camera.eye().distance(camera.target()));
    let mut rows = family_rows(of, go_on)?.to_vec();
    for row in &mut rows {
        if row.info.step.wrong_unit == "px" {
            row.worst_wrong *= PX / px;
        }
        if row.info.step.error_unit == "px" {
            row.worst_error *= PX / px;
        }
    }
    if !go_on() {
        return None;
    }
    let own = SceneRays::new(scene, view, RAYS, Effort::QUICK.seed);
    rows.extend((of.step.rows)(SCENE, Effort::QUICK, Some(&own), go_on)?);
    Some(rows)
}

/// The rows of a break's family, in pixels of general workloads. They hang on no scene and no view, so they are kept
/// once they are there. `None` once `go_on` says no.
fn family_rows(of: &Break, go_on: &dyn Fn() -> bool) -> Option<Arc<[Row]>> {
    /// By a step's key and a family's name.
    type Kept = BTreeMap<(&'static str, &'static str), Arc<[Row]>>;
    static KEPT: Mutex<Kept> = Mutex::new(BTreeMap::new());
    let kept = || KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    let key = (of.step.about.key, of.family);
    if let Some(rows) = kept().get(&key) {
        return Some(Arc::clone(rows));
    }
    // The lock is free meanwhile: other families are looked up.
    let rows = (of.step.rows)(of.family, Effort::QUICK, None, go_on)?;
    Some(Arc::clone(kept().entry(key).or_insert(rows.into())))
}

/// The methods besides Sightline's whose mistakes cannot be seen on the scene: every decision is right, and every error
/// is below half a pixel, a degree or a ten-thousandth.
pub fn as_good(rows: &[Row]) -> impl Iterator<Item = &Row> {
    let least = |row: &Row| match row.info.step.error_unit {
        "px" => 0.5,
        "degrees" => 1.0,
        _ => 1e-4,
    };
    let is_right = move |row: &Row| row.wrong() == 0 && row.worst_error < least(row);
    let own = rows.iter().filter(|row| row.family == SCENE);
    own.filter(move |row| !row.info.ours && is_right(row))
}

/// Every method that a scene of the gallery can be picked by: first those that break on it, then the others of their
/// steps.
pub fn swaps(exhibit: &str) -> Vec<Swap> {
    let broken = breaks_on(exhibit).filter_map(Break::swap);
    let all = breaks_on(exhibit).flat_map(|known| {
        let step = known.step;
        (0..step.methods().len()).map(move |method| Swap { step, method })
    });
    distinct(broken.chain(all.filter(|swap| !swap.info().ours)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::methods::picks::ball_scene;

    /// What is kept is the rows themselves, and no view's pixels get into them.
    #[test]
    fn a_family_is_studied_once_for_all_views() {
        let of = &BREAKS[0];
        let fresh = (of.step.rows)(of.family, Effort::QUICK, None, &|| true);
        let fresh = fresh.expect("nobody stops it");
        let (scene, view) = ball_scene(0.0);
        let large = rows(of, &scene, view, &|| true).expect("nobody stops it");
        let kept = family_rows(of, &|| false).expect("it was studied");
        assert_eq!(*kept, *fresh);
        let scale = PX / px_angle(&view, 1.0);
        assert!((scale - 1.0).abs() > 0.01, "a scale that shows");
        let general = large.iter().filter(|row| row.family != SCENE);
        assert!(general.clone().count() == fresh.len() && large.len() > fresh.len());
        for (row, fresh) in general.zip(&fresh) {
            let scaled = fresh.worst_wrong * scale;
            assert_eq!(row.worst_wrong.to_bits(), scaled.to_bits());
        }
    }
}
