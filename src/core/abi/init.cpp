#include "core/abi/init.h"

using namespace agaa;

extern "C" {

#define AGAA_STRUCT AGAA_INIT_FUNCTION
#include "core/base/structs.inc"

void AGAA_CALL agaaInitLayoutAttribute(AgaaLayoutAttribute* attribute) {
    const AgaaLayoutAttribute initial = AGAA_LAYOUT_ATTRIBUTE_INIT;
    initialise(attribute, sizeof initial, &initial, sizeof initial);
}

void AGAA_CALL agaaInitLight(AgaaLight* light, size_t structSize) {
    const AgaaLight initial = AGAA_LIGHT_INIT;
    initialise(light, structSize, &initial, sizeof initial);
}

void AGAA_CALL agaaInitShadow(AgaaShadow* shadow, size_t structSize) {
    const AgaaShadow initial = AGAA_SHADOW_INIT;
    initialise(shadow, structSize, &initial, sizeof initial);
}

} // extern "C"
