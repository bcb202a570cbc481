// The mean of light of a high range: each event has the weight 1 / (1 + e L), where L is its luminance and e the
// exposure, because tone mapping after a linear mean turns edges of high contrast back into steps (Karis 2013).
//
// The sum of weights needs no place of its own: with m the mean of weighted light, it is 1 - e L(m). That difference
// loses digits where all events are far brighter than white (.01 % at 100 times white, 7 % at 65504 times), so that
// still brighter ones are scaled down.
#ifndef AGAA_MATH_HDR_WEIGHT_GLSL
#define AGAA_MATH_HDR_WEIGHT_GLSL
#include "real.glsl"

// The largest luminance of an event, in units of 1 / exposure. With an exposure up to 1, the output holds no more.
#define AGAA_MAX_EXPOSED real(65536.0)

real agaa_exposedLuminance(rvec3 light, real exposure) {
    return exposure * max(dot(light, rvec3(real(0.2126), real(0.7152), real(0.0722))), real(0.0));
}

// Returns finite light times its weight.
rvec3 agaa_weightByLuminance(rvec3 light, real exposure) {
    const real exposed = agaa_exposedLuminance(light, exposure);
    const real kept = min(exposed, AGAA_MAX_EXPOSED);
    const real scale = exposed > AGAA_MAX_EXPOSED ? AGAA_MAX_EXPOSED / exposed : real(1.0);
    return light * (scale / (real(1.0) + kept));
}

// Returns the light whose weighted light is the mean: sum(w light) / sum(w).
rvec3 agaa_lightOfWeightedMean(rvec3 mean, real exposure) {
    const real least = real(1.0) / (real(1.0) + AGAA_MAX_EXPOSED);
    return mean / max(real(1.0) - agaa_exposedLuminance(mean, exposure), least);
}

#endif
