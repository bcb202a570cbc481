/* Draws meshes of Qt Quick 3D in the SDK's draw passes, with pipelines of its own: Qt 6.4 has no hook for passes.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <vulkan/vulkan.h> // before Qt's headers, which hide Vulkan's functions

#include "agaa_vk.h"

#include <QtQuick3DRuntimeRender/private/qssgrenderbuffermanager_p.h>
#include <QtQuick3DRuntimeRender/private/qssgrendercustommaterial_p.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace agaaQt {

/* Results below 0 are errors, in the SDK and in Vulkan. It throws a std::runtime_error that names the call. */
void require(int64_t result, const char* call);

/* Materials    Properties of a CustomMaterial are constants of the surface text, and its textures are samplers. A
 *              property `cutoff` above 0 makes a cut-out. Textures come from a TextureData in RGBA8; they must not be
 *              replaced while there are passes. All materials with one texture filter it alike.
 * Meshes       Triangles with positions, normals and texture coordinates. Others are not drawn. */
class MeshRenderer {
public:
    struct Constants { // push constants: 112 bytes, of the 128 that Vulkan guarantees
        float clipFromShading[16];
        float shadingFromModel[12]; // rows
    };

    /* The vertex shader has Constants. The surface text is GLSL that fills an AgaaSurfaceInput. */
    MeshRenderer(VkDevice device, QSSGBufferManager& buffers, const std::string& vertexShader, std::string surfaceText);
    ~MeshRenderer();
    MeshRenderer(const MeshRenderer&) = delete;

    void setPasses(const std::vector<AgaaDrawPass>& passes); // with an AgaaVkDrawPass each
    void clear() { m_draws.clear(); }
    /* Adds a mesh and compiles its pipelines, before the SDK records: its callbacks only draw. A mesh whose textures Qt
     * has not loaded yet is left out. */
    void add(const QSSGRenderSubset& mesh, const QSSGRenderCustomMaterial& material, const Constants& constants);
    void draw(const AgaaDrawTarget& target) const;

private:
    struct Draw {
        Constants constants;
        const QSSGRenderSubset* mesh;
        std::array<uint32_t, 4> vertices; // stride, and offsets of position, normal and texture coordinates
        VkPipeline pipelines[2];          // of the draw passes
    };
    struct Texture {
        VkImage image;
        VkImageView view;
        VkSampler sampler;
        QSSGRenderCustomMaterial::TextureProperty property; // by which the image is sampled
    };
    bool describeMaterial(const QSSGRenderCustomMaterial& material, std::string& text);
    size_t textureIndex(VkImage image, const QSSGRenderCustomMaterial::TextureProperty& property);
    VkPipeline createPipeline(size_t pass, const Draw& draw, const QSSGRenderCustomMaterial& material,
                              const std::string& text) const;

    VkDevice m_device;
    QSSGBufferManager& m_buffers;
    VkShaderModule m_vertexShader;
    std::string m_surfaceText;
    VkDescriptorSetLayout m_setLayout; // of all textures, after the SDK's set
    VkDescriptorPool m_pool;
    VkDescriptorSet m_set;
    std::vector<AgaaDrawPass> m_passes;
    std::vector<VkPipelineLayout> m_layouts; // of the draw passes, each of which has another layout of the SDK's set
    std::vector<Texture> m_textures;
    std::map<std::tuple<size_t, const QSSGRenderCustomMaterial*, std::array<uint32_t, 4>, std::string>, VkPipeline>
        m_pipelines;
    std::vector<Draw> m_draws;
};

} // namespace agaaQt
