//! A picture drawn in pieces equals one drawn at once. A changed scene is drawn like a new one.

use super::*;
use glam::DAffine3;
use sightline::{
    geometry::Placement,
    render::{Drawing, Piece, SMOOTH_SAMPLES, Wireframe},
};

/// The number of pieces, and the ids, the colours and the picture with its marks that were drawn in them.
fn in_pieces(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    samples: u32,
    piece: Piece,
) -> (usize, Image<Id>, Image<Rgb>, Image<Rgb>) {
    let mut renderer = Renderer::new(gpu, samples);
    let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
    let targets = Targets::new(gpu, view.viewport, samples).expect("fits");
    let mut drawing = Drawing::of_scene(samples, view, vec![line()]);
    let whole = drawing.whole(&buffers).work;
    let mut pieces = 1;
    let mut done = 0;
    while !renderer
        .advance(&buffers, &targets, &mut drawing, piece)
        .expect("drawn")
    {
        assert!(drawing.done > done, "each piece does something");
        assert!(drawing.done - done <= piece.work.max(33), "and no more");
        done = drawing.done;
        pieces += 1;
    }
    assert!(drawing.done >= whole, "all of it");
    let onto = (&buffers, &targets, view);
    renderer.draw_outline(onto, SELECTED);
    let picture = renderer.composite_to_image(onto, &MARKS);
    (
        pieces,
        targets.read_ids(gpu).expect("ids"),
        targets.read_colours(gpu).expect("colours"),
        picture.expect("a picture"),
    )
}

/// The floor, a square.
const SELECTED: usize = 0;
const MARKS: Marks = Marks {
    selection: Some(SELECTED),
    hover: None,
};

fn line() -> Line {
    Line {
        from: DVec3::new(-2.0, 0.0, 2.0),
        to: DVec3::new(2.0, 1.0, 0.0),
        colour: sightline::colour::Srgb([255, 0, 0]),
    }
}

#[test]
fn pieces_make_the_whole_picture() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([320, 200]);
    for samples in [1, SMOOTH_SAMPLES] {
        let (ids, colours, picture) = draw(&gpu, &scene, &view, &[line()], &MARKS, samples);
        for (work, instances, least) in [(50, u32::MAX, 20), (1000, 1, 8), (u64::MAX, 2, 4)] {
            let piece = Piece { work, instances };
            let (pieces, piece_ids, piece_colours, piece_picture) =
                in_pieces(&gpu, &scene, &view, samples, piece);
            assert!(pieces >= least, "{pieces} pieces of {piece:?}");
            assert_eq!(differing(&ids, &piece_ids), 0, "{piece:?}");
            assert_eq!(differing(&colours, &piece_colours), 0, "{piece:?}");
            assert_eq!(differing(&picture, &piece_picture), 0, "{piece:?}");
        }
    }
}

/// A move writes single rows of tables. A mirroring writes all rows.
#[test]
fn objects_that_move_are_drawn_where_they_are() {
    let gpu = gpu();
    let mut scene = shapes(DVec3::ZERO);
    let view = overview([320, 200]);
    let mut kept = Kept::new(&gpu, &scene, view);
    let mut before = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).0;
    let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    let up = DAffine3::from_translation(DVec3::new(0.1, 0.3, 0.0));
    for by in [up, mirror] {
        // Without mirroring only single rows are written: none of these objects is one of several parts.
        for object in [0, 1, 6, 9] {
            let model = by * scene.objects()[object].placement.model();
            scene.place(object, Placement::new(model).expect("invertible"));
        }
        scene.set_visible(2, by == mirror);
        let drawn = kept.ids(&scene);
        let fresh = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).0;
        assert_eq!(differing(&drawn, &fresh), 0);
        assert!(differing(&drawn, &before) > 300, "they moved");
        before = drawn;
    }
}

/// Edges of triangles, and more lines than one piece holds.
#[test]
fn edges_and_lines_come_in_pieces_too() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([320, 200]);
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let meshes = |object: &sightline::scene::Object| object.shape.triangles().is_some();
    let mesh = scene.objects().iter().position(meshes).expect("a mesh");
    let lines: Vec<_> = (0..100_u8)
        .map(|i| Line {
            to: DVec3::new(2.0, f64::from(i) / 50.0 - 1.0, 1.0),
            ..line()
        })
        .collect();
    for samples in [1, SMOOTH_SAMPLES] {
        let targets = Targets::new(&gpu, view.viewport, samples).expect("fits");
        let mut pieces = Vec::new();
        for wireframe in [None, Some(Wireframe::Of(mesh)), Some(Wireframe::OfAll)] {
            let mut renderer = Renderer::new(&gpu, samples);
            renderer.wireframe = wireframe;
            renderer
                .draw((&buffers, &targets, &view), &lines)
                .expect("draws");
            let whole = targets.read_colours(&gpu).expect("colours");
            let piece = Piece::of_work(200);
            let mut drawing = Drawing::of_scene(samples, &view, lines.clone());
            let mut count = 1;
            while !renderer
                .advance(&buffers, &targets, &mut drawing, piece)
                .expect("drawn")
            {
                count += 1;
            }
            pieces.push(count);
            let colours = targets.read_colours(&gpu).expect("colours");
            assert_eq!(differing(&colours, &whole), 0, "{wireframe:?}");
        }
        let [bare, of_one, of_all] = pieces[..] else {
            panic!("{pieces:?}");
        };
        assert!(bare + 3 < of_one && of_one + 10 < of_all, "{pieces:?}");
    }
}
