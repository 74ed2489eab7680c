// Triangles numbered by the adapter's primitive index.

@vertex
fn vertex(in: Vertex, batch: Batch) -> Corner {
    return corner(in, batch, 0u);
}

@vertex
fn vertex_in_ndc(in: Vertex, batch: Batch) -> Corner {
    return corner_in_ndc(in, batch, 0u);
}

@fragment
fn id(in: Corner, @builtin(primitive_index) primitive: u32) -> @location(0) vec2<u32> {
    return id_of(in, primitive);
}

@fragment
fn colour_and_id(
    in: Corner,
    @builtin(front_facing) front: bool,
    @builtin(primitive_index) primitive: u32,
) -> ColourAndId {
    return ColourAndId(shaded(in, front, false), id_of(in, primitive));
}

@fragment
fn id_cut(in: Corner, @builtin(primitive_index) primitive: u32) -> @location(0) vec2<u32> {
    cut(in.clip);
    return id_of(in, primitive);
}

@fragment
fn colour_and_id_cut(
    in: Corner,
    @builtin(front_facing) front: bool,
    @builtin(primitive_index) primitive: u32,
) -> ColourAndId {
    cut(in.clip);
    return ColourAndId(shaded(in, front, frame.shows_inside == 1u), id_of(in, primitive));
}
