//! Scene files load as written, saved ones read back the same, and errors name the file and line.
#![cfg(feature = "window")]

#[path = "../common/mod.rs"]
mod common;
mod many;
mod moved_folder;
mod saved;

use common::assert_near;
use glam::{DAffine3, DVec3, dvec3};
use sightline::{
    camera::{CameraChoice, DepthMapping, UpAxis},
    colour::Srgb,
    geometry::Placement,
    image::ImageError,
    scene::{
        self, Cancelled, DescriptionError, Detail, FileError, FilesAgain, LoadError, Loaded,
        MeshFile, MeshFiles, ObjError, ObjFile, Object, Problem, Progress, SaveError, Warning,
        description,
        gallery::Exhibit,
        obj::{Again, AgainError, BadLine, Contents},
    },
};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Can be shared between threads.
const fn is_shared<T: Send + Sync>() {}

/// Can be returned by `?` from any thread.
const fn is_error<T: std::error::Error + Send + Sync + 'static>() {}

const _: () = {
    is_shared::<Loaded>();
    is_shared::<MeshFile>();
    is_shared::<MeshFiles>();
    is_shared::<Detail>();
    is_shared::<FilesAgain>();
    is_shared::<Again>();
    is_shared::<Contents>();
    is_shared::<ObjFile>();
    is_shared::<Exhibit>();
    is_shared::<Progress>();
    is_shared::<Warning>();
    is_shared::<description::Description>();
    is_error::<AgainError>();
    is_error::<BadLine>();
    is_error::<Cancelled>();
    is_error::<DescriptionError>();
    is_error::<FileError>();
    is_error::<ImageError>();
    is_error::<LoadError>();
    is_error::<ObjError>();
    is_error::<Problem>();
    is_error::<SaveError>();
};

fn parse(text: &str) -> Result<description::Description, String> {
    let (mut meshes, progress) = (scene::MeshFiles::default(), Progress::default());
    let file = Path::new("folder/test.toml");
    description::parse(text, file, &mut meshes, &progress, &mut Vec::new())
        .map_err(|error| error.to_string())
}

/// The error of a text that must be refused: one line that names the file.
#[track_caller]
fn refused(text: &str) -> String {
    let error = parse(text).expect_err("it must be refused");
    assert!(!error.contains('\n'), "one line, not {error:?}");
    assert!(
        error.starts_with("folder/test.toml:"),
        "{error} names the file"
    );
    error
}

/// Writes a file into a folder, and returns its path.
fn write(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn load(paths: &[PathBuf]) -> Result<Loaded, String> {
    scene::load(paths, &Progress::default()).map_err(|error| error.to_string())
}

fn model(text: &str) -> DAffine3 {
    let objects = parse(&format!("[[object]]\nshape = \"cube\"\n{text}"))
        .unwrap()
        .objects;
    assert_eq!(objects.len(), 1);
    objects[0].placement.model()
}

#[test]
fn every_field_means_what_it_says() {
    let description = parse(
        r##"
        [camera]
        eye = [3, 2.5, -4]
        target = [0, 0, 0]
        up = [0, 0, 1]
        fov = 30
        near = 0.1
        far = 100
        depth = "standard"
        up_axis = "z"

        [[object]]
        name = "Ball"
        shape = "sphere"
        colour = "#d95f02"
        position = [0, 1, 0]
        scale = 2
        visible = false

        [[object]]
        shape = "cube"
        color = [1, 0.5, 0]

        [[object]]
        shape = "square"
        matrix = [[1, 2, 3, 4], [0, 1, 5, 6], [0, 0, 1, 7]]
        "##,
    )
    .unwrap();
    let camera = CameraChoice {
        eye: Some(dvec3(3.0, 2.5, -4.0)),
        target: Some(DVec3::ZERO),
        up: Some(DVec3::Z),
        fov: Some(30.0),
        near: Some(0.1),
        far: Some(100.0),
        depth: Some(DepthMapping::Standard),
        up_axis: Some(UpAxis::Z),
        ..CameraChoice::default()
    };
    assert_eq!(description.camera, Some(camera));
    let [ball, cube, square] = &description.objects[..] else {
        panic!("three objects");
    };
    assert_eq!(
        (ball.name.as_str(), ball.shape.kind(), ball.visible),
        ("Ball", "sphere", false)
    );
    assert_eq!(ball.colour, Some(Srgb([0xd9, 0x5f, 0x02])));
    let expected = DAffine3::from_translation(DVec3::Y) * DAffine3::from_scale(DVec3::splat(2.0));
    assert_eq!(ball.placement.model(), expected);
    assert_eq!(
        (cube.name.as_str(), cube.colour),
        ("Cube", Some(Srgb([255, 128, 0])))
    );
    assert_eq!(cube.placement, Placement::IDENTITY);
    assert!(cube.visible);
    assert_eq!((square.name.as_str(), square.colour), ("Square", None));
    let point = square.placement.point_to_world(dvec3(10.0, 100.0, 1000.0));
    assert_eq!(point, dvec3(3214.0, 5106.0, 1007.0));
}

#[test]
fn scale_comes_first_then_x_y_z_turns_about_the_worlds_axes_then_position() {
    let model_of = model("scale = [1, 2, -3]\nrotation = [20, -50, 70]\nposition = [5, 6, 7]");
    let turn = |axis, degrees: f64| DAffine3::from_axis_angle(axis, degrees.to_radians());
    let expected = DAffine3::from_translation(dvec3(5.0, 6.0, 7.0))
        * turn(DVec3::Z, 70.0)
        * turn(DVec3::Y, -50.0)
        * turn(DVec3::X, 20.0)
        * DAffine3::from_scale(dvec3(1.0, 2.0, -3.0));
    for corner in [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z] {
        let [ours, theirs] = [model_of, expected].map(|model| model.transform_point3(corner));
        assert_near(ours, theirs, 1e-15);
    }
    // A positive angle turns counter-clockwise when the axis points at the viewer.
    assert_near(
        model("rotation = [0, 0, 30]").transform_vector3(DVec3::X),
        dvec3(0.75_f64.sqrt(), 0.5, 0.0),
        1e-15,
    );
    // Quarter turns are exact, in either direction and any number.
    for (degrees, x) in [
        (90, DVec3::Y),
        (-270, DVec3::Y),
        (180, DVec3::NEG_X),
        (-90, DVec3::NEG_Y),
        (720, DVec3::X),
    ] {
        assert_eq!(
            model(&format!("rotation = [0, 0, {degrees}]")).transform_vector3(DVec3::X),
            x
        );
    }
}

#[test]
fn an_empty_file_is_an_empty_scene() {
    let description = parse("# nothing yet\n").unwrap();
    assert!(description.objects.is_empty() && description.camera.is_none());
    assert_eq!(
        parse("[camera]\n").unwrap().camera,
        Some(CameraChoice::default())
    );
}

#[test]
fn errors_say_where_and_what() {
    let cube = "[[object]]\nshape = \"cube\"\n";
    for (text, line, word) in [
        ("[[object]]\nshape = \"ball\"\n", 2, "ball"),
        ("[[object]]\nname = \"A\"\n", 1, "shape"),
        ("[[object]]\nshape = \"cube\"\nsize = 3\n", 3, "size"),
        ("[scene]\n", 1, "scene"),
        ("[camera]\n\neye = [1, 2]\n", 3, "3"),
        ("[camera]\neye = [1, 2, 3, 4]\n", 2, "exactly 3"),
        ("[camera]\neye = \"here\"\n", 2, "here"),
        ("[camera]\nzoom = 3\n", 2, "zoom"),
        ("[camera]\ndepth = \"deep\"\n", 2, "deep"),
        ("[camera]\neye = [1, 2,\n", 2, ""),
        (
            "# c\n[camera]\ntarget = [0, 0, 0]\nlook = [1, 0, 0]\n",
            2,
            "target and look",
        ),
        ("[camera]\nfov = 40\northo = 3\n", 1, "fov and ortho"),
        ("[camera]\nnear = nan\n", 1, "up to 1.29e33"),
        ("[camera]\neye = [0, inf, 0]\n", 1, "up to 1.29e33"),
        (&format!("{cube}scale = [1, 0, 1]\n"), 1, "no inverse"),
        (
            &format!("{cube}{cube}name = \"Flat\"\nscale = 0\n"),
            3,
            "Flat",
        ),
        (
            &format!("{cube}position = [nan, 0, 0]\n"),
            1,
            "up to 1.29e33",
        ),
        (
            &format!("{cube}matrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0]]\nscale = 2\n"),
            1,
            "matrix and",
        ),
        (
            &format!("{cube}matrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]\n"),
            3,
            "",
        ),
        (
            &format!("{cube}matrix = [[1,0,0,0],[0,1,0,0],[0,0,1,0,0]]\n"),
            3,
            "exactly 4",
        ),
        (&format!("{cube}position = [1, 2, 3, 4]\n"), 3, "exactly 3"),
        (&format!("{cube}scale = [1, 2, 3, 4]\n"), 3, "one number"),
        (&format!("{cube}colour = [1, 0, 0, 1]\n"), 3, "#rrggbb"),
        (&format!("{cube}matrix = [[1,0,0,0],[0,1,0,0]]\n"), 3, "3"),
        (
            &format!("{cube}matrix = [[1,0,0,0],[0,1,0,0],[0,0,inf,0]]\n"),
            1,
            "up to 1.29e33",
        ),
        (&format!("{cube}colour = \"red\"\n"), 3, "#rrggbb"),
        (&format!("{cube}colour = \"#ff00é\"\n"), 3, "#rrggbb"),
        (&format!("{cube}colour = [0, 0, 2]\n"), 3, "0 to 1"),
        (&format!("{cube}colour = [0, 0, nan]\n"), 3, "0 to 1"),
        (
            &format!("{cube}colour = \"#ffffff\"\ncolor = \"#ffffff\"\n"),
            1,
            "colo",
        ),
        (&format!("{cube}scale = [1, 2]\n"), 3, "one number"),
        (&format!("{cube}file = \"a.obj\"\n"), 1, "mesh"),
        (&format!("{cube}part = 1\n"), 1, "mesh"),
        ("[[object]]\nshape = \"mesh\"\n", 1, "file ="),
        (
            "\n\n[[object]]\nshape = \"mesh\"\nfile = \"nowhere.obj\"\n",
            3,
            "nowhere.obj",
        ),
    ] {
        let error = refused(text);
        assert!(
            error.starts_with(&format!("folder/test.toml:{line}:")),
            "{error} for {text}"
        );
        assert!(error.contains(word), "{error} does not say {word}");
    }
}

/// What a person wrote, with the place and the words of the parser. Where a scene file says more than TOML does, the
/// words are its own.
#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn errors_have_a_place_and_the_parsers_words() {
    let fields = "expected one of `name`, `shape`, `file`, `part`, `color`, `colour`, `position`, `rotation`, `scale`, `matrix`, `visible`";
    for (text, message) in [
        (
            "[scene]\n",
            "1:2: unknown field `scene`, expected `camera` or `object`",
        ),
        (
            "[[object]]\nshape = \"cube\"\nsize = 3\n",
            &*format!("3:1: unknown field `size`, {fields}"),
        ),
        (
            "[[object]]\nshape = \"cube\"\n\"a\\nb\" = 3\n",
            &*format!("3:1: unknown field `a\\nb`, {fields}"),
        ),
        (
            "[[object]]\nname = \"A\"\n",
            "1:1: an object needs its shape: shape = \"sphere\", \"cube\", \"square\" or \"mesh\"",
        ),
        (
            "[[object]]\nshape = \"ball\"\n",
            "2:9: unknown variant `ball`, expected one of `sphere`, `cube`, `square`, `mesh`",
        ),
        ("[[object]]\nshape = 3\n", "2:9: wanted string or table"),
        (
            "[[object]]\nshape = {}\n",
            "2:9: wanted exactly 1 element, found 0 elements",
        ),
        (
            "[[object]]\nshape = {a = 1, b = 2}\n",
            "2:9: wanted exactly 1 element, more than 1 element",
        ),
        (
            "[[object]]\nshape = {cube = 3}\n",
            "2:17: expected table, found integer",
        ),
        (
            "[[object]]\nshape = cube\n",
            "2:9: string values must be quoted, expected literal string",
        ),
        (
            "[[object]]\nshape = \"cube\n",
            "2:14: invalid basic string, expected `\"`",
        ),
        (
            "[object]\nshape = \"cube\"\n",
            "1:1: invalid type: map, expected a sequence",
        ),
        (
            "object = [3]\n",
            "1:11: invalid type: integer `3`, expected an object, which begins with [[object]]",
        ),
        (
            "object = [[\"A\", \"cube\"]]\n",
            "1:11: invalid length 2, expected an object, which begins with [[object]]",
        ),
        (
            "camera = 3\n",
            "1:10: invalid type: integer `3`, expected a camera, which begins with [camera]",
        ),
        (
            "[[camera]]\nfov = 3\n",
            "1:1: invalid type: map, expected a sequence",
        ),
        (
            "[[object]]\nshape = \"cube\"\nname = 3\n",
            "3:8: invalid type: integer `3`, expected a string",
        ),
        (
            "[[object]]\nshape = \"cube\"\nvisible = \"no\"\n",
            "3:11: invalid type: string \"no\", expected a boolean",
        ),
        (
            "[[object]]\nshape = \"cube\"\npart = -1\n",
            "3:8: invalid value: integer `-1`, expected usize",
        ),
        (
            "[[object]]\nshape = \"cube\"\npart = 1.5\n",
            "3:8: invalid type: floating point `1.5`, expected usize",
        ),
        (
            "[[object]]\nshape = \"cube\"\nmatrix = [1, 2, 3]\n",
            "3:11: invalid type: integer `1`, expected a sequence",
        ),
        (
            "[[object]]\nshape = \"cube\"\nmatrix = {}\n",
            "3:10: invalid type: map, expected a sequence",
        ),
        (
            "[[object]]\nshape = \"cube\"\nposition = [1, 2]\n",
            "3:12: invalid length 2, expected exactly 3",
        ),
        (
            "[[object]]\nshape = \"cube\"\nposition = [1, \", expected \", 3]\n",
            "3:16: invalid type: string \", expected \", expected f64",
        ),
        (
            "[[object]]\nshape = \"cube\"\ncolour = \"#ffffff\"\ncolor = \"#ffffff\"\n",
            "1:1: duplicate field `colour`",
        ),
        (
            "[[object]]\nshape = \"cube\"\nname = \"A\"\nname = \"A\"\n",
            "4:1: duplicate key",
        ),
        (
            "[camera]\n\nfov = true\n",
            "3:7: invalid type: boolean `true`, expected f64",
        ),
        (
            "[camera]\n\nfov = [40]\n",
            "3:7: invalid type: sequence, expected f64",
        ),
        (
            "[camera]\n\nfov = 99999999999999999999999\n",
            "3:7: invalid type: integer `99999999999999999999999` as i128, expected f64",
        ),
        (
            "[camera]\n\nfov = 999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999\n",
            "3:7: integer number overflowed",
        ),
        (
            "[camera]\n\nfov = 1e999\n",
            "3:7: floating-point number overflowed",
        ),
        ("[camera]\n\nfov\n", "3:4: key with no value, expected `=`"),
        (
            "[camera]\n\ndepth = \"deep\"\n",
            "3:9: unknown variant `deep`, expected `reversed` or `standard`",
        ),
        (
            "[camera]\n\neye = \"here\"\n",
            "3:7: invalid type: string \"here\", expected a sequence",
        ),
    ] {
        assert_eq!(
            refused(text),
            format!("folder/test.toml:{message}"),
            "{text}"
        );
    }
    let long = refused(&format!("[[object]]\n{} = 3\n", "x".repeat(1000)));
    assert!(long.len() < 400, "{long}");
}

/// A file without objects opens and shows nothing, so one line says why. A file with a camera alone lacks nothing
/// beside files with objects.
#[test]
fn what_a_scene_file_without_objects_lacks_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let empty = write(&folder, "empty.toml", "# nothing yet\n");
    let camera = write(&folder, "camera.toml", "[camera]\nfov = 10\n");
    let cube = write(&folder, "cube.toml", "[[object]]\nshape = \"cube\"\n");
    let unseen = "has no objects, so there is nothing to see: [[object]] begins one";
    let nothing = "has no objects and no camera: [[object]] begins an object";
    for (files, expected) in [
        (vec![&empty], vec![(&empty, nothing)]),
        (vec![&camera], vec![(&camera, unseen)]),
        (
            vec![&empty, &camera],
            vec![(&empty, nothing), (&camera, unseen)],
        ),
        (vec![&camera, &cube], vec![]),
        (vec![&cube, &camera, &empty], vec![(&empty, nothing)]),
    ] {
        let files: Vec<_> = files.into_iter().cloned().collect();
        let loaded = load(&files).expect("a scene");
        let said: Vec<_> = loaded.warnings.iter().map(Warning::to_string).collect();
        let expected = expected.into_iter();
        let expected: Vec<_> = expected
            .map(|(file, what)| format!("{}: {what}", file.display()))
            .collect();
        assert_eq!(said, expected);
    }
}

#[test]
fn files_make_one_scene_in_their_order() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| write(&folder, name, text);
    let object = |name: &str| format!("[[object]]\nshape = \"cube\"\nname = \"{name}\"\n");
    let plain = write("plain.toml", &(object("a") + &object("b")));
    let first = write(
        "first.TOML",
        &format!("[camera]\nfov = 10\n{}", object("c")),
    );
    let second = write(
        "second.toml",
        &format!("[camera]\nfov = 20\n{}", object("d")),
    );
    let names = |loaded: &Loaded| {
        let names = loaded
            .scene
            .objects()
            .iter()
            .map(|object| object.name.clone());
        names.collect::<Vec<_>>().concat()
    };

    let all = load(&[plain.clone(), first.clone(), second.clone()]).unwrap();
    assert_eq!(names(&all), "abcd");
    assert_eq!(all.camera.fov, Some(10.0), "the first camera counts");
    assert_eq!(all.camera_from.as_ref().map(|(file, _)| file), Some(&first));
    assert_eq!(all.title, "plain.toml and 2 more");
    let turned = load(&[second.clone(), first, plain.clone()]).unwrap();
    assert_eq!(
        (names(&turned).as_str(), turned.camera.fov),
        ("dcab", Some(20.0))
    );
    let alone = load(std::slice::from_ref(&plain)).unwrap();
    assert_eq!(
        (alone.title.as_str(), alone.camera),
        ("plain.toml", CameraChoice::default())
    );
    assert!(alone.warnings.is_empty());

    let missing = folder.path().join("missing.toml");
    let error = load(&[plain, missing.clone()]).unwrap_err();
    assert!(error.contains(missing.to_str().unwrap()), "{error}");
    let binary = write("binary.toml", "");
    std::fs::write(&binary, [0xff, 0xfe, 0x00]).unwrap();
    assert_eq!(
        load(std::slice::from_ref(&binary)).unwrap_err(),
        format!(
            "{}: is not text in UTF-8: save it in that encoding",
            binary.display()
        )
    );
    let broken = write("broken.toml", "[[object]\n");
    assert!(load(&[broken]).unwrap_err().contains("broken.toml:1"));
}

#[cfg(unix)]
#[test]
fn what_is_no_scene_file_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let made = std::process::Command::new("mkfifo")
        .arg(path("pipe.toml"))
        .status();
    assert!(made.expect("mkfifo").success());
    // A sparse file, which takes no space on the disk.
    let large = std::fs::File::create(path("large.toml")).unwrap();
    large.set_len((1 << 30) + 1).unwrap();
    for (name, why) in [
        ("pipe.toml", "is not a file"),
        ("large.toml", "is too large: more than 1 GiB"),
        ("missing.toml", "cannot be read: "),
    ] {
        let error = load(&[path(name)]).unwrap_err();
        let expected = format!("{}: {why}", path(name).display());
        assert!(error.starts_with(&expected), "{error}");
    }
}

/// Files of the system whose size says 0 bytes. The second one holds about 256 GB.
#[cfg(target_os = "linux")]
#[test]
fn a_file_longer_than_its_size_says_is_not_read() {
    let folder = tempfile::tempdir().unwrap();
    let link = folder.path().join("link.toml");
    for (target, why) in [
        (
            "/proc/self/status",
            "is longer than its size says (0 bytes): copy it and open the copy",
        ),
        ("/proc/self/pagemap", ""),
    ] {
        std::os::unix::fs::symlink(target, &link).unwrap();
        let error = load(std::slice::from_ref(&link)).unwrap_err();
        let expected = format!("{}: {why}", link.display());
        assert!(error.starts_with(&expected), "{target}: {error}");
        assert_eq!(error.lines().count(), 1, "{target}: {error}");
        std::fs::remove_file(&link).unwrap();
    }
}

#[test]
fn the_demo_shows_every_shape_and_kind_of_transform() {
    let demo = load(&[]).unwrap();
    assert_eq!(demo.title, "demo");
    let objects = demo.scene.objects();
    for kind in ["sphere", "cube", "square", "mesh"] {
        assert!(
            objects.iter().any(|object| object.shape.kind() == kind),
            "no {kind}"
        );
    }
    assert!((200..=600).contains(&demo.scene.triangle_count()));
    assert!(objects.iter().any(|object| object.placement.mirrors()));
    let sheared = |object: &Object| {
        let linear = object.placement.model().matrix3;
        linear.x_axis.dot(linear.y_axis).abs() > 0.1
    };
    assert!(objects.iter().any(sheared));
    let mut names: Vec<_> = objects.iter().map(|object| &object.name).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), objects.len(), "each name once");
    // The picture shows the whole scene.
    let viewport = sightline::camera::Viewport::new(1280, 720).unwrap();
    let camera = demo
        .camera
        .resolve(&demo.scene.visible_bounds(), viewport)
        .unwrap();
    for corner in (0..objects.len()).flat_map(|i| demo.scene.bounds_of(i).corners()) {
        let shown = camera.project(viewport, corner).unwrap();
        assert!(viewport.contains(shown.px), "{corner} is at {}", shown.px);
    }
}

#[test]
fn reading_tells_how_far_it_has_come_and_can_be_cancelled() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("many.toml");
    let object = "[[object]]\nshape = \"cube\"\nposition = [1, 2, 3]\n";
    std::fs::write(&path, object.repeat(3)).expect("writable");
    let progress = Progress::default();
    let loaded = scene::load(std::slice::from_ref(&path), &progress).expect("a scene");
    assert_eq!(loaded.scene.objects().len(), 3);
    assert_eq!(progress.fraction().to_bits(), 1.0_f32.to_bits());

    std::fs::write(&path, object.repeat(100_000)).expect("writable");
    let progress = Progress::default();
    let stopped = std::thread::scope(|scope| {
        let loading = scope.spawn(|| scene::load(&[path], &progress));
        // Parsing the text is the first half of the work, in one step. The objects are the second half.
        while progress.fraction() < 0.55 && !loading.is_finished() {
            std::thread::yield_now();
        }
        let seen = progress.fraction();
        progress.cancel();
        assert!(seen < 1.0, "{seen}: there is a middle");
        loading.join().expect("no panic")
    });
    assert!(matches!(stopped, Err(LoadError::Cancelled(_))));
}
