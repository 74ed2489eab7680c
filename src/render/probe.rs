//! Measures an adapter's rasteriser by drawing a few triangles: wgpu does not report it.

use super::{
    abilities::Numbers,
    formats::IDS,
    gpu::{Gpu, GpuError},
    rasteriser::{MOST_BITS, Rasteriser, grid_px},
    readback::read,
    shaders::shader_module,
    without_depth,
};

/// Triangles in each of four groups. Each triangle has a column or row of the picture: see `shaders/probe.wgsl`.
const LANES: u32 = MOST_BITS;
const SIZE: [u32; 2] = [16, 8];

/// Measures the rasteriser. An adapter that numbers triangles wrongly is refused.
///
/// Each triangle has a side that misses a pixel's centre by a little less than half a step of a grid of 2^-bits pixels.
/// A rasteriser with that many bits or fewer snaps the side onto the centre. Of two triangles that lie on opposite
/// sides of their centres, one then covers its pixel, whatever the rule for centres on edges. A rasteriser that
/// truncates moves sides twice as far; it is measured as having one bit less.
pub(super) fn probe(gpu: &Gpu) -> Result<Rasteriser, GpuError> {
    let name = match gpu.numbers {
        Numbers::Primitives => "probe by primitive",
        Numbers::Corners => "probe by corner",
    };
    let module = shader_module(gpu, name);
    let pipeline = without_depth::pipeline(gpu, None, &module, ["vertex", "id"], IDS.into());
    let usage = wgpu::TextureUsages::COPY_SRC;
    let texture = without_depth::texture(gpu, "probe", SIZE, IDS, 1, usage, &[]);
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    gpu.submit(|encoder| {
        let mut pass = without_depth::begin(encoder, &view, without_depth::CLEAR);
        pass.set_pipeline(&pipeline);
        pass.draw(0..4 * LANES * 3, 0..1);
    });
    let pixels = read(gpu, &texture, [0, 0], SIZE, |id: [u32; 2]| id)?;
    let (rasteriser, names_triangles) = found(&pixels);
    if names_triangles {
        return Ok(rasteriser);
    }
    Err(GpuError::Lacks {
        adapter: gpu.adapter_name().to_owned(),
        what: "right numbers of triangles in shaders".to_owned(),
    })
}

/// Evaluates the picture's pixels, given row by row: each is 1 where a triangle is, and the triangle's number plus 1.
/// Returns the rasteriser, and whether it numbers triangles right.
fn found(pixels: &[[u32; 2]]) -> (Rasteriser, bool) {
    // The pixel of a group's lane that is this far along it; the missed one is at 0.
    let at = |group: u32, lane: u32, along: u32| {
        let is_forward = group.is_multiple_of(2);
        let along = if is_forward { along } else { 7 - along };
        let [x, y] = if group < 2 {
            [along, lane]
        } else {
            [8 + lane, along]
        };
        pixels[(y * SIZE[0] + x) as usize]
    };
    let each = || (0..4).flat_map(|group| (0..LANES).map(move |lane| (group, lane)));
    let moved = each().filter(|&(group, lane)| at(group, lane, 0)[0] == 1);
    let bits = moved.map(|(_, lane)| lane + 1).min().unwrap_or(LANES);
    let number = |(group, lane)| [1, group * LANES + lane + 1];
    let names_triangles = each().all(|of| at(of.0, of.1, 1) == number(of));
    let grid_px = grid_px(bits);
    (Rasteriser { grid_px }, names_triangles)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The picture of a rasteriser that snaps to a grid of this many bits by `round`, and numbers triangles by
    /// `number`.
    fn picture(bits: i32, round: fn(f64) -> f64, number: fn(u32) -> u32) -> Vec<[u32; 2]> {
        let mut pixels = vec![[0; 2]; (SIZE[0] * SIZE[1]) as usize];
        let step = 0.5_f64.powi(bits);
        for triangle in 0..4 * LANES {
            let (group, lane) = (triangle / LANES, triangle % LANES);
            let past = 0.5 + 0.375 * 0.5_f64.powi(i32::try_from(lane).expect("few") + 1);
            let is_forward = group.is_multiple_of(2);
            let at = if is_forward { past } else { 8.0 - past };
            let at = round(at / step) * step;
            for along in 0..4 {
                let px = if is_forward { along } else { 7 - along };
                let centre = f64::from(px) + 0.5;
                // Top and left sides belong to a triangle.
                let is_in = (at <= centre) == is_forward;
                let [x, y] = if group < 2 {
                    [px, lane]
                } else {
                    [8 + lane, px]
                };
                if is_in {
                    pixels[(y * SIZE[0] + x) as usize] = [1, number(triangle)];
                }
            }
        }
        pixels
    }

    #[test]
    fn grids_are_told_apart() {
        for bits in 1..=12 {
            let found = |round| found(&picture(bits, round, |i| i + 1)).0.sub_pixel_bits();
            let bits = u32::try_from(bits).expect("few");
            assert_eq!(found(f64::round_ties_even), bits.min(LANES));
            // Truncation moves sides twice as far.
            let cut = found(f64::floor);
            assert_eq!(cut, bits.saturating_sub(1).clamp(1, LANES), "{bits}");
        }
    }

    #[test]
    fn wrong_numbers_are_noticed() {
        let names = |number| found(&picture(8, f64::round, number)).1;
        assert!(names(|i| i + 1));
        assert!(!names(|i| i));
        assert!(!names(|_| 1));
        assert!(!names(|i| 1 + i % 31));
    }
}
