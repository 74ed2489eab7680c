//! Enlarges a coarse picture on the processor. Software adapters take several times as long for each of its pixels.

use super::{
    Destination,
    formats::reordered,
    gpu::{Gpu, GpuError},
    readback,
    targets::Targets,
    without_depth,
};

impl Targets {
    /// Writes the colours into a destination, as they are stored. Each pixel of the picture covers `coarseness` pixels
    /// there along each side. The destination's texture must allow copies to it.
    ///
    /// # Errors
    /// When memory runs out or the device is lost.
    pub(super) fn enlarge(&self, gpu: &Gpu, onto: &Destination<'_>) -> Result<(), GpuError> {
        let size = [self.viewport.width(), self.viewport.height()];
        let Some([x, y, width, height]) = onto.within([0, 0, size[0], size[1]]) else {
            return Ok(());
        };
        let stored = reordered(onto.texture.format());
        let pixels = readback::read(gpu, self.colour_view.texture(), [0, 0], size, stored)?;
        let (times, row) = (onto.coarseness as usize, width as usize);
        let mut enlarged = vec![[0; 4]; row * height as usize];
        let bands = enlarged.chunks_mut(row * times);
        for (band, pixels) in bands.zip(pixels.chunks_exact(size[0] as usize)) {
            let (first, others) = band.split_at_mut(row);
            for (to, pixel) in first.chunks_mut(times).zip(pixels) {
                to.fill(*pixel);
            }
            for other in others.chunks_exact_mut(row) {
                other.copy_from_slice(first);
            }
        }
        gpu.queue.write_texture(
            without_depth::at(onto.texture, [x, y]),
            bytemuck::cast_slice(&enlarged),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(4 * width),
                rows_per_image: None,
            },
            without_depth::extent([width, height]),
        );
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        camera::{CameraChoice, View, Viewport},
        geometry::Placement,
        image::Image,
        render::{
            Destination, Gpu, Marks, Renderer, SceneBuffers, Targets, formats::COLOUR, readback,
            without_depth,
        },
        scene::{Object, Scene, Shape},
    };
    use wgpu::{TextureFormat, TextureUsages};

    /// Into textures of both orders of channels, at a corner that cuts off a part of the last pixels.
    #[test]
    fn a_coarse_picture_covers_its_room_pixel_by_pixel() {
        const TIMES: u32 = 3;
        let gpu = Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
        let scene: Scene = [Object::new("", Shape::Cube, Placement::IDENTITY)]
            .into_iter()
            .collect();
        let buffers = SceneBuffers::upload(&gpu, &scene).expect("it fits");
        let size = Viewport::new(40, 30).expect("a size");
        let camera = CameraChoice::default().resolve(&scene.bounds(), size);
        let view = View::new(camera.expect("it is framed"), size);
        let targets = Targets::new(&gpu, size, 1).expect("it fits");
        let mut renderer = Renderer::new(&gpu, 1);
        (renderer.draw((&buffers, &targets, &view), &[])).expect("it fits");
        let coarse = targets.read_colours(&gpu).expect("it is read");
        let colours = |picture: &[[u8; 3]]| {
            let mut all = picture.to_vec();
            all.sort_unstable();
            all.dedup();
            all.len()
        };
        assert!(colours(coarse.pixels()) > 10, "not one colour alone");
        let page = Viewport::new(120, 90).expect("a size");
        for format in [COLOUR, TextureFormat::Bgra8Unorm] {
            let formats = [format.add_srgb_suffix(), format.remove_srgb_suffix()];
            let usage = TextureUsages::COPY_SRC | TextureUsages::COPY_DST;
            let size = [page.width(), page.height()];
            let texture = without_depth::texture(&gpu, "page", size, format, 1, usage, &formats);
            let onto = Destination {
                texture: &texture,
                origin_px: [7, 5],
                room_px: [112, 80],
                coarseness: TIMES,
            };
            let marks = Marks::default();
            (renderer.composite((&buffers, &targets, &view), &marks, &onto)).expect("it fits");
            let stored = |[first, second, third, _]: [u8; 4]| [first, second, third];
            let pixels = readback::read(&gpu, &texture, [0, 0], size, stored).expect("it is read");
            let picture = Image::new(page, pixels);
            for y in 0..90 {
                for x in 0..120 {
                    let is_in = (7..7 + 112).contains(&x) && (5..5 + 80).contains(&y);
                    let wanted = if is_in {
                        let [r, g, b] = coarse.at((x - 7) / TIMES, (y - 5) / TIMES);
                        if format == COLOUR {
                            [r, g, b]
                        } else {
                            [b, g, r]
                        }
                    } else {
                        [0; 3]
                    };
                    assert_eq!(picture.at(x, y), wanted, "{format:?} {x} {y}");
                }
            }
        }
    }
}
