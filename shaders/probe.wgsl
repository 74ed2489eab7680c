// Measures the rasteriser's grid: triangles in pixel coordinates, each with a side that misses a pixel's centre by a
// little. A triangle covers that pixel only where the grid moves the side onto the centre.

struct Corner {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(flat) triangle: u32,
}

const SIZE_PX = vec2<f32>(16.0, 8.0);

// The corner with this number. There are four groups of eight triangles, one triangle per lane. In rows they lie right,
// then left of the missed pixels; in columns below, then above. Lane i misses the centre by 3/8 of 2^-(i + 1) pixel:
// less than half a step of that grid.
fn probe(index: u32) -> vec4<f32> {
    let triangle = index / 3u;
    let lane = triangle % 8u;
    let past = 0.5 + ldexp(0.375, -1 - i32(lane));
    // x along the lane, y across it.
    var at = vec2<f32>(past, f32(index % 3u));
    if index % 3u == 2u {
        at = vec2<f32>(3.5, 0.5);
    }
    let group = triangle / 8u;
    at.x = select(at.x, 8.0 - at.x, group % 2u == 1u);
    at.y += f32(lane);
    let px = select(at, vec2<f32>(8.0 + at.y, at.x), group >= 2u);
    let ndc = 2.0 * px / SIZE_PX - 1.0;
    return vec4<f32>(ndc.x, -ndc.y, 0.5, 1.0);
}
