//! The view and the pick as a command line that gives both again, to the bit.

use super::state::State;
use crate::{
    camera::{DepthMapping, Projection, UpAxis},
    geometry::Sides,
};
use glam::{DVec2, DVec3};
use std::fmt::Write;

/// `sightline pick` with all that the window shows now, at a pixel position.
pub(in crate::viewer) fn pick_command(state: &State, at_px: DVec2) -> String {
    format!("{} --at {},{}", line(state, "pick"), at_px.x, at_px.y)
}

/// `sightline verify` with all that the window shows now.
pub(in crate::viewer) fn verify_command(state: &State) -> String {
    line(state, "verify")
}

/// A command about what the window shows now.
fn line(state: &State, command: &str) -> String {
    let (scene, view) = state.world();
    let camera = &view.camera;
    let lens = camera.lens();
    let mut line = format!("sightline {command}");
    for path in &state.source().paths {
        let _ = write!(line, " {}", quoted(&path.display().to_string()));
    }
    let mut flag = |name: &str, value: String| {
        let _ = write!(line, " --{name} {value}");
    };
    flag(
        "size",
        format!("{}x{}", view.viewport.width(), view.viewport.height()),
    );
    flag("eye", triple(camera.eye()));
    flag("target", triple(camera.target()));
    flag("up", triple(camera.up_hint()));
    let set_deg = state.controls().fov_deg;
    let set = Projection::Perspective {
        fov_y: set_deg.to_radians(),
    };
    match lens.projection {
        // The panel's own number, unless it is about the stage on screen by now.
        projection if projection == set => flag("fov", set_deg.to_string()),
        Projection::Perspective { fov_y } => flag("fov", fov_y.to_degrees().to_string()),
        Projection::Orthographic { height } => flag("ortho", height.to_string()),
    }
    flag("near", lens.near.to_string());
    flag("far", lens.far.to_string());
    if state.up_axis == UpAxis::Z {
        flag("up-axis", "z".into());
    }
    if lens.depth == DepthMapping::Standard {
        flag("depth", lens.depth.to_string());
    }
    let hidden = scene
        .objects()
        .iter()
        .enumerate()
        .filter(|(_, object)| !object.visible);
    let hidden: Vec<String> = hidden.map(|(index, _)| (index + 1).to_string()).collect();
    if !hidden.is_empty() {
        flag("hide", hidden.join(","));
    }
    if view.sides == Sides::Front {
        line.push_str(" --cull");
    }
    line
}

fn triple(v: DVec3) -> String {
    format!("{},{},{}", v.x, v.y, v.z)
}

/// As a POSIX shell takes it back.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+=:,@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}
