// A G-buffer of the host's own on Vulkan: a buffer.
#include "host_gbuffer_cases.h"
#include "show.h"

#include "shader_math.h"

#include <bit>

namespace agaa::test {
namespace {

// A buffer of four vectors a sample; the first one's w is negative where nothing shows.
std::string functionText(const Plan& plan) {
    return R"(
struct HostSample { vec4 diffuseDepth, specularAlpha2, emissive, normal; };
layout(std430, )" +
           std::string(FunctionBuffer::place) + R"() readonly buffer Samples { HostSample samples[]; } host;
bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) {
    HostSample h = host.samples[(pixel.y * )" +
           std::to_string(plan.view.width) + "u + pixel.x) * " + std::to_string(plan.view.samples) + R"(u + i];
    depth = h.diffuseDepth.w;
    m.diffuse = h.diffuseDepth.xyz;
    m.specular = h.specularAlpha2.xyz;
    m.emissive = h.emissive.xyz;
    m.normal = h.normal.xyz;
    m.alpha2 = h.specularAlpha2.w;
    return h.diffuseDepth.w >= 0.0;
}
)";
}

// What a view drew, decoded.
std::vector<glm::vec4> decodedSamples(const StageView& drawn) {
    const Plan& plan = drawn.plan();
    const GBufferPacking packing = packGBuffer(plan.view.layout);
    const auto depth = drawn.readSurface("depth");
    std::vector<std::vector<glm::uvec4>> attachments;
    for (size_t i = 0; i < packing.attachments.size(); ++i)
        attachments.push_back(drawn.readSurface("gbuffer-" + std::to_string(i)));
    std::vector<glm::vec4> out;
    for (uint32_t y = 0; y < plan.view.height; ++y)
        for (uint32_t x = 0; x < plan.view.width; ++x)
            for (uint32_t i = 0; i < plan.view.samples; ++i) {
                const size_t at = drawn.sampleIndex(x, y, i);
                const auto value = [&](size_t channel, float absent) {
                    const Field& f = packing.fields[channel];
                    return f.bits ? std::bit_cast<float>(attachments[f.word][at][int(f.shift)]) : absent;
                };
                const bool isCovered = value(ChannelNormalX, 0) != 0;
                const float range = plan.view.layout.emissiveRange();
                const glm::dvec3 n =
                    math_d::agaa_decodeOct({double(value(ChannelNormalX, 0)), double(value(ChannelNormalY, 0))},
                                           packing.fields[ChannelNormalX].bits);
                const glm::vec3 diffuse(value(ChannelDiffuseR, 0), value(ChannelDiffuseG, 0),
                                        value(ChannelDiffuseB, 0));
                glm::vec3 emissive(value(ChannelEmissiveR, 0), value(ChannelEmissiveG, 0), value(ChannelEmissiveB, 0));
                if (plan.view.layout[AGAA_SEMANTIC_EMISSIVE].channels == 1)
                    emissive = emissive.x * diffuse;
                out.emplace_back(diffuse, isCovered ? std::bit_cast<float>(depth[at].x) : -1.0f);
                out.emplace_back(value(ChannelSpecularR, 0), value(ChannelSpecularG, 0), value(ChannelSpecularB, 0),
                                 value(ChannelRoughness, 1));
                out.emplace_back(range * emissive, 0);
                out.emplace_back(glm::vec3(n), 0);
            }
    return out;
}

class BufferSamples {
public:
    explicit BufferSamples(const StageView& drawn) : data_(decodedSamples(drawn)), text_(functionText(drawn.plan())) {}
    std::string text() const { return text_; }
    uint64_t layout() const { return data_.layout(); }
    void bind(AgaaVkFrame& frame) const { data_.bind(frame); }

private:
    FunctionBuffer data_;
    std::string text_;
};

struct GBufferHost : VulkanHost {
    using Samples = BufferSamples;
    static constexpr uint32_t shadowMaps = 0;
    static constexpr GBufferRow rows[] = {
        {"single", 1}, {"fxaa", 1}, {"smaa", 1}, {"ssaa", 4},  {"visibility", 4}, {"sbaa", 8},    {"simple_complex", 4},
        {"agaa", 1},   {"agaa", 4}, {"agaa", 8}, {"agaa", 32}, {"adaptive", 4},   {"adaptive", 8}};
};
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HostGBufferCases, GBufferHost);

} // namespace
} // namespace agaa::test
