// Triangles numbered by vertex index, for adapters without a primitive index: no triangle shares its three vertices.

@vertex
fn vertex(in: Vertex, batch: Batch, @builtin(vertex_index) index: u32) -> Corner {
    return corner(in, batch, index / 3u);
}

@vertex
fn vertex_in_ndc(in: Vertex, batch: Batch, @builtin(vertex_index) index: u32) -> Corner {
    return corner_in_ndc(in, batch, index / 3u);
}

@fragment
fn id(in: Corner) -> @location(0) vec2<u32> {
    return id_of(in, 0u);
}

@fragment
fn colour_and_id(in: Corner, @builtin(front_facing) front: bool) -> ColourAndId {
    return ColourAndId(shaded(in, front, false), id_of(in, 0u));
}

@fragment
fn id_cut(in: Corner) -> @location(0) vec2<u32> {
    cut(in.clip);
    return id_of(in, 0u);
}

@fragment
fn colour_and_id_cut(in: Corner, @builtin(front_facing) front: bool) -> ColourAndId {
    cut(in.clip);
    return ColourAndId(shaded(in, front, frame.shows_inside == 1u), id_of(in, 0u));
}
