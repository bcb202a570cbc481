// The sample engine's pipelines for the SDK's draw passes, by the SDK's pipeline key. All views share them.
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
constexpr uint32_t stripSetIndex = 3;       // of passes that pull vertices
constexpr uint32_t environmentSetIndex = 3; // of other passes; only those that shade read it

class PassPipelines {
public:
    PassPipelines(const Device& device, VkDescriptorSetLayout cameraLayout);

    // Creates the missing pipelines for the draws. Must run before recording, because pipelines take time to compile.
    // lastLayout   Of the set stripSetIndex or environmentSetIndex.
    void prepare(const DrawPass<AgaaVkDrawPass>& pass, const Scene& scene, const std::vector<Draw>& draws,
                 VkDescriptorSetLayout materialLayout, VkDescriptorSetLayout lastLayout);
    // Both functions throw std::runtime_error if prepare() was not called for the pass.
    VkPipelineLayout layout(uint64_t pipelineKey) const;
    VkPipeline pipeline(uint64_t pipelineKey, const Variant& variant) const;
    void clear() { programs_.clear(); }

private:
    struct Program {
        std::string text;
        PipelineLayout layout;
        std::map<std::pair<bool, MotionOutput>, ShaderModule> fragments; // by isMasked and motion of the variant
        ShaderModule geometry, ownVertex;                                // null if the pass has none
        const ShaderModule* vertex = nullptr;
        std::map<Variant, Pipeline> pipelines;
    };
    const Program& program(uint64_t pipelineKey) const;
    PipelineLayout makeLayout(const DrawPass<AgaaVkDrawPass>& pass, VkDescriptorSetLayout materials,
                              VkDescriptorSetLayout last) const;
    Pipeline makePipeline(const DrawPass<AgaaVkDrawPass>& pass, const Program& program, const Variant& variant) const;

    const Device* device_;
    VkDescriptorSetLayout cameraLayout_;
    std::array<ShaderModule, 3> vertices_; // indexed by cornerOutputs()
    std::map<uint64_t, Program> programs_;
};

} // namespace harness::vk
