// The colour of a pixel from its samples: SMOOTH_SAMPLES of them. Unrolled, since loops are slow on software adapters.

@group(0) @binding(0) var samples: texture_multisampled_2d<f32>;

@fragment
fn resolve(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let sum = textureLoad(samples, at, 0) + textureLoad(samples, at, 1);
    return 0.25 * (sum + textureLoad(samples, at, 2) + textureLoad(samples, at, 3));
}
