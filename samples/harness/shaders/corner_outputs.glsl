// The outputs for corners.frag: the three corners of a triangle, from either shader that expands it. The SDK's text for
// that shader and interface.glsl come before this text.

struct Corner {
    vec2 uv;
    float alpha;
#if AGAA_NEEDS_MATERIAL
    vec3 position, normal; // in shading space
    vec4 tangent;
    vec3 color;
#endif
};

#if AGAA_NEEDS_MATERIAL
// The outputs take thirteen locations, because the SDK uses three and devices need not have more than 16.
VARYING(0) flat out vec4 cornerNormal[3]; // w: u
VARYING(3) flat out vec4 cornerTangent[3];
VARYING(6) flat out vec4 cornerColor[3]; // w: alpha
VARYING(9) flat out vec4 cornerPosition[3]; // w: v
VARYING(12) flat out uvec3 cornerIds; // seed, draw, primitive

void setCorner(int i, Corner corner) {
    cornerNormal[i] = vec4(corner.normal, corner.uv.x);
    cornerTangent[i] = corner.tangent;
    cornerColor[i] = vec4(corner.color, corner.alpha);
    cornerPosition[i] = vec4(corner.position, corner.uv.y);
}
#else
VARYING(0) flat out vec2 cornerUv[3];
VARYING(3) flat out vec3 cornerAlpha;
VARYING(4) flat out uvec3 cornerIds;

void setCorner(int i, Corner corner) {
    cornerUv[i] = corner.uv;
    cornerAlpha[i] = corner.alpha;
}
#endif
