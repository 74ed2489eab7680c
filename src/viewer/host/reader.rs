//! Screen readers: the system's side of egui's tree of controls.

use crate::viewer::app::{Reader, Wake, Waker};
use egui::accesskit::{
    ActionHandler, ActionRequest, ActivationHandler, DeactivationHandler, TreeUpdate,
};
use egui_winit::accesskit_winit::Adapter;
use winit::{event_loop::ActiveEventLoop, window::Window};

/// Tells the program what screen readers do.
struct Teller(Waker);

impl ActivationHandler for Teller {
    fn request_initial_tree(&mut self) -> Option<TreeUpdate> {
        // The next frame sends the tree.
        (self.0)(Wake::Reader(Reader::Came));
        None
    }
}

impl ActionHandler for Teller {
    fn do_action(&mut self, request: ActionRequest) {
        (self.0)(Wake::Reader(Reader::Uses(request)));
    }
}

impl DeactivationHandler for Teller {
    fn deactivate_accessibility(&mut self) {
        (self.0)(Wake::Reader(Reader::Left));
    }
}

/// Shows a window's controls to screen readers.
///
/// # Panics
/// When the window is visible already.
pub(super) fn adapter(event_loop: &ActiveEventLoop, window: &Window, wake: &Waker) -> Adapter {
    let teller = || Teller(wake.clone());
    Adapter::with_direct_handlers(event_loop, window, teller(), teller(), teller())
}
