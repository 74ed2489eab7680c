//! How desktops recognise the program and its windows.

use winit::{
    event_loop::ActiveEventLoop,
    window::{Icon, WindowAttributes},
};

/// The program's icon as a PNG file: `assets/icon.svg`, 256 pixels wide.
const ICON_PNG: &[u8] = include_bytes!("../../../assets/icon.png");

/// Puts name and icon on a window. Wayland takes the icon from the desktop entry.
pub(super) fn marked(
    attributes: WindowAttributes,
    event_loop: &ActiveEventLoop,
) -> WindowAttributes {
    named(attributes.with_window_icon(icon()), event_loop)
}

#[cfg(all(unix, not(target_os = "macos")))]
fn named(attributes: WindowAttributes, event_loop: &ActiveEventLoop) -> WindowAttributes {
    use winit::platform::{
        startup_notify::{EventLoopExtStartupNotify, WindowAttributesExtStartupNotify},
        wayland, x11,
    };
    /// The name of the program's desktop entry.
    const ID: &str = "sightline";
    let attributes = x11::WindowAttributesExtX11::with_name(attributes, ID, ID);
    let attributes = wayland::WindowAttributesExtWayland::with_name(attributes, ID, ID);
    // With its token, the desktop that started the program knows that its window has come.
    match event_loop.read_token_from_env() {
        Some(token) => attributes.with_activation_token(token),
        None => attributes,
    }
}

/// Other systems go by the program's file.
#[cfg(not(all(unix, not(target_os = "macos"))))]
fn named(attributes: WindowAttributes, _: &ActiveEventLoop) -> WindowAttributes {
    attributes
}

fn icon() -> Option<Icon> {
    let decoder = png::Decoder::new(std::io::Cursor::new(ICON_PNG));
    let mut reader = decoder.read_info().ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    Icon::from_rgba(rgba, info.width, info.height).ok()
}

#[cfg(test)]
mod tests {
    use super::icon;

    #[test]
    fn windows_have_an_icon() {
        assert!(icon().is_some());
    }
}
