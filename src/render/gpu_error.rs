//! What can go wrong with the graphics device.

use std::env;

/// Why nothing can be drawn. Each says in one line what to do about it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// No driver.
    #[error("no graphics driver found{}", where_to_find())]
    NoAdapter,
    /// The driver lacks something that drawing requires.
    #[error("{adapter} lacks {what}: use another driver; `sightline doctor` lists what there is")]
    Lacks {
        /// The adapter's name.
        adapter: String,
        /// What it lacks.
        what: String,
    },
    /// The driver is there but does not work.
    #[error(
        "{adapter} refuses to work ({reason}): use another driver; `sightline doctor` lists what there is"
    )]
    Device {
        /// The adapter's name.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// More pixels than a texture may have.
    #[error(
        "a picture of {width}x{height} is too large: {adapter} draws at most {limit} pixels each way"
    )]
    PictureTooLarge {
        /// The adapter's name.
        adapter: String,
        /// Requested width.
        width: u32,
        /// Requested height.
        height: u32,
        /// The most the adapter does.
        limit: u32,
    },
    /// More vertices, triangles or objects than a buffer may hold.
    #[error("the scene's {what} need {bytes} bytes, {adapter} takes at most {limit}")]
    SceneTooLarge {
        /// The adapter's name.
        adapter: String,
        /// What does not fit.
        what: &'static str,
        /// How much it needs.
        bytes: u64,
        /// The most the adapter takes.
        limit: u64,
    },
    /// The driver gave up the device: it was reset, updated or unplugged.
    #[error("{0} was lost, as when a driver restarts: try again")]
    Lost(String),
    /// Graphics memory is used up.
    #[error("{0} is out of memory: draw a smaller picture or scene")]
    OutOfMemory(String),
}

/// What to do where no driver is found.
fn where_to_find() -> String {
    match env::var_os("WGPU_BACKEND") {
        Some(name) => format!(" for WGPU_BACKEND={}: unset it", name.display()),
        None if cfg!(target_os = "linux") => {
            ": install one (Debian, Ubuntu: apt-get install mesa-vulkan-drivers)".to_owned()
        }
        None => ": install that of the graphics card".to_owned(),
    }
}
