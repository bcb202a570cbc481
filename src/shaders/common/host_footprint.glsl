// The argument of shadow functions of the host, for the shadows of AgaaShadowFunction::footprints.
#ifndef AGAA_HOST_FOOTPRINT_GLSL
#define AGAA_HOST_FOOTPRINT_GLSL

// The extent of a shading event, in shading space.
struct AgaaFootprint {
    vec3 position;
    // Second moments of the samples' positions around it. They are 0 for one sample, and where a shading function looks
    // a shadow up at a position. Fragments of lists and surfaces of "dcaa" have those of four of their samples.
    vec3 positionSquares;  // means of xx, yy and zz
    vec3 positionProducts; // means of yz, zx and xy
    float depthVariance;   // the moment along the view's axis
};

#endif
