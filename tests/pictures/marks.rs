//! The selection, lines and wireframes are drawn over the scene and change no id.

use crate::{
    common::{mesh, orthographic, perspective, view},
    differing, draw,
    images::{apart, differing_where},
    overview,
    scenes::{gpu, shapes},
    show,
};
use glam::{DAffine3, DVec3, dvec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    colour::Srgb,
    geometry::Placement,
    image::{Image, Rgb},
    look::{self, Background},
    render::{Gpu, Line, Marks, Renderer, SMOOTH_SAMPLES, SceneBuffers, Targets, Wireframe},
    scene::{Object, Scene, Shape},
};

#[test]
fn the_selection_is_outlined_where_it_shows() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([640, 400]);
    for samples in [1, 4] {
        // The turned box stands behind the ball, the right half of a mesh behind the card.
        for (name, object) in [("turned box", 7), ("right", 11), ("ellipsoid", 3)] {
            let marks = Marks {
                selection: vec![object],
                hover: Some(2),
            };
            let (ids, plain, picture) = draw(&gpu, &scene, &view, &[], &marks, samples);
            show(&format!("selected-{name}-{samples}"), &picture);
            let [selected, hovered] = [object, 2].map(|i| u32::try_from(i + 1).expect("small"));
            let shows = |x: u32, y: u32| ids.at(x.min(639), y.min(399)).object;
            let [mut tinted, mut outlined, mut through] = [0; 3];
            for (x, y) in ids.positions() {
                let changed = apart(plain.at(x, y), picture.at(x, y), 2);
                let line = !apart(picture.at(x, y), look::SELECTION.0, 12);
                tinted += u32::from(shows(x, y) == selected && changed);
                outlined += u32::from(line);
                // Not at the visible rim, but inside the object that hides it.
                let mut around = (0..9).flat_map(|i| (0..9).map(move |j| (i, j)));
                let within = around.all(|(i, j)| {
                    shows((x + i).saturating_sub(4), (y + j).saturating_sub(4)) != selected
                });
                through += u32::from(line && within);
                assert!(
                    shows(x, y) != hovered || changed,
                    "what is hovered is tinted at ({x}, {y})"
                );
            }
            assert!(tinted > 100, "{name}: {tinted} pixels tinted");
            assert!(outlined > 100, "{name}: {outlined} pixels of outline");
            assert_eq!(through, 0, "{name}: pixels of outline seen through others");
        }
    }
}

/// Each of several selected objects is marked as if it were selected alone, and nothing else is. Of two that touch in the
/// picture, the line between them goes.
#[test]
fn several_objects_are_marked_as_each_alone_is() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([640, 400]);
    let marked = |selection: Vec<usize>| {
        let marks = Marks {
            selection,
            hover: None,
        };
        draw(&gpu, &scene, &view, &[], &marks, 1)
    };
    let (ids, plain, _) = marked(Vec::new());
    let apart = [3, 7, 11];
    let all = marked(apart.into()).2;
    let alone = apart.map(|object| marked(vec![object]).2);
    let mut changed = [0; 3];
    for (x, y) in ids.positions() {
        let of: Vec<_> = (0..3)
            .filter(|i| alone[*i].at(x, y) != plain.at(x, y))
            .collect();
        match of[..] {
            [] => assert_eq!(all.at(x, y), plain.at(x, y), "({x}, {y})"),
            [one] => {
                assert_eq!(all.at(x, y), alone[one].at(x, y), "({x}, {y})");
                changed[one] += 1;
            }
            _ => {}
        }
    }
    assert!(changed.iter().all(|changed| *changed > 200), "{changed:?}");
    // More than can have a rectangle of their own, most of which are not there.
    let many = marked((0..2000).collect()).2;
    let shown = ids.pixels().iter().filter(|id| id.object != 0).count();
    let differ = many.pixels().iter().zip(plain.pixels());
    let differ = differ.filter(|(a, b)| a != b).count();
    assert!(differ * 10 > shown * 9, "{differ} of {shown}");
}

/// Half of a line's light, and half of what is behind it: an object or the background. It fades from end to end.
#[test]
fn a_line_may_fade_into_what_is_behind_it() {
    let (gpu, scene, view) = (gpu(), shapes(DVec3::ZERO), overview([640, 400]));
    let (from, to) = (dvec3(-2.5, 0.8, 2.0), dvec3(2.5, 0.8, 2.0));
    let with = |opacity| {
        let line = Line::new(from, to, Srgb([255, 0, 255]));
        let lines = [Line { opacity, ..line }];
        draw(&gpu, &scene, &view, &lines, &Marks::default(), 1).2
    };
    let [none, half, all, fading] = [[0.0; 2], [0.5; 2], [1.0; 2], [0.0, 1.0]].map(with);
    let plain = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).2;
    let mut on_line = Vec::new();
    for (x, y) in plain
        .positions()
        .filter(|at| all.at(at.0, at.1) != plain.at(at.0, at.1))
    {
        let linear = |picture: &Image<Rgb>| Srgb(picture.at(x, y)).to_linear();
        let mixed = |opacity: f32| {
            let (line, behind) = (linear(&all), linear(&plain));
            Srgb::from_linear([0, 1, 2].map(|i| behind[i] + (line[i] - behind[i]) * opacity)).0
        };
        assert_eq!(none.at(x, y), plain.at(x, y));
        assert!(!apart(half.at(x, y), mixed(0.5), 2), "{x}, {y}");
        on_line.push((x, fading.at(x, y), mixed(1.0), plain.at(x, y)));
    }
    assert!(on_line.len() > 100, "{}", on_line.len());
    on_line.sort_unstable();
    let [(_, faint, ..), (_, strong, ..)] = [on_line[0], on_line[on_line.len() - 1]];
    let [(.., at_first), (.., whole, _)] = [on_line[0], on_line[on_line.len() - 1]];
    assert!(!apart(faint, at_first, 12) && !apart(strong, whole, 12));
}

/// The same view in orthographic projection, so high.
fn in_parallel(view: &View, height: f64) -> View {
    let lens = orthographic(height, 0.1, 100.0);
    let camera = view.camera.with_lens(lens).expect("a lens");
    View { camera, ..*view }
}

#[test]
fn lines_are_in_the_picture_and_not_in_the_ids() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([640, 400]);
    let colour = Srgb([255, 0, 255]);
    let lines: Vec<Line> = (-10..=10)
        .flat_map(|i| {
            let (a, y) = (f64::from(i) * 0.5, -0.99);
            [
                Line::new(dvec3(a, y, -5.0), dvec3(a, y, 5.0), colour),
                Line::new(dvec3(-5.0, y, a), dvec3(5.0, y, a), colour),
            ]
        })
        .collect();
    let orthographic_view = in_parallel(&view, 5.0);
    for view in [view, orthographic_view] {
        let (plain_ids, plain, _) = draw(&gpu, &scene, &view, &[], &Marks::default(), 1);
        for samples in [1, 4] {
            let (ids, colours, _) = draw(&gpu, &scene, &view, &lines, &Marks::default(), samples);
            show("grid", &colours);
            assert_eq!(differing(&ids, &plain_ids), 0);
            let pixels = || {
                ids.positions()
                    .filter(|&(x, y)| colours.at(x, y) == colour.0)
            };
            assert!(samples == 4 || pixels().count() > 1000, "the grid shows");
            // What stands on the floor hides the grid.
            let on_ball = pixels().filter(|&(x, y)| ids.at(x, y).object == 2);
            assert!(on_ball.count() < 100, "the grid lies behind the mesh");
        }
        assert!(!plain.pixels().contains(&colour.0));
    }
}

/// A line is as many pixels wide as a point of the screen has, whatever its slope, also where it begins behind the eye.
#[test]
fn a_line_is_a_point_wide() {
    let gpu = gpu();
    let view = view(
        [0.0, 0.0, 5.0],
        [0.0; 3],
        perspective(40.0, 0.1, 100.0),
        [320, 240],
    );
    let scene = Scene::from_iter([]);
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let targets = Targets::new(&gpu, view.viewport, SMOOTH_SAMPLES).expect("fits");
    let white = |scale_factor, ends: [DVec3; 2]| {
        let mut renderer = Renderer::new(&gpu, SMOOTH_SAMPLES);
        renderer.background = Background::BLACK;
        renderer.scale_factor = scale_factor;
        let lines = [Line::new(ends[0], ends[1], Srgb([255; 3]))];
        renderer
            .draw((&buffers, &targets, &view), &lines)
            .expect("draws");
        let colours = targets.read_colours(&gpu).expect("colours");
        let light = |colour: &Rgb| f64::from(Srgb(*colour).to_linear()[0]);
        colours.pixels().iter().map(light).sum::<f64>()
    };
    let a = dvec3(-0.9, -0.4, 0.0);
    for b in [
        dvec3(0.9, -0.4, 0.0),
        dvec3(-0.9, 0.5, 0.0),
        dvec3(0.7, 0.8, 0.0),
    ] {
        let px = [a, b].map(|end| view.project(end).expect("it is in view").px);
        let length_px = px[0].distance(px[1]);
        for scale in [1.0, 2.0, 3.5] {
            let width_px = white(scale, [a, b]) / length_px;
            assert!(
                (width_px / f64::from(scale) - 1.0).abs() < 0.06,
                "{b}: {width_px} of {scale}"
            );
        }
        let [thinner, one] = [0.5, 1.0].map(|scale| white(scale, [a, b]));
        assert!(
            thinner.total_cmp(&one).is_eq(),
            "it is at least a pixel wide"
        );
    }
    // From below the eye into the distance: it is cut at the picture's lower edge.
    let distant = dvec3(0.0, -1.0, -20.0);
    let from_below = |behind| white(4.0, [dvec3(0.0, -1.0, behind), distant]);
    let before_eye = from_below(4.0);
    assert!(before_eye > 300.0, "{before_eye}");
    assert!(
        (from_below(30.0) / before_eye - 1.0).abs() < 0.02,
        "{}",
        from_below(30.0)
    );
}

/// Lines that near and far do not clip look as if these were far apart, and no object is covered by what lies before
/// near or beyond far: neither by the floor that it stands on, nor by a line right before it.
#[test]
fn lines_that_are_not_clipped_go_on_before_near_and_beyond_far() {
    let gpu = gpu();
    let cube = Object::new("cube", Shape::Cube, Placement::IDENTITY);
    let scene = Scene::from_iter([cube]);
    let (near, far) = (4.2, 6.2);
    let mut lines: Vec<_> = (-8..=8)
        .flat_map(|i| {
            let (a, y) = (0.4 * f64::from(i), -0.51);
            // Along z they begin behind the eye.
            [
                [dvec3(a, y, 9.0), dvec3(a, y, -20.0)],
                [dvec3(-9.0, y, a), dvec3(9.0, y, a)],
            ]
        })
        .collect();
    lines.push([dvec3(-1.7, 0.3, 1.5), dvec3(2.4, 0.3, 1.5)]);
    let lines = |is_clipped| -> Vec<_> {
        let line = |[from, to]: &[DVec3; 2]| Line {
            is_clipped,
            opacity: [1.0, 0.2],
            ..Line::new(*from, *to, Srgb([255, 0, 255]))
        };
        lines.iter().map(line).collect()
    };
    for (is_parallel, depth) in [
        (false, DepthMapping::Reversed),
        (false, DepthMapping::Standard),
        (true, DepthMapping::Reversed),
        (true, DepthMapping::Standard),
    ] {
        let seen = |near, far| {
            let lens = if is_parallel {
                orthographic(3.0, near, far)
            } else {
                perspective(40.0, near, far)
            };
            let lens = Lens { depth, ..lens };
            view([1.2, 1.0, 5.0], [0.0; 3], lens, [320, 240])
        };
        let (fitted, wide) = (seen(near, far), seen(0.1, 100.0));
        for samples in [1, 4] {
            let drawn = |view, lines: &[Line]| {
                let (ids, picture, _) = draw(&gpu, &scene, view, lines, &Marks::default(), samples);
                (ids, picture)
            };
            let (ids, bare) = drawn(&fitted, &[]);
            let (_, open) = drawn(&fitted, &lines(false));
            let (_, clipped) = drawn(&fitted, &lines(true));
            let (_, whole) = drawn(&wide, &lines(true));
            show("before-near-and-beyond-far", &open);
            let case = format!("{is_parallel} {depth} {samples}");
            let is_beside = |at: [u32; 2]| ids.at(at[0], at[1]).object == 0;
            let beside = |a, b| differing_where(a, b, |a, b, at| apart(a, b, 8) && is_beside(at));
            let (all, missing) = (beside(&whole, &bare), beside(&whole, &clipped));
            assert!(missing > 400, "{case}: near and far clip {missing}");
            let off = beside(&whole, &open);
            // Which of two lines that cross is seen may change.
            assert!(40 * off < all, "{case}: {off} of {all}");
            // Where edges are smooth, a pixel of the outline shows the cube and the floor.
            let covered = differing_where(&open, &bare, |a, b, [x, y]| {
                let mut around = (0..9).map(|i| [x + i % 3 - 1, y + i / 3 - 1]);
                a != b && !is_beside([x, y]) && (samples == 1 || !around.any(is_beside))
            });
            assert_eq!(covered, 0, "{case}");
        }
    }
}

/// Edges of triangles show in the colours alone: ids stay the same.
#[test]
fn a_wireframe_is_not_in_the_ids() {
    let gpu = &gpu();
    let scene = shapes(DVec3::ZERO);
    let buffers = SceneBuffers::upload(gpu, &scene).expect("fits");
    for depth in [DepthMapping::Reversed, DepthMapping::Standard] {
        let view = overview([320, 240]);
        let lens = Lens {
            depth,
            ..*view.camera.lens()
        };
        let view = View {
            camera: view.camera.with_lens(lens).expect("a lens"),
            ..view
        };
        for samples in [1, 4] {
            let targets = Targets::new(gpu, view.viewport, samples).expect("fits");
            let mut renderer = Renderer::new(gpu, samples);
            let mut draw = |wireframe| {
                renderer.wireframe = wireframe;
                let drawn = renderer.draw((&buffers, &targets, &view), &[]);
                drawn.expect("draws");
                let ids = targets.read_ids(gpu).expect("ids");
                (ids, targets.read_colours(gpu).expect("colours"))
            };
            let (ids, colours) = draw(None);
            let changed = |wired: &Image<Rgb>| {
                let pairs = wired
                    .pixels()
                    .iter()
                    .zip(colours.pixels())
                    .zip(ids.pixels());
                let changed = pairs.filter(|((a, b), _)| a != b);
                changed.map(|(_, id)| id.object).collect::<Vec<_>>()
            };
            let (all_ids, all) = draw(Some(Wireframe::OfAll));
            let (one_ids, one) = draw(Some(Wireframe::Of(0)));
            assert!(all_ids == ids && one_ids == ids, "{depth} {samples}");
            // Edges of visible triangles, back faces too. A few pixels lie beside the object: lines reach beyond
            // outlines.
            let (all, one) = (changed(&all), changed(&one));
            assert!(
                one.len() > 100 && all.len() > 2 * one.len(),
                "{}, {}",
                one.len(),
                all.len()
            );
            let beside = one.iter().filter(|object| **object != 1).count();
            assert!(beside * 3 < one.len(), "{beside} of {}", one.len());
        }
    }
}

/// A square in the plane z = 0, two wide, of so many squares along each side. It is given smaller, and enlarged by its
/// model matrix.
fn squares(count: u32, enlarged: f64) -> Scene {
    let side = count + 1;
    #[expect(
        clippy::cast_precision_loss,
        clippy::cast_possible_truncation,
        reason = "small"
    )]
    let place = |i| (2.0 * i as f32 / count as f32 - 1.0) / enlarged as f32;
    let positions = (0..side * side).map(|i| [place(i % side), place(i / side), 0.0]);
    let corners = (0..count * count).flat_map(|i| {
        let at = i % count + i / count * side;
        [[at, at + 1, at + side], [at + 1, at + side + 1, at + side]]
    });
    let shape = Shape::Mesh {
        mesh: mesh(positions.collect(), corners.collect(), DVec3::ZERO),
        part: 0,
    };
    let scale = DAffine3::from_scale(DVec3::splat(enlarged));
    let placement = Placement::new(scale).expect("a placement");
    Scene::from_iter([Object::new("squares", shape, placement)])
}

/// Lines are dark on bright faces, from in front and from behind, and light on dark ones: on both they can be seen.
#[test]
fn a_wireframe_is_seen_on_bright_and_on_dark_faces() {
    let gpu = &gpu();
    let cube = Scene::from_iter([Object::new("cube", Shape::Cube, Placement::IDENTITY)]);
    let of_colour = |scene: &Scene, colour| -> Scene {
        let object = scene.objects()[0].clone();
        let colour = Some(colour);
        Scene::from_iter([Object { colour, ..object }])
    };
    let lens = perspective(40.0, 0.1, 100.0);
    let aside = view([1.2, 1.5, 2.2], [0.0; 3], lens, [400, 400]);
    let behind = view([0.0, 0.0, -3.0], [0.0; 3], lens, [400, 400]);
    // How many pixels are that much lighter, and darker, than the faces.
    let seen = |scene: &Scene, view: &View| {
        let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
        let targets = Targets::new(gpu, view.viewport, 1).expect("fits");
        let mut renderer = Renderer::new(gpu, 1);
        let [plain, wired] = [None, Some(Wireframe::OfAll)].map(|wireframe| {
            renderer.wireframe = wireframe;
            let drawn = renderer.draw((&buffers, &targets, view), &[]);
            drawn.expect("draws");
            targets.read_colours(gpu).expect("colours")
        });
        let ids = targets.read_ids(gpu).expect("ids");
        show("wired", &wired);
        let green = |picture: &Image<Rgb>, x, y| i32::from(picture.at(x, y)[1]);
        let count = |holds: fn(i32) -> bool| {
            let inside = ids.positions().filter(|&(x, y)| ids.at(x, y).object > 0);
            let lighter = inside.map(|(x, y)| green(&wired, x, y) - green(&plain, x, y));
            lighter.filter(|lighter| holds(*lighter)).count()
        };
        [
            count(|lighter| lighter > 40),
            count(|lighter| lighter < -40),
        ]
    };
    for dark in [Srgb([0; 3]), Srgb([10, 12, 70]), Srgb([40; 3])] {
        let [light, dark] = seen(&of_colour(&cube, dark), &aside);
        assert!(light > 800 && dark == 0, "{light} {dark}");
    }
    // The second is bright only on the side that is seen.
    for (scene, bright, view) in [
        (cube, Srgb([250; 3]), aside),
        (squares(4, 1.0), Srgb([150; 3]), behind),
    ] {
        let [light, dark] = seen(&of_colour(&scene, bright), &view);
        assert!(dark > 800 && light == 0, "{light} {dark}");
    }
}

/// How much darker the wireframe makes the darkest pixel of a scene, and all of them in the mean.
fn darker(gpu: &Gpu, scene: &Scene, view: &View) -> [f32; 2] {
    let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
    let targets = Targets::new(gpu, view.viewport, 4).expect("fits");
    let mut renderer = Renderer::new(gpu, 4);
    let mut light = |wireframe| {
        renderer.wireframe = wireframe;
        let drawn = renderer.draw((&buffers, &targets, view), &[]);
        drawn.expect("draws");
        let ids = targets.read_ids(gpu).expect("ids");
        let colours = targets.read_colours(gpu).expect("colours");
        let seen = ids.pixels().iter().zip(colours.pixels());
        let seen = seen.filter(|(id, _)| id.object > 0);
        let light = seen.map(|(_, pixel)| look::luminance(Srgb(*pixel).to_linear()));
        let light: Vec<_> = light.collect();
        assert!(light.len() > 3000);
        let least = light.iter().copied().fold(f32::INFINITY, f32::min);
        [least, light.iter().sum::<f32>()]
    };
    let [plain, wired] = [light(None), light(Some(Wireframe::OfAll))];
    [0, 1].map(|i| 1.0 - wired[i] / plain[i])
}

/// Edges that are far apart are dark. Where they are dense they fade, so that the form of a fine mesh is seen through
/// its wireframe: from near and far, at a slant, and whatever its model matrix.
#[test]
fn a_wireframe_fades_where_it_is_dense() {
    let gpu = &gpu();
    let lens = perspective(40.0, 0.1, 100.0);
    let in_front = view([0.0, 0.0, 3.0], [0.0; 3], lens, [400, 400]);
    let of = |count| darker(gpu, &squares(count, 1.0), &in_front);
    // The square is 366 pixels wide.
    let all = [4, 40, 180].map(of);
    let [[sparse, few], [_, between], [dense, many]] = all;
    assert!(sparse > 0.6, "{all:?}");
    assert!(few > 0.01 && between < 0.3 && many < 0.1, "{all:?}");
    assert!(dense < 0.35, "{all:?}");
    for count in [4, 40] {
        let [as_is, enlarged] =
            [1.0, 1000.0].map(|times| darker(gpu, &squares(count, times), &in_front)[1]);
        assert!((as_is - enlarged).abs() < 0.01, "{as_is} {enlarged}");
    }
    // At a slant, lines that run across it are a few pixels apart.
    let beside = view([2.9, 0.0, 0.35], [0.0; 3], lens, [400, 400]);
    let slanted = darker(gpu, &squares(40, 1.0), &beside)[1];
    assert!(slanted < 0.3, "{slanted}");
    let ortho = in_parallel(&in_front, 2.2);
    let [sparse, dense] = [4, 180].map(|count| darker(gpu, &squares(count, 1.0), &ortho));
    assert!(sparse[0] > 0.6 && dense[1] < 0.1, "{sparse:?} {dense:?}");
}
