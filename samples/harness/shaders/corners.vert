// Replaces corners.geom in views with AGAA_VIEW_VERTEX_PULLING: reads the corners of a triangle from the scene's
// vertices and indices. The SDK's vertex text, interface.glsl, object.glsl and corner_outputs.glsl come before this
// text. Vertices of a draw are numbered through the strips of all triangles of a mesh.

layout(PULLED_VERTICES_AT) uniform usamplerBuffer pulledVertices; // words of the engine's Vertex
layout(PULLED_INDICES_AT) uniform usamplerBuffer pulledIndices;

const int vertexWords = 13;

float pulledFloat(int word) { return uintBitsToFloat(texelFetch(pulledVertices, word).x); }
vec4 pulledBytes(int word) { // decodes an attribute of normalised bytes
    uint bytes = texelFetch(pulledVertices, word).x;
    return vec4(uvec4(bytes, bytes >> 8u, bytes >> 16u, bytes >> 24u) & 255u) * (1.0 / 255.0);
}
vec3 pulledVector(int word) { return vec3(pulledFloat(word), pulledFloat(word + 1), pulledFloat(word + 2)); }

// vertex is an index into the scene's vertices. Returns clip coordinates.
vec4 pull(uint vertex, out Corner corner) {
    int word = vertexWords * int(vertex);
    vec4 color = pulledBytes(word + 12);
    vec3 position = transform(draw.toShading, pulledVector(word));
    vec4 clip = clipOf(position);
    corner.uv = vec2(pulledFloat(word + 10), pulledFloat(word + 11));
    corner.alpha = color.a;
#if AGAA_NEEDS_MATERIAL
    corner.position = position;
    corner.normal = rotate(draw.normalToShading, pulledVector(word + 3));
    corner.tangent = vec4(rotate(draw.toShading, pulledVector(word + 6)), pulledFloat(word + 9) * draw.handedness);
    corner.color = color.rgb;
#endif
    return clip;
}

void main() {
    uint primitive = uint(VERTEX_INDEX) / uint(AGAA_MAX_STRIP);
    uint vertex = 0u;
    vec4 clip[3];
    for (int i = 0; i < 3; ++i) {
        uint pulled = draw.firstVertex + texelFetch(pulledIndices, int(draw.firstIndex + 3u * primitive) + i).x;
        vertex = i == 0 ? pulled : vertex;
        Corner corner;
        clip[i] = pull(pulled, corner);
        setCorner(i, corner);
    }
    cornerIds = uvec3(seedOf(vertex), draw.index, primitive);
    agaa_pullVertex(clip[0], clip[1], clip[2], uint(VERTEX_INDEX) % uint(AGAA_MAX_STRIP));
}
