@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    return Corner(probe(index), index / 3u);
}

@fragment
fn id(in: Corner) -> @location(0) vec2<u32> {
    return vec2<u32>(1u, in.triangle + 1u);
}
