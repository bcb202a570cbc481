// Features by which samples are compared. Needs common/target.glsl and math/display.glsl.
#ifndef AGAA_SAMPLE_FEATURES_GLSL
#define AGAA_SAMPLE_FEATURES_GLSL
#if !defined(AGAA_TARGET_GLSL) || !defined(AGAA_MATH_DISPLAY_GLSL)
#error "sample_features.glsl needs target.glsl and display.glsl."
#endif
#ifndef AGAA_SAMPLE_LANES
#define AGAA_SAMPLE_LANES 0
#endif
// A lane exchanges the five words of its features and three words of aggregate/lanes.glsl.
#define AGAA_GROUPING_WORDS 8u
#include "math/adaptive.glsl"
#include "adaptive/adaptive_flags.glsl"
#include "gbuffer/gbuffer.glsl"
#include "common/sample_depth.glsl"
#include "adaptive/stored_choice.glsl"

struct agaa_Features {
    vec3 position, normal; // in shading space
    float width;           // tolerance of distances from its plane
    vec4 diffuseAlpha; // diffuse colour; w: the lobe's alpha
    vec3 specular;     // reflectance
    vec3 emission;     // as displayed: colours of equal luma differ
    float light;       // luma as displayed, without shadows, with AGAA_ADAPTIVE_LIGHTS
};

// Returns sample j of the pattern's order, which begins in the middle. A constant holds four samples.
uint agaa_sampleInOrder(uint j) {
    const uint words[8] =
        uint[8](AGAA_ORDER0, AGAA_ORDER1, AGAA_ORDER2, AGAA_ORDER3, AGAA_ORDER4, AGAA_ORDER5, AGAA_ORDER6, AGAA_ORDER7);
    return words[j >> 2u] >> (8u * (j & 3u)) & 0xFFu;
}

agaa_Features agaa_featuresAt(uvec2 pixel, uint i, float depth, vec3 normal, vec4 diffuseAlpha, vec3 specular,
                              vec3 emission, float light) {
    vec3 position = agaa_sampleViewPosition(pixel, i, depth);
    float width = agaa_frame.surfaceDistance * agaa_pixelWidth(position.z) +
                  2.0 * agaa_depthQuantum(position.z, depth, agaa_frame.projection22, agaa_frame.projection32,
                                          agaa_isOrthographic(), agaa_storedQuantum(depth));
    return agaa_Features(agaa_toShadingSpace(position), normal, width, diffuseAlpha, specular, emission,
                         light);
}

// Returns the light of a sample, which a pass before this one has estimated.
float agaa_estimatedLight(uvec2 pixel, uint i) {
#ifdef AGAA_ESTIMATES_LIGHT
    return 0.0;
#else
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_LIGHTS))
        return 0.0;
    return float(agaa_choices.words[agaa_lightAt(pixel, i >> 2u)] >> (8u * (i & 3u)) & 0xFFu) / 255.0;
#endif
}

// Returns the features of the sample fetched last.
agaa_Features agaa_fetchedFeatures(uvec2 pixel, uint i, float depth) {
    agaa_Surface s = agaa_sampleSurface();
    return agaa_featuresAt(pixel, i, depth, s.normal, vec4(s.diffuse, sqrt(s.alpha2)), s.specular,
                           agaa_displayed(s.emissive), agaa_estimatedLight(pixel, i));
}

// The features of the pixel's samples: depth, the code of the normal, diffuse colour and alpha, reflectance; and
// emission, where materials are emissive.
#if AGAA_SAMPLE_LANES
#include "aggregate/lanes.glsl"
void agaa_keepFeatureWords(uint i, uvec4 words, uint emission) {
    const uint lane = agaa_firstLane() + i;
    for (uint k = 0u; k < 4u; ++k)
        AGAA_LANE_WORD(lane, k) = words[k];
    if (agaa_hasFact(AGAA_FACT_EMISSIVE))
        AGAA_LANE_WORD(lane, 4u) = emission;
}
uvec4 agaa_keptFeatures(uint i) {
    const uint lane = agaa_firstLane() + i;
    return uvec4(AGAA_LANE_WORD(lane, 0u), AGAA_LANE_WORD(lane, 1u), AGAA_LANE_WORD(lane, 2u),
                 AGAA_LANE_WORD(lane, 3u));
}
uint agaa_keptEmission(uint i) { return AGAA_LANE_WORD(agaa_firstLane() + i, 4u); }
#else
uvec4 agaa_sampleFeatures[AGAA_SAMPLES];
uint agaa_sampleEmission[AGAA_SAMPLES];
void agaa_keepFeatureWords(uint i, uvec4 words, uint emission) {
    agaa_sampleFeatures[i] = words;
    if (agaa_hasFact(AGAA_FACT_EMISSIVE))
        agaa_sampleEmission[i] = emission;
}
uvec4 agaa_keptFeatures(uint i) { return agaa_sampleFeatures[i]; }
uint agaa_keptEmission(uint i) { return agaa_sampleEmission[i]; }
#endif

// Packs the features of the sample fetched last.
void agaa_packFeatures(uvec2 pixel, uint i, float depth) {
    agaa_Surface s = agaa_sampleSurface();
    agaa_keepFeatureWords(i,
                          uvec4(floatBitsToUint(depth), packUnorm2x16(agaa_normalCode()),
                                packUnorm4x8(vec4(s.diffuse, sqrt(s.alpha2))),
                                packUnorm4x8(vec4(s.specular, agaa_estimatedLight(pixel, i)))),
                          packUnorm4x8(vec4(agaa_displayed(s.emissive), 0.0)));
}

agaa_Features agaa_unpackFeatures(uvec2 pixel, uint i) {
    uvec4 words = agaa_keptFeatures(i);
    vec3 emission = agaa_hasFact(AGAA_FACT_EMISSIVE) ? unpackUnorm4x8(agaa_keptEmission(i)).xyz : vec3(0.0);
    vec4 specularLight = unpackUnorm4x8(words.w);
    return agaa_featuresAt(pixel, i, uintBitsToFloat(words.x),
                           agaa_decodeOct(unpackUnorm2x16(words.y), agaa_fieldBits(AGAA_SOURCE_NORMAL_X)),
                           unpackUnorm4x8(words.z), specularLight.xyz, emission, specularLight.w);
}

// Returns the difference of two samples in thresholds: the largest of those of normals, planes, materials and light.
// The weight of normals rises with gloss.
float agaa_differenceOf(agaa_Features a, agaa_Features b) {
    float gloss = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) / max(min(a.diffuseAlpha.w, b.diffuseAlpha.w), 0.01),
                        1.0, 20.0);
    vec4 material = abs(a.diffuseAlpha - b.diffuseAlpha);
    material.w = max(material.w, abs(a.light - b.light));
    material.xyz = max(material.xyz, max(abs(a.specular - b.specular), abs(a.emission - b.emission)));
    return max(max(agaa_normalStep(a.normal, b.normal, agaa_frame.surfaceCosine) * gloss,
                   agaa_planeStep(b.position - a.position, a.normal, b.normal, max(a.width, b.width))),
               max(max(material.x, material.y), max(material.z, material.w)) / max(agaa_frame.surfaceMaterial, 1e-3));
}

// Returns the first of these samples in the pattern's order.
uint agaa_firstInOrder(uint covered) {
    uint j = 0u;
    while ((covered >> agaa_sampleInOrder(j) & 1u) == 0u)
        ++j;
    return agaa_sampleInOrder(j);
}

// Returns the samples whose shadows the first sample is shaded with.
// alike   Samples that do not differ enough to be shaded.
uint agaa_samplesOfFirst(uint first, uint alike, uint covered) {
    if (agaa_isAdaptive(AGAA_ADAPTIVE_GEOMETRY))
        return alike;
    return agaa_isAdaptive(AGAA_ADAPTIVE_SHADING) ? covered : 1u << first;
}

#if AGAA_SAMPLE_LANES
// The sample of a lane. All lanes call the functions.
struct agaa_LaneFeatures {
    uint covered; // samples of the pixel with geometry
    uint first;   // of these, in the pattern's order
    bool isCovered;
    float difference; // from the first
};

// Returns the features of sample i. own: of this lane's sample.
agaa_Features agaa_featuresOfSample(agaa_Features own, uint i) {
    agaa_Features f;
    f.position = agaa_ofSample(own.position, i);
    f.normal = agaa_ofSample(own.normal, i);
    f.diffuseAlpha.xyz = agaa_ofSample(own.diffuseAlpha.xyz, i);
    f.specular = agaa_ofSample(own.specular, i);
    f.emission = agaa_hasFact(AGAA_FACT_EMISSIVE) ? agaa_ofSample(own.emission, i) : own.emission;
    vec3 others = agaa_ofSample(vec3(own.width, own.diffuseAlpha.w, own.light), i);
    f.width = others.x;
    f.diffuseAlpha.w = others.y;
    f.light = others.z;
    return f;
}

#ifdef AGAA_HOST_FETCH
// Keeps the features of this lane's sample. The lane of the first sample of a primitive fetches its material.
agaa_Features agaa_loadFeatures(uvec2 pixel, uint covered, bool isCovered) {
    const uint i = min(agaa_laneSample(), AGAA_SAMPLES - 1u);
    const uint shown = isCovered ? agaa_samplesOfPrimitive(pixel, i, covered) : 1u << i;
    const uint fetching = uint(findLSB(shown));
    AgaaMaterial m = agaa_defaultMaterial();
    if (isCovered && fetching == i)
        m = agaa_fetchMaterial(agaa_primitive(agaa_idOf(pixel, i)), pixel, shown);
    m.diffuse = agaa_ofSample(m.diffuse, fetching);
    m.specular = agaa_ofSample(m.specular, fetching);
    m.emissive = agaa_ofSample(m.emissive, fetching);
    m.normal = agaa_ofSample(m.normal, fetching);
    m.normalDx = agaa_ofSample(m.normalDx, fetching);
    m.normalDy = agaa_ofSample(m.normalDy, fetching);
    m.alpha2 = agaa_ofSample(vec3(m.alpha2), fetching).x;
    agaa_fetched = m;
    agaa_fetched.normal = agaa_materialNormal(m, i);
    if (isCovered)
        agaa_packFeatures(pixel, i, agaa_depthOf(pixel, i));
    return agaa_unpackFeatures(pixel, i);
}
#else
agaa_Features agaa_loadFeatures(uvec2 pixel, uint covered, bool isCovered) {
    const uint i = min(agaa_laneSample(), AGAA_SAMPLES - 1u);
    agaa_Features own = agaa_Features(vec3(0.0), vec3(0.0), 0.0, vec4(0.0), vec3(0.0), vec3(0.0), 0.0);
    if (isCovered) {
        agaa_fetchSample(pixel, i);
        float depth = agaa_depthOf(pixel, i);
        own = agaa_fetchedFeatures(pixel, i, depth);
        agaa_packFeatures(pixel, i, depth);
    }
    return own;
}
#endif

// Loads the samples of a pixel, which may be outside the image, and compares them with the first.
agaa_LaneFeatures agaa_loadLaneFeatures(uvec2 pixel) {
    const uint i = agaa_laneSample();
    agaa_LaneFeatures s;
    s.isCovered = false;
    if (all(lessThan(pixel, agaa_frame.size)) && i < AGAA_SAMPLES)
        s.isCovered = agaa_isCovered(pixel, i);
    s.covered = agaa_samplesWhere(s.isCovered);
    s.first = s.covered != 0u ? agaa_firstInOrder(s.covered) : 0u;
    agaa_syncLanes(); // the lanes have read the features of the previous pixel
    agaa_Features own = agaa_loadFeatures(pixel, s.covered, s.isCovered);
    agaa_syncLanes();
    agaa_Features f = agaa_featuresOfSample(own, s.first);
    s.difference = i == s.first ? -1.0 : agaa_differenceOf(f, own);
    return s;
}

// Returns the samples that do not differ enough from the first to be shaded.
uint agaa_alikeSamples(agaa_LaneFeatures s) {
    return agaa_samplesWhere(s.isCovered && !agaa_callsForSample(s.difference));
}

// Reads the kept features of sample i, which has geometry. Returns true.
bool agaa_readFeatures(uvec2 pixel, uint i, out agaa_Features f) {
    f = agaa_unpackFeatures(pixel, i);
    return true;
}
#elif defined(AGAA_HOST_FETCH)
// Loads the pixel's samples, with one material per primitive. Returns the mask of samples with geometry.
uint agaa_loadFetched(uvec2 pixel) {
    uint covered = 0u;
    uint i = 0u;
    do
        covered |= agaa_isCovered(pixel, i) ? 1u << i : 0u;
    while (++i < agaa_sampleCount());
    for (uint left = covered; left != 0u;) {
        uint own = agaa_samplesOfPrimitive(pixel, uint(findLSB(left)), left);
        left &= ~own;
        AgaaMaterial m = agaa_fetchMaterial(agaa_primitive(agaa_idOf(pixel, uint(findLSB(own)))), pixel, own);
        agaa_fetched = m;
        for (; own != 0u; own &= own - 1u) {
            uint j = uint(findLSB(own));
            agaa_fetched.normal = agaa_materialNormal(m, j);
            agaa_packFeatures(pixel, j, agaa_depthOf(pixel, j));
        }
    }
    return covered;
}

// Called before the pixel's samples are read.
uint agaa_fetchedSamples = 0u;
void agaa_beginSamples(uvec2 pixel) { agaa_fetchedSamples = agaa_loadFetched(pixel); }

// Returns false where the sample has no geometry.
bool agaa_readFeatures(uvec2 pixel, uint i, out agaa_Features f) {
    f = agaa_unpackFeatures(pixel, i);
    return (agaa_fetchedSamples >> i & 1u) != 0u;
}

void agaa_keepFeatures(uvec2 pixel, uint i) {}
#else
void agaa_beginSamples(uvec2 pixel) {}

bool agaa_readFeatures(uvec2 pixel, uint i, out agaa_Features f) {
    bool isCovered = agaa_fetchSample(pixel, i);
    f = agaa_fetchedFeatures(pixel, i, agaa_depthOf(pixel, i));
    return isCovered;
}

// Keeps the features of the sample that was read last.
void agaa_keepFeatures(uvec2 pixel, uint i) { agaa_packFeatures(pixel, i, agaa_depthOf(pixel, i)); }
#endif
#endif
