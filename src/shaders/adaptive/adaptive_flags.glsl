#ifndef AGAA_ADAPTIVE_FLAGS_GLSL
#define AGAA_ADAPTIVE_FLAGS_GLSL
// Flags of AgaaAdaptiveSampling.
bool agaa_isAdaptive(uint flag) { return (AGAA_ADAPTIVE_FLAGS & flag) != 0u; }

const uint agaa_byGeometry = 0x01u, agaa_byShading = 0x02u, agaa_printedMetric = 0x04u, agaa_inOrder = 0x08u;
const uint agaa_equalWeights = 0x10u, agaa_shadeInLoops = 0x20u, agaa_bucketed = 0x80u, agaa_sorted = 0x100u;
const uint agaa_tileMaximum = 0x200u, agaa_sampleFootprints = 0x400u;
#endif
