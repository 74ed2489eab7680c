//! How desktops recognise the program and its windows.

use winit::window::{Icon, WindowAttributes};

/// The program's icon as a PNG file: `assets/icon.svg`, 256 pixels wide.
const ICON_PNG: &[u8] = include_bytes!("../../../assets/icon.png");

/// Puts name and icon on a window. Wayland takes the icon from the desktop entry.
pub(super) fn marked(attributes: WindowAttributes) -> WindowAttributes {
    named(attributes.with_window_icon(icon()))
}

#[cfg(all(unix, not(target_os = "macos")))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
    use winit::platform::{wayland, x11};
    /// The name of the program's desktop entry.
    const ID: &str = "sightline";
    let attributes = x11::WindowAttributesExtX11::with_name(attributes, ID, ID);
    wayland::WindowAttributesExtWayland::with_name(attributes, ID, ID)
}

/// Other systems go by the program's file.
#[cfg(not(all(unix, not(target_os = "macos"))))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
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
