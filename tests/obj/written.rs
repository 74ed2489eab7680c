//! A mesh reads back the same in whichever of the format's ways it is written.

use super::{Folder, common::Random, parts, triangles, vector_area};
use glam::{DVec3, Vec3};
use sightline::{colour::Srgb, geometry::Mesh};

const FILES: u64 = 400;
const NAMES: [&str; 5] = ["Cube", "Würfel 2", "a#b", "-", "Cube"];

/// The expected contents of a file.
struct Model {
    vertices: Vec<(DVec3, Option<Srgb>)>,
    normals: Vec<Vec3>,
    materials: Vec<Srgb>,
    objects: Vec<(&'static str, Vec<Face>)>,
}

struct Face {
    corners: Vec<usize>,
    normals: Option<Vec<usize>>,
    material: Option<usize>,
}

struct Dice(Random);

impl Dice {
    /// A whole number below `end`.
    fn whole(&mut self, end: u32) -> f64 {
        (self.0.unit() * f64::from(end)).floor()
    }

    fn below(&mut self, end: usize) -> usize {
        self.0.below(end)
    }

    fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// A point with coordinates in multiples of 1/64. `f32` stores them exactly, and sums and products of a few are
    /// exact.
    fn point(&mut self) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.whole(1024) / 64.0 - 8.0))
    }

    fn colour(&mut self) -> Srgb {
        Srgb([0; 3].map(|_| u8::try_from(self.below(256)).expect("a byte")))
    }
}

impl Model {
    fn new(dice: &mut Dice) -> Self {
        let colours = dice.one_in(3);
        let mut model = Self {
            vertices: (0..3 + dice.below(20))
                .map(|_| (dice.point(), None))
                .collect(),
            normals: (0..dice.below(4))
                .map(|_| dice.0.direction().as_vec3())
                .collect(),
            materials: (0..dice.below(4)).map(|_| dice.colour()).collect(),
            objects: Vec::new(),
        };
        let mut material = None;
        for _ in 0..=dice.below(4) {
            let mut faces = Vec::new();
            for _ in 0..=dice.below(6) {
                if !model.materials.is_empty() && dice.one_in(3) {
                    material = Some(dice.below(model.materials.len()));
                }
                let corners = if dice.one_in(3) {
                    model.polygon(dice)
                } else {
                    model.triangle(dice)
                };
                let normals = (!model.normals.is_empty() && dice.one_in(2)).then(|| {
                    corners
                        .iter()
                        .map(|_| dice.below(model.normals.len()))
                        .collect()
                });
                faces.push(Face {
                    corners,
                    normals,
                    material,
                });
            }
            model.objects.push((dice.one_of(&NAMES), faces));
        }
        for (_, colour) in &mut model.vertices {
            *colour = (colours && dice.one_in(2)).then(|| dice.colour());
        }
        model
    }

    fn triangle(&self, dice: &mut Dice) -> Vec<usize> {
        loop {
            let corners: Vec<usize> = (0..3).map(|_| dice.below(self.vertices.len())).collect();
            let [a, b, c] = [0, 1, 2].map(|i| self.vertices[corners[i]].0);
            if vector_area([a, b, c]) != DVec3::ZERO {
                return corners;
            }
        }
    }

    /// A polygon of new vertices along a parabola.
    fn polygon(&mut self, dice: &mut Dice) -> Vec<usize> {
        let (start, across, up) = (dice.point(), dice.point(), dice.point());
        let first = self.vertices.len();
        let corners = 4 + dice.below(5);
        let steps = std::iter::successors(Some(0.0), |i| Some(i + 1.0)).take(corners);
        let along = steps.map(|i| start + i * across + i * i * up);
        self.vertices.extend(along.map(|vertex| (vertex, None)));
        (first..first + corners).collect()
    }
}

/// Writes a file. Wherever the format allows several ways, one is chosen at random for each word.
struct Writer<'a> {
    dice: &'a mut Dice,
    line_end: &'static str,
    text: String,
}

impl Writer<'_> {
    fn line(&mut self, words: &[String]) {
        for (place, word) in words.iter().enumerate() {
            if place > 0 {
                let gap = match self.dice.below(12) {
                    0 => "\t",
                    1 => "   ",
                    2 => &format!(" \\{}  ", self.line_end),
                    _ => " ",
                };
                self.text += gap;
            }
            self.text += word;
        }
        self.text += self.dice.one_of(&["", "", "", " ", " # a comment", "\t"]);
        self.text += self.line_end;
        if self.dice.one_in(4) {
            self.text += self
                .dice
                .one_of(&["", "  ", "# f 1 2 3", "s off", "vt 0 1"]);
            self.text += self.line_end;
        }
    }

    fn name(&mut self, keyword: &str, name: &str) {
        let gap = self.dice.one_of(&[" ", "\t", "  "]);
        self.text += &[keyword, gap, name, self.line_end].concat();
    }

    fn number(&mut self, value: f64) -> String {
        match self.dice.below(5) {
            0 => format!("{value:e}"),
            1 => format!("{value:+}"),
            2 => format!("{value:.6}"),
            3 if value.fract().abs() < 1.0 / 128.0 => format!("{value}."),
            _ => format!("{value}"),
        }
    }

    fn vertex(&mut self, (point, colour): (DVec3, Option<Srgb>)) {
        let mut words = vec!["v".to_owned()];
        words.extend(point.to_array().map(|c| self.number(c)));
        if let Some(Srgb(channels)) = colour {
            words.extend(channels.map(|c| (f64::from(c) / 255.0).to_string()));
        } else if self.dice.one_in(8) {
            words.push("1.0".to_owned());
        }
        self.line(&words);
    }

    /// `vertices` is the number of vertices that are written above.
    fn face(&mut self, face: &Face, vertices: usize, model: &Model) {
        let mut words = vec!["f".to_owned()];
        for (place, &corner) in face.corners.iter().enumerate() {
            let vertex = if corner < vertices && self.dice.one_in(2) {
                format!("-{}", vertices - corner)
            } else {
                (corner + 1).to_string()
            };
            let texture = self.dice.one_of(&["", "1", "-1"]);
            let normal = match &face.normals {
                Some(normals) if self.dice.one_in(2) => {
                    format!("-{}", model.normals.len() - normals[place])
                }
                Some(normals) => (normals[place] + 1).to_string(),
                None => String::new(),
            };
            words.push(match (texture, &*normal) {
                ("", "") => vertex,
                (texture, "") => format!("{vertex}/{texture}"),
                (texture, normal) => format!("{vertex}/{texture}/{normal}"),
            });
        }
        self.line(&words);
    }

    fn model(&mut self, model: &Model) {
        self.name("mtllib", "the materials.mtl");
        for normal in &model.normals {
            let normal = normal.as_dvec3().to_array().map(|c| c.to_string());
            self.line(&[&["vn".to_owned()][..], &normal].concat());
        }
        // Vertices come before all faces, before the faces that need them, or last.
        let (mut written, order) = (0, self.dice.below(3));
        let (mut material, all) = (None, model.vertices.len());
        for (name, faces) in &model.objects {
            self.name("o", name);
            for face in faces {
                let needed = match order {
                    0 => all,
                    1 => face.corners.iter().max().map_or(0, |last| last + 1),
                    _ => 0,
                };
                for &vertex in model.vertices.get(written..needed).unwrap_or_default() {
                    self.vertex(vertex);
                }
                written = written.max(needed);
                if material != face.material || self.dice.one_in(8) {
                    material = face.material;
                    if let Some(material) = material {
                        self.name("usemtl", &format!("material {material}"));
                    }
                }
                self.face(face, written, model);
            }
        }
        for &vertex in &model.vertices[written..] {
            self.vertex(vertex);
        }
    }

    fn materials(&mut self, model: &Model) {
        for (material, Srgb(colour)) in model.materials.iter().enumerate() {
            self.name("newmtl", &format!("material {material}"));
            let colour = colour.map(|c| (f64::from(c) / 255.0).to_string());
            self.line(&[&["Kd".to_owned()][..], &colour].concat());
        }
        if model.materials.is_empty() {
            self.name("newmtl", "unused");
        }
    }
}

/// The file in a random encoding, and its text.
fn written(dice: &mut Dice, what: impl FnOnce(&mut Writer)) -> (Vec<u8>, String) {
    let line_end = dice.one_of(&["\n", "\r\n", "\r"]);
    let text = String::new();
    let mut writer = Writer {
        dice,
        line_end,
        text,
    };
    what(&mut writer);
    let text = writer.text;
    let units = || std::iter::once(0xfeff).chain(text.encode_utf16());
    let bytes = match dice.below(6) {
        0 => units().flat_map(u16::to_le_bytes).collect(),
        1 => units().flat_map(u16::to_be_bytes).collect(),
        2 => format!("\u{feff}{text}").into_bytes(),
        _ => text.as_bytes().to_vec(),
    };
    (bytes, text)
}

fn assert_reads(mesh: &Mesh, model: &Model) {
    let count = |faces: &Vec<Face>| {
        faces
            .iter()
            .map(|face| face.corners.len() - 2)
            .sum::<usize>()
    };
    let objects: Vec<_> = model
        .objects
        .iter()
        .map(|(name, faces)| (*name, count(faces)))
        .collect();
    assert_eq!(parts(mesh), objects);
    let data = mesh.data();
    let mut read = (0_u32..).zip(triangles(mesh));
    for face in model.objects.iter().flat_map(|(_, faces)| faces) {
        let corners: Vec<DVec3> = face.corners.iter().map(|&i| model.vertices[i].0).collect();
        let fan = corners
            .windows(2)
            .skip(1)
            .map(|pair| vector_area([corners[0], pair[0], pair[1]]));
        let (mut area, expected) = (DVec3::ZERO, fan.sum::<DVec3>());
        for (triangle, at) in read.by_ref().take(corners.len() - 2) {
            area += vector_area(at);
            if let [_, _, _] = *corners {
                assert_eq!(&at[..], corners);
            }
            let colour = face.material.map(|material| model.materials[material]);
            assert_eq!(mesh.triangle_colour(triangle), colour);
            for (place, at) in at.iter().enumerate() {
                let corner = corners
                    .iter()
                    .position(|corner| corner == at)
                    .expect("a corner of the face");
                let vertex = data.triangles[triangle as usize][place] as usize;
                let colour = data.vertex_colours.get(vertex).copied();
                assert_eq!(
                    colour.unwrap_or(Srgb::WHITE),
                    model.vertices[face.corners[corner]]
                        .1
                        .unwrap_or(Srgb::WHITE)
                );
                if let Some(normals) = &face.normals {
                    let shading = mesh.normals();
                    let corners = shading.corners_of(&data.triangles);
                    let normal = corners[triangle as usize][place] as usize;
                    let normal = Vec3::from_array(shading.normals[normal]);
                    assert!(normal.distance(model.normals[normals[corner]]) < 1e-6);
                }
            }
        }
        assert_eq!(area, expected);
    }
    assert!(read.next().is_none());
}

#[test]
fn a_written_mesh_reads_back() {
    for seed in 0..FILES {
        let mut dice = Dice(Random::new(seed));
        let model = Model::new(&mut dice);
        let (obj, text) = written(&mut dice, |writer| writer.model(&model));
        let (mtl, _) = written(&mut dice, |writer| writer.materials(&model));
        let folder = Folder::new(&[("some.obj", &obj), ("the materials.mtl", &mtl)]);
        let file = folder
            .load("some.obj")
            .unwrap_or_else(|error| panic!("seed {seed}: {error}\n{text}"));
        println!("seed {seed}:\n{text}");
        assert_eq!(folder.warnings(&file), [""; 0]);
        assert_reads(&file.mesh, &model);
    }
}
