//! The view and the pick as a command line that reproduces both, to the bit.

use super::{hits::RayHits, state::State};
use crate::{
    camera::{DepthMapping, Projection, SectionChoice, UpAxis, View},
    geometry::Sides,
};
use glam::{DVec2, DVec3};
use std::{fmt::Write, path::Path};

/// The `sightline pick` command that repeats a click in its view. Where a surface behind the first is picked, the
/// command lists all surfaces.
pub(in crate::viewer) fn pick_command(state: &State, ray: &RayHits) -> String {
    let command = pick_at(state, &ray.view, ray.px);
    match ray.at {
        None | Some(0) => command,
        Some(_) => format!("{command} --all-hits"),
    }
}

/// The `sightline pick` command that repeats the pick; without a pick, it picks in the middle of the camera's picture.
pub(in crate::viewer) fn view_command(state: &State) -> String {
    let view = state.view();
    state.pick_ray().map_or_else(
        || pick_at(state, view, view.viewport.size_px() / 2.0),
        |ray| pick_command(state, ray),
    )
}

/// The `sightline verify` command for what the window shows now.
pub(in crate::viewer) fn verify_command(state: &State) -> String {
    line(state, state.view(), "verify")
}

fn pick_at(state: &State, view: &View, at_px: DVec2) -> String {
    format!("{} --at {},{}", line(state, view, "pick"), at_px.x, at_px.y)
}

/// The command line of `command`, for the scene in a view.
fn line(state: &State, view: &View, command: &str) -> String {
    let camera = &view.camera;
    let lens = camera.lens();
    let mut line = format!("sightline {command}");
    for path in &state.source().paths {
        let _ = write!(line, " {}", argument(path));
    }
    let mut flag = |name: &str, value: String| {
        let _ = write!(line, " --{name} {value}");
    };
    let (width, height) = (view.viewport.width(), view.viewport.height());
    flag("size", format!("{width}x{height}"));
    flag("eye", triple(camera.eye()));
    flag("target", triple(camera.target()));
    flag("up", triple(camera.up_hint()));
    let set_deg = state.controls().fov_deg;
    let set = Projection::Perspective {
        fov_y: set_deg.to_radians(),
    };
    match lens.projection {
        // The panel's own number, if this view has it.
        projection if projection == set => flag("fov", set_deg.to_string()),
        Projection::Perspective { fov_y } => flag("fov", degrees(fov_y).to_string()),
        Projection::Orthographic { height } => flag("ortho", height.to_string()),
    }
    flag("near", lens.near.to_string());
    flag("far", lens.far.to_string());
    if state.up_axis() == UpAxis::Z {
        flag("up-axis", "z".into());
    }
    if lens.depth == DepthMapping::Standard {
        flag("depth", lens.depth.to_string());
    }
    if let Some(section) = view.section {
        flag("section", SectionChoice::Plane(section).to_string());
    }
    let filed = &state.filed.shown;
    let is_hidden_in_file = |index: usize| filed.get(index) == Some(&false);
    for (name, visible) in [("hide", false), ("show", true)] {
        let objects = state.scene().objects().iter().enumerate();
        let ids = objects.filter(|(index, object)| {
            object.visible == visible && (!visible || is_hidden_in_file(*index))
        });
        let ids: Vec<String> = ids.map(|(index, _)| (index + 1).to_string()).collect();
        if !ids.is_empty() {
            flag(name, ids.join(","));
        }
    }
    if view.sides == Sides::Front {
        line.push_str(" --cull");
    }
    line
}

/// The degrees that convert to exactly these radians. `to_degrees` may round to a neighbour of them.
pub(crate) fn degrees(radians: f64) -> f64 {
    let near = radians.to_degrees();
    let beside = [near, near.next_up(), near.next_down()];
    let same = |degrees: &f64| degrees.to_radians().to_bits() == radians.to_bits();
    beside.into_iter().find(same).unwrap_or(near)
}

fn triple(v: DVec3) -> String {
    format!("{},{},{}", v.x, v.y, v.z)
}

/// A file as an argument: one that begins like a flag is named by its folder too.
fn argument(path: &Path) -> String {
    let name = path.display().to_string();
    let folder = if name.starts_with('-') { "./" } else { "" };
    quoted(&format!("{folder}{name}"))
}

/// Quoted for a POSIX shell.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+=:,@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::argument;
    use std::path::Path;

    #[test]
    fn a_file_is_no_flag_and_one_word() {
        for (file, word) in [
            ("/a/b.obj", "/a/b.obj"),
            ("-x.obj", "./-x.obj"),
            ("--help", "./--help"),
            ("two words.obj", "'two words.obj'"),
            ("-it's", r"'./-it'\''s'"),
        ] {
            assert_eq!(argument(Path::new(file)), word);
        }
    }
}
