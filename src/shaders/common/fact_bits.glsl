// Bits of AgaaSceneFacts::flags.
#ifndef AGAA_FACT_BITS_GLSL
#define AGAA_FACT_BITS_GLSL
const uint agaa_factSpecular = 0x01u, agaa_factEmissive = 0x02u, agaa_factAlphaMasked = 0x04u, agaa_factAmbient = 0x08u;
const uint agaa_factOneRoughness = 0x100u, agaa_factGreySpecular = 0x200u, agaa_factOneSpecular = 0x400u;
const uint agaa_factNoDiffuse = 0x800u, agaa_factNoLocalLights = 0x1000u;
const uint agaa_factNoTranslucency = 0x2000u, agaa_factNoCutouts = 0x4000u;
const uint agaa_factPlaneNormals = 0x8000u;
#endif
