//! `sightline doctor`: describes the graphics of this machine, as text for a bug report.

use super::{CliError, print, terminal::start_log};
use crate::{
    geometry::shares,
    plain::plain,
    render::{self, AdapterCan, AdapterFound, GpuError, Numbers},
    viewer,
};
use std::env;

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
    "list, pick, render (by rays, without --views) and study (but for the step that draws)";

/// Prints the report.
pub(super) fn run(args: &DoctorArgs) -> Result<(), CliError> {
    start_log(args.verbose);
    let display = viewer::display();
    let adapters = render::adapters();
    let mut lines = vec![format!(
        "sightline {}, {} {}, {} threads",
        env!("CARGO_PKG_VERSION"),
        env::consts::OS,
        env::consts::ARCH,
        shares::cores()
    )];
    let variables = VARIABLES.map(|name| Some((name, env::var_os(name)?)));
    let variables = variables.into_iter().flatten();
    lines.extend(variables.map(|(name, value)| format!("{name}={}", value.display())));
    lines.push(match &display {
        Ok(()) => "display: there is one".to_owned(),
        Err(error) => format!("display: {error}"),
    });
    lines.extend((1..).zip(&adapters).flat_map(describe));
    let drawing = drawing(&adapters);
    lines.extend(
        drawing
            .as_ref()
            .err()
            .map(|error| format!("drawing: {error}")),
    );
    lines.push(format!("works without an adapter: {WITHOUT}"));
    let text: String = lines.iter().map(|line| plain(line) + "\n").collect();
    print(&text)?;
    drawing?;
    Ok(display?)
}

/// Whether the chosen adapter draws.
fn drawing(adapters: &[AdapterFound]) -> Result<(), GpuError> {
    let used = adapters.iter().find(|adapter| adapter.is_used);
    let used = used.ok_or(GpuError::NoAdapter)?;
    used.can.as_ref().map(|_| ()).map_err(Clone::clone)
}

/// The lines about an adapter.
fn describe((number, adapter): (usize, &AdapterFound)) -> Vec<String> {
    let used = if adapter.is_used { ", which draws" } else { "" };
    let [vendor, device] = adapter.numbers;
    let mut lines = vec![
        format!("adapter {number}{used}: {}", adapter.name),
        format!(
            "  {} by {}, driver {}, {vendor:04x}:{device:04x}",
            adapter.kind, adapter.backend, adapter.driver
        ),
    ];
    match &adapter.can {
        Ok(can) => lines.extend(abilities(can)),
        Err(error) => lines.push(format!("  draws nothing: {error}")),
    }
    lines
}

fn abilities(can: &AdapterCan) -> [String; 4] {
    let numbers = match can.numbers {
        Numbers::Primitives => "by primitive index",
        Numbers::Corners => {
            "by corners, without a primitive index: meshes take about four times the graphics memory"
        }
    };
    let bits = can.rasteriser.sub_pixel_bits();
    let grid = 1_u32 << bits;
    let side = can.max_side_px;
    let [buffer, table] = [can.max_buffer_bytes, can.max_table_bytes].map(|bytes| bytes >> 20);
    [
        format!("  triangles in ids: {numbers}"),
        format!("  corners go to 1/{grid} pixel: {bits} sub-pixel bits, measured"),
        format!("  pictures: up to {side}x{side}"),
        format!(
            "  buffers: up to {buffer} MiB, larger meshes are split; tables of objects up to {table} MiB"
        ),
    ]
}
