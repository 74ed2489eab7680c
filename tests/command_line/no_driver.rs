//! Without a graphics driver `render` draws by rays and says so; what needs a driver refuses, and says what to install.

use crate::{Folder, error};
use std::process::{Command, Output};

/// Ways to have no driver: a loader that finds none, and no loader.
const WAYS: [fn(&Folder, &mut Command); 2] = [
    |_, command| {
        let nowhere = "/nowhere.json";
        command.env("VK_DRIVER_FILES", nowhere);
        command.env("VK_ICD_FILENAMES", nowhere);
    },
    |folder, command| {
        // An empty file is found before the system's loader, and is none.
        for name in ["libvulkan.so.1", "libvulkan.so"] {
            std::fs::write(folder.path(name), "").unwrap();
        }
        command.env("LD_LIBRARY_PATH", folder.path(""));
    },
];

fn run(folder: &Folder, args: &str, without_driver: fn(&Folder, &mut Command)) -> Output {
    let mut command = folder.command(args);
    without_driver(folder, &mut command);
    command.output().unwrap()
}

#[test]
fn a_picture_is_drawn_by_rays() {
    let folder = Folder::new();
    let args = "render scene.toml --size 64x48 --pick 32,24";
    let by_rays = folder.run(&format!(
        "{args} --by raycast -o rays.png --ids rays-ids.png"
    ));
    assert!(by_rays.status.success() && by_rays.stderr.is_empty());
    for way in WAYS {
        let output = run(&folder, &format!("{args} -o a.png --ids ids.png"), way);
        let said = error(&output, 0, "render");
        assert!(
            said.contains("drawn by rays on the CPU: no graphics driver found"),
            "{said}"
        );
        assert!(
            said.contains("apt-get install mesa-vulkan-drivers"),
            "{said}"
        );
        for [drawn, rays] in [["a.png", "rays.png"], ["ids.png", "rays-ids.png"]] {
            let [drawn, rays] = [drawn, rays].map(|name| std::fs::read(folder.path(name)).unwrap());
            assert!(drawn == rays, "the picture is not the one by rays");
        }
        std::fs::remove_file(folder.path("a.png")).unwrap();
    }
}

#[test]
fn what_needs_a_driver_refuses() {
    let folder = Folder::new();
    for way in WAYS {
        for args in [
            "render scene.toml --by raster -o a.png",
            "render scene.toml --views four -o a.png",
            "verify scene.toml",
        ] {
            let said = error(&run(&folder, args, way), 4, args);
            assert!(
                said.contains("apt-get install mesa-vulkan-drivers"),
                "{args}: {said}"
            );
            assert!(!folder.path("a.png").exists(), "{args}");
        }
    }
}

/// With a driver, nothing is said: rays draw only where they must.
#[test]
fn with_a_driver_rays_are_not_mentioned() {
    let folder = Folder::new();
    let output = folder.run("render scene.toml --size 64x48 -o a.png -v");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success() && said.contains("drawing with "),
        "{said}"
    );
    assert!(!said.contains("by rays"), "{said}");
}

/// Where only other backends are allowed, that is said: to install a driver would not help.
#[test]
fn a_choice_of_backends_that_leaves_none_is_named() {
    let folder = Folder::new();
    let mut command = folder.command("verify scene.toml");
    let output = command.env("WGPU_BACKEND", "gl").output().unwrap();
    let said = error(&output, 4, "verify");
    assert!(
        said.contains("no graphics driver found for WGPU_BACKEND=gl: unset it"),
        "{said}"
    );
}
