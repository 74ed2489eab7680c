//! Two near squares fight under standard depth, and do not under reversed depth.

use crate::{draw, scenes::gpu};
use sightline::{
    camera::{CameraChoice, DepthMapping, View, Viewport},
    geometry::Sides,
    look, pick,
    render::Marks,
    scene::{self, Progress},
};

#[test]
fn near_squares_fight_under_standard_depth_only() {
    let loaded = scene::load(&["gallery:far_over_near".into()], &Progress::default());
    let loaded = loaded.expect("a scene");
    let gpu = gpu();
    for size in [[640, 360], [900, 900]] {
        let viewport = Viewport::new(size[0], size[1]).expect("a size");
        let wrong = [DepthMapping::Standard, DepthMapping::Reversed].map(|depth| {
            let choice = CameraChoice {
                depth: Some(depth),
                ..CameraChoice::default()
            };
            let camera = choice.or(loaded.camera);
            let camera = camera.resolve(&loaded.scene, viewport).expect("a camera");
            let view = View {
                camera,
                viewport,
                sides: Sides::Both,
                section: None,
            };
            let (ids, _, _) = draw(&gpu, &loaded.scene, &view, &[], &Marks::default(), 1);
            let (cast, _) = pick::raycast(&loaded.scene, &view, look::Background::BLACK);
            let id = |name| {
                loaded
                    .scene
                    .objects()
                    .iter()
                    .position(|object| object.name == name)
            };
            let [front, behind] = ["Front", "Behind"].map(|name| id(name).expect("it is there"));
            let pairs = ids.pixels().iter().zip(cast.pixels());
            let is_wrong =
                |drawn: u32, cast: u32| cast as usize == front + 1 && drawn as usize == behind + 1;
            let fronts = cast
                .pixels()
                .iter()
                .filter(|id| id.object as usize == front + 1);
            (
                pairs
                    .filter(|(drawn, cast)| is_wrong(drawn.object, cast.object))
                    .count(),
                fronts.count(),
            )
        });
        let [(standard, all), (reversed, _)] = wrong;
        assert!(all > 1000, "{size:?}: {all}");
        assert!(standard * 10 > all, "{size:?}: {standard} of {all}");
        assert_eq!(reversed, 0, "{size:?}");
    }
}
