//! Makes the pipelines: which shader draws what in which pass. Pipelines and shader modules are made at first use,
//! since they take milliseconds and most programs need few.

use super::{
    abilities::Numbers,
    bindings,
    formats::{COLOUR, DEPTH, IDS},
    gpu::Gpu,
    shader_structs::{Batch, LineEnd, Vertex},
    shaders::shader_module,
};
use crate::{
    camera::{DepthMapping, NdcSpace, View},
    geometry::Sides,
};
use std::{collections::HashMap, mem::offset_of};
use wgpu::{CompareFunction, Face, PrimitiveTopology, VertexAttribute, VertexFormat};

/// What a pass writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Pass {
    /// Colours and ids at one sample.
    ColourAndIds,
    /// Colours at several samples.
    Colour,
    /// Ids.
    Ids,
}

impl Pass {
    /// Whether it writes colours, which include lines and background.
    pub fn has_colours(self) -> bool {
        matches!(self, Self::ColourAndIds | Self::Colour)
    }
}

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Drawn {
    /// Triangles. With `Some`, only those that face the eye, under matrices that mirror (`true`) or do not.
    Triangles { culled_mirrored: Option<bool> },
    /// Spheres, which cull themselves.
    Spheres,
    /// Edges of triangles, over their faces.
    Edges,
    /// Lines.
    Lines,
    /// The background.
    Background,
    /// Given depths, and nothing else.
    Depths,
}

/// What the surfaces that are drawn are part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum World {
    /// The world. Lines and background belong to it always.
    Whole,
    /// What a section leaves of it.
    Cut,
    /// A camera's NDC.
    Ndc,
}

impl World {
    /// What a view of the world shows, or of a camera's NDC.
    pub fn of(ndc: Option<&NdcSpace>, view: &View) -> Self {
        match (ndc, view.section) {
            (Some(_), _) => Self::Ndc,
            (None, Some(_)) => Self::Cut,
            (None, None) => Self::Whole,
        }
    }
}

/// What a pipeline depends on.
type Key = (Pass, Drawn, DepthMapping, World);

/// All pipelines that draw the scene.
#[derive(Debug)]
pub(super) struct Pipelines {
    /// Frame, objects and spheres.
    pub bind_group_layout: wgpu::BindGroupLayout,
    layout: wgpu::PipelineLayout,
    modules: HashMap<&'static str, wgpu::ShaderModule>,
    /// Samples of [`Pass::Colour`].
    pub samples: u32,
    made: HashMap<Key, wgpu::RenderPipeline>,
}

const VERTEX: wgpu::VertexBufferLayout = wgpu::VertexBufferLayout {
    array_stride: size_of::<Vertex>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &[
        attribute(0, VertexFormat::Float32x3, offset_of!(Vertex, position)),
        attribute(1, VertexFormat::Float32x3, offset_of!(Vertex, normal)),
        attribute(2, VertexFormat::Uint32, offset_of!(Vertex, part)),
        attribute(3, VertexFormat::Unorm16x4, offset_of!(Vertex, colour)),
    ],
};

/// The vertex buffer slot of the attributes of triangles' instances.
pub(super) const BATCHES: u32 = 1;

const BATCH: wgpu::VertexBufferLayout = wgpu::VertexBufferLayout {
    array_stride: size_of::<Batch>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &[
        // The pivot and its view depth.
        attribute(4, VertexFormat::Float32x4, offset_of!(Batch, pivot)),
        column(5, offset_of!(Batch, linear), 0),
        column(6, offset_of!(Batch, linear), 1),
        column(7, offset_of!(Batch, linear), 2),
        attribute(8, VertexFormat::Float32x3, offset_of!(Batch, translation)),
        column(9, offset_of!(Batch, normal), 0),
        column(10, offset_of!(Batch, normal), 1),
        column(11, offset_of!(Batch, normal), 2),
        // Object of part 0, first triangle and flags.
        attribute(
            12,
            VertexFormat::Uint32x3,
            offset_of!(Batch, object_of_part_0),
        ),
    ],
};

/// A line is an instance: both its ends.
const LINE: wgpu::VertexBufferLayout = wgpu::VertexBufferLayout {
    array_stride: size_of::<[LineEnd; 2]>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &[
        attribute(0, VertexFormat::Float32x4, POSITION_OF_END),
        // With the opacity.
        attribute(1, VertexFormat::Float32x4, COLOUR_OF_END),
        attribute(
            2,
            VertexFormat::Float32x4,
            size_of::<LineEnd>() + POSITION_OF_END,
        ),
        attribute(
            3,
            VertexFormat::Float32x4,
            size_of::<LineEnd>() + COLOUR_OF_END,
        ),
    ],
};
const POSITION_OF_END: usize = offset_of!(LineEnd, position);
const COLOUR_OF_END: usize = offset_of!(LineEnd, colour);

const fn attribute(shader_location: u32, format: VertexFormat, offset: usize) -> VertexAttribute {
    VertexAttribute {
        format,
        offset: offset as u64,
        shader_location,
    }
}

/// A column of a matrix.
const fn column(shader_location: u32, matrix: usize, column: usize) -> VertexAttribute {
    attribute(
        shader_location,
        VertexFormat::Float32x3,
        matrix + column * size_of::<[f32; 3]>(),
    )
}

impl Pipelines {
    pub fn new(gpu: &Gpu, samples: u32) -> Self {
        let types = [
            wgpu::BufferBindingType::Uniform,
            wgpu::BufferBindingType::Storage { read_only: true },
            wgpu::BufferBindingType::Storage { read_only: true },
        ];
        let types = types.map(bindings::buffer);
        let (bind_group_layout, layout) =
            bindings::layouts(gpu, "scene", wgpu::ShaderStages::VERTEX_FRAGMENT, &types);
        Self {
            bind_group_layout,
            layout,
            modules: HashMap::new(),
            samples,
            made: HashMap::new(),
        }
    }

    pub fn get(
        &mut self,
        gpu: &Gpu,
        pass: Pass,
        drawn: Drawn,
        view: &View,
        world: World,
    ) -> wgpu::RenderPipeline {
        let key = key(pass, drawn, view, world);
        if let Some(pipeline) = self.made.get(&key) {
            return pipeline.clone();
        }
        let pipeline = self.make(gpu, key);
        self.made.insert(key, pipeline.clone());
        pipeline
    }

    /// Makes one pipeline that pictures of a view need, if any is missing. Returns whether one was.
    pub fn make_ahead(&mut self, gpu: &Gpu, view: &View) -> bool {
        let culled: &[_] = match view.sides {
            Sides::Both => &[None],
            Sides::Front => &[Some(false), Some(true)],
        };
        let culled = culled.iter().copied();
        let triangles = culled.map(|culled_mirrored| Drawn::Triangles { culled_mirrored });
        let surfaces = triangles.chain([Drawn::Spheres]);
        let passes: &[_] = match self.samples {
            1 => &[Pass::ColourAndIds],
            _ => &[Pass::ColourAndIds, Pass::Colour, Pass::Ids],
        };
        let mut all = passes.iter().flat_map(|&pass| {
            let others = [Drawn::Background, Drawn::Lines].into_iter();
            let drawn = surfaces
                .clone()
                .chain(others.filter(move |_| pass.has_colours()));
            drawn.map(move |drawn| (pass, drawn))
        });
        let world = World::of(None, view);
        let is_missing = |(pass, drawn)| !self.made.contains_key(&key(pass, drawn, view, world));
        let missing = all.find(|kind| is_missing(*kind));
        if let Some((pass, drawn)) = missing {
            self.get(gpu, pass, drawn, view, world);
        }
        missing.is_some()
    }

    fn make(&mut self, gpu: &Gpu, (pass, drawn, depth, world): Key) -> wgpu::RenderPipeline {
        // NDC is cut, too: by the near plane.
        let is_cut = world != World::Whole;
        let (uncut, cut) = match pass {
            Pass::ColourAndIds => ("colour_and_id", "colour_and_id_cut"),
            Pass::Colour => ("colour", "colour_cut"),
            Pass::Ids => ("id", "id_cut"),
        };
        let surface_entry = if is_cut { cut } else { uncut };
        let vertex = match world {
            World::Ndc => "vertex_in_ndc",
            _ => "vertex",
        };
        let triangle_vertex = match surface_entry {
            "colour" => "colour_vertex",
            _ => vertex,
        };
        let edge_entry = if is_cut { "edge_cut" } else { "edge" };
        let edge_vertex = match world {
            World::Ndc => "edge_vertex_in_ndc",
            _ => "edge_vertex",
        };
        let mesh = match gpu.numbers {
            Numbers::Primitives => "mesh by primitive",
            Numbers::Corners => "mesh by corner",
        };
        let (module, vertex, fragment) = match drawn {
            Drawn::Triangles { .. } => (mesh, triangle_vertex, surface_entry),
            Drawn::Edges => (mesh, edge_vertex, edge_entry),
            Drawn::Spheres => ("sphere", "vertex", surface_entry),
            Drawn::Lines => ("background and lines", "line_vertex", "line_colour"),
            Drawn::Background => ("background and lines", "behind", "background_colour"),
            Drawn::Depths => ("background and lines", "cover", "given_depth"),
        };
        let module = self.modules.entry(module);
        let module = &*module.or_insert_with_key(|name| shader_module(gpu, name));
        let buffers: &[Option<wgpu::VertexBufferLayout>] = match drawn {
            Drawn::Triangles { .. } | Drawn::Edges => &[Some(VERTEX), Some(BATCH)],
            Drawn::Lines => &[Some(LINE)],
            Drawn::Spheres | Drawn::Background | Drawn::Depths => &[],
        };
        let on_surfaces = matches!(drawn, Drawn::Triangles { .. } | Drawn::Spheres);
        let (all, none) = (wgpu::ColorWrites::ALL, wgpu::ColorWrites::empty());
        let write = |format, writes| {
            Some(wgpu::ColorTargetState {
                format,
                // Lines and edges may fade into what is behind them.
                blend: (matches!(drawn, Drawn::Lines | Drawn::Edges) && format == COLOUR)
                    .then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                write_mask: if writes { all } else { none },
            })
        };
        let targets = match pass {
            // Lines and background are not in the ids.
            Pass::ColourAndIds => {
                let has_colour = drawn != Drawn::Depths;
                vec![write(COLOUR, has_colour), write(IDS, on_surfaces)]
            }
            Pass::Colour => vec![write(COLOUR, true)],
            Pass::Ids => vec![write(IDS, true)],
        };
        let samples = match pass {
            Pass::Colour => self.samples,
            _ => 1,
        };
        gpu.device
            .create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(fragment),
                layout: Some(&self.layout),
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some(vertex),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers,
                },
                primitive: primitive(drawn),
                depth_stencil: Some(depth_state(drawn, depth)),
                multisample: wgpu::MultisampleState {
                    count: samples,
                    ..Default::default()
                },
                fragment: Some(wgpu::FragmentState {
                    module,
                    entry_point: Some(fragment),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &targets,
                }),
                multiview_mask: None,
                cache: None,
            })
    }
}

fn key(pass: Pass, drawn: Drawn, view: &View, world: World) -> Key {
    let world = match drawn {
        Drawn::Lines | Drawn::Background | Drawn::Depths => World::Whole,
        _ => world,
    };
    (pass, drawn, view.camera.lens().depth, world)
}

/// Counter-clockwise in the world is counter-clockwise in the picture, unless the model matrix mirrors: then the
/// winding is reversed, and the other side is culled. (That view space is left-handed does not matter: its x runs right
/// and its y up, as in NDC.)
fn primitive(drawn: Drawn) -> wgpu::PrimitiveState {
    let culled = |mirrors| if mirrors { Face::Front } else { Face::Back };
    let (topology, cull_mode) = match drawn {
        Drawn::Triangles { culled_mirrored } => {
            (PrimitiveTopology::TriangleList, culled_mirrored.map(culled))
        }
        Drawn::Spheres | Drawn::Lines => (PrimitiveTopology::TriangleStrip, None),
        Drawn::Edges | Drawn::Background | Drawn::Depths => (PrimitiveTopology::TriangleList, None),
    };
    wgpu::PrimitiveState {
        topology,
        front_face: wgpu::FrontFace::Ccw,
        cull_mode,
        polygon_mode: match drawn {
            Drawn::Edges => wgpu::PolygonMode::Line,
            _ => wgpu::PolygonMode::Fill,
        },
        ..Default::default()
    }
}

/// The comparison is strict: at equal depth the surface drawn first stays, which is that of the object or
/// triangle with the lower index. The background lies at the cleared depth, and shows only where no surface was drawn:
/// edges, which leave no depth, end at outlines.
fn depth_state(drawn: Drawn, depth: DepthMapping) -> wgpu::DepthStencilState {
    let (nearer, as_near, step_nearer) = match depth {
        DepthMapping::Reversed => (
            CompareFunction::Greater,
            CompareFunction::GreaterEqual,
            1_i8,
        ),
        DepthMapping::Standard => (CompareFunction::Less, CompareFunction::LessEqual, -1),
    };
    // An edge is as deep as its faces, but is rasterised at other points of them. A depth bias of 1.5 pixels' slope and
    // 4 units brings it in front of them.
    let towards_the_eye = wgpu::DepthBiasState {
        constant: 4 * i32::from(step_nearer),
        slope_scale: 1.5 * f32::from(step_nearer),
        clamp: 0.0,
    };
    wgpu::DepthStencilState {
        format: DEPTH,
        depth_write_enabled: Some(!matches!(drawn, Drawn::Background | Drawn::Edges)),
        depth_compare: Some(match drawn {
            Drawn::Background => as_near,
            Drawn::Depths => CompareFunction::Always,
            _ => nearer,
        }),
        stencil: wgpu::StencilState::default(),
        bias: match drawn {
            Drawn::Edges => towards_the_eye,
            _ => wgpu::DepthBiasState::default(),
        },
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        camera::{CameraChoice, View, Viewport},
        colour::Srgb,
        geometry::{Placement, Sides},
        render::{Gpu, Line, Marks, Renderer, SMOOTH_SAMPLES, SceneBuffers, Targets},
        scene::{Object, Scene, Shape},
    };
    use glam::DVec3;

    /// The scene has triangles and a sphere, selected and lit. Pictures have smooth edges and rough ones.
    #[test]
    fn a_picture_makes_no_pipeline_once_all_are_made_ahead() {
        let gpu = Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
        let shapes = [Shape::Cube, Shape::Sphere];
        let object = |shape| Object::new("", shape, Placement::IDENTITY);
        let scene: Scene = shapes.map(object).into_iter().collect();
        let buffers = SceneBuffers::upload(&gpu, &scene).expect("it fits");
        let size = Viewport::new(64, 64).expect("a size");
        let camera = CameraChoice::default().resolve(&scene.bounds(), size);
        let view = View::new(camera.expect("it is framed"), size);
        for samples in [1, SMOOTH_SAMPLES] {
            for sides in [Sides::Both, Sides::Front] {
                let view = View { sides, ..view };
                let mut renderer = Renderer::new(&gpu, samples);
                let mut count = 0;
                while renderer.make_ahead(&view) {
                    count += 1;
                }
                let line = Line::new(DVec3::ZERO, DVec3::X, Srgb::NEUTRAL);
                let targets = Targets::new(&gpu, view.viewport, samples).expect("it fits");
                let onto = (&buffers, &targets, &view);
                renderer.draw_rough(onto, &[line]).expect("it fits");
                renderer.draw(onto, &[line]).expect("it fits");
                for object in 0..2 {
                    renderer.draw_outline(onto, &[object]);
                    let marks = Marks {
                        selection: vec![object],
                        hover: Some(1 - object),
                    };
                    renderer.mark(onto, &marks);
                }
                let for_marks = renderer.post.as_ref().map_or(0, |post| post.made.len());
                let made = renderer.pipelines.made.len() + for_marks;
                assert_eq!(made, count, "{samples} {sides:?}");
                // Those of marks; spheres, and triangles of each winding that is culled; background and lines.
                let surfaces = if sides == Sides::Front { 3 } else { 2 };
                let several = if samples > 1 {
                    surfaces + 2 + surfaces
                } else {
                    0
                };
                assert_eq!(count, 3 + surfaces + 2 + several, "{samples} {sides:?}");
            }
        }
    }
}
