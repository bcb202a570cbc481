// A fragment of the layer, which fades where it comes near to the surfaces that the pixel shows.

layout(AT(1)) uniform sampler2D meanDepth;
layout(AT(2)) uniform sampler2D coverage;
layout(location = 0) in vec2 quadPlace;
layout(location = 1) flat in int quadIndex;
layout(location = 0) out vec4 premultiplied;

float distanceOf(float depth) {
    return layers.depth.z != 0.0 ? (layers.depth.y - depth) / layers.depth.x
                                 : abs(layers.depth.y) / max(abs(depth + layers.depth.x), 1e-12);
}

void main() {
    LayerQuad quad = layers.quads[quadIndex];
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float covered = texelFetch(coverage, pixel, 0).x;
    float behind = distanceOf(texelFetch(meanDepth, pixel, 0).x) - distanceOf(gl_FragCoord.z);
    float inFront = clamp(behind / quad.shape.z, 0.0, 1.0);
    float round = max(1.0 - dot(quadPlace, quadPlace), 0.0);
    float opacity = quad.color.w * (quad.shape.y != 0.0 ? round : 1.0);
    opacity *= mix(1.0, inFront, covered); // where nothing is covered, the background is behind the quad
    premultiplied = vec4(quad.color.rgb * opacity, opacity);
}
