// Custom attributes of layouts. core/view/custom_glsl.h writes these macros for a layout that has some.
#ifndef AGAA_CUSTOM_MEMBERS
#define AGAA_CUSTOM_MEMBERS                  // members of AgaaSurfaceInput, AgaaMaterial and AgaaAggregate
#define AGAA_CLEAR_CUSTOM(s)                 // sets defaults
#define AGAA_SANITISE_CUSTOM(s, bad)         // clamps to their range; sets bad if a value is not finite
#define AGAA_STORE_CUSTOM(s, stored)         // copies members of s to agaa_Stored::custom
#define AGAA_LOAD_CUSTOM(stored, s)          // copies them back
#endif
