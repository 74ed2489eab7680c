// The colour of a pixel from its samples.

@group(0) @binding(0) var samples: texture_multisampled_2d<f32>;

@fragment
fn resolve(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let at = vec2i(position.xy);
    let count = i32(textureNumSamples(samples));
    var sum = vec4f(0.0);
    for (var i = 0; i < count; i++) {
        sum += textureLoad(samples, at, i);
    }
    return sum / f32(count);
}
