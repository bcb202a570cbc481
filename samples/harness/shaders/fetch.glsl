// What the SDK's pass that fetches by id asks of the sample engine: triangles and materials from buffers, textures
// from two arrays. interface.glsl and material.glsl come before this text.

// As the engine's FetchDraw and FetchMaterial.
struct FetchDraw {
    vec4 toShading[3];       // as material.vert's
    vec4 normalToShading[3];
    uint firstIndex;
    uint firstVertex;
    uint material;
    float handedness;
};
struct FetchMaterial {
    MaterialValues values;
    ivec4 layers; // of base colour, normal, metallic-roughness and emissive texture; -1: none
    uvec4 wraps;  // of these: of u, and of v times 4: 0 repeat, 1 mirror, 2 clamp
};
layout(std140, FETCH_UNIFORM_AT) uniform FetchCamera { mat4 viewProjection; } fetchCamera;
layout(std430, FETCH_STORAGE_AT(0)) readonly buffer FetchDraws { FetchDraw data[]; } fetchDraws;
layout(std430, FETCH_STORAGE_AT(1)) readonly buffer FetchMaterials { FetchMaterial data[]; } fetchMaterials;
layout(std430, FETCH_STORAGE_AT(2)) readonly buffer FetchVertices { float data[]; } fetchVertices;
layout(std430, FETCH_STORAGE_AT(3)) readonly buffer FetchIndices { uint data[]; } fetchIndices;
layout(FETCH_TEXTURE_AT(0)) uniform sampler2DArray fetchColors; // sRGB
layout(FETCH_TEXTURE_AT(1)) uniform sampler2DArray fetchValues;

const uint vertexFloats = 13u; // position 3, normal 3, tangent 4, uv 2, colour 1

vec2 fetch2(uint at) { return vec2(fetchVertices.data[at], fetchVertices.data[at + 1u]); }
vec3 fetch3(uint at) { return vec3(fetch2(at), fetchVertices.data[at + 2u]); }

float fetchRow(vec4 row, vec3 p) { return ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w; }
vec3 fetchTransform(vec4 rows[3], vec3 p) {
    return vec3(fetchRow(rows[0], p), fetchRow(rows[1], p), fetchRow(rows[2], p));
}
vec3 fetchRotate(vec4 rows[3], vec3 v) {
    return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

uint fetchVertex(FetchDraw draw, uint primitive, uint corner) {
    return vertexFloats * (draw.firstVertex + fetchIndices.data[draw.firstIndex + 3u * primitive + corner]);
}

// As material.vert computes it.
vec4 fetchClip(FetchDraw draw, uint vertex) {
    vec3 p = fetchTransform(draw.toShading, fetch3(vertex));
    mat4 m = fetchCamera.viewProjection;
    return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3];
}

void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    FetchDraw d = fetchDraws.data[draw];
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
    vec2 halfTexel = 0.5 / vec2(textureSize(textures, 0).xy);
    uv = vec2(fetchWrapped(uv.x, wrap & 3u, halfTexel.x), fetchWrapped(uv.y, wrap >> 2u, halfTexel.y));
    return textureGrad(textures, vec3(uv, float(layer)), dx, dy);
}

void agaaHostMaterial(AgaaPrimitive primitive, inout AgaaMaterial result) {
    FetchDraw draw = fetchDraws.data[primitive.draw];
    FetchMaterial material = fetchMaterials.data[draw.material];
    SurfacePoint p;
    vec3 position = vec3(0.0);
    p.normal = vec3(0.0);
    p.tangent = vec4(0.0);
    p.color = vec3(0.0);
    vec2 uv = vec2(0.0), dx = vec2(0.0), dy = vec2(0.0);
    for (uint corner = 0u; corner < 3u; ++corner) {
        uint v = fetchVertex(draw, primitive.primitive, corner);
        float weight = primitive.at[corner];
        position += weight * fetch3(v);
        p.normal += weight * fetch3(v + 3u);
        p.tangent += weight * vec4(fetch3(v + 6u), fetchVertices.data[v + 9u]);
        vec2 own = fetch2(v + 10u);
        uv += weight * own;
        dx += primitive.dx[corner] * own;
        dy += primitive.dy[corner] * own;
        p.color += weight * unpackUnorm4x8(floatBitsToUint(fetchVertices.data[v + 12u])).rgb;
    }
    p.position = fetchTransform(draw.toShading, position);
    p.normal = fetchRotate(draw.normalToShading, p.normal);
    p.tangent = vec4(fetchRotate(draw.toShading, p.tangent.xyz), p.tangent.w * draw.handedness);
    p.isFront = primitive.facing * draw.handedness < 0.0; // counter-clockwise where y points up
    p.isBent = material.layers.y >= 0;
    p.baseTexel = fetchTexel(fetchColors, material.layers.x, material.wraps.x, uv, dx, dy);
    p.normalTexel = fetchTexel(fetchValues, material.layers.y, material.wraps.y, uv, dx, dy);
    p.metalRoughTexel = fetchTexel(fetchValues, material.layers.z, material.wraps.z, uv, dx, dy);
    p.emissiveTexel = fetchTexel(fetchColors, material.layers.w, material.wraps.w, uv, dx, dy);
    SurfaceModel model = surfaceModel(material.values, p);
    result.diffuse = model.diffuse;
    result.specular = model.specular;
    result.emissive = model.emissive;
    result.normal = model.normal;
    result.alpha2 = model.alpha2;
}
