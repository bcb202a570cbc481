// Attributes of the host's own. core/view/custom_glsl.h writes these macros where a layout has such attributes.
#ifndef AGAA_CUSTOM_MEMBERS
#define AGAA_CUSTOM_MEMBERS                  // of AgaaSurfaceInput, AgaaMaterial and AgaaAggregate
#define AGAA_CLEAR_CUSTOM(s)                 // defaults
#define AGAA_SANITISE_CUSTOM(s, bad)         // into range; sets bad where a value is not finite
#define AGAA_STORE_CUSTOM(s, stored)         // members of s to agaa_Stored::custom
#define AGAA_LOAD_CUSTOM(stored, s)          // and back
#endif
