// Shading by the light of an environment: the text of an AgaaShadingFunction at the level EVENT. The engine defines:
// ENVIRONMENT_MAP_AT, ENVIRONMENT_LIGHT_AT   where the resources are bound
// ENVIRONMENT_LEVELS                         the number of levels of the map
// ENVIRONMENT_SPECULAR                       1 if the view has AGAA_FACT_SPECULAR
// MATERIAL_CLASSES                           if the layout has the attribute `materialClass`

layout(ENVIRONMENT_MAP_AT) uniform sampler2D environmentMap; // RadianceLevel of the engine, by mip level
layout(std140, ENVIRONMENT_LIGHT_AT) uniform EnvironmentLight {
    vec4 irradiance[9];    // spherical harmonics of irradiance / pi
    vec4 reflectance[512]; // two entries of the table each, which has 32 cosines for each of 32 roughnesses
} environment;

const float environmentPi = 3.14159265;

// Returns the mean of irradiance / pi over the normals of an event, which is the radiance of a white diffuse surface.
// Irradiance is a sum of spherical harmonics of the normal. The mean of band 0 is exact, and so is that of band 1: its
// terms are linear, so that their mean is the term of the mean normal, whose length is normalLength. Of a narrow round
// distribution of normals, the mean of band 2 is that of its middle times the cube of the length: with the variance v,
// band l shrinks by exp(-l(l+1) v / 2), and band 1 is the length.
vec3 environmentIrradiance(vec3 n, float normalLength) {
    vec4 c[9] = environment.irradiance;
    vec3 band1 = c[1].rgb * n.y + c[2].rgb * n.z + c[3].rgb * n.x;
    vec3 band2 = c[4].rgb * (n.x * n.y) + c[5].rgb * (n.y * n.z) + c[6].rgb * (3.0 * n.z * n.z - 1.0) +
                 c[7].rgb * (n.x * n.z) + c[8].rgb * (n.x * n.x - n.y * n.y);
    return max(c[0].rgb + normalLength * (band1 + normalLength * normalLength * band2), vec3(0.0));
}

// Rows 0 and height - 1 of a level are the poles.
vec3 environmentLevel(vec2 place, int level) {
    // The size of a level is computed: llvmpipe (Mesa 22.3) returns that of the first invocation's level to all.
    float height = float(textureSize(environmentMap, 0).y >> level);
    return textureLod(environmentMap, vec2(place.x, (0.5 + place.y * (height - 1.0)) / height), float(level)).rgb;
}

// Returns the radiance from a direction, a unit vector, that a lobe of this width reflects. Shading space has the axes
// of the world, as the map has.
vec3 environmentRadiance(vec3 direction, float alpha2) {
    vec2 place = vec2(0.5 + 0.5 / environmentPi * atan(direction.x, -direction.z),
                      acos(clamp(direction.y, -1.0, 1.0)) / environmentPi);
    float level = clamp(sqrt(sqrt(alpha2)), 0.0, 1.0) * float(ENVIRONMENT_LEVELS - 1);
    int finer = min(int(level), ENVIRONMENT_LEVELS - 2);
    return mix(environmentLevel(place, finer), environmentLevel(place, finer + 1), level - float(finer));
}

vec2 environmentTable(int cosine, int roughness) {
    vec4 pair = environment.reflectance[16 * roughness + cosine / 2];
    return (cosine & 1) == 0 ? pair.xy : pair.zw;
}

// Returns the scale and the offset of F0 in the integral of the lobe over all light, the second sum of the split-sum
// approximation. The usual fit for mobile devices (Karis 2014) loses a quarter of the light at a roughness of 0.5.
vec2 environmentReflectance(float alpha2, float cosine) {
    vec2 place = 31.0 * clamp(vec2(cosine, sqrt(sqrt(alpha2))), 0.0, 1.0);
    ivec2 first = min(ivec2(place), ivec2(30));
    vec2 share = place - vec2(first);
    return mix(mix(environmentTable(first.x, first.y), environmentTable(first.x + 1, first.y), share.x),
               mix(environmentTable(first.x, first.y + 1), environmentTable(first.x + 1, first.y + 1), share.x),
               share.y);
}

vec3 environmentSpecular(vec3 specular, float alpha2, vec3 normal, vec3 toEye) {
    float cosine = clamp(dot(normal, toEye), 0.0, 1.0);
    vec2 reflectance = environmentReflectance(alpha2, cosine);
    vec3 mirrored = normalize(2.0 * dot(normal, toEye) * normal - toEye);
    return (specular * reflectance.x + reflectance.y) * environmentRadiance(mirrored, alpha2);
}

// An elliptic lobe reads the level of a round one with the same solid angle.
float environmentAlpha2(AgaaSurface surface) { return sqrt(surface.alpha2 * surface.alpha2Along); }

// The light of the environment that a surface without a coat reflects.
vec3 environmentLight(AgaaSurface surface, vec3 toEye) {
    vec3 sum = surface.diffuse * environmentIrradiance(surface.normal, surface.normalLength);
#if ENVIRONMENT_SPECULAR
    sum += environmentSpecular(surface.specular, environmentAlpha2(surface), surface.normal, toEye);
#endif
    return sum;
}

// The light of the frame that the library's model reflects.
vec3 reflectedLight(AgaaSurface surface, AgaaIncidentLight light, vec3 toEye) {
    return agaaBuiltInReflect(surface, light.toLight, toEye) * light.radiance;
}

// Classes of materials, which are custom attributes of the layout. Class 1 has a clear coat over class 0, as
// KHR_materials_clearcoat has it at full strength.
#ifdef MATERIAL_CLASSES
const float coatReflectance = 0.04;
const float coatAlpha2 = 0.05 * 0.05 * 0.05 * 0.05; // the square of GGX alpha 0.05^2

bool hasCoat(AgaaSurface surface) { return surface.materialClass == 1.0; }

// The spread of normals widens the lobe of the coat as the library widens surface.alpha2, but from the coat's own
// width (Toksvig 2005).
float coatWidth(float normalLength) {
    float spread = 2.0 * (1.0 - coatAlpha2) * (1.0 - normalLength);
    return clamp((coatAlpha2 * normalLength + spread) / (normalLength + spread), coatAlpha2, 1.0);
}

AgaaSurface coatOf(AgaaSurface surface) {
    surface.diffuse = vec3(0.0);
    surface.specular = vec3(coatReflectance);
    surface.alpha2 = surface.alpha2Along = coatWidth(surface.normalLength);
    surface.axis = vec3(0.0);
    return surface;
}

// The share of light that the coat lets through towards the eye.
float underCoat(AgaaSurface surface, vec3 toEye) {
    float m = 1.0 - clamp(dot(surface.normal, toEye), 0.0, 1.0);
    return (1.0 - coatReflectance) * (1.0 - m * m * m * m * m);
}
#endif

vec3 agaaShade(AgaaSurface surface) {
    vec3 toEye = agaaToEye(surface.position);
    vec3 base = surface.emissive + environmentLight(surface, toEye);
    vec3 coat = vec3(0.0);
#ifdef MATERIAL_CLASSES
    bool isCoated = hasCoat(surface);
    if (isCoated)
        coat = environmentSpecular(vec3(coatReflectance), coatWidth(surface.normalLength), surface.normal, toEye);
#endif
    AgaaLights lights = agaaLights();
    AgaaIncidentLight light;
    while (agaaNextLight(lights, surface, light)) {
        if (light.radiance == vec3(0.0))
            continue;
        AgaaSurface lit = agaaLitPart(surface, light);
        base += reflectedLight(lit, light, toEye);
#ifdef MATERIAL_CLASSES
        if (isCoated)
            coat += reflectedLight(coatOf(lit), light, toEye);
#endif
    }
#ifdef MATERIAL_CLASSES
    if (isCoated)
        base *= underCoat(surface, toEye);
#endif
    return base + coat;
}
