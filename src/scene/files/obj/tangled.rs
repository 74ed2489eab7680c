//! Finds large polygons whose outlines cross themselves. Earcut takes cubic time on some of these: hours for one face.

/// Whether an outline that should be counter-clockwise is found to cross itself. One that is not found may still touch
/// itself, like a bridge to a hole. Beyond sorting, it takes time only where many sides lie above each other.
pub(super) fn is_tangled(flat: &[[f64; 2]]) -> bool {
    !turns_once(flat) || has_crossing(flat)
}

/// Whether the direction of the sides turns once around, as that of each simple outline does. A side that goes straight
/// back may turn either way.
fn turns_once(flat: &[[f64; 2]]) -> bool {
    let sides = sides(flat).map(|[[ax, ay], [bx, by]]| [bx - ax, by - ay]);
    let sides: Vec<_> = sides.filter(|[x, y]| *x != 0.0 || *y != 0.0).collect();
    let (mut turns, mut back) = (0_i32, 0);
    for (&[ax, ay], &[bx, by]) in sides.iter().zip(sides.iter().cycle().skip(1)) {
        let left = ax * by - ay * bx;
        // A turn counts where the direction passes that of x.
        if left > 0.0 && ay < 0.0 && by >= 0.0 {
            turns += 1;
        } else if left < 0.0 && ay >= 0.0 && by < 0.0 {
            turns -= 1;
        } else if left == 0.0 && ax * bx + ay * by < 0.0 {
            back += 1;
        }
    }
    (turns - 1).abs() <= back
}

/// Whether two sides cross between their ends, further than rounding may deceive.
fn has_crossing(flat: &[[f64; 2]]) -> bool {
    let along_x = |[a, b]: [[f64; 2]; 2]| if a[0] <= b[0] { [a, b] } else { [b, a] };
    let mut sides: Vec<_> = sides(flat).map(along_x).collect();
    sides.sort_by(|[a, _], [b, _]| a[0].total_cmp(&b[0]));
    sides.iter().enumerate().any(|(i, &[a, b])| {
        let (low, high) = (a[1].min(b[1]), a[1].max(b[1]));
        let later = sides[i + 1..].iter().take_while(|[c, _]| c[0] < b[0]);
        let beside = later.filter(|[c, d]| c[1].max(d[1]) > low && c[1].min(d[1]) < high);
        let mut beside = beside.copied();
        beside.any(|[c, d]| {
            side_of([a, b], c) * side_of([a, b], d) < 0.0
                && side_of([c, d], a) * side_of([c, d], b) < 0.0
        })
    })
}

fn sides(flat: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let ends = flat.iter().zip(flat.iter().cycle().skip(1));
    ends.map(|(&a, &b)| [a, b])
}

/// The side of a line on which a point lies, 1 or -1; 0 if rounding may decide it.
fn side_of([a, b]: [[f64; 2]; 2], c: [f64; 2]) -> f64 {
    let left = (a[0] - c[0]) * (b[1] - c[1]);
    let right = (a[1] - c[1]) * (b[0] - c[0]);
    // The bound of Shewchuk's predicates, rounded up.
    if (left - right).abs() > 4.0 * f64::EPSILON * (left.abs() + right.abs()) {
        (left - right).signum()
    } else {
        0.0
    }
}
