// A scene on the device: one vertex and one index buffer, textures, and a descriptor set per material.
#pragma once

#include "render/host_material.h"
#include "vk/upload.h"

#include <array>
#include <map>

namespace harness::vk {

// Filters are anisotropic unless a texture sets its own.
Sampler makeSampler(const Device& device, const Sampling& sampling);

class GpuScene {
public:
    GpuScene(const Device& device, const Scene& scene);

    VkDescriptorSetLayout materialLayout() const { return layout_.get(); }
    // Meshes without a valid material use the default material.
    VkDescriptorSet materialSet(uint32_t material) const;
    void bindGeometry(VkCommandBuffer commands) const;
    const BufferResource& indices() const { return indices_; } // with texel buffer usage
    const BufferResource& vertices() const { return vertices_; }

private:
    void uploadGeometry(Uploader& uploader, const Scene& scene);
    void uploadTextures(Uploader& uploader, const Scene& scene);
    void createMaterials(Uploader& uploader, const Scene& scene);
    VkSampler sampler(const Sampling& sampling);

    const Device* device_;
    Arena arena_;
    BufferResource vertices_;
    BufferResource indices_;
    BufferResource materialConstants_;
    std::vector<ImageResource> textures_; // Scene::textures, then a white texture
    std::vector<Sampling> samplings_;     // of textures_
    std::map<Sampling, Sampler> samplers_;
    DescriptorSetLayout layout_;
    DescriptorPool pool_;
    std::vector<VkDescriptorSet> materialSets_; // Scene::materials, then the default material
};

// The vertex layout of all pipelines. A mask of locations excludes attributes that a shader does not read, because
// validation warns of them.
struct VertexInput {
    explicit VertexInput(uint32_t locations);
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    VkVertexInputBindingDescription binding{};
    std::vector<VkVertexInputAttributeDescription> attributes;
    VkPipelineVertexInputStateCreateInfo state{};
};

} // namespace harness::vk
