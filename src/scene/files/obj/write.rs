//! Writes a mesh as the text of an OBJ file, and of an MTL file if the mesh has colours.

use crate::{
    colour::Srgb,
    geometry::{ColourRun, Mesh},
};
use glam::Vec3;
use std::{collections::BTreeMap, fmt::Write};

/// The text of an OBJ file for a mesh. Its colours are in the MTL file `library`. Every number reads back as exactly
/// the same value.
pub(in crate::scene::files) fn text(mesh: &Mesh, library: Option<&str>) -> String {
    let data = mesh.data();
    let mut text = String::new();
    if let Some(library) = library {
        let _ = writeln!(text, "mtllib {library}");
    }
    for (index, position) in data.positions.iter().enumerate() {
        // A sum with 0 would lose the sign of -0.
        let [x, y, z] = std::array::from_fn(|i| match f64::from(position[i]) {
            at if data.origin[i] == 0.0 => at,
            at => data.origin[i] + at,
        });
        let _ = write!(text, "v {x} {y} {z}");
        if let Some(colour) = data.vertex_colours.get(index) {
            let [r, g, b] = unit(*colour);
            let _ = write!(text, " {r} {g} {b}");
        }
        text.push('\n');
    }
    let normals = mesh.normals();
    for [x, y, z] in &normals.normals {
        let _ = writeln!(text, "vn {x} {y} {z}");
    }
    let mut runs = data.colours.iter().peekable();
    for part in &data.parts {
        // OBJ has no names of several lines.
        let name = part.name.replace(char::is_control, " ");
        let _ = writeln!(text, "o {name}");
        for triangle in part.triangles.clone() {
            if let Some(run) = runs.next_if(|run| run.triangles.start <= triangle)
                && library.is_some()
            {
                let _ = writeln!(text, "usemtl {}", material(mesh, run));
            }
            let at = triangle as usize;
            let corners = data.triangles[at].map(|corner| corner + 1);
            text.push('f');
            match normals.corners_of(&data.triangles).get(at) {
                Some(of) => (corners.iter().zip(of)).for_each(|(corner, normal)| {
                    let _ = write!(text, " {corner}//{}", normal + 1);
                }),
                None => corners.iter().for_each(|corner| {
                    let _ = write!(text, " {corner}");
                }),
            }
            text.push('\n');
        }
    }
    text
}

/// The text of the MTL file that [`text`] names; `None` if no triangle has a colour or a material of its own.
pub(in crate::scene::files) fn materials(mesh: &Mesh) -> Option<String> {
    let runs = mesh.data().colours.iter();
    let all: BTreeMap<_, _> = runs.map(|run| (material(mesh, run), run.colour)).collect();
    let has_some = !mesh.data().materials.is_empty() || all.values().any(Option::is_some);
    has_some.then(|| {
        let mut text = String::new();
        for (name, colour) in all {
            let _ = writeln!(text, "newmtl {name}");
            if let Some(colour) = colour {
                let [r, g, b] = unit(colour);
                let _ = writeln!(text, "Kd {r} {g} {b}");
            }
        }
        text
    })
}

/// The name of a run's material. One without a name is called by its colour, and by no name that the mesh has.
fn material(mesh: &Mesh, run: &ColourRun) -> String {
    let named = &mesh.data().materials;
    let own = run.material.and_then(|own| named.get(own as usize));
    // A backslash at its end would go on in the next line.
    if let Some(own) = own.filter(|own| !own.ends_with('\\')) {
        return own.clone();
    }
    let mut name = run.colour.map_or("none".to_owned(), |Srgb([r, g, b])| {
        format!("c{r:02x}{g:02x}{b:02x}")
    });
    while named.contains(&name) {
        name.push('_');
    }
    name
}

fn unit(Srgb(channels): Srgb) -> [f64; 3] {
    channels.map(|c| f64::from(c) / 255.0)
}

/// Whether two meshes have bit-identical triangles and colours, and normals that differ by rounding only.
pub(in crate::scene::files) fn same(a: &Mesh, b: &Mesh) -> bool {
    /// The largest difference of normals. Reading makes them unit length again, which rounds once or twice.
    const NORMALS: f32 = 4.0 * f32::EPSILON;
    let (a_data, b_data) = (a.data(), b.data());
    let count = a_data.triangles.len();
    let parts = |mesh: &Mesh| {
        let parts = mesh.data().parts.iter();
        parts.map(|part| part.triangles.clone()).collect::<Vec<_>>()
    };
    let bits = |mesh: &Mesh, triangle| {
        mesh.corners(triangle)
            .map(|corner| corner.to_array().map(f64::to_bits))
    };
    let local = |mesh: &Mesh, triangle: u32| {
        mesh.data().triangles[triangle as usize].map(|corner| {
            let corner = corner as usize;
            let colour = mesh.data().vertex_colours.get(corner).copied();
            (mesh.data().positions[corner].map(f32::to_bits), colour)
        })
    };
    let shading = |mesh: &Mesh, triangle: u32| {
        let shading = mesh.normals();
        let corners = shading.corners_of(&mesh.data().triangles);
        let corners = corners.get(triangle as usize)?;
        Some(corners.map(|corner| Vec3::from_array(shading.normals[corner as usize])))
    };
    let alike = |triangle| match (shading(a, triangle), shading(b, triangle)) {
        (Some(a), Some(b)) => {
            (a.into_iter().zip(b)).all(|(a, b)| (a - b).abs().max_element() <= NORMALS)
        }
        (a, b) => a.is_none() && b.is_none(),
    };
    count == b_data.triangles.len()
        && a_data.origin == b_data.origin
        && parts(a) == parts(b)
        && (0..u32::try_from(count).unwrap_or(u32::MAX)).all(|triangle| {
            bits(a, triangle) == bits(b, triangle)
                && local(a, triangle) == local(b, triangle)
                && a.triangle_colour(triangle) == b.triangle_colour(triangle)
                && alike(triangle)
        })
}
