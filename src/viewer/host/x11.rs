//! Where an X server goes, Xlib ends the process, or winit panics: edits are saved first. Neither hands over the
//! program, so what is to be saved lies ready.
#![expect(unsafe_code, reason = "see SAFETY")]

use crate::viewer::app::{App, Unsaved, rescue};
use std::{
    ffi::c_int,
    panic, process, ptr,
    sync::{Mutex, PoisonError},
    thread,
};
use winit::{event_loop::ActiveEventLoop, platform::x11::ActiveEventLoopExtX11 as _};
use x11_dl::xlib::{Display, Xlib};

/// The edits that are in no file, as they were after the last pass; `None` where there is no X server.
static UNSAVED: Mutex<Option<Vec<Unsaved>>> = Mutex::new(None);
/// The program's exit code where there is no display.
const NO_DISPLAY: i32 = 5;

/// From now on, edits are saved when the X server goes, if there is one.
pub(super) fn save_when_gone(event_loop: &ActiveEventLoop) {
    let Some(xlib) = event_loop.is_x11().then(Xlib::open).and_then(Result::ok) else {
        return;
    };
    // SAFETY: Xlib calls the function with a pointer, which is not used.
    unsafe { (xlib.XSetIOErrorHandler)(Some(gone)) };
    if let Ok(mut unsaved) = UNSAVED.lock() {
        *unsaved = Some(Vec::new());
    }
    let before = panic::take_hook();
    let window_thread = thread::current().id();
    panic::set_hook(Box::new(move |panicked| {
        // winit panics here. Panics of jobs are not about the display.
        if thread::current().id() == window_thread {
            // SAFETY: without a name, it opens the display that the environment names, or returns null. A connection of
            // its own is used by this thread alone.
            let display = unsafe { (xlib.XOpenDisplay)(ptr::null()) };
            if display.is_null() {
                end();
            }
            // SAFETY: it was opened above, and nothing else has it.
            unsafe { (xlib.XCloseDisplay)(display) };
        }
        before(panicked);
    }));
}

/// Makes the program's edits ready to be saved, if they are others than before.
pub(super) fn keep_ready(app: &App) {
    if let Ok(mut unsaved) = UNSAVED.lock()
        && let Some(unsaved) = &mut *unsaved
    {
        app.list_unsaved(unsaved);
    }
}

unsafe extern "C" fn gone(_: *mut Display) -> c_int {
    end()
}

/// Saves the edits, says so, and ends the process.
fn end() -> ! {
    // Passes lock it only while they ask nothing of the display. Another thread that comes here waits until the end.
    let unsaved = UNSAVED.lock().unwrap_or_else(PoisonError::into_inner);
    log::error!("{}", rescue(unsaved.as_deref().unwrap_or_default()));
    process::exit(NO_DISPLAY)
}
