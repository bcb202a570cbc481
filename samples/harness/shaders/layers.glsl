// Transparent quads and particles over the anti-aliased image. The includer declares the version and AT(n), the layout
// of binding n.

struct LayerQuad {
    vec4 centre; // in shading space; w: half the width
    vec4 color;  // linear; w: opacity
    vec4 shape;  // height / width; 1 if it is round; distance over which it fades in front of surfaces
};

layout(std140, AT(0)) uniform Layers {
    mat4 toClip; // from shading space
    vec4 right;  // of the image, in shading space
    vec4 up;
    vec4 depth; // elements 2, 2 and 3, 2 of the projection to depths in [0, 1]; 1 if it is orthographic
    LayerQuad quads[LAYER_QUADS];
} layers;
