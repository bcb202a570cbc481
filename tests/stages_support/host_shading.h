// A host that shades aggregates itself: ambient light and emission over black, by the text that reads aggregates.
#pragma once

#include "agaa_sdk.h"

#include <string>

namespace agaa::test {

inline constexpr float hostAmbient[3] = {0.5f, 0.4f, 0.3f};

// Of a compute shader in groups of 8 x 8 pixels. declarations: the version, AGAA_AGGREGATE_WORD(i) and
// void show(uvec2 pixel, vec3 color).
std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations);

} // namespace agaa::test
