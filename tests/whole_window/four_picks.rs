//! What is picked in one of the four views is picked in all, and stays picked while a view is made large.

use super::{
    four::{NAMES, away, four, rects},
    *,
};
use egui::vec2;
use glam::DVec3;

#[test]
fn a_point_has_one_colour_in_all_views_and_the_numbers() {
    let (mut window, _folder) = four();
    // This leaves room between the near plane and the cube. The matrices had scrolled the camera away.
    press_key(&mut window, Modifiers::NONE, Key::P);
    type_into(&mut window, "near", "4");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let places = rects(&window);
    // The point lies on the cube's front, where the world view shows it.
    let state = window.state();
    let front = state.scene().bounds_of(0).corners()[7]
        .with_x(0.2)
        .with_y(0.1);
    let seen = state.pane_view(Stage::World).expect("a view");
    let at = seen.project(front).expect("in front").px;
    #[expect(clippy::cast_possible_truncation, reason = "points are f32")]
    let at = places[1].min + vec2(at.x as f32, at.y as f32);
    click(&mut window, at);
    assert_eq!(selected(&window), Some("front"));
    let picture = away(&mut window);
    let amber = sightline::look::SELECTION.0;
    let colour_at = |stage: Stage, at: Option<DVec3>, aside: f64| {
        let seen = window.state().pane_view(stage).expect("a view");
        let px = seen.project(at?)?.px + DVec2::new(aside, 0.0);
        let place = places[stage as usize].min;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the window"
        )]
        let [x, y] = [place.x + px.x as f32, place.y + px.y as f32].map(|at| at as u32);
        Some(picture.at(x, y))
    };
    let state = window.state();
    let world = state.followed_world().expect("a point");
    let ray = state.view().ray(picked_px(&window).expect("a pick"));
    let pixel = ray.at(ray.t_min);
    let in_object = |world| state.scene().objects()[0].placement.point_to_object(world);
    for (stage, point, pixel) in [
        (Stage::Object, Some(in_object(world)), None),
        (Stage::World, Some(world), Some(pixel)),
        (Stage::View, Some(world), Some(pixel)),
        (
            Stage::Ndc,
            state.ndc().drawn(world),
            state.ndc().drawn(pixel),
        ),
    ] {
        // A ring marks the point, and a dot its pixel.
        let is_amber = |at, aside: i32| colour_at(stage, at, aside.into()) == Some(amber);
        assert!((-4..=4).any(|aside| is_amber(point, aside)), "{stage:?}");
        let has_pixel = stage != Stage::Object;
        assert_eq!(
            (-1..=1).any(|aside| is_amber(pixel, aside)),
            has_pixel,
            "{stage:?}"
        );
    }
    let title = control(&window, "The pick: front").rect;
    let (x, y) = (title.left() - 8.0, title.center().y);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "within the window"
    )]
    let dots = (0..12).map(|by| picture.at(x as u32 - by, y as u32));
    assert!(dots.filter(|dot| *dot == amber).count() >= 4);
    // In each view the point's numbers stand beside it.
    let view = window.state().view();
    let ndc = view.project(world).expect("in front").ndc;
    let object = window.state().followed().expect("a point").point_object;
    for point in [object, world, view.camera.to_view(world), ndc] {
        control(
            &window,
            &format!("({:.3}, {:.3}, {:.3})", point.x, point.y, point.z),
        );
    }
}

#[test]
fn a_double_click_on_nothing_makes_a_view_large_and_keeps_the_pick() {
    let (mut window, _folder) = row(1.0);
    for at in [MIDDLE, MIDDLE + vec2(20.0, 10.0)] {
        click(&mut window, at);
        window.wait_s(1.0);
    }
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    let kept = |window: &Window| {
        let state = window.state();
        let points = state.measuring().points.clone();
        let hits = state.hits().map(|hits| (hits.px, hits.at));
        (state.selection().cloned(), hits, state.followed(), points)
    };
    let before = kept(&window);
    assert!(before.0.is_some() && window.state().picked().is_some() && before.3.len() == 2);
    for (i, stage) in [Stage::Object, Stage::World, Stage::View, Stage::Ndc]
        .into_iter()
        .enumerate()
    {
        let nothing = rects(&window)[i].right_bottom() - vec2(8.0, 8.0);
        window.send([Event::PointerMoved(nothing)]);
        assert_eq!(window.state().cursor(), None, "there is nothing");
        double_click(&mut window, nothing);
        assert_eq!(window.state().views(), Views::One(stage));
        assert_eq!(kept(&window), before, "{stage:?}");
        let large = control(&window, &format!("stage {}", NAMES[i])).rect;
        double_click(&mut window, large.right_bottom() - vec2(8.0, 8.0));
        assert_eq!(window.state().views(), Views::Four);
        assert_eq!(kept(&window), before, "{stage:?}");
    }
    // A single click there selects nothing.
    window.wait_s(1.0);
    let nothing = rects(&window)[1].right_bottom() - vec2(8.0, 8.0);
    click(&mut window, nothing);
    assert_eq!(window.state().selection(), None);
}

#[test]
fn the_same_pixel_of_a_view_again_is_the_surface_behind() {
    let (mut window, _folder) = four();
    let [_, world, ..] = rects(&window);
    let point = |window: &Window| {
        let view = window.state().pane_view(Stage::World)?;
        Some(view.project(DVec3::new(0.1, 0.1, 2.5))?.px)
    };
    let at = point(&window).expect("the front cube shows in world");
    #[expect(clippy::cast_possible_truncation, reason = "points of a window")]
    let at = world.min + vec2(at.x as f32, at.y as f32);
    click(&mut window, at);
    let hits = |window: &Window| {
        window
            .state()
            .hits()
            .and_then(|hits| Some((hits.at?, hits.picks.len())))
    };
    let (first, count) = hits(&window).expect("a pick");
    assert!(count > 2, "{count}");
    window.wait_s(1.0);
    click(&mut window, at);
    assert_eq!(hits(&window), Some(((first + 1) % count, count)));
    // The second click of a double click picks what shows there.
    double_click(&mut window, at);
    assert_eq!(hits(&window), Some((first, count)));
}
