// Between the spaces of a frame.
#ifndef AGAA_CAMERA_GLSL
#define AGAA_CAMERA_GLSL
uint agaa_isOrthographic() { return agaa_opaque(agaa_frame.isOrthographic); }

vec3 agaa_toShadingSpace(vec3 viewPosition) { return transpose(mat3(agaa_frame.view)) * viewPosition; }

// From a point in shading space toward the eye; for an orthographic view, against the view direction.
vec3 agaa_toEye(vec3 position) {
    vec3 towards = mix(-position, transpose(mat3(agaa_frame.view))[2], bvec3(agaa_isOrthographic() != 0u));
    float d2 = dot(towards, towards);
    return d2 > 0.0 ? towards * inversesqrt(d2) : vec3(0.0, 0.0, 1.0);
}

// Of a pixel's footprint at this depth, across the view.
float agaa_pixelWidth(float viewZ) {
    float scale = agaa_isOrthographic() != 0u ? 1.0 : abs(viewZ);
    return scale * 2.0 / (abs(agaa_frame.projectionScale.x) * float(agaa_frame.size.x));
}
#endif
