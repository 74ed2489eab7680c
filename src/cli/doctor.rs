//! `sightline doctor`: describes the graphics of this machine, as text for a bug report.

use super::{CliError, terminal::start_log};
use crate::{
    geometry::shares,
    render::{self, AdapterCan, AdapterFound, GpuError, Numbers},
    viewer,
};
use std::{env, fmt::Write as _, io::Write as _};

/// Arguments of `doctor`.
#[derive(Debug, clap::Args)]
pub struct DoctorArgs {
    /// Say on stderr what is being done
    #[arg(short, long)]
    pub verbose: bool,
}

/// The help text about exit codes.
pub(super) const CODES: &str = "\
Exit codes: 0 pictures and windows can be drawn, 4 no adapter draws, 5 one does, but there is no display.";

/// Environment variables that select the adapter and the display.
const VARIABLES: [&str; 7] = [
    "DISPLAY",
    "WAYLAND_DISPLAY",
    "XDG_SESSION_TYPE",
    "VK_DRIVER_FILES",
    "VK_ICD_FILENAMES",
    "WGPU_BACKEND",
    "LIBGL_ALWAYS_SOFTWARE",
];

/// The commands that work without an adapter.
const WITHOUT: &str =
    "list, pick, install-desktop, study (but for the step that draws) and render --by raycast";

/// Prints the report.
pub(super) fn run(args: &DoctorArgs) -> Result<(), CliError> {
    start_log(args.verbose);
    let display = viewer::display();
    let adapters = render::adapters();
    let mut text = format!(
        "sightline {}, {} {}, {} threads\n",
        env!("CARGO_PKG_VERSION"),
        env::consts::OS,
        env::consts::ARCH,
        shares::cores()
    );
    for name in VARIABLES {
        if let Some(value) = env::var_os(name) {
            line(&mut text, &format!("{name}={}", value.display()));
        }
    }
    match &display {
        Ok(()) => line(&mut text, "display: there is one"),
        Err(error) => line(&mut text, &format!("display: {error}")),
    }
    for (number, adapter) in (1..).zip(&adapters) {
        describe(&mut text, number, adapter);
    }
    let drawing = drawing(&adapters);
    if let Err(error) = &drawing {
        line(&mut text, &format!("drawing: {error}"));
    }
    line(&mut text, &format!("works without an adapter: {WITHOUT}"));
    let mut out = std::io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    written.map_err(CliError::stdout)?;
    drawing?;
    Ok(display?)
}

/// Whether the chosen adapter draws.
fn drawing(adapters: &[AdapterFound]) -> Result<(), GpuError> {
    let used = adapters.iter().find(|adapter| adapter.is_used);
    let used = used.ok_or(GpuError::NoAdapter)?;
    used.can.as_ref().map(|_| ()).map_err(Clone::clone)
}

fn describe(text: &mut String, number: usize, adapter: &AdapterFound) {
    let used = if adapter.is_used { ", which draws" } else { "" };
    line(text, &format!("adapter {number}{used}: {}", adapter.name));
    let [vendor, device] = adapter.numbers;
    line(
        text,
        &format!(
            "  {} by {}, driver {}, {vendor:04x}:{device:04x}",
            adapter.kind, adapter.backend, adapter.driver
        ),
    );
    match &adapter.can {
        Ok(can) => abilities(text, can),
        Err(error) => line(text, &format!("  draws nothing: {error}")),
    }
}

fn abilities(text: &mut String, can: &AdapterCan) {
    let numbers = match can.numbers {
        Numbers::Primitives => "by primitive index",
        Numbers::Corners => {
            "by corners, without a primitive index: meshes take about four times the graphics memory"
        }
        Numbers::Objects => "none, so that verify compares objects alone",
    };
    line(text, &format!("  triangles in ids: {numbers}"));
    let bits = can.rasteriser.sub_pixel_bits();
    line(
        text,
        &format!(
            "  corners go to 1/{} pixel: {bits} sub-pixel bits, measured",
            1_u32 << bits
        ),
    );
    let edges = if can.smooth_samples > 1 {
        format!("smooth, {} samples a pixel", can.smooth_samples)
    } else {
        "rough, without multisampling".to_owned()
    };
    line(text, &format!("  edges: {edges}"));
    let wireframe = if can.draws_wireframes { "yes" } else { "no" };
    line(text, &format!("  wireframe: {wireframe}"));
    let side = can.max_side_px;
    line(text, &format!("  pictures: up to {side}x{side}"));
    let [buffer, table] = [can.max_buffer_bytes, can.max_table_bytes].map(|bytes| bytes >> 20);
    line(
        text,
        &format!(
            "  buffers: up to {buffer} MiB, larger meshes are split; tables of objects up to {table} MiB"
        ),
    );
}

/// Adds a line, with terminal control characters escaped.
fn line(text: &mut String, content: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{}", super::terminal::plain(content));
}
