// Types of the functions with which a host describes its draws to passes that expand triangles
// (AgaaFetchFunction::maxTriangles). Needs AgaaPrimitive.
#ifndef AGAA_HOST_TRIANGLES_GLSL
#define AGAA_HOST_TRIANGLES_GLSL

struct AgaaDraw {
    uint primitives;    // that are drawn, from 0 on; at first 0
    int culledFacing;   // 1: primitives with AgaaPrimitive::facing > 0 are not drawn, -1: those with facing < 0
    bool isAlphaMasked; // read in views with AGAA_FACT_ALPHA_MASKED: agaaHostAlpha() is called for its primitives
};

struct AgaaAlpha { // as in AgaaSurfaceInput
    float alpha;
    float alphaCutoff;
    bool hasAlphaNear; // without alphaNear or alphaRows, a pixel has one alpha
    vec4 alphaNear;
    bool hasAlphaRows;
    vec4 alphaRows[4];
    uint primitiveSeed;
};

// Evaluates the weights of a primitive at an offset from the centre of the current pixel, in pixels. Points outside the
// primitive are moved inside. For agaaHostAlpha().
void agaaMoveTo(inout AgaaPrimitive p, vec2 offset);
#endif
