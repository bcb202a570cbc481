// Reads samples of a multisampled G-buffer: from attachments by the layout, from the host's G-buffer by a function of
// the host, or by fetching materials by id. Needs common/target.glsl. To fetch by id it needs what ids/fetch.glsl
// needs.
#ifndef AGAA_GBUFFER_GLSL
#define AGAA_GBUFFER_GLSL
#ifndef AGAA_TARGET_GLSL
#error "gbuffer.glsl needs target.glsl."
#endif
#include "math/encoding.glsl"
#include "math/light.glsl"
#include "common/host_samples.glsl"
#include "common/scene_facts.glsl"
#include "common/stored.glsl"

#if defined(AGAA_HOST_GBUFFER) || (defined(AGAA_HOST_FETCH) && !defined(AGAA_SOME_UNFETCHED))
AgaaMaterial agaa_fetched; // the sample fetched last

#ifdef AGAA_HOST_GBUFFER
bool agaa_fetchSample(uvec2 pixel, uint i) {
    float depth;
    return agaa_readHost(pixel, i, depth, agaa_fetched);
}

bool agaa_isCovered(uvec2 pixel, uint i) { return agaa_hostShows(pixel, i); }
void agaa_fetchEvent(uvec2 pixel, uint i, uint samples) { agaa_fetchSample(pixel, i); }
#else
#include "adaptive/adaptive_flags.glsl"
#include "ids/fetch.glsl"
#include "ids/sample_ids.glsl"

bool agaa_isCovered(uvec2 pixel, uint i) { return agaa_idOf(pixel, i) != 0u; }

// Returns those of these samples that show the primitive of sample i.
uint agaa_samplesOfPrimitive(uvec2 pixel, uint i, uint samples) {
    const uint id = agaa_idOf(pixel, i);
    uint found = 0u;
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        uint other = uint(findLSB(rest));
        found |= agaa_idOf(pixel, other) == id ? 1u << other : 0u;
    }
    return found;
}

// Fetches the material of a shading event at sample i, at the centroid of those of these samples that show its
// primitive. Textures are filtered over their share of the pixel (Hollaender et al. 2013, section 4.1).
void agaa_fetchEvent(uvec2 pixel, uint i, uint samples) {
    const uint shown = agaa_samplesOfPrimitive(pixel, i, samples | 1u << i);
    vec2 middle = vec2(0.0);
    for (uint rest = shown; rest != 0u; rest &= rest - 1u)
        middle += agaa_sampleLocation(uint(findLSB(rest)));
    middle /= float(bitCount(shown));
    const int represented = agaa_isAdaptive(AGAA_ADAPTIVE_SAMPLE_FOOTPRINTS) ? 1 : bitCount(shown);
    const float width = sqrt(float(represented) / float(AGAA_SAMPLES));
    AgaaPrimitive p = agaa_primitive(agaa_idOf(pixel, i));
    agaa_evaluateAt(p, pixel, middle);
    p.dx *= width;
    p.dy *= width;
    agaa_fetched = agaa_evaluateMaterial(p);
}
#endif

vec2 agaa_normalCode() { return agaa_encodeOct(agaa_fetched.normal, agaa_fieldBits(AGAA_SOURCE_NORMAL_X)); }
vec3 agaa_fetchedNormal() { return agaa_fetched.normal; }
vec3 agaa_fetchedDiffuse() { return agaa_fetched.diffuse; }
vec3 agaa_fetchedSpecular() { return agaa_fetched.specular; }
float agaa_fetchedAlpha2() { return agaa_fetched.alpha2; }

vec3 agaa_storedEmissive() {
    vec3 e = agaa_fetched.emissive / agaa_frame.emissiveRange;
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        return vec3(agaa_emissiveFactor(agaa_fetched.diffuse, e));
    return AGAA_EMISSIVE_CHANNELS == 3u ? e : vec3(0.0);
}

void agaa_storeFetchedCustom(inout agaa_Stored v) { AGAA_STORE_CUSTOM(agaa_fetched, v) }
#else
layout(AGAA_BINDING_GBUFFER0) uniform AGAA_TARGET_TEXTURE agaa_gbuffer0;
layout(AGAA_BINDING_GBUFFER1) uniform AGAA_TARGET_TEXTURE agaa_gbuffer1;
layout(AGAA_BINDING_GBUFFER2) uniform AGAA_TARGET_TEXTURE agaa_gbuffer2;
layout(AGAA_BINDING_GBUFFER3) uniform AGAA_TARGET_TEXTURE agaa_gbuffer3;

agaa_Stored agaa_fetched; // the sample fetched last; absent channels are 0

// spirv-opt inlines functions with one return.
float agaa_sourceValue(float texel, uint source) {
    const uint bits = agaa_fieldBits(source);
    float value = bits != 0u ? texel : 0.0;
    if (agaa_isSignedField(source))
        value = agaa_fromSignedCode(uint(texel * float(agaa_maxCode(bits)) + 0.5), bits);
    return value;
}

// Returns false where the sample has no geometry.
bool agaa_fetchSample(uvec2 pixel, uint i) {
    vec4 texels[4];
    texels[0] = AGAA_FETCH(agaa_gbuffer0, pixel, i);
    texels[1] = AGAA_FETCH(agaa_gbuffer1, pixel, i);
    texels[2] = AGAA_FETCH(agaa_gbuffer2, pixel, i);
    texels[3] = AGAA_FETCH(agaa_gbuffer3, pixel, i);
    // Sources are constants, so that each row folds to one component of one texel.
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) \
    agaa_fetched.member = agaa_sourceValue(texels[source & 0xFFu][source >> 8u & 0xFFu], source);
#include "tables/channels.inc"
    return agaa_fetched.normal.x != 0.0;
}

// Returns the result of agaa_fetchSample(), but fetches one attachment only.
bool agaa_isCovered(uvec2 pixel, uint i) {
    const uint attachment = AGAA_SOURCE_NORMAL_X & 0xFFu;
    vec4 texel = attachment == 0u   ? AGAA_FETCH(agaa_gbuffer0, pixel, i)
                 : attachment == 1u ? AGAA_FETCH(agaa_gbuffer1, pixel, i)
                 : attachment == 2u ? AGAA_FETCH(agaa_gbuffer2, pixel, i)
                                    : AGAA_FETCH(agaa_gbuffer3, pixel, i);
    return texel[AGAA_SOURCE_NORMAL_X >> 8u & 0xFFu] != 0.0;
}

// Fetches sample i for a shading event that represents these samples.
void agaa_fetchEvent(uvec2 pixel, uint i, uint samples) { agaa_fetchSample(pixel, i); }

// Returns whether two samples have the same values. The samples of a texel that one fragment covered have.
bool agaa_areAlike(uvec2 pixel, uint a, uint b) {
    return AGAA_FETCH(agaa_gbuffer0, pixel, a) == AGAA_FETCH(agaa_gbuffer0, pixel, b) &&
           AGAA_FETCH(agaa_gbuffer1, pixel, a) == AGAA_FETCH(agaa_gbuffer1, pixel, b) &&
           AGAA_FETCH(agaa_gbuffer2, pixel, a) == AGAA_FETCH(agaa_gbuffer2, pixel, b) &&
           AGAA_FETCH(agaa_gbuffer3, pixel, a) == AGAA_FETCH(agaa_gbuffer3, pixel, b);
}

vec2 agaa_normalCode() { return agaa_fetched.normal.xy; }

// Returns the emission divided by the layout's range or, with one channel, by range times diffuse.
vec3 agaa_storedEmissive() {
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        return agaa_fetched.emissive;
    return AGAA_EMISSIVE_CHANNELS == 1u ? vec3(agaa_fetched.emissive.x) : vec3(0.0);
}

vec3 agaa_fetchedNormal() { return agaa_decodeOct(agaa_normalCode(), agaa_fieldBits(AGAA_SOURCE_NORMAL_X)); }
vec3 agaa_fetchedDiffuse() { return agaa_fetched.diffuse; }
vec3 agaa_fetchedSpecular() { return agaa_storedSpecular(agaa_fetched.specular); }
float agaa_fetchedAlpha2() {
    return agaa_fieldBits(AGAA_SOURCE_ROUGHNESS) != 0u ? agaa_fetched.alpha2 : agaa_factAlpha2(1.0);
}
void agaa_storeFetchedCustom(inout agaa_Stored v) { v.custom = agaa_fetched.custom; }
#endif

agaa_Surface agaa_sampleSurface() {
    agaa_Surface s;
    s.diffuse = agaa_fetchedDiffuse();
    s.normal = agaa_fetchedNormal();
    s.meanLength = 1.0;
    s.alpha2Along = 0.0;
    s.axis = vec3(0.0);
    s.specular = vec3(0.0);
    s.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        s.specular = agaa_fetchedSpecular();
        s.alpha2 = agaa_fetchedAlpha2();
    }
    s.emissive = agaa_frame.emissiveRange * agaa_storedEmissive();
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        s.emissive *= s.diffuse;
    return s;
}

// Returns the custom attributes of the sample fetched last, and no others.
agaa_Stored agaa_fetchedCustom() {
    agaa_Stored v = agaa_storedSurface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
    agaa_storeFetchedCustom(v);
    return v;
}

// Returns the sample fetched last as an aggregate stores it.
agaa_Stored agaa_storedSample() {
    agaa_Surface s = agaa_sampleSurface();
    agaa_Stored v = agaa_storedSurface(s.diffuse, s.specular, s.normal, s.alpha2, agaa_storedEmissive());
    agaa_storeFetchedCustom(v);
    return v;
}
#endif
