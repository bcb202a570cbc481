#include "surfaces.h"

#include <algorithm>
#include <stdexcept>

namespace agaa::test {

ResourceId findResource(const Plan& plan, const std::string& name) {
    const auto found = std::ranges::find(plan.resources, name, &Resource::name);
    if (found == plan.resources.end())
        throw std::runtime_error("The plan has no resource \"" + name + "\".");
    return ResourceId(found - plan.resources.begin());
}

size_t sampleIndex(const Plan& plan, uint32_t x, uint32_t y, uint32_t i) {
    const uint32_t group = i / plan.view.hwSamples;
    if (plan.view.layers > 1) {
        const size_t texel = (size_t(group) * plan.view.height + y) * plan.view.width + x;
        return texel * plan.view.hwSamples + i % plan.view.hwSamples;
    }
    const size_t texelX = size_t(x) * plan.view.scaleX + group % plan.view.scaleX;
    const size_t texelY = size_t(y) * plan.view.scaleY + group / plan.view.scaleX;
    return (texelY * (size_t(plan.view.width) * plan.view.scaleX) + texelX) * plan.view.hwSamples +
           i % plan.view.hwSamples;
}

std::string surfaceText(const Resource& resource) {
    const bool isUint = resource.format == Format::R8U || resource.format == Format::R16U ||
                        resource.format == Format::R32U || resource.format == Format::RG32U;
    std::string text = "layout(local_size_x = 8, local_size_y = 8) in;\n";
    text += std::string("layout(binding = 0) uniform ") + (isUint ? "u" : "") + "sampler2D" +
            (resource.samples > 1 ? "MS" : "") + " surface;\n";
    text += "layout(std430, binding = 1) writeonly buffer Out { uvec4 texels[]; };\n";
    text += "const uint samples = " + std::to_string(resource.samples) + "u;\n";
    text += "const uvec2 size = uvec2(" + std::to_string(resource.width) + "u, " + std::to_string(resource.height) +
            "u);\n";
    text += R"(void main() {
    uvec2 p = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(p, size)))
        return;
    for (uint s = 0u; s < samples; ++s)
        texels[(p.y * size.x + p.x) * samples + s] = )";
    const std::string fetch = std::string("texelFetch(surface, ivec2(p), ") + (resource.samples > 1 ? "int(s))" : "0)");
    return text + (isUint ? fetch : "floatBitsToUint(" + fetch + ")") + ";\n}\n";
}

std::vector<uint32_t> byPixels(const Resource& resource, const std::vector<uint32_t>& layers) {
    constexpr uint32_t wordsOfTexel = 4;
    const size_t pixels = size_t(resource.width) * resource.height;
    std::vector<uint32_t> words(layers.size());
    for (size_t i = 0; i < layers.size(); ++i) {
        const size_t layer = i / (pixels * wordsOfTexel), pixel = i / wordsOfTexel % pixels;
        words[(pixel * resource.layers + layer) * wordsOfTexel + i % wordsOfTexel] = layers[i];
    }
    return words;
}

} // namespace agaa::test
