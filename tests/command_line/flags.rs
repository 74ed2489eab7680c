//! Flags may stand before the command as well as after it.

use crate::Folder;

#[test]
fn flags_may_stand_before_the_command() {
    let folder = Folder::new();
    let usual = folder.json("pick scene.toml --size 200x100 --at 100,50 5.25,7.5 --eye 0,0,-9");
    assert_eq!(usual.len(), 2);
    for args in [
        "--size 200x100 pick scene.toml --at 100,50 5.25,7.5 --eye 0,0,-9",
        "--size=200x100 --eye 0,0,-9 pick --at 100,50 5.25,7.5 -- scene.toml",
        "--eye 0,0,-9 --size 200x100 pick scene.toml --at 100,50 5.25,7.5",
    ] {
        assert_eq!(folder.json(args), usual, "{args}");
    }
    for args in ["-v list scene.toml", "-v --cull pick scene.toml --at 1,1"] {
        let output = folder.run(args);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{args}: {stderr}");
        assert!(stderr.contains("loaded"), "{args} says what is done");
    }
    // Flags that only one command has, and a value that is also the name of a command.
    let output = folder.run("-o render.png --by raycast render scene.toml --size 20x10");
    assert!(output.status.success() && folder.path("render.png").exists());
    let error = folder.error("--depth list pick scene.toml --at 1,1", 2);
    assert!(error.contains("reversed"), "{error}");
}
