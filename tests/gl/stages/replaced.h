// Contexts some of whose functions are a test's.
#pragma once

#include "stage_host.h"

#include <string>

namespace agaa::test {

using Replaced = std::map<std::string, AgaaGlFunction>; // by name

inline AgaaGlFunction AGAA_CALL replacedProcAddr(void* user, const char* name) {
    const auto& replaced = *static_cast<const Replaced*>(user);
    const auto found = replaced.find(name);
    return found == replaced.end() ? EglContext::getProcAddr(nullptr, name) : found->second;
}

template <class Function> void replace(Replaced& replaced, const char* name, Function* function) {
    replaced[name] = reinterpret_cast<AgaaGlFunction>(function);
}

inline OpenGLContextDesc contextDesc(Replaced& replaced) {
    OpenGLContextDesc desc = contextDesc();
    desc.device.getProcAddr = replacedProcAddr;
    desc.device.getProcUser = &replaced;
    return desc;
}

} // namespace agaa::test
