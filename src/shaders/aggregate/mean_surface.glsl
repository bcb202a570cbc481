// The means of an aggregate: their sums, and the surface that is shaded with them. Needs a function agaa_count(counter,
// amount).
#ifndef AGAA_MEAN_SURFACE_GLSL
#define AGAA_MEAN_SURFACE_GLSL
#include "aggregate/means.glsl"
#include "math/encoding.glsl"
#include "math/statistics.glsl"
#include "common/custom_filters.glsl"

agaa_Means agaa_noMeans() {
    agaa_Means m;
    m.diffuse = m.specular = m.emissive = m.normal = vec3(0.0);
    m.alpha2 = 0.0;
    m.lengthBound = 1e-6;
    m.moments = agaa_SecondMoments(vec3(0.0), vec3(0.0));
#ifdef AGAA_SHADES_CUSTOM
    for (int i = 0; i < AGAA_SHADES_CUSTOM; ++i)
        m.custom[i] = 0.0;
    m.classWeight = 0.0;
#endif
    return m;
}

// Adds custom attributes, as layouts store them, by their filters.
void agaa_addCustom(inout agaa_Means m, float weight, agaa_Stored v) {
#ifdef AGAA_SHADES_CUSTOM
    uint order = 0u;
    for (int i = 0; i < AGAA_SHADES_CUSTOM; ++i) {
        if (uint(i) + 1u == AGAA_CLASS_CHANNEL) {
            agaa_voteForClass(m.custom[i], m.classWeight, v.custom[i], weight);
        } else if (agaa_isUnfilteredChannel(uint(i))) {
            if (agaa_takesUnfiltered(order, uint(i), m.custom[i], v.custom[i]) && weight > 0.0)
                m.custom[i] = v.custom[i];
        } else {
            m.custom[i] += weight * v.custom[i];
        }
    }
#endif
}

void agaa_addNormal(inout agaa_Means m, float weight, vec3 normal) {
    m.normal += weight * normal;
    if (AGAA_KEEPS_MOMENTS)
        agaa_addSecondMoments(m.moments, weight, normal);
}

// Adds the attributes of an unwidened surface except the normal.
void agaa_addMaterial(inout agaa_Means m, float weight, agaa_Surface one) {
    m.diffuse += weight * one.diffuse;
    if (AGAA_HAS_SPECULAR != 0u) {
        m.specular += weight * one.specular;
        m.alpha2 += weight * one.alpha2;
    }
    if (AGAA_EMISSIVE_CHANNELS != 0u)
        m.emissive += weight * one.emissive;
}

void agaa_addToMeans(inout agaa_Means m, float weight, agaa_Surface one) {
    agaa_addMaterial(m, weight, one);
    agaa_addNormal(m, weight, one.normal);
}

// folded   The length of the normal has spread and roughness in one value, which the diffuse term cannot separate.
agaa_Surface agaa_surfaceOfMeans(agaa_Means m, bool folded, vec3 toEye) {
    agaa_Surface s;
    float meanLength;
    agaa_meanDirection(m.normal, toEye, s.normal, meanLength);
    if (!folded && meanLength <= m.lengthBound) { // the direction is a rounding error
        s.normal = toEye;
        meanLength = 0.0;
    }
    s.diffuse = m.diffuse;
    s.specular = m.specular;
    s.emissive = m.emissive;
    s.alpha2 = 1.0;
    s.alpha2Along = 0.0;
    s.axis = vec3(0.0);
    s.meanLength = agaa_varianceFloor(meanLength, m.lengthBound);
    if (folded)
        s.meanLength = 1.0;
    if (AGAA_HAS_SPECULAR == 0u)
        return s;
    if (folded) {
        s.alpha2 = agaa_alpha2FromFoldedLength(meanLength);
    } else if (AGAA_NDF >= agaa_ndfLean) {
        // Moments in memory have errors of up to 1e-6. The mean is rounded on its own, and the square of the angle by
        // which that turns it counts as spread.
        const float bound = AGAA_SPREAD_WORDS != 0u ? m.lengthBound * m.lengthBound + 1e-6 : m.lengthBound;
        agaa_spreadAlpha2(m.moments, s.normal, meanLength, m.alpha2, AGAA_NDF == agaa_ndfSggx ? 1u : 0u, bound, s.axis,
                          s.alpha2Along, s.alpha2);
    } else {
        s.alpha2 = AGAA_NDF != agaa_ndfNone ? agaa_toksvigAlpha2(m.alpha2, s.meanLength) : m.alpha2;
    }
    return s;
}

// Returns the increase of alpha.
float agaa_widening(agaa_Means means, agaa_Surface surface) {
    float widest = max(surface.alpha2, surface.alpha2Along);
    return AGAA_HAS_SPECULAR == 0u ? 0.0 : max(sqrt(widest) - sqrt(means.alpha2), 0.0);
}

void agaa_countWidening(agaa_Means means, agaa_Surface surface) {
    agaa_count(AGAA_COUNT_WIDENED, agaa_widening(means, surface) > 0.0 ? 1u : 0u);
}
#endif
