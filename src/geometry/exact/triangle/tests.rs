//! Pairs of `f64` and integers say the same of triangles.

use super::*;
use crate::geometry::random::Random;

/// Rays through an edge that two triangles share, or beside it by as little as one likes; some end there. A third of
/// them lie in the plane x = y with the edge, or the whole triangle, but for a step that may be too small for pairs.
#[test]
fn what_pairs_decide_is_what_integers_say() {
    let mut random = Random(3);
    let [mut hits, mut misses, mut doubts, mut orders] = [0; 4];
    for case in 0..20_000_i32 {
        let mut corner = || random.point().as_vec3().as_dvec3();
        let [mut origin, mut a, mut b, mut c, d] = [(); 5].map(|()| corner());
        let aside = two(-(case % 110)) * random.point();
        let mut direction = 0.5 * (a + b) - origin + aside;
        if case % 3 == 0 {
            [a.y, b.y] = [a.x, b.x];
            if case % 4 == 0 {
                c.y = c.x;
            }
            (origin.x, origin.y) = (0.5 * (a.x + b.x), 0.5 * (a.x + b.x));
            direction = DVec3::new(aside.x, 0.0, c.z);
        }
        let triangle = |third| Corners::new(None, DVec3::ZERO, [a, b, third]);
        let line = Line::Given { origin, direction };
        let end = if case % 2 == 0 { 1.0 } else { f64::INFINITY };
        let interval = Ray::over(origin, direction, [0.0, end]);
        let hit = Hit {
            line,
            triangle: triangle(c),
            interval: &interval,
        };
        match hit.enclosed() {
            Ok(found) => {
                // Shortest digits, so equal to the bit.
                assert_eq!(format!("{found:?}"), format!("{:?}", solve(&hit)));
                hits += i32::from(found.is_some());
                misses += i32::from(found.is_none());
            }
            Err(InDoubt) => doubts += 1,
        }
        let planes = [c, d].map(triangle);
        let both = Both(&line, planes.each_ref());
        match both.enclosed() {
            Ok(order) => {
                assert_eq!(order, solve(&both));
                orders += 1;
            }
            Err(InDoubt) => doubts += 1,
        }
    }
    let counts = [hits, misses, doubts, orders];
    assert!(counts.iter().all(|count| *count > 2000), "{counts:?}");
}

/// A parameter below the least normal number is rounded as integers round it.
#[test]
fn a_subnormal_parameter_is_rounded_as_by_integers() {
    let mut random = Random(8);
    for _ in 0..500 {
        let origin = DVec3::new(0.25, 0.25, -two(-893) * random.next().abs());
        let direction = DVec3::new(0.0, 0.0, two(130) * (1.0 + random.next().abs()));
        let interval = Ray::over(origin, direction, [0.0, 1.0]);
        let hit = Hit {
            line: Line::Given { origin, direction },
            triangle: Corners::new(None, DVec3::ZERO, [DVec3::ZERO, DVec3::X, DVec3::Y]),
            interval: &interval,
        };
        let exact = solve(&hit).expect("it hits").t;
        let found = hit.enclosed().ok().flatten();
        assert!(found.is_none_or(|found| found.t.to_bits() == exact.to_bits()));
    }
}

fn two(power: i32) -> f64 {
    2_f64.powi(power)
}
