// The fetch functions of the sample engine: triangles and materials from buffers, textures from arrays. interface.glsl
// and material.glsl come before this text. Buffers are read as texels of four words: drivers load a texel at once, and
// software rasterisers skip the bounds check per word and lane. Textures have a kind: 0 base colour, 1 normal, 2
// metallic-roughness, 3 emissive. FETCH_LARGE and FETCH_SMALL have a bit for each kind that occurs among the large or
// small textures.

layout(std140, FETCH_UNIFORM_AT) uniform FetchCamera { mat4 viewProjection; vec4 viewer; } fetchCamera;
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

const int drawTexels = 8, materialTexels = 5, vertexTexels = 3;

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

// FetchMaterial::samplers packs how a texture is sampled.
const uint fetchOwnSampling = 0xF00Fu; // bits of wrap modes and filters other than those of the arrays' sampler

// Wraps a texture coordinate to [0, 1].
float fetchWrapped(float x, uint wrap) {
    return wrap == 0u ? fract(x) : wrap == 1u ? 1.0 - abs(mod(x, 2.0) - 1.0) : clamp(x, 0.0, 1.0);
}

// Returns the texel i of a row of `size` texels, a power of two, or its neighbour across the edge.
int fetchNeighbour(int i, int size, uint wrap) { return wrap == 0u ? i & size - 1 : clamp(i, 0, size - 1); }

// Reads one level between the edges of the texture. The arrays' sampler repeats, so it would mix in texels of the
// opposite edge, the more the coarser the level is.
vec4 fetchLevel(sampler2DArray textures, int layer, uint code, vec2 uv, vec2 share, int level, bool isNearest) {
    // The size of a level is computed: llvmpipe (Mesa 22.3) returns that of the first invocation's level to all.
    ivec2 size = max(ivec2(vec2(textureSize(textures, 0).xy) * share) >> level, 1);
    vec2 place = uv * vec2(size) - (isNearest ? 0.0 : 0.5);
    ivec2 first = ivec2(floor(place));
    vec4 texels[4];
    for (int i = 0; i < 4; ++i) {
        ivec2 at = first + ivec2(i & 1, i >> 1);
        at = ivec2(fetchNeighbour(at.x, size.x, code & 3u), fetchNeighbour(at.y, size.y, code >> 2u & 3u));
        texels[i] = texelFetch(textures, ivec3(at, layer), level);
        if (isNearest)
            return texels[0];
    }
    vec2 weight = place - vec2(first);
    return mix(mix(texels[0], texels[1], weight.x), mix(texels[2], texels[3], weight.x), weight.y);
}

// Filters as a sampler of the texture would, but without anisotropy.
vec4 fetchLevels(sampler2DArray textures, int layer, uint code, vec2 uv, vec2 share, float lod) {
    bool isNearest = (code & (lod <= 0.0 ? 0x1000u : 0x2000u)) != 0u;
    uint mips = code >> 14u & 3u; // 0 linear, 1 nearest, 2 none
    lod = mips == 2u ? 0.0 : clamp(lod, 0.0, float(textureQueryLevels(textures) - 1));
    lod = mips == 1u ? floor(lod + 0.5) : lod;
    vec4 finer = fetchLevel(textures, layer, code, uv, share, int(lod), isNearest);
    if (fract(lod) == 0.0)
        return finer;
    return mix(finer, fetchLevel(textures, layer, code, uv, share, int(lod) + 1, isNearest), fract(lod));
}

vec4 fetchTexel(sampler2DArray textures, int layer, uint code, vec2 uv, vec2 dx, vec2 dy) {
    if (layer < 0)
        return vec4(1.0);
    vec2 share = exp2(-vec2(code >> 4u & 15u, code >> 8u & 15u)); // size of one repetition in the layer
#if FETCH_OWN_SAMPLING == 0 // software rasterisers execute both sides of a branch
    return textureGrad(textures, vec3(uv * share, float(layer)), dx * share, dy * share);
#endif
    if ((code & fetchOwnSampling) == 0u)
        return textureGrad(textures, vec3(uv * share, float(layer)), dx * share, dy * share);
    uv = vec2(fetchWrapped(uv.x, code & 3u), fetchWrapped(uv.y, code >> 2u & 3u));
    vec2 size = vec2(textureSize(textures, 0).xy) * share;
    float footprint = max(max(length(dx * size), length(dy * size)), 1e-6); // texels of level 0
    // Away from the edges, hardware filters as well. The coarser of two levels reaches `footprint` texels of level 0.
    vec2 reach = abs(dx) + abs(dy) + max(footprint, 1.0) / size;
    bvec2 reachesEdge = greaterThan(abs(uv - 0.5) + reach, vec2(0.5));
    bvec2 hasEdge = notEqual(uvec2(code, code >> 2u) & 3u, uvec2(0u));
    bool isInside = !(hasEdge.x && reachesEdge.x) && !(hasEdge.y && reachesEdge.y);
    if (isInside && (code & 0xF000u) == 0u)
        return textureGrad(textures, vec3(uv * share, float(layer)), dx * share, dy * share);
    return fetchLevels(textures, layer, code, uv, share, log2(footprint));
}

vec4 fetchColor(int kind, int layer, uint code, vec2 uv, vec2 dx, vec2 dy) {
#if (FETCH_SMALL & 9) != 0
    if ((FETCH_SMALL >> kind & 1) != 0 && layer >= FETCH_FIRST_SMALL)
        return fetchTexel(fetchSmallColors, layer - FETCH_FIRST_SMALL, code, uv, dx, dy);
#endif
    return (FETCH_LARGE >> kind & 1) != 0 ? fetchTexel(fetchColors, layer, code, uv, dx, dy) : vec4(1.0);
}

vec4 fetchValue(int kind, int layer, uint code, vec2 uv, vec2 dx, vec2 dy) {
#if (FETCH_SMALL & 6) != 0
    if ((FETCH_SMALL >> kind & 1) != 0 && layer >= FETCH_FIRST_SMALL)
        return fetchTexel(fetchSmallValues, layer - FETCH_FIRST_SMALL, code, uv, dx, dy);
#endif
    return (FETCH_LARGE >> kind & 1) != 0 ? fetchTexel(fetchValues, layer, code, uv, dx, dy) : vec4(1.0);
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
        vec4 color = unpackUnorm4x8(a.w);
        position += weight * uintBitsToFloat(a.xyz);
        p.color += weight * color.rgb;
        p.normal += weight * b.xyz;
        normalDx += primitive.dx[corner] * b.xyz;
        normalDy += primitive.dy[corner] * b.xyz;
        p.tangent += weight * vec4(c.xyz, (a.w >> 24u & 1u) != 0u ? 1.0 : -1.0);
        vec2 own = vec2(b.w, c.w);
        uv += weight * own;
        dx += primitive.dx[corner] * own;
        dy += primitive.dy[corner] * own;
    }
    p.toViewer = viewerDirection(fetchCamera.viewer, fetchTransform(draw, position));
    p.normal = fetchRotate(draw, 3, p.normal);
    p.tangent = vec4(fetchRotate(draw, 0, p.tangent.xyz), p.tangent.w * draw.handedness);
    p.isFront = primitive.facing * draw.handedness < 0.0; // counter-clockwise where y points up

    int m = materialTexels * draw.material;
    vec4 emissive = uintBitsToFloat(texelFetch(fetchMaterials, m + 1));
    vec4 numbers = uintBitsToFloat(texelFetch(fetchMaterials, m + 2));
    ivec4 layers = ivec4(texelFetch(fetchMaterials, m + 3)); // base, normal, metallic-roughness, emissive
    uvec4 samplers = texelFetch(fetchMaterials, m + 4);
    MaterialValues values = MaterialValues(uintBitsToFloat(texelFetch(fetchMaterials, m)), emissive.xyz, emissive.w,
                                           numbers.x, numbers.y, numbers.z, numbers.w);
    p.isBent = ((FETCH_LARGE | FETCH_SMALL) & 2) != 0 && layers.y >= 0;
    p.baseTexel = fetchColor(0, layers.x, samplers.x, uv, dx, dy);
    p.normalTexel = fetchValue(1, layers.y, samplers.y, uv, dx, dy);
    p.metalRoughTexel = fetchValue(2, layers.z, samplers.z, uv, dx, dy);
    p.emissiveTexel = fetchColor(3, layers.w, samplers.w, uv, dx, dy);
    SurfaceModel model = surfaceModel(values, p);
    result.diffuse = model.diffuse;
    result.specular = model.specular;
    result.emissive = model.emissive;
    result.normal = model.normal;
    result.alpha2 = model.alpha2;
#ifdef MATERIAL_CLASSES
    result.materialClass = values.materialClass;
#endif
    result.normalDx = unitNormalChange(p, fetchRotate(draw, 3, normalDx));
    result.normalDy = unitNormalChange(p, fetchRotate(draw, 3, normalDy));
}

#ifdef AGAA_EXPANDS_TRIANGLES
const uint drawTwoSided = 1u, drawMasked = 2u, drawAlphaRows = 4u, drawTested = 8u;

void agaaHostDraw(uint index, inout AgaaDraw d) {
    uvec4 t = texelFetch(fetchDraws, drawTexels * int(index) + 7);
    d.primitives = t.x;
    d.isAlphaMasked = (t.y & drawMasked) != 0u;
    if ((t.y & drawTwoSided) == 0u)
        d.culledFacing = fetchDraw(index).handedness < 0.0 ? -1 : 1;
}

// The inputs of alpha at all points of a primitive.
struct FetchAlpha {
    vec2 uv[3];
    vec3 alpha; // of the vertices
    float base;
    int layer;
    uint sampling;
    vec2 dx, dy;
};

vec2 fetchAlphaUv(FetchAlpha f, vec3 weights) {
    return weights.x * f.uv[0] + weights.y * f.uv[1] + weights.z * f.uv[2];
}

// The function matches alphaAt() of material_inputs.glsl.
float fetchAlphaAt(FetchAlpha f, AgaaPrimitive p, vec2 offset) {
    agaaMoveTo(p, offset);
    precise float alpha = f.base * clamp(dot(p.at, f.alpha), 0.0, 1.0);
    if (f.layer >= 0)
        alpha *= fetchColor(0, f.layer, f.sampling, fetchAlphaUv(f, p.at), f.dx, f.dy).a;
    return alpha;
}

void agaaHostAlpha(AgaaPrimitive p, inout AgaaAlpha a) {
    FetchDraw draw = fetchDraw(p.draw);
    uvec4 t = texelFetch(fetchDraws, draw.at + 7);
    int m = materialTexels * draw.material;
    FetchAlpha f;
    for (uint corner = 0u; corner < 3u; ++corner) {
        int v = fetchVertex(draw, p.primitive, corner);
        uint color = texelFetch(fetchVertices, v).w;
        f.alpha[corner] = float(color >> 25u) / 127.0;
        f.uv[corner] = uintBitsToFloat(uvec2(texelFetch(fetchVertices, v + 1).w, texelFetch(fetchVertices, v + 2).w));
    }
    f.base = uintBitsToFloat(texelFetch(fetchMaterials, m).w);
    f.layer = int(texelFetch(fetchMaterials, m + 3).x);
    f.sampling = texelFetch(fetchMaterials, m + 4).x;
    f.dx = fetchAlphaUv(f, p.dx);
    f.dy = fetchAlphaUv(f, p.dy);
    uint first = draw.firstVertex + texelFetch(fetchIndices, int(draw.firstIndex + 3u * p.primitive)).x;
    uint seed = (t.z ^ first) * 0x9E3779B1u;
    a.primitiveSeed = seed ^ seed >> 15;
    bool isTested = (t.y & drawTested) != 0u;
    a.alphaCutoff = isTested ? uintBitsToFloat(t.w) : 0.0;
    a.hasAlphaRows = (t.y & drawAlphaRows) != 0u;
    a.hasAlphaNear = true;
    for (uint k = 0u; k < 1u && !isTested; ++k)
        a.alpha = fetchAlphaAt(f, p, vec2(0.0));
    for (uint k = 0u; k < 4u && isTested && !a.hasAlphaRows; ++k)
        a.alphaNear[k] = fetchAlphaAt(f, p, agaa_alphaPoint(k));
    for (uint k = 0u; k < 16u && a.hasAlphaRows; ++k)
        a.alphaRows[k >> 2u][k & 3u] = fetchAlphaAt(f, p, agaa_alphaRowPoint(k >> 2u, k & 3u));
}
#endif
