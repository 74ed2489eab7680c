//! Where no window can be, one line says why and what works without.

use super::{SIGHTLINE, Screen};
use std::process::Command;

#[test]
fn without_a_display_it_says_what_to_do() {
    let output = Command::new(SIGHTLINE)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .output()
        .expect("the binary runs");
    let message = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(5), "{message}");
    assert!(message.contains("sightline render"), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
}

/// With a display and no driver, one line says what to install, and what works without.
#[test]
fn without_a_driver_it_refuses() {
    let screen = Screen::new(640, 480);
    let output = Command::new(SIGHTLINE)
        .env("DISPLAY", &screen.display)
        .env("VK_DRIVER_FILES", "/nowhere.json")
        .env("VK_ICD_FILENAMES", "/nowhere.json")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .env_remove("RUST_LOG")
        .output()
        .expect("the binary runs");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(4), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(
        said.contains("apt-get install mesa-vulkan-drivers"),
        "{said}"
    );
    assert!(
        said.contains("sightline render SCENE --by raycast -o picture.png"),
        "{said}"
    );
}

/// Where the environment names a Wayland compositor that is gone, the window opens on X11.
#[test]
fn a_compositor_that_is_gone_gives_way_to_x11() {
    let screen = Screen::new(640, 480);
    let folder = tempfile::tempdir().expect("a folder");
    let report = |display: &str| {
        let mut command = Command::new(SIGHTLINE);
        command.arg("doctor").env("DISPLAY", display);
        command.env("WAYLAND_DISPLAY", "wayland-gone");
        command.env("XDG_RUNTIME_DIR", folder.path());
        command.env_remove("WAYLAND_SOCKET");
        let output = command.output().expect("it runs");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let text = report(&screen.display);
    assert!(text.contains("display: there is one"), "{text}");
    let text = report(":999");
    assert!(text.contains("display: no display"), "{text}");
}

/// Without the library that reads keyboards, one line says what to install.
#[test]
#[cfg(target_os = "linux")]
fn without_a_library_of_keyboards_it_refuses() {
    let screen = Screen::new(640, 480);
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |library: &str| {
        // An empty file is found before the system's library, and is none.
        let files = [".so.0", ".so"].map(|ending| folder.path().join(format!("{library}{ending}")));
        for file in &files {
            std::fs::write(file, "").expect("written");
        }
        let mut command = Command::new(SIGHTLINE);
        command.env("DISPLAY", &screen.display);
        command.env("LD_LIBRARY_PATH", folder.path());
        command.env_remove("WAYLAND_DISPLAY");
        command.env_remove("WAYLAND_SOCKET");
        let output = command.output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(5), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(
            said.contains("apt-get install libxkbcommon-x11-0"),
            "{said}"
        );
        for file in files {
            std::fs::remove_file(file).expect("removed");
        }
    };
    refused("libxkbcommon-x11");
    refused("libxkbcommon");
}
