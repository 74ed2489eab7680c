//! Screen readers: hands egui's tree of controls to the system, and tells the program what screen readers do.

use super::shell::Shell;
use crate::viewer::app::{Reader, Wake, Waker};
use egui::accesskit::{
    ActionHandler, ActionRequest, ActivationHandler, DeactivationHandler, TreeUpdate,
};
use egui_winit::accesskit_winit::Adapter;
use winit::event_loop::ActiveEventLoop;

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

/// Shows a window's controls to screen readers, and then the window.
///
/// # Panics
/// When the window is visible already.
pub(super) fn show(mut shell: Shell, event_loop: &ActiveEventLoop, wake: &Waker) -> Shell {
    let teller = || Teller(wake.clone());
    let adapter =
        Adapter::with_direct_handlers(event_loop, &shell.window, teller(), teller(), teller());
    shell.egui.accesskit = Some(adapter);
    shell.window.set_visible(true);
    shell
}
