// The sample engine's material. The version, the SDK's extensions, interface.glsl, the SDK's declarations,
// material.glsl and material_inputs.glsl come before this text.

// There are two sets of inputs, because Mesa's software rasteriser (22.3) has two faults at the edges of triangles. If
// a shader reads an input inside the primitive, plain reads of the same input and their derivatives are displaced, too.
// Inputs that are read both ways are therefore passed twice.
VARYING(0) in vec3 centrePosition; // shading space
VARYING(1) in vec2 centreUv;
VARYING(2) in float centreAlpha;
// The second fault: it interpolates inside the primitive with 1/w of the pixel's centre. Values are too large by a
// factor, which an interpolated constant 1 measures. Other drivers interpolate it to 1.
VARYING(3) centroid in vec4 insidePosition; // w: 1
VARYING(4) centroid in vec3 insideNormal;
VARYING(5) centroid in vec4 insideTangent;
VARYING(6) centroid in vec2 insideUv;
VARYING(7) centroid in vec3 insideColor;
VARYING(8) flat in uint primitiveSeed;
VARYING(9) flat in uint drawIndex;

// dx and dy are the footprint of textures. It may differ from the derivatives of uv in its size only.
void setAlpha(inout AgaaSurfaceInput surface, vec2 uv, vec2 dx, vec2 dy) {
    float vertexAlpha = AGAA_AT_CENTRE(centreAlpha);
    surface.alpha = alphaAt(vertexAlpha, uv, dx, dy);
    if ((features & alphaTestBit) != 0u)
        surface.alphaCutoff = material.alphaCutoff;
    surface.hasAlphaNear = (features & alphaNearBit) != 0u;
    if ((features & alphaNearBit) == 0u)
        return;
    vec2 uvDx = agaa_dFdx(uv), uvDy = agaa_dFdy(uv);
    vec2 alphaStep = vec2(agaa_dFdx(vertexAlpha), agaa_dFdy(vertexAlpha));
    for (uint k = 0u; k < AGAA_ALPHA_POINTS; ++k) {
        vec2 point = agaa_alphaPoint(k);
        precise vec2 place = uv + (uvDx * point.x + uvDy * point.y);
        precise float pointAlpha = vertexAlpha + (alphaStep.x * point.x + alphaStep.y * point.y);
        surface.alphaNear[k] = alphaAt(pointAlpha, place, dx, dy);
    }
}

SurfacePoint pointInside(vec3 position, float scale, vec2 dx, vec2 dy) {
    // Values at the pixel's centre extrapolate if the primitive is thinner than a pixel.
    vec2 uv = AGAA_INSIDE(insideUv) * scale;
    SurfacePoint p;
    p.toViewer = viewerDirection(camera.viewer, position);
    p.normal = AGAA_INSIDE(insideNormal);
    p.tangent = AGAA_INSIDE(insideTangent);
    p.color = AGAA_INSIDE(insideColor) * scale;
    p.isFront = gl_FrontFacing;
    p.isBent = (features & normalBit) != 0u;
    p.baseTexel = p.normalTexel = p.metalRoughTexel = p.emissiveTexel = vec4(1.0);
    if ((features & baseColorBit) != 0u)
        p.baseTexel = textureGrad(baseColorMap, uv, dx, dy);
    if ((features & normalBit) != 0u)
        p.normalTexel = textureGrad(normalMap, uv, dx, dy);
    if ((features & metalRoughBit) != 0u)
        p.metalRoughTexel = textureGrad(metalRoughMap, uv, dx, dy);
    if ((features & emissiveBit) != 0u)
        p.emissiveTexel = textureGrad(emissiveMap, uv, dx, dy);
    return p;
}

// MOTION_OUTPUT is 1 if the layout has the attribute `velocity`, and 2 if emission shows the motion.
#if AGAA_NEEDS_MATERIAL && MOTION_OUTPUT
layout(MOTION_AT) uniform samplerBuffer motionRows; // MotionRows of the engine

// Gets the displacement of a point from this frame to the previous one, in widths and heights of the view, and the
// point's distance in that frame. Returns false if the draw has no motion of its own.
bool motionOf(vec3 position, out vec2 motion, out float distance) {
    int row = 3 * int(drawIndex);
    vec4 p = vec4(position, 1.0);
    vec3 before = vec3(dot(texelFetch(motionRows, row), p), dot(texelFetch(motionRows, row + 1), p),
                       dot(texelFetch(motionRows, row + 2), p));
    vec4 now = camera.viewProjection * p;
    motion = 0.5 * (before.xy / max(before.z, 1e-20) - (now.xy / now.w - camera.jitter));
    distance = before.z;
    return before.z > 0.0;
}
#endif

void main() {
    AgaaSurfaceInput surface = agaa_surfaceInput();
    vec4 inside = AGAA_INSIDE(insidePosition);
    float scale = 1.0 / inside.w;
    // Gradients come from the plain input, because the point inside the primitive jumps between pixels.
    vec2 uvAtCentre = AGAA_AT_CENTRE(centreUv);
    vec2 dx = agaa_dFdx(uvAtCentre) * camera.footprint;
    vec2 dy = agaa_dFdy(uvAtCentre) * camera.footprint;
    surface.position = inside.xyz * scale;
    surface.geometricNormal = agaa_planeNormal(AGAA_AT_CENTRE(centrePosition));
    surface.primitiveSeed = primitiveSeed;

#if AGAA_WRITES_IDS
    surface.draw = drawIndex;
    surface.primitive = uint(gl_PrimitiveID);
#endif
#if AGAA_ALPHA_MASKED
    setAlpha(surface, uvAtCentre, dx, dy);
#endif
#if AGAA_NEEDS_MATERIAL
    SurfaceModel model = surfaceModel(material, pointInside(surface.position, scale, dx, dy));
    surface.diffuse = model.diffuse;
    surface.specular = model.specular;
    surface.emissive = model.emissive;
    surface.normal = model.normal;
    surface.alpha2 = model.alpha2;
#ifdef MATERIAL_CLASSES
    surface.materialClass = material.materialClass;
#endif
#if MOTION_OUTPUT
    vec2 motion;
    float distance;
    bool hasMotion = motionOf(surface.position, motion, distance);
#endif
#if MOTION_OUTPUT == 1
    surface.velocity = hasMotion ? (32768.0 + 32767.0 * clamp(motion, -1.0, 1.0)) / 65535.0 : vec2(0.0);
#elif MOTION_OUTPUT == 2
    surface.diffuse = surface.specular = vec3(0.0);
    surface.emissive = vec3(motion * 32.0 + 8.0, 16.0 * distance / (distance + camera.unitDistance));
#endif
#endif
    agaa_emit(surface);
#ifdef COPY_OUTPUTS
    COPY_OUTPUTS // if the host declares the outputs
#endif
}
