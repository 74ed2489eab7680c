//! All methods of a step do one job: they answer the same question from the same inputs, each in the form that its kind
//! is given, and from nothing else.

use sightline::study::{
    methods::{
        boxes::BoxCase, clipping::ClipCase, closed::ClosedCase, normals::NormalCase,
        object_space::PlacedCase, rays::PixelCase, registry, spheres::SphereCase,
        squares::SquareCase, triangles::TriangleCase,
    },
    random::Random,
    step::{
        Case, MethodInfo,
        Precision::{F32, F64},
        Verdict,
    },
};
use std::{collections::HashSet, fmt::Debug};

/// Takes a part of another case.
type Take<C> = fn(&mut C, &C);

/// Pairs of cases for each method.
const PAIRS: usize = 60;

/// Gives each method of a step cases whose parts come from two cases. A method in `f32` must answer as in the case that
/// `narrow` is from, one in `f64` as in that of `wide`, all others as in that of `wide` and `own`; what the rest is from
/// must change nothing. Returns the methods.
fn read_only_their_own<C: Case<Answer: PartialEq + Debug>>(
    [narrow, wide, own]: [Take<C>; 3],
) -> Vec<MethodInfo> {
    let mut random = Random::named(11, &[C::ABOUT.key]);
    let make = C::FAMILIES[0].make;
    let pairs: Vec<[C; 2]> = (0..PAIRS)
        .map(|_| [make(&mut random, 1.0), make(&mut random, 1.0)])
        .collect();
    let methods = C::methods().map(|method| {
        let info = method.info;
        let (read, rest): (Vec<Take<C>>, Vec<Take<C>>) = match (info.precision, info.ours) {
            (F32, _) => (vec![narrow], vec![wide, own]),
            (F64, false) => (vec![wide], vec![narrow, own]),
            _ => (vec![wide, own], vec![narrow]),
        };
        let (mut changed, mut right) = (0, 0);
        for [a, b] in &pairs {
            let [of_a, of_b] = [a, b].map(method.run);
            let (mut mixed, mut other) = (a.clone(), a.clone());
            for take in &read {
                take(&mut mixed, b);
            }
            for take in &rest {
                take(&mut other, b);
            }
            assert_eq!((method.run)(&mixed), of_b, "reads more: {info:?}");
            assert_eq!((method.run)(&other), of_a, "reads another's: {info:?}");
            changed += usize::from(of_a != of_b);
            let verdict = a.judge(&a.truth(), &of_a);
            right += usize::from(match verdict {
                Verdict::Agreed => true,
                Verdict::Right(error) => error < 0.5,
                _ => false,
            });
        }
        assert!(changed > PAIRS / 12, "{changed}: {info:?}");
        // Three methods are known to be wrong; of a closed mesh's rays, which aim at edges, some leak.
        let is_known = ["areas, sum == 1", "M n", "by distance"].contains(&info.name);
        let least = match (is_known, info.step.key) {
            (true, _) => 1,
            (_, "closed-mesh") => PAIRS / 2,
            _ => PAIRS - 2,
        };
        assert!(right >= least, "{right} of {PAIRS}: {info:?}");
        info
    });
    methods.collect()
}

/// The parts of a step's cases, by the names of their fields.
macro_rules! parts {
    ($($own:ident),*) => {
        [
            |case, other| case.narrow = other.narrow.clone(),
            |case, other| case.wide = other.wide.clone(),
            |case, other| {
                $(case.$own = other.$own.clone();)*
            },
        ]
    };
}

#[test]
fn each_method_reads_its_own_inputs_and_answers_its_steps_question() {
    let done = [
        read_only_their_own::<PixelCase>(parts!(rays)),
        read_only_their_own::<PlacedCase>(parts!(ray, placement)),
        read_only_their_own::<TriangleCase>(parts!(ray)),
        read_only_their_own::<ClosedCase>(parts!(ray)),
        read_only_their_own::<SphereCase>(parts!(ray)),
        read_only_their_own::<BoxCase>(parts!(ray)),
        read_only_their_own::<SquareCase>(parts!(ray, placement)),
        read_only_their_own::<ClipCase>(parts!(ray, depth)),
        read_only_their_own::<NormalCase>(parts!(placement)),
    ];
    let done: HashSet<_> = (done.iter().flatten())
        .map(|info| (info.step.key, info.key()))
        .collect();
    // A depth is one number, and whole picks have one scene and one view.
    let rest = registry()
        .into_iter()
        .filter(|info| !done.contains(&(info.step.key, info.key())));
    let rest: HashSet<_> = rest.map(|info| info.step.key).collect();
    assert_eq!(rest, HashSet::from(["depth", "pick"]));
}
