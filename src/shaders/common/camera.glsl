// Conversions between the spaces of a frame. Needs common/frame.glsl.
#ifndef AGAA_CAMERA_GLSL
#define AGAA_CAMERA_GLSL
#ifndef AGAA_FRAME_GLSL
#error "camera.glsl needs frame.glsl."
#endif
uint agaa_isOrthographic() { return agaa_opaque(agaa_frame.isOrthographic); }

vec3 agaa_toShadingSpace(vec3 viewPosition) { return transpose(mat3(agaa_frame.view)) * viewPosition; }

// Returns the unit vector from a point in shading space toward the eye. An orthographic view has one such direction.
vec3 agaa_toEye(vec3 position) {
    vec3 towards = mix(-position, transpose(mat3(agaa_frame.view))[2], bvec3(agaa_isOrthographic() != 0u));
    float d2 = dot(towards, towards);
    return d2 > 0.0 ? towards * inversesqrt(d2) : vec3(0.0, 0.0, 1.0);
}

// Returns the width of a pixel's footprint at this depth, in view space.
float agaa_pixelWidth(float viewZ) {
    float scale = agaa_isOrthographic() != 0u ? 1.0 : abs(viewZ);
    return scale * 2.0 / (abs(agaa_frame.projectionScale.x) * float(agaa_frame.size.x));
}
#endif
