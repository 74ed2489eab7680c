//! The tour through cameras and raycasting: what to do, why, and how the window notices that it is done.

mod just_done;

pub(in crate::viewer) use just_done::JustDone;
use just_done::turns;

use super::{
    command::{Command, TourMove},
    panels::Topic,
};
use crate::{
    camera::{DepthMapping, Projection},
    scene::{Object, Shape},
    viewer::{
        jobs::Checking,
        model::{Action, Compared, LensControls, Overlay, Stage, State, Views},
    },
};
use glam::DVec3;

/// A topic of the lecture.
pub(in crate::viewer) struct Chapter {
    pub title: &'static str,
    steps: &'static [Step],
}

/// Something to do.
pub(in crate::viewer) struct Step {
    pub task: &'static str,
    pub why: &'static str,
    /// A point of view space. The card says where in NDC the present lens puts it.
    pub example: Option<[f64; 3]>,
    /// The step is done in the camera's picture, not in the four views.
    is_in_picture: bool,
    /// What the step begins with; `None` for whatever is there.
    pub start: Option<Start>,
    is_done: fn(&JustDone) -> bool,
}

/// What a step of the tour begins with: the demo's picture, seen as it opened.
#[derive(Clone, Copy)]
pub(in crate::viewer) struct Start {
    /// The object that is picked.
    pub picked: Option<&'static str>,
    /// What is done besides.
    pub then: Then,
    /// The topics of the inspector that are unfolded: the last one comes into view.
    pub topics: &'static [Topic],
}

/// Commands for a state.
type Then = fn(&State) -> Vec<Command>;

impl Start {
    /// With the pick that the tour speaks of most.
    pub const EGG: Self = Self {
        picked: Some(EGG),
        then: |_| Vec::new(),
        topics: &[],
    };
}

/// How far the user is in the tour.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct Tour {
    at: usize,
    /// Whether the step was seen to be done.
    pub is_done: bool,
}

const fn step(task: &'static str, why: &'static str, is_done: fn(&JustDone) -> bool) -> Step {
    Step {
        task,
        why,
        example: None,
        is_in_picture: false,
        start: Some(Start::EGG),
        is_done,
    }
}

impl Step {
    const fn in_picture(mut self) -> Self {
        self.is_in_picture = true;
        self
    }

    const fn about(mut self, topics: &'static [Topic]) -> Self {
        if let Some(start) = &mut self.start {
            start.topics = topics;
        }
        self
    }

    const fn from(mut self, picked: Option<&'static str>, then: Then) -> Self {
        if let Some(start) = &mut self.start {
            (start.picked, start.then) = (picked, then);
        }
        self
    }

    const fn after(self, then: Then) -> Self {
        self.from(Some(EGG), then)
    }

    const fn wherever(mut self) -> Self {
        self.start = None;
        self
    }

    const fn with_example(mut self, point: [f64; 3]) -> Self {
        self.example = Some(point);
        self
    }
}

/// The object that the steps speak of most.
const EGG: &str = "Egg";
/// The object in the background.
const TOWER: &str = "Tower";
/// So near that standard depth has long steps at the tower.
const NEAR: f64 = 0.001;

/// The tour.
const CHAPTERS: [Chapter; 8] = [
    Chapter {
        title: "Axes and the view matrix",
        steps: &[
            step(
                "Drag over the picture with the left button: the camera orbits the point under the cursor.",
                "A camera is a point, the eye, and three axes of length 1: R right, U up and F forward. Nothing in the scene moves.",
                turns,
            )
            .in_picture(),
            step(
                "Drag again and watch V, under Matrices.",
                "V = O T. T moves the eye to the origin. O turns: its rows are R, U and F. In view space x is right, y up and z forward, which makes it left-handed.",
                |done| done.matrices && turns(done),
            )
            .in_picture()
            .about(&[Topic::Matrices]),
        ],
    },
    Chapter {
        title: "Perspective and orthographic",
        steps: &[
            step(
                "Under Camera set fov to 90, near to 1 and far to 10; under Depth buffer set depth to standard.",
                "Perspective divides by depth, so what is far away is small: the point (-1, 1.5, 2) of view space, which is drawn, maps to y = 1.5 / 2 = 3/4, to depth 5/9 and, in a square picture, to x = -1/2.",
                |done| {
                    let lens = done.state.controls();
                    !lens.orthographic
                        && (lens.fov_deg, lens.near, lens.far, lens.depth)
                            == (90.0, Some(1.0), Some(10.0), DepthMapping::Standard)
                },
            )
            .about(&[Topic::DepthBuffer, Topic::Camera])
            .with_example([-1.0, 1.5, 2.0]),
            step(
                "Press 5: orthographic.",
                "Nothing is divided, so size does not depend on depth. In a square picture with a height of 20, near 1, far 10 and standard depth, which can all be set, the point (-2, 5, 0.5) maps to (-0.2, 0.5, -1/18): a depth below 0 is in front of the near plane.",
                |done| done.state.controls().orthographic,
            )
            .about(&[Topic::DepthBuffer, Topic::Camera])
            .after(|state| {
                let lens = LensControls {
                    near: Some(1.0),
                    far: Some(10.0),
                    depth: DepthMapping::Standard,
                    ..state.controls()
                };
                vec![Action::Lens(lens).into()]
            })
            .with_example([-2.0, 5.0, 0.5]),
            step(
                "Press 5 again, then Enter: the view that the scene opened with.",
                "Each projection is one 4 x 4 matrix. The last row of P makes w, by which all else is divided: the depth in perspective, 1 in orthographic.",
                |done| {
                    done.acts(|action| *action == Action::ResetView)
                        && !done.state.controls().orthographic
                },
            )
            .after(|_| vec![Action::ToggleProjection.into()]),
        ],
    },
    Chapter {
        title: "Clipping",
        steps: &[
            step(
                "In the field near type a larger number, such as 9.5, until the near plane has passed the egg.",
                "What lies in front of near or beyond far is cut away. Picture and picks agree on that by one number, depth along F: a hit counts where near <= t < far, and t is that depth.",
                |done| done.near_is_past(EGG),
            )
            .about(&[Topic::Camera]),
            step(
                "Check fit beside near.",
                "A fitted near plane is as far away as the scene allows, which saves digits of the depth buffer.",
                |done| {
                    done.acts(|action| matches!(action, Action::Lens(_)))
                        && done.state.controls().near.is_none()
                },
            )
            .about(&[Topic::Camera])
            .after(|state| {
                let lens = LensControls {
                    near: Some(9.5),
                    ..state.controls()
                };
                vec![Action::Lens(lens).into()]
            }),
        ],
    },
    Chapter {
        title: "From a pixel to a ray",
        steps: &[
            step(
                "Click the egg. A ring with a dot marks the point that the ray hit.",
                "Worked out, at the right, has the numbers of your pick. The position (X, Y) in a picture of W x H pixels is x = 2 X / W - 1, y = 1 - 2 Y / H. The point p = target + x H + y V of the picture's plane lies there, and the ray runs from the eye through p.",
                |done| done.clicks() && done.has_picked(EGG),
            )
            .about(&[Topic::WorkedOut])
            .from(None, |_| Vec::new()),
            step(
                "Press T: the view steps back, and this camera stays behind, as lines. Drag to walk around it.",
                "They show its eye, its frustum, the pixel grid on its near plane and the ray through your pixel, with every surface that it hits. Point at a number under Worked out, and what it is lights up. T looks through the camera again.",
                |done| done.state.frozen().is_some() && turns(done),
            )
            .about(&[Topic::WorkedOut])
            .in_picture(),
        ],
    },
    Chapter {
        title: "Sphere, cube, square, triangle",
        steps: &[
            step(
                "Click the egg, and then the same pixel again.",
                "The egg is a sphere under a matrix. A ray hits it where a quadratic in t is 0: twice, once or never, as its discriminant D = B^2 - 4AC says. The smaller root is the front; the larger one, a back face, gets a ring with a cross.",
                |done| {
                    let further = done.state.hits().is_some_and(|hits| hits.at > Some(0));
                    further && done.clicks_on(|shape| matches!(shape, Shape::Sphere))
                },
            )
            .about(&[Topic::WorkedOut]),
            step(
                "Click the blue box behind the ring.",
                "A cube is where three slabs overlap, one along each axis. A ray is inside each slab between two values of t, and inside the cube from the last entry to the first exit.",
                |done| done.clicks_on(|shape| matches!(shape, Shape::Cube)),
            )
            .about(&[Topic::WorkedOut]),
            step(
                "Click the ground.",
                "A square is part of a plane. The plane gives one t, and two coordinates of the point there tell whether it is in the square.",
                |done| done.clicks_on(|shape| matches!(shape, Shape::Square)),
            )
            .about(&[Topic::WorkedOut]),
            step(
                "Click the ring and turn the wheel over the point, until the picked triangle shows its three weights.",
                "A point of a triangle is a weighted mean of its corners. The weights, its barycentrics, are the shares of its area that S1, S2 and S3 have under Worked out. They add up to 1. Inside the triangle all are positive; on an edge one is 0.",
                |done| {
                    let zooms = done
                        .acts(|action| matches!(action, Action::Zoom(_, factor) if *factor > 1.0));
                    let shows = done.state.overlays().shows(Overlay::Triangle);
                    let is_mesh = |object: &Object| matches!(object.shape, Shape::Mesh { .. });
                    zooms && shows && done.picked().is_some_and(is_mesh)
                },
            )
            .about(&[Topic::WorkedOut]),
        ],
    },
    Chapter {
        title: "Object space and back",
        steps: &[
            step(
                "Press 4: object, world, view and NDC side by side.",
                "Object space has one object before any matrix: there, all spheres are the same. The inverse of M takes a ray there, where it meets the simple shape. Sightline does not normalise it there, so its t stays the same as in the world.",
                |done| done.state.views() == Views::Four,
            ),
            step(
                "Double click the heading of NDC.",
                "After P and the division by w the frustum is a box, and what is far away is small. Normals go from object space to the world by the inverse transpose of M: M itself would tilt them.",
                |done| done.state.views() == Views::One(Stage::Ndc),
            )
            .after(|_| vec![Command::ToggleFour]),
            step(
                "Press 4 again: back to the picture.",
                "A pick compares the hits on all objects by their t, which is the same in every object's space: the smallest wins.",
                |done| {
                    let is_asked = matches!(done.command, Some(Command::ToggleFour));
                    is_asked && done.state.views() == Views::Picture
                },
            )
            .after(|_| {
                let ndc = Action::Views(Views::One(Stage::Ndc));
                vec![Command::ToggleFour, ndc.into()]
            }),
        ],
    },
    Chapter {
        title: "Near, far and the depth buffer",
        steps: &[
            step(
                "Set near to 0.001 and, under Depth buffer, depth to standard. Click the tower.",
                "Standard depth is a + b / z. Nearly all of its f32 values lie just beyond near. At the tower they are far apart, and two surfaces within one step look like one.",
                |done| {
                    let lens = done.state.controls();
                    let near = lens.near.is_some_and(|near| near <= NEAR);
                    near && lens.depth == DepthMapping::Standard
                        && done.has_picked(TOWER)
                        && done.command == Some(&Command::ShowsDepthSteps)
                },
            )
            .about(&[Topic::Camera, Topic::DepthBuffer]),
            step(
                "Set depth to reversed.",
                "Reversed depth puts far at 0, where f32 has most of its values: that makes up for 1 / z. Enter brings back the view that the scene opened with.",
                |done| {
                    done.acts(|action| matches!(action, Action::Lens(_)))
                        && done.state.controls().depth == DepthMapping::Reversed
                },
            )
            .about(&[Topic::DepthBuffer])
            .from(Some(TOWER), |state| {
                let lens = LensControls {
                    near: Some(NEAR),
                    depth: DepthMapping::Standard,
                    ..state.controls()
                };
                vec![Action::Lens(lens).into()]
            }),
        ],
    },
    Chapter {
        title: "Where methods fail",
        steps: &[
            step(
                "Press E for the failure gallery's first scene, then M: the test of Moeller & Trumbore in f32 picks now. Find a pixel where it fails and click it.",
                "Every wrong pixel is marked. f32 keeps 24 bits of a number. The difference of two large ones keeps only the last few, rounding noise, which then decides on which side of an edge the ray passes.",
                |done| {
                    let showing = done.state.showing();
                    let compared = showing.and_then(|showing| showing.compared.as_ref());
                    let fault = compared.and_then(Compared::fault);
                    let method = done.state.method();
                    method.is_some_and(|method| method.info().name == "Moeller-Trumbore")
                        && fault.is_some_and(|fault| fault.is_wrong())
                },
            ),
            step(
                "Press Escape until the demo is back.",
                "Sightline computes in f64, with a bound on the rounding error. Where the bound leaves an answer open, exact arithmetic decides.",
                |done| done.command == Some(&Command::Escape) && done.state.showing().is_none(),
            )
            .wherever(),
            step(
                "Press V.",
                "Every pixel as drawn is compared with what a click there picks. That is the promise of this program, checked on your machine.",
                |done| !matches!(done.checking, Checking::Off),
            ),
            step(
                "Click anything, then press C and paste the command into a terminal (cargo install --path . installs sightline).",
                "It prints the same pick, to the last bit. That was the tour. Ctrl+O opens your own files.",
                |done| done.command == Some(&Command::CopyCommandLine) && done.picked().is_some(),
            ),
        ],
    },
];

impl Tour {
    /// All steps.
    pub fn steps() -> impl Iterator<Item = &'static Step> {
        CHAPTERS.iter().flat_map(|chapter| chapter.steps)
    }

    /// The chapter's number from 1, the chapter, and the step.
    pub fn step(self) -> (usize, &'static Chapter, &'static Step) {
        let steps = CHAPTERS.iter().enumerate().flat_map(|(at, chapter)| {
            let steps = chapter.steps.iter();
            steps.map(move |step| (at + 1, chapter, step))
        });
        let mut from_here = steps.skip(self.at);
        from_here.next().expect("a tour is at one of its steps")
    }

    /// How many steps there are, and how many of them lie behind.
    pub fn progress(self) -> (usize, usize) {
        (Self::steps().count(), self.at)
    }

    /// Where a move leads; `None` ends the tour.
    pub fn after(self, to: TourMove) -> Option<Self> {
        let (count, at) = self.progress();
        let at = match to {
            TourMove::Begin => 0,
            TourMove::Back => at.saturating_sub(1),
            TourMove::Next => at + 1,
            TourMove::End => return None,
        };
        (at < count).then_some(Self { at, is_done: false })
    }

    /// Checks whether the step is done by now; returns whether it has just been done.
    pub fn notice(&mut self, done: &JustDone) -> bool {
        let (_, _, step) = self.step();
        let was_done = self.is_done;
        self.is_done |= (step.is_done)(done);
        self.is_done != was_done
    }
}

impl Step {
    /// What the card adds in the present state: where the lens puts the step's point, or that the four views are in the
    /// way.
    pub fn now(&self, state: &State) -> Option<String> {
        let elsewhere = "Here a drag turns one view alone: press 4 for the picture first.";
        if self.is_in_picture && state.views() != Views::Picture {
            return Some(elsewhere.to_owned());
        }
        self.example(state)
    }

    fn example(&self, state: &State) -> Option<String> {
        let [a, b, c] = self.example?;
        let DVec3 { x, y, z } = state.example_of(DVec3::new(a, b, c)).ndc;
        let height = match state.view().camera.lens().projection {
            Projection::Perspective { .. } => String::new(),
            Projection::Orthographic { height } => format!(" and {height:.4} high"),
        };
        Some(format!(
            "Now: ({a}, {b}, {c}) maps to ({x:.4}, {y:.4}, {z:.4}), in a picture {:.4} times as wide as high{height}.",
            state.view().viewport.aspect()
        ))
    }
}
