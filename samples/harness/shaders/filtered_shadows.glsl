// Shadows from maps that are filtered in advance (exponential variance maps, Lauritzen and McCool 2008), looked up once
// for the footprint of a shading event (AGAA 3.5.3). The text before it defines FILTERED_SHADOWS_AT,
// FILTERED_LIGHT_AT and FILTERED_EXPONENT.
layout(FILTERED_SHADOWS_AT) uniform sampler2DArray filteredMoments; // of exp(exponent * depth)

struct FilteredShadow {
    uvec4 layers; // first layer, number of layers
    vec4 bias;    // x: of depth
    mat4 toClip[6];
};
layout(std140, FILTERED_LIGHT_AT) uniform FilteredShadows { FilteredShadow filteredShadows[4]; };

// Returns the second moment of the footprint along a gradient.
float filteredVariance(AgaaFootprint f, vec3 g) {
    return max(dot(f.positionSquares, g * g) + 2.0 * dot(f.positionProducts, g.yzx * g.zxy), 0.0);
}

// Returns the share of occluders behind the receiver, at most (Chebyshev's inequality). The share below 0.3 is mostly
// light that bleeds through occluders.
// spread   Variance of the receiver's depth, exponentiated.
float filteredLight(vec2 moments, float receiver, float spread) {
    float apart = receiver - moments.x;
    float variance = max(moments.y - moments.x * moments.x, 1e-6 * moments.x * moments.x) + spread;
    float lit = apart > 0.0 ? variance / (variance + apart * apart) : 1.0;
    return clamp((lit - 0.3) / 0.7, 0.0, 1.0);
}

float agaaHostShadowFootprint(uint shadow, AgaaFootprint footprint) {
    uvec4 layers = filteredShadows[shadow].layers;
    for (uint i = 0u; i < layers.y; ++i) {
        mat4 toClip = filteredShadows[shadow].toClip[i];
        vec4 clip = toClip * vec4(footprint.position, 1.0);
        if (!(clip.w > 0.0) || any(greaterThan(abs(clip.xy), vec2(clip.w))) || clip.z < 0.0 || clip.z > clip.w)
            continue;
        vec3 at = clip.xyz / clip.w;
        // Gradients of the map's coordinates. A box has 12 times the variance as its squared width.
        mat4 rows = transpose(toClip);
        vec3 alongX = (rows[0].xyz - at.x * rows[3].xyz) / clip.w, alongY = (rows[1].xyz - at.y * rows[3].xyz) / clip.w;
        vec3 alongZ = (rows[2].xyz - at.z * rows[3].xyz) / clip.w;
        float variance = max(filteredVariance(footprint, alongX), filteredVariance(footprint, alongY));
        float texels = sqrt(12.0 * variance) * 0.5 * float(textureSize(filteredMoments, 0).x);
        vec2 moments = textureLod(filteredMoments, vec3(at.xy * 0.5 + 0.5, float(layers.x + i)),
                                  log2(max(texels, 1.0))).xy;
        float receiver = exp(FILTERED_EXPONENT * (at.z - filteredShadows[shadow].bias.x));
        float steepness = FILTERED_EXPONENT * receiver;
        return filteredLight(moments, receiver, steepness * steepness * filteredVariance(footprint, alongZ));
    }
    return 1.0;
}
