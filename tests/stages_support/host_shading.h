// A host that shades aggregates itself: ambient light and emission over black, by the text that reads aggregates.
#pragma once

#include "view_settings.h"

#include <functional>
#include <span>
#include <string>

namespace agaa::test {

// Settings of views that leave aggregates in memory: by drawnTier, and from a G-buffer.
void forHostShading(uint32_t drawnTier, const std::function<void(const ViewSettings&)>& check);
std::vector<Triangle> hostShadingScene();
// No lights but what the shader below knows.
void lightForHost(AgaaFrame& frame);

// Of a compute shader in groups of 8 x 8 pixels. declarations: the version, AGAA_AGGREGATE_WORD(i) and
// void show(uvec2 pixel, vec3 color).
std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations);

// sdk: the image of the SDK's own shading, of this many channels; host: the shader's, RGBA.
void expectShadedAlike(const std::vector<float>& sdk, size_t channels, std::span<const float> host);

} // namespace agaa::test
