// Draws the panels' picture over the frame, and clears parts of the panels' picture.

@group(0) @binding(0) var panels: texture_2d<f32>;

@fragment
fn over(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(panels, vec2<i32>(position.xy), 0);
}

@fragment
fn empty() -> @location(0) vec4<f32> {
    return vec4<f32>(0.0);
}
