// The metallic-roughness model of glTF at a point. Each caller reads the vertices and textures in its own manner.

// Matches MaterialConstants of the engine.
struct MaterialValues {
    vec4 baseColor;
    vec3 emissive;
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff; // < 0: alpha is the coverage
    float materialClass;
};

struct SurfacePoint {
    vec3 toViewer; // unit vector in shading space
    vec3 normal;   // vertex normal of any length
    vec4 tangent;  // w: handedness
    vec3 color;    // vertex colour
    bool isFront;
    bool isBent; // normalTexel bends the normal
    vec4 baseTexel; // 1 if the material has no such texture
    vec4 normalTexel;
    vec4 metalRoughTexel;
    vec4 emissiveTexel;
};

struct SurfaceModel {
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;
    vec3 normal;
    float alpha2;
};

// viewer is a homogeneous position, at infinity in an orthographic view.
vec3 viewerDirection(vec4 viewer, vec3 position) { return normalize(viewer.xyz - viewer.w * position); }

// Returns the vertex normal n, bent by the normal map.
vec3 mappedNormal(vec3 n, vec4 tangent, vec3 m) {
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    float tangentSquared = dot(t, t);
    if (tangentSquared <= 0.0)
        return n;
    t *= inversesqrt(tangentSquared);
    vec3 b = cross(n, t) * (tangent.w < 0.0 ? -1.0 : 1.0);
    vec3 bent = t * m.x + b * m.y + n * m.z;
    float bentSquared = dot(bent, bent);
    return bentSquared > 1e-8 ? bent * inversesqrt(bentSquared) : n;
}

vec3 shadingNormal(SurfacePoint p, float normalScale) {
    float squared = dot(p.normal, p.normal);
    vec3 n = squared > 0.0 ? p.normal * inversesqrt(squared) : p.toViewer;
    if (p.isBent) {
        vec3 m = p.normalTexel.xyz * 2.0 - 1.0;
        m.xy *= normalScale;
        n = mappedNormal(n, p.tangent, m);
    }
    if (!p.isFront)
        n = -n; // glTF's rule for the back of double-sided materials
    // Interpolation and normal maps may turn the normal away from the viewer. It is bent onto the horizon.
    float facing = dot(n, p.toViewer);
    return facing < 0.0 ? normalize(n - p.toViewer * (facing - 1e-3)) : n;
}

// Converts a change of the vertex normal to a change of the unit normal. A normal map turns with it.
vec3 unitNormalChange(SurfacePoint p, vec3 change) {
    float squared = dot(p.normal, p.normal);
    if (squared <= 0.0)
        return vec3(0.0);
    vec3 across = (change - p.normal * (dot(p.normal, change) / squared)) * inversesqrt(squared);
    return p.isFront ? across : -across;
}

// Returns the widening of the lobe: filtering shortens the mean of normals that diverge (Toksvig 2005). `scale` scales
// their slopes.
float widenedAlpha2(float alpha2, float meanLength, float scale) {
    const float rounding = 0.0068; // rounding error of three components of 8 bits
    float deficit = clamp((1.0 - meanLength - rounding) * scale * scale, 0.0, 0.99);
    float widening = 2.0 * (1.0 - alpha2) * deficit;
    return (alpha2 * (1.0 - deficit) + widening) / (1.0 - deficit + widening);
}

SurfaceModel surfaceModel(MaterialValues material, SurfacePoint p) {
    SurfaceModel s;
    vec3 base = material.baseColor.rgb * max(p.color, vec3(0.0)) * p.baseTexel.rgb;
    float metallic = material.metallic * p.metalRoughTexel.b;
    float roughness = material.roughness * p.metalRoughTexel.g;
    s.diffuse = base * (1.0 - metallic);
    s.specular = mix(vec3(0.04), base, metallic);
    s.emissive = material.emissive * p.emissiveTexel.rgb;
    s.normal = shadingNormal(p, material.normalScale);
    // Below this value, the highlight of a point light has no width.
    float alpha = max(roughness, 0.089);
    alpha *= alpha;
    s.alpha2 = alpha * alpha;
    if (p.isBent)
        s.alpha2 = widenedAlpha2(s.alpha2, length(p.normalTexel.xyz * 2.0 - 1.0), material.normalScale);
    return s;
}
