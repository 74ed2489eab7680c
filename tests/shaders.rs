//! Every shader is valid, and each struct has the same layout in WGSL and Rust. Needs no GPU.
#![cfg(feature = "window")]

use naga::valid::{Capabilities, ValidationFlags, Validator};
use sightline::render::{SHADERS, shader_structs};
use std::mem::{offset_of, size_of};

fn module(name: &str) -> naga::Module {
    let (_, source) = (SHADERS.iter().find(|(other, _)| *other == name)).expect("such a shader");
    naga::front::wgsl::parse_str(source)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(source)))
}

/// Only the modules named for it may use the primitive index.
#[test]
fn every_shader_is_valid() {
    let sampled = Capabilities::MULTISAMPLED_SHADING;
    let mut by_primitive = 0;
    for (name, source) in SHADERS {
        let needed = if name.ends_with("by primitive") {
            by_primitive += 1;
            sampled | Capabilities::PRIMITIVE_INDEX
        } else {
            sampled
        };
        let mut validator = Validator::new(ValidationFlags::all(), needed);
        if let Err(error) = validator.validate(&module(name)) {
            panic!("{name}: {}", error.emit_to_string(source));
        }
    }
    assert_eq!(by_primitive, 2);
}

/// Names, offsets and size of a WGSL struct without its padding.
fn wgsl_layout(shader: &str, name: &str) -> (Vec<(String, usize)>, usize) {
    let module = module(shader);
    let found = module.types.iter().find_map(|(_, ty)| match &ty.inner {
        naga::TypeInner::Struct { members, span } if ty.name.as_deref() == Some(name) => {
            let named = members.iter().map(|member| {
                let name = member.name.clone().expect("members have names");
                (name, member.offset as usize)
            });
            let used = named.filter(|(name, _)| !name.starts_with("padding"));
            Some((used.collect(), *span as usize))
        }
        _ => None,
    });
    found.unwrap_or_else(|| panic!("{shader} has no {name}"))
}

/// Compares a struct of `shader_structs` with the shader's struct of the same name.
macro_rules! same_layout {
    ($shader:literal, $name:ident { $($field:ident),* }) => {
        let rust = vec![$((stringify!($field).to_owned(), offset_of!(shader_structs::$name, $field))),*];
        let rust = (rust, size_of::<shader_structs::$name>());
        assert_eq!(rust, wgsl_layout($shader, stringify!($name)), "{} in {}", stringify!($name), $shader);
    };
}

#[test]
fn structs_have_one_layout_on_both_sides() {
    for shader in [
        "mesh by primitive",
        "mesh by corner",
        "sphere",
        "background and lines",
    ] {
        let frame = wgsl_layout(shader, "Frame");
        assert_eq!(frame, wgsl_layout("mesh by primitive", "Frame"), "{shader}");
    }
    same_layout!(
        "mesh by primitive",
        Frame {
            ndc_per_view,
            viewport_px,
            clip_per_depth,
            perspective,
            front_only,
            section_corner_slack,
            key_direction,
            near_start,
            fill_direction,
            near_per_q,
            key,
            section_start,
            fill,
            section_per_q,
            sky,
            section_slack,
            ground,
            q_is_depth,
            inside,
            shows_inside,
            background_top,
            line_half_px,
            background_bottom,
            section_per_px,
            near_per_px,
            ndc_clip,
            ndc_normal
        }
    );
    same_layout!(
        "mesh by primitive",
        ObjectState {
            colour,
            has_colour,
            first_triangle,
            visible
        }
    );
    same_layout!("sphere", Quadratic { linear, square });
    same_layout!(
        "sphere",
        Sphere {
            rect_px,
            pivot_px,
            depth,
            depth_per_root,
            a,
            b,
            c,
            discriminant,
            normal,
            origin_step,
            normal_per_root,
            direction_step,
            normal_right,
            object,
            normal_down,
            view_depth
        }
    );
    same_layout!(
        "marks",
        Marking {
            selection_colour,
            tint,
            lit,
            selection,
            hover,
            outline_px
        }
    );
}

#[test]
fn flags_have_one_value_on_both_sides() {
    let module = module("mesh by primitive");
    let value = |name: &str| {
        let constant = module
            .constants
            .iter()
            .find(|(_, constant)| constant.name.as_deref() == Some(name));
        let init = constant.expect("such a constant").1.init;
        match module.global_expressions[init] {
            naga::Expression::Literal(naga::Literal::U32(value)) => value,
            ref other => panic!("{name} is {other:?}"),
        }
    };
    assert_eq!(
        value("NUMBERS_TRIANGLES"),
        shader_structs::Batch::NUMBERS_TRIANGLES
    );
    assert_eq!(value("MIRRORS"), shader_structs::Batch::MIRRORS);
}

/// The shader's instance attributes, in their order, fill the struct `Batch`.
#[test]
fn attributes_of_an_instance_are_the_fields_of_its_row() {
    let module = module("mesh by primitive");
    let mut layouter = naga::proc::Layouter::default();
    layouter.update(module.to_ctx()).expect("types with sizes");
    let batch = module.types.iter().find_map(|(_, ty)| match &ty.inner {
        naga::TypeInner::Struct { members, .. } if ty.name.as_deref() == Some("Batch") => {
            Some(members)
        }
        _ => None,
    });
    let (mut at, mut found) = (0, Vec::new());
    for member in batch.expect("a struct of attributes") {
        found.push((member.name.as_deref().expect("a name"), at));
        at += layouter[member.ty].size as usize;
    }
    assert_eq!(at, size_of::<shader_structs::Batch>());
    for (name, offset) in [
        (
            "pivot_and_view_depth",
            offset_of!(shader_structs::Batch, pivot),
        ),
        ("linear_x", offset_of!(shader_structs::Batch, linear)),
        (
            "translation",
            offset_of!(shader_structs::Batch, translation),
        ),
        ("normal_x", offset_of!(shader_structs::Batch, normal)),
        (
            "numbers",
            offset_of!(shader_structs::Batch, object_of_part_0),
        ),
    ] {
        assert!(
            found.contains(&(name, offset)),
            "{name} at {offset}: {found:?}"
        );
    }
}
