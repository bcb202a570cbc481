/* SPDX-License-Identifier: MIT */
#include "mesh_renderer.h"

#include "glsl.h"

#include <QtGui/QVector4D>
#include <QtQuick3DRuntimeRender/private/qssgrenderimage_p.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace agaaQt {

namespace {

constexpr uint32_t maxTextures = 8; // of all materials

/* Finds the attributes that the vertex shader reads. It returns false if the mesh lacks one. */
bool findAttributes(const QSSGRhiInputAssemblerState& mesh, std::array<uint32_t, 4>& vertices) {
    using State = QSSGRhiInputAssemblerState;
    constexpr State::InputSemantic semantics[] = {State::PositionSemantic, State::NormalSemantic,
                                                  State::TexCoord0Semantic};
    vertices[0] = mesh.inputLayout.cbeginBindings()->stride();
    for (size_t i = 0; i < std::size(semantics); ++i) {
        const auto found = std::find(mesh.inputs.begin(), mesh.inputs.end(), semantics[i]);
        if (found == mesh.inputs.end())
            return false;
        vertices[i + 1] = mesh.inputLayout.cbeginAttributes()[found - mesh.inputs.begin()].offset();
    }
    return mesh.topology == QRhiGraphicsPipeline::Triangles;
}

VkBuffer nativeBuffer(const QSSGRhiBuffer& buffer) {
    return *static_cast<const VkBuffer*>(buffer.buffer()->nativeBuffer().objects[0]);
}

VkSampler createSampler(VkDevice device, const QSSGRenderCustomMaterial::TextureProperty& property) {
    using Op = QSSGRenderTextureFilterOp;
    const auto filter = [](Op op) { return op == Op::Nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; };
    constexpr VkSamplerAddressMode modes[] = {
        VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT, VK_SAMPLER_ADDRESS_MODE_REPEAT}; // as QSSGRenderTextureCoordOp
    VkSamplerCreateInfo info = {VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.minFilter = filter(property.minFilterType), info.magFilter = filter(property.magFilterType);
    info.mipmapMode = VkSamplerMipmapMode(filter(property.mipFilterType)); // both enumerations have the same values
    info.maxLod = property.mipFilterType == Op::None ? 0.25f : VK_LOD_CLAMP_NONE; // 0.25: level 0 of all sizes
    info.addressModeU = modes[int(property.horizontalClampType)];
    info.addressModeV = modes[int(property.verticalClampType)];
    VkSampler sampler;
    require(vkCreateSampler(device, &info, nullptr, &sampler), "vkCreateSampler");
    return sampler;
}

bool areSampledAlike(const QSSGRenderCustomMaterial::TextureProperty& a,
                     const QSSGRenderCustomMaterial::TextureProperty& b) {
    return a.minFilterType == b.minFilterType && a.magFilterType == b.magFilterType &&
           a.mipFilterType == b.mipFilterType && a.horizontalClampType == b.horizontalClampType &&
           a.verticalClampType == b.verticalClampType;
}

} // namespace

void require(int64_t result, const char* call) {
    if (result < 0)
        throw std::runtime_error(std::string(call) + " failed.");
}

MeshRenderer::MeshRenderer(VkDevice device, QSSGBufferManager& buffers, const std::string& vertexShader,
                           std::string surfaceText)
    : m_device(device), m_buffers(buffers), m_surfaceText(std::move(surfaceText)) {
    m_vertexShader = compile(m_device, VK_SHADER_STAGE_VERTEX_BIT, vertexShader);
    const VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, maxTextures,
                                                  VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo setInfo = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.bindingCount = 1, setInfo.pBindings = &binding;
    require(vkCreateDescriptorSetLayout(m_device, &setInfo, nullptr, &m_setLayout), "vkCreateDescriptorSetLayout");
    const VkDescriptorPoolSize size = {binding.descriptorType, maxTextures};
    VkDescriptorPoolCreateInfo pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool.maxSets = 1, pool.poolSizeCount = 1, pool.pPoolSizes = &size;
    require(vkCreateDescriptorPool(m_device, &pool, nullptr, &m_pool), "vkCreateDescriptorPool");
    VkDescriptorSetAllocateInfo allocation = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocation.descriptorPool = m_pool, allocation.descriptorSetCount = 1, allocation.pSetLayouts = &m_setLayout;
    require(vkAllocateDescriptorSets(m_device, &allocation, &m_set), "vkAllocateDescriptorSets");
}

MeshRenderer::~MeshRenderer() {
    setPasses({});
    vkDestroyDescriptorPool(m_device, m_pool, nullptr);
    vkDestroyDescriptorSetLayout(m_device, m_setLayout, nullptr);
    vkDestroyShaderModule(m_device, m_vertexShader, nullptr);
}

void MeshRenderer::setPasses(const std::vector<AgaaDrawPass>& passes) {
    for (const auto& [key, pipeline] : m_pipelines)
        vkDestroyPipeline(m_device, pipeline, nullptr);
    m_pipelines.clear();
    for (const VkPipelineLayout layout : m_layouts)
        vkDestroyPipelineLayout(m_device, layout, nullptr);
    m_layouts.clear();
    for (const Texture& texture : m_textures) {
        vkDestroyImageView(m_device, texture.view, nullptr);
        vkDestroySampler(m_device, texture.sampler, nullptr);
    }
    m_textures.clear();
    if (passes.size() > std::size(Draw{}.pipelines))
        throw std::runtime_error("The view has more draw passes than the host expects.");
    m_passes = passes;
    for (const AgaaDrawPass& pass : passes) {
        const VkDescriptorSetLayout sets[] = {
            VkDescriptorSetLayout(static_cast<const AgaaVkDrawPass*>(pass.pNext)->descriptorSetLayout), m_setLayout};
        const VkPushConstantRange push = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(Constants)};
        VkPipelineLayoutCreateInfo layout = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        layout.setLayoutCount = 2, layout.pSetLayouts = sets;
        layout.pushConstantRangeCount = 1, layout.pPushConstantRanges = &push;
        m_layouts.emplace_back();
        require(vkCreatePipelineLayout(m_device, &layout, nullptr, &m_layouts.back()), "vkCreatePipelineLayout");
    }
}

void MeshRenderer::add(const QSSGRenderSubset& mesh, const QSSGRenderCustomMaterial& material,
                       const Constants& constants) {
    Draw draw = {constants, &mesh, {}, {}};
    std::string text;
    if (!findAttributes(mesh.rhi.ia, draw.vertices) || !describeMaterial(material, text))
        return;
    for (size_t pass = 0; pass < m_passes.size(); ++pass) {
        VkPipeline& pipeline = m_pipelines[{pass, &material, draw.vertices, text}];
        if (!pipeline)
            pipeline = createPipeline(pass, draw, material, text + m_surfaceText);
        draw.pipelines[pass] = pipeline;
    }
    m_draws.push_back(draw);
}

/* Writes GLSL with the properties and textures of a material. It returns false if Qt has not loaded a texture yet: then
 * the frame lacks the mesh. */
bool MeshRenderer::describeMaterial(const QSSGRenderCustomMaterial& material, std::string& text) {
    for (const auto& property : material.m_properties) {
        const bool isVector = property.value.metaType() == QMetaType::fromType<QVector4D>();
        const QVector4D v = isVector ? property.value.value<QVector4D>() : QVector4D(property.value.toFloat(), 0, 0, 0);
        char line[200];
        std::snprintf(line, sizeof line,
                      isVector ? "const vec4 %s = vec4(%.9g, %.9g, %.9g, %.9g);\n" : "const float %s = float(%.9g);\n",
                      property.name.constData(), v[0], v[1], v[2], v[3]);
        const bool isMasked = property.name == "cutoff" && v[0] > 0.0f;
        text = (isMasked ? "#define AGAA_ALPHA_MASKED 1\n" : "") + text + line;
    }
    for (const auto& property : material.m_textureProperties) {
        QRhiTexture* texture = property.texImage ? m_buffers.getCustomTextureMap()
                                                       .value(property.texImage->m_rawTextureData)
                                                       .renderImageTexture.m_texture
                                                 : nullptr;
        if (!texture || texture->nativeTexture().layout != VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL)
            return false;
        if (texture->format() != QRhiTexture::RGBA8)
            throw std::runtime_error("A texture of a material is not RGBA8.");
        const size_t index = textureIndex(VkImage(texture->nativeTexture().object), property);
        text += "#define " + property.name.toStdString() + " textures[" + std::to_string(index) + "]\n";
    }
    text += "layout(set = 1, binding = 0) uniform sampler2D textures[" + std::to_string(maxTextures) + "];\n";
    return true;
}

/* Returns the index of a texture in the descriptor set, in which no element may stay empty. No frame is unfinished. */
size_t MeshRenderer::textureIndex(VkImage image, const QSSGRenderCustomMaterial::TextureProperty& property) {
    for (size_t i = 0; i < m_textures.size(); ++i)
        if (m_textures[i].image == image && areSampledAlike(m_textures[i].property, property))
            return i;
    if (m_textures.size() == maxTextures)
        throw std::runtime_error("The scene has too many textures.");
    VkImageViewCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image, info.viewType = VK_IMAGE_VIEW_TYPE_2D, info.format = VK_FORMAT_R8G8B8A8_UNORM;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, 1};
    Texture texture = {image, VK_NULL_HANDLE, createSampler(m_device, property), property};
    require(vkCreateImageView(m_device, &info, nullptr, &texture.view), "vkCreateImageView");
    const auto first = uint32_t(m_textures.size());
    const std::vector<VkDescriptorImageInfo> images(
        maxTextures - first, {texture.sampler, texture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = m_set, write.dstArrayElement = first, write.descriptorCount = maxTextures - first;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, write.pImageInfo = images.data();
    vkUpdateDescriptorSets(m_device, 1, &write, 0, nullptr);
    m_textures.push_back(texture);
    return first;
}

void MeshRenderer::draw(const AgaaDrawTarget& target) const {
    const auto commands = static_cast<VkCommandBuffer>(target.commandBuffer);
    const size_t pass = target.pipelineKey == m_passes[0].pipelineKey ? 0 : 1;
    const VkDescriptorSet sets[] = {VkDescriptorSet(target.descriptorSet), m_set};
    const VkViewport viewport = {0.0f, 0.0f, float(target.width), float(target.height), 0.0f, 1.0f};
    const VkRect2D scissor = {{0, 0}, {target.width, target.height}};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, m_layouts[pass], 0, 2, sets, 0, nullptr);
    for (const Draw& draw : m_draws) {
        const QSSGRenderSubset& mesh = *draw.mesh;
        const VkBuffer vertices = nativeBuffer(*mesh.rhi.vertexBuffer);
        const VkDeviceSize offset = 0;
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.pipelines[pass]);
        vkCmdPushConstants(commands, m_layouts[pass], VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof draw.constants,
                           &draw.constants);
        vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
        if (const QSSGRhiBuffer* indices = mesh.rhi.indexBuffer.data()) {
            const bool isShort = indices->indexFormat() == QRhiCommandBuffer::IndexUInt16;
            vkCmdBindIndexBuffer(commands, nativeBuffer(*indices), 0,
                                 isShort ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
            vkCmdDrawIndexed(commands, mesh.count, 1, mesh.offset, 0, 0);
        } else {
            vkCmdDraw(commands, mesh.count, 1, mesh.offset, 0);
        }
    }
}

} // namespace agaaQt
