// The definitions of agaaInit… functions.
#pragma once

#include "core/base/structs.h"

#include <cstddef>
#include <cstdint>

namespace agaa {

// The sizes of the structs in arrays depend on the host's version, so that only the host can set them.
template <class T> void leaveToHost(T&) {}
inline void leaveToHost(AgaaFrame& frame) { frame.lightSize = frame.shadowSize = 0; }

template <class T> void initialiseStruct(T* structure, size_t structSize) {
    T initial = StructOf<T>::initial();
    initial.structSize = uint32_t(structSize);
    leaveToHost(initial);
    initialise(structure, structSize, &initial, sizeof initial);
}

} // namespace agaa

// Defines the function of a row of structs.inc.
#define AGAA_INIT_FUNCTION(Name, TYPE, bytes)                                                                          \
    void AGAA_CALL agaaInit##Name(Agaa##Name* structure, size_t structSize) {                                          \
        agaa::initialiseStruct(structure, structSize);                                                                 \
    }
