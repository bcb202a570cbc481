// Reading of aggregates from memory, in the SDK's passes and in hosts' own. The including text says by
// AGAA_AGGREGATE_WORD, AGAA_IMAGE_WIDTH and AGAA_EMISSIVE_RANGE where they are.
#ifndef AGAA_STORED_AGGREGATE_GLSL
#define AGAA_STORED_AGGREGATE_GLSL
#include "passes/means.glsl"
#include "math/encoding.glsl"
#include "math/ndf.glsl"
#include "math/records.glsl"

uint agaa_base = 0u;   // first word of the aggregate at hand
uint agaa_count_ = 0u; // its samples

uint agaa_field(uint field) {
    uint bits = field >> 16;
    uint word = AGAA_AGGREGATE_WORD(agaa_base + (field & 0xFFu));
    return bitfieldExtract(word, int(field >> 8u & 0xFFu), int(bits));
}

#if AGAA_REPRESENTED
uvec2 agaa_record() {
    return uvec2(AGAA_AGGREGATE_WORD(agaa_base + AGAA_WORDS),
                 AGAA_SAMPLES > 16u ? AGAA_AGGREGATE_WORD(agaa_base + AGAA_WORDS + 1u) : 0u);
}

// A surface that no fragment was kept for shows nothing.
uint agaa_coverage() {
    return agaa_field(AGAA_FIELD_COVERAGE) != 0u ? agaa_recordSamples(agaa_record(), AGAA_SAMPLES) : 0u;
}

float agaa_mean(uint field) { return agaa_meanOfSum(agaa_field(field), 1u, field >> 16); }
float agaa_signedMean(uint field) { return agaa_signedMeanOfSum(agaa_field(field), 1u, field >> 16); }
#else
uint agaa_coverage() { return agaa_field(AGAA_FIELD_COVERAGE); }

// Sums take log2(n) bits more than one fragment's value.
uint agaa_sum(uint field) { return agaa_field(field + (uint(findMSB(AGAA_SAMPLES)) << 16)); }

float agaa_mean(uint field) { return agaa_meanOfSum(agaa_sum(field), agaa_count_, field >> 16); }
float agaa_signedMean(uint field) { return agaa_signedMeanOfSum(agaa_sum(field), agaa_count_, field >> 16); }
#endif

vec3 agaa_mean3(uint r, uint g, uint b) { return vec3(agaa_mean(r), agaa_mean(g), agaa_mean(b)); }

agaa_Means agaa_aggregateMeans() {
    agaa_Means m;
    m.moments = agaa_NormalMoments(vec3(0.0), vec3(0.0)); // memory has no place for them
    m.diffuse = agaa_mean3(AGAA_FIELD_DIFFUSE_R, AGAA_FIELD_DIFFUSE_G, AGAA_FIELD_DIFFUSE_B);
    m.normal = vec3(agaa_signedMean(AGAA_FIELD_NORMAL_X), agaa_signedMean(AGAA_FIELD_NORMAL_Y),
                    agaa_signedMean(AGAA_FIELD_NORMAL_Z));
    m.lengthBound = agaa_storedLengthBound(1u, AGAA_FIELD_NORMAL_X >> 16);
    m.specular = vec3(0.0);
    m.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        m.specular = agaa_mean3(AGAA_FIELD_SPECULAR_R, AGAA_FIELD_SPECULAR_G, AGAA_FIELD_SPECULAR_B);
        if (AGAA_YCBCR_SPECULAR != 0u)
            m.specular = max(agaa_yCbCrToRgb(m.specular), vec3(0.0));
        if (AGAA_FIELD_ROUGHNESS >> 16 != 0u)
            m.alpha2 = agaa_mean(AGAA_FIELD_ROUGHNESS);
    }
    m.emissive = vec3(0.0);
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        m.emissive = AGAA_EMISSIVE_RANGE *
                     agaa_mean3(AGAA_FIELD_EMISSIVE_R, AGAA_FIELD_EMISSIVE_G, AGAA_FIELD_EMISSIVE_B);
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        m.emissive = AGAA_EMISSIVE_RANGE * agaa_mean(AGAA_FIELD_EMISSIVE_R) * m.diffuse;
    return m;
}

void agaa_selectAggregate(uvec2 pixel, uint a) {
    agaa_base = ((pixel.y * AGAA_IMAGE_WIDTH + pixel.x) * AGAA_AGGREGATES + a) * AGAA_STRIDE;
}
#endif
