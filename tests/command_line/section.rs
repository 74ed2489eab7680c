//! A section in a scene file names faces of that file's objects, whatever other files are loaded.

use crate::Folder;

const SQUARE: &str = "[[object]]\nshape = \"square\"\nrotation = [10, 20, 30]\n";

#[test]
fn a_scene_file_cuts_along_a_face_of_its_own_whatever_is_shown_beside() {
    let folder = Folder::new();
    let cut = |name: &str, id: u32| {
        let text = format!(
            "[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nsection = \"face:{id}\"\n\
             [[object]]\nshape = \"square\"\nposition = [0, 0, -1]\n"
        );
        std::fs::write(folder.path(name), text).unwrap();
    };
    std::fs::write(folder.path("other.toml"), SQUARE.repeat(2)).unwrap();
    cut("own.toml", 1);
    let section = |args: &str| folder.json(args)[0]["stored"]["camera"]["section"].clone();
    let alone = section("pick own.toml --at 5,5 --stored");
    assert_eq!(alone["normal"].to_string(), "[0.0,0.0,-1.0]");
    assert_eq!(section("pick other.toml own.toml --at 5,5 --stored"), alone);
    // A scene file may not name another file's object. The command line may name any object.
    for id in [0, 2, 3, 4] {
        cut("beyond.toml", id);
        let error = folder.error("pick other.toml beyond.toml --at 5,5", 3);
        assert!(error.contains("there is no object"), "{error}");
    }
    let named = section("pick other.toml own.toml --at 5,5 --stored --section face:2");
    assert!(!named.is_null() && named != alone, "{named}");
}
