// The fetch functions of the sample engine: triangles and materials from buffers, textures from arrays. interface.glsl
// and material.glsl come before this text. Buffers are read as texels of four words: drivers load a texel at once, and
// software rasterisers skip the bounds check per word and lane. Textures have a kind: 0 base colour, 1 normal, 2
// metallic-roughness, 3 emissive. FETCH_LARGE and FETCH_SMALL have a bit for each kind that occurs among the large or
// small textures.

layout(std140, FETCH_UNIFORM_AT) uniform FetchCamera { mat4 viewProjection; } fetchCamera;
layout(FETCH_TEXTURE_AT(0)) uniform sampler2DArray fetchColors; // sRGB
layout(FETCH_TEXTURE_AT(1)) uniform sampler2DArray fetchValues;
layout(FETCH_TEXTURE_AT(2)) uniform usamplerBuffer fetchDraws;     // FetchDraw of the engine
layout(FETCH_TEXTURE_AT(3)) uniform usamplerBuffer fetchMaterials; // FetchMaterial
layout(FETCH_TEXTURE_AT(4)) uniform usamplerBuffer fetchVertices;  // FetchVertex
layout(FETCH_TEXTURE_AT(5)) uniform usamplerBuffer fetchIndices;   // one word each
#if (FETCH_SMALL & 9) != 0
layout(FETCH_TEXTURE_AT(6)) uniform sampler2DArray fetchSmallColors;
#endif
#if (FETCH_SMALL & 6) != 0
layout(FETCH_TEXTURE_AT(7)) uniform sampler2DArray fetchSmallValues;
#endif

const int drawTexels = 7, materialTexels = 5, vertexTexels = 3;

struct FetchDraw {
    int at; // first texel
    uint firstIndex;
    uint firstVertex;
    int material;
    float handedness;
};

FetchDraw fetchDraw(uint index) {
    int at = drawTexels * int(index);
    uvec4 t = texelFetch(fetchDraws, at + 6);
    return FetchDraw(at, t.x, t.y, int(t.z), uintBitsToFloat(t.w));
}

vec4 fetchRowOf(FetchDraw draw, int row) { return uintBitsToFloat(texelFetch(fetchDraws, draw.at + row)); }

float fetchRow(vec4 row, vec3 p) {
    precise float sum = ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
    return sum;
}
vec3 fetchTransform(FetchDraw draw, vec3 p) { // matches object.glsl
    return vec3(fetchRow(fetchRowOf(draw, 0), p), fetchRow(fetchRowOf(draw, 1), p), fetchRow(fetchRowOf(draw, 2), p));
}
vec3 fetchRotate(FetchDraw draw, int firstRow, vec3 v) {
    return vec3(dot(fetchRowOf(draw, firstRow).xyz, v), dot(fetchRowOf(draw, firstRow + 1).xyz, v),
                dot(fetchRowOf(draw, firstRow + 2).xyz, v));
}

int fetchVertex(FetchDraw draw, uint primitive, uint corner) {
    uint index = texelFetch(fetchIndices, int(draw.firstIndex + 3u * primitive + corner)).x;
    return vertexTexels * int(draw.firstVertex + index);
}

// Computes clip coordinates exactly like object.glsl.
vec4 fetchClip(FetchDraw draw, int vertex) {
    vec3 p = fetchTransform(draw, uintBitsToFloat(texelFetch(fetchVertices, vertex).xyz));
    mat4 m = fetchCamera.viewProjection;
    precise vec4 clip = ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
    return clip;
}

void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    FetchDraw d = fetchDraw(draw);
    a = fetchClip(d, fetchVertex(d, primitive, 0u));
    b = fetchClip(d, fetchVertex(d, primitive, 1u));
    c = fetchClip(d, fetchVertex(d, primitive, 2u));
}

float fetchWrapped(float x, uint wrap, float halfTexel) {
    return wrap == 0u ? x : wrap == 1u ? 1.0 - abs(mod(x, 2.0) - 1.0) : clamp(x, halfTexel, 1.0 - halfTexel);
}

vec4 fetchTexel(sampler2DArray textures, int layer, uint wrap, vec2 uv, vec2 dx, vec2 dy) {
    if (layer < 0)
        return vec4(1.0);
    vec2 share = exp2(-vec2(wrap >> 4u & 15u, wrap >> 8u & 15u)); // size of one repetition in the layer
    vec2 halfTexel = 0.5 / (vec2(textureSize(textures, 0).xy) * share);
    uv = vec2(fetchWrapped(uv.x, wrap & 3u, halfTexel.x), fetchWrapped(uv.y, wrap >> 2u & 3u, halfTexel.y));
    return textureGrad(textures, vec3(uv * share, float(layer)), dx * share, dy * share);
}

vec4 fetchColor(int kind, int layer, uint wrap, vec2 uv, vec2 dx, vec2 dy) {
#if (FETCH_SMALL & 9) != 0
    if ((FETCH_SMALL >> kind & 1) != 0 && layer >= FETCH_FIRST_SMALL)
        return fetchTexel(fetchSmallColors, layer - FETCH_FIRST_SMALL, wrap, uv, dx, dy);
#endif
    return (FETCH_LARGE >> kind & 1) != 0 ? fetchTexel(fetchColors, layer, wrap, uv, dx, dy) : vec4(1.0);
}

vec4 fetchValue(int kind, int layer, uint wrap, vec2 uv, vec2 dx, vec2 dy) {
#if (FETCH_SMALL & 6) != 0
    if ((FETCH_SMALL >> kind & 1) != 0 && layer >= FETCH_FIRST_SMALL)
        return fetchTexel(fetchSmallValues, layer - FETCH_FIRST_SMALL, wrap, uv, dx, dy);
#endif
    return (FETCH_LARGE >> kind & 1) != 0 ? fetchTexel(fetchValues, layer, wrap, uv, dx, dy) : vec4(1.0);
}

void agaaHostMaterial(AgaaPrimitive primitive, inout AgaaMaterial result) {
    FetchDraw draw = fetchDraw(primitive.draw);
    SurfacePoint p;
    vec3 position = vec3(0.0);
    p.normal = vec3(0.0);
    vec3 normalDx = vec3(0.0), normalDy = vec3(0.0);
    p.tangent = vec4(0.0);
    p.color = vec3(0.0);
    vec2 uv = vec2(0.0), dx = vec2(0.0), dy = vec2(0.0);
    for (uint corner = 0u; corner < 3u; ++corner) {
        int v = fetchVertex(draw, primitive.primitive, corner);
        float weight = primitive.at[corner];
        uvec4 a = texelFetch(fetchVertices, v);
        vec4 b = uintBitsToFloat(texelFetch(fetchVertices, v + 1));
        vec4 c = uintBitsToFloat(texelFetch(fetchVertices, v + 2));
        vec4 color = unpackUnorm4x8(a.w); // alpha holds the handedness of the tangent
        position += weight * uintBitsToFloat(a.xyz);
        p.color += weight * color.rgb;
        p.normal += weight * b.xyz;
        normalDx += primitive.dx[corner] * b.xyz;
        normalDy += primitive.dy[corner] * b.xyz;
        p.tangent += weight * vec4(c.xyz, color.a * 2.0 - 1.0);
        vec2 own = vec2(b.w, c.w);
        uv += weight * own;
        dx += primitive.dx[corner] * own;
        dy += primitive.dy[corner] * own;
    }
    p.position = fetchTransform(draw, position);
    p.normal = fetchRotate(draw, 3, p.normal);
    p.tangent = vec4(fetchRotate(draw, 0, p.tangent.xyz), p.tangent.w * draw.handedness);
    p.isFront = primitive.facing * draw.handedness < 0.0; // counter-clockwise where y points up

    int m = materialTexels * draw.material;
    vec4 emissive = uintBitsToFloat(texelFetch(fetchMaterials, m + 1));
    vec4 numbers = uintBitsToFloat(texelFetch(fetchMaterials, m + 2));
    ivec4 layers = ivec4(texelFetch(fetchMaterials, m + 3)); // base, normal, metallic-roughness, emissive
    uvec4 wraps = texelFetch(fetchMaterials, m + 4);
    MaterialValues values = MaterialValues(uintBitsToFloat(texelFetch(fetchMaterials, m)), emissive.xyz, emissive.w,
                                           numbers.x, numbers.y, numbers.z);
    p.isBent = ((FETCH_LARGE | FETCH_SMALL) & 2) != 0 && layers.y >= 0;
    p.baseTexel = fetchColor(0, layers.x, wraps.x, uv, dx, dy);
    p.normalTexel = fetchValue(1, layers.y, wraps.y, uv, dx, dy);
    p.metalRoughTexel = fetchValue(2, layers.z, wraps.z, uv, dx, dy);
    p.emissiveTexel = fetchColor(3, layers.w, wraps.w, uv, dx, dy);
    SurfaceModel model = surfaceModel(values, p);
    result.diffuse = model.diffuse;
    result.specular = model.specular;
    result.emissive = model.emissive;
    result.normal = model.normal;
    result.alpha2 = model.alpha2;
    result.normalDx = unitNormalChange(p, fetchRotate(draw, 3, normalDx));
    result.normalDy = unitNormalChange(p, fetchRotate(draw, 3, normalDy));
}
