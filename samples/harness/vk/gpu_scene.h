// A scene on the device: one vertex and one index buffer, its textures, and a descriptor set a
// material.
#pragma once

#include "render/host_material.h"
#include "vk/upload.h"

#include <array>
#include <map>

namespace harness::vk {

class GpuScene {
public:
    GpuScene(const Device& device, const Scene& scene);

    VkDescriptorSetLayout materialLayout() const { return layout_.get(); }
    // Meshes without a valid material get the default one.
    VkDescriptorSet materialSet(uint32_t material) const;
    void bindGeometry(VkCommandBuffer commands) const;
    const BufferResource& indices() const { return indices_; } // texels too
    const BufferResource& vertices() const { return vertices_; }

private:
    void uploadGeometry(Uploader& uploader, const Scene& scene);
    void uploadTextures(Uploader& uploader, const Scene& scene);
    void createMaterials(Uploader& uploader, const Scene& scene);
    VkSampler sampler(Wrap u, Wrap v);

    const Device* device_;
    Arena arena_;
    BufferResource vertices_;
    BufferResource indices_;
    BufferResource materialConstants_;
    std::vector<ImageResource> textures_; // as Scene::textures, then a white one
    std::vector<std::pair<Wrap, Wrap>> textureWraps_;
    std::map<std::pair<Wrap, Wrap>, Sampler> samplers_;
    DescriptorSetLayout layout_;
    DescriptorPool pool_;
    std::vector<VkDescriptorSet> materialSets_; // as Scene::materials, then the default one
};

// The vertex layout of all pipelines. Attributes that a shader does not read are left out by a mask
// of locations: validation warns of them.
struct VertexInput {
    explicit VertexInput(uint32_t locations);
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    VkVertexInputBindingDescription binding{};
    std::vector<VkVertexInputAttributeDescription> attributes;
    VkPipelineVertexInputStateCreateInfo state{};
};

} // namespace harness::vk
