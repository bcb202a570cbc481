// The corners of a quad of the layer.

layout(location = 0) out vec2 quadPlace; // [-1, 1]
layout(location = 1) flat out int quadIndex;

void main() {
    LayerQuad quad = layers.quads[INSTANCE];
    quadPlace = vec2((VERTEX & 1) != 0 ? 1.0 : -1.0, VERTEX > 1 ? 1.0 : -1.0);
    quadIndex = INSTANCE;
    vec3 corner = quad.centre.xyz + quad.centre.w * (quadPlace.x * layers.right.xyz +
                                                     quad.shape.x * quadPlace.y * layers.up.xyz);
    gl_Position = layers.toClip * vec4(corner, 1.0);
}
