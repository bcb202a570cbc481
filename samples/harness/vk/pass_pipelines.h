// The sample engine's pipelines for the SDK's draw passes. The SDK says when they must be rebuilt
// by a key, so they are kept by it, also across views.
#pragma once

#include "render/draw_pass.h"
#include "render/host_material.h"
#include "vk/pipeline_state.h"

#include <array>
#include <map>
#include <optional>

namespace harness::vk {

// Descriptor sets of a pass's pipeline layout.
constexpr uint32_t cameraSetIndex = 0;
constexpr uint32_t agaaSetIndex = 1;
constexpr uint32_t materialSetIndex = 2;
constexpr uint32_t stripSetIndex = 3; // of passes that pull vertices

class PassPipelines {
public:
    PassPipelines(const Device& device, VkDescriptorSetLayout cameraLayout);

    // Makes what the draws need and is not there yet. Before recording: pipelines take time. stripLayout: may be null if no
    // pass pulls vertices.
    void prepare(const DrawPass<AgaaVkDrawPass>& pass, const Scene& scene, const std::vector<Draw>& draws,
                 VkDescriptorSetLayout materialLayout, VkDescriptorSetLayout stripLayout);
    // Both throw std::runtime_error where prepare() was not called for it.
    VkPipelineLayout layout(uint64_t pipelineKey) const;
    VkPipeline pipeline(uint64_t pipelineKey, const Variant& variant) const;
    void clear() { programs_.clear(); }

private:
    struct Program {
        std::string text;
        PipelineLayout layout;
        std::array<ShaderModule, 2> fragments; // opaque, masked
        ShaderModule geometry, pulling;        // where the pass has one
        const ShaderModule* vertex = nullptr;
        std::map<Variant, Pipeline> pipelines;
    };
    const Program& program(uint64_t pipelineKey) const;
    PipelineLayout makeLayout(const DrawPass<AgaaVkDrawPass>& pass, VkDescriptorSetLayout materials,
                              VkDescriptorSetLayout strips) const;
    Pipeline makePipeline(const DrawPass<AgaaVkDrawPass>& pass, const Program& program,
                          const Variant& variant) const;

    const Device* device_;
    VkDescriptorSetLayout cameraLayout_;
    std::array<ShaderModule, 3> vertices_; // by cornerOutputs()
    std::map<uint64_t, Program> programs_;
};

} // namespace harness::vk
