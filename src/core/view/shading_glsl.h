// GLSL for shading functions of the host: the macros of src/shaders/common/host_code.glsl and lighting.glsl.
#pragma once

#include "core/base/error.h"
#include "core/view/view_settings.h"

#include <string>

namespace agaa {

// Returns empty text if the view has no AgaaShadingFunction.
inline std::string shadingFunctionGlsl(const ViewSettings& view) {
    if (!view.shadingFunction)
        return {};
    std::string out = std::string("#define AGAA_HOST_SHADING 1\n#define AGAA_HOST_SHADES_EVENTS ") +
                      (view.hostShadesEvents ? "1\n" : "0\n");
    if (const uint32_t channels = view.layout.customChannels())
        out += format("#define AGAA_SHADES_CUSTOM %u\n", channels);
    return out;
}

} // namespace agaa
