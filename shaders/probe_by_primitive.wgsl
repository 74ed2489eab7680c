@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    return Corner(probe(index), 0u);
}

@fragment
fn id(in: Corner, @builtin(primitive_index) primitive: u32) -> @location(0) vec2<u32> {
    return vec2<u32>(1u, primitive + 1u);
}
