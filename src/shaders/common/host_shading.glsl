// The surface that a shading function of the host receives (AgaaShadingFunction), and the functions that it may call.
// common/shade_by_host.glsl defines them.
#ifndef AGAA_HOST_SHADING_GLSL
#define AGAA_HOST_SHADING_GLSL

// The surface of one shading event: a sample, a fragment or an aggregate. Attributes are means over its samples.
// Positions and directions are in shading space, colours are linear.
struct AgaaSurface {
    vec3 diffuse;         // [0,1]
    vec3 specular;        // reflectance at normal incidence, [0,1]; 0 if the layout has none
    vec3 emissive;        // radiance
    vec3 normal;          // direction of the mean normal, unit
    float normalLength;   // of the mean of unit normals, [0,1]. It is 1 if they agree, and with layouts that fold
                          // roughness into it
    float alpha2;         // GGX alpha squared, [4.1e-6,1], widened by the spread of normals
    float alpha2Along;    // the same along `axis`, >= alpha2, which is then that across; equal for round lobes
    vec3 axis;            // direction of the widest spread, unit, perpendicular to the normal; 0 for round lobes
    float materialAlpha2; // mean of alpha squared over the samples, before it is widened. It is alpha2 in "dcaa",
                          // with folded roughness in memory, and in parts of an event, with litShadows
    // Second moments of the samples' unit normals in "agaa" with specular light and AGAA_NDF_LEAN or AGAA_NDF_SGGX,
    // except in parts of an event. Otherwise those of a round spread of the same normalLength.
    vec3 normalSquares;   // means of xx, yy and zz, whose sum is 1
    vec3 normalProducts;  // means of yz, zx and xy
    vec3 position;        // mean over the samples, or that of the sample that represents them
    float positionSpread; // mean squared distance of the samples from it, at most the squared width of a pixel there.
    // Footprint of the event: second moments of its samples' positions around `position`, in "msaa" around their mean,
    // without a bound. Events of one sample and with AGAA_ADAPTIVE_EQUAL_WEIGHTS have none (0); fragments of lists and
    // surfaces of "dcaa" have those of four of their samples.
    vec3 positionSquares;  // means of xx, yy and zz
    vec3 positionProducts; // means of yz, zx and xy
    float depthVariance;   // the moment along the view's axis: the variance of depth where `position` is the mean
    uvec2 pixel;
    uvec4 samples;        // that the event represents: bit i % 32 of element i / 32 for sample i
    float coverage;       // their share of the samples of the pixel, (0,1]
    uint shadows;         // bit i: lights with AgaaFrame::shadows[i] may reach the surface
    AGAA_CUSTOM_MEMBERS   // custom attributes of the layout, combined by AgaaFilter; means of normals are not unit
};

// A light as it reaches the surface.
struct AgaaIncidentLight {
    vec3 toLight;  // unit
    vec3 radiance; // colour, attenuation, spot cone and shadows: irradiance of a plane that faces the light
    uint index;    // in AgaaFrame::lights
    uint shadow;   // AgaaLight::shadowMap
};

// Lights that reach the tile of an event, in the order of the frame.
struct AgaaLights {
    uint word;
    uint left;
};
AgaaLights agaaLights();
// Finds the next light. Returns false after the last one. Skip those whose radiance is 0: they do not reach the event.
bool agaaNextLight(inout AgaaLights lights, AgaaSurface surface, out AgaaIncidentLight light);
// Returns the part of the surface that the light reaches: means over the samples that are not in its shadow, with
// AgaaAggregation::litShadows. Without, it is the surface.
AgaaSurface agaaLitPart(AgaaSurface surface, AgaaIncidentLight light);

// Returns the light that the library's model reflects to the eye, as agaaReflect() does.
vec3 agaaBuiltInReflect(AgaaSurface surface, vec3 toLight, vec3 toEye);
// Returns the unit vector from a position to the eye.
vec3 agaaToEye(vec3 position);
// Returns AgaaFrame::ambient, or 0 without AGAA_FACT_AMBIENT.
vec3 agaaAmbient();
// Returns the share of light, [0,1], that AgaaFrame::shadows[shadow] lets reach the event: a mean over its samples.
float agaaShadow(uint shadow);
// Returns the share that reaches a position.
float agaaShadowAt(uint shadow, vec3 position);
#endif
