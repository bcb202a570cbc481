// What a frame must hold, sample by sample: which triangle each sample shows.
#pragma once

#include "view_settings.h"

#include "core/plan/plan.h"

#include <bit>
#include <cmath>
#include <string>
#include <vector>

namespace agaa::test {

inline constexpr uint32_t noTriangle = ~0u;

struct Truth {
    uint32_t width = 0, height = 0, samples = 0;
    std::vector<uint32_t> triangle; // (y width + x) samples + i

    uint32_t at(uint32_t x, uint32_t y, uint32_t i) const { return triangle[(size_t(y) * width + x) * samples + i]; }
};

// Renders primitive ids into a multisampled G-buffer of the same tier, by a technique that does not
// aggregate.
template <class Host>
Truth visibleTriangles(typename Host::Context& context, const ViewSettings& like,
                       const std::vector<Triangle>& triangles) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout("paper16", &layout);
    for (uint32_t i = 0; i < layout.attributeCount; ++i)
        if (layout.attributes[i].semantic == AGAA_SEMANTIC_DIFFUSE)
            layout.attributes[i].sampleBits = 8;
    ViewSettings settings = like;
    settings.config = {};
    settings.config.technique = "ssaa";
    settings.config.samples = like.config.samples;
    settings.config.visibilityTier = like.config.visibilityTier;
    settings.config.layout = &layout;
    settings.config.flags = AGAA_CONFIG_READBACK;
    settings.facts = AGAA_SCENE_FACTS_INIT;
    settings.facts.shadowMapCount = 0;
    settings.shader = ViewSettings::Shader::PrimitiveIds;
    typename Host::View view(context, settings);
    view.setTriangles(triangles);
    view.render(view.frame());

    Truth truth{settings.width, settings.height, view.plan().view.samples, {}};
    const GBufferPacking packing = packGBuffer(view.plan().view.layout);
    const Fields& fields = packing.fields;
    std::vector<std::vector<glm::uvec4>> attachments;
    for (size_t i = 0; i < packing.attachments.size(); ++i)
        attachments.push_back(view.readSurface("gbuffer-" + std::to_string(i)));
    const auto byte = [&](Channel channel, size_t sample) {
        const Field& field = fields[channel];
        const uint32_t bits = attachments[field.word][sample][int(field.shift)];
        return uint32_t(std::lround(255 * std::bit_cast<float>(bits)));
    };
    for (uint32_t y = 0; y < truth.height; ++y)
        for (uint32_t x = 0; x < truth.width; ++x)
            for (uint32_t i = 0; i < truth.samples; ++i) {
                const size_t s = view.sampleIndex(x, y, i);
                const uint32_t id =
                    byte(ChannelDiffuseR, s) | byte(ChannelDiffuseG, s) << 8 | byte(ChannelDiffuseB, s) << 16;
                truth.triangle.push_back(id - 1); // 0: none
            }
    return truth;
}

} // namespace agaa::test
