/* SPDX-License-Identifier: MIT */
#include "adapter.h"

#include <QtGui/private/qrhivulkan_p.h>
#include <QtQuick/QQuickWindow>
#include <QtQuick3D/private/qquick3dcamera_p.h>
#include <QtQuick3D/private/qquick3dobject_p.h>
#include <QtQuick3DRuntimeRender/private/qssgrendercamera_p.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace agaaQt {

namespace {

const QRhiVulkanNativeHandles& nativeHandles(QRhi& rhi) {
    return *static_cast<const QRhiVulkanNativeHandles*>(rhi.nativeHandles());
}

void copyVector(const QVector3D& from, float* to) {
    for (int i = 0; i < 3; ++i)
        to[i] = from[i];
}

} // namespace

/* ---- context and views ---------------------------------------------------------------------------- */

Adapter::Adapter(QQuickWindow& window, QQuick3DViewport& view3D, const VkPhysicalDeviceFeatures2& enabledFeatures,
                 const std::string& vertexShader, const std::string& surfaceText)
    : m_window(window), m_view3D(view3D),
      m_rhi(static_cast<QRhi*>(window.rendererInterface()->getResource(&window, QSGRendererInterface::RhiResource))),
      m_buffers(*QSSGRenderContextInterface::renderContextForWindow(window)->bufferManager()),
      m_meshes(nativeHandles(*m_rhi).dev, m_buffers, vertexShader, surfaceText) {
    const QRhiVulkanNativeHandles& native = nativeHandles(*m_rhi);
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onLog, log.user = this;
    AgaaVkDeviceDesc device = AGAA_VK_DEVICE_DESC_INIT;
    device.instance = window.vulkanInstance()->vkInstance();
    device.physicalDevice = native.physDev, device.device = native.dev;
    device.queueFamily = uint32_t(native.gfxQueueFamilyIdx), device.apiVersion = VK_API_VERSION_1_2;
    device.getProcAddr = reinterpret_cast<AgaaVkGetInstanceProcAddr>(vkGetInstanceProcAddr);
    device.enabledFeatures = &enabledFeatures, device.descriptorSet = 0;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    desc.pNext = &device, desc.log = &log;
    desc.framesInFlight = 1; // QQuickRenderControl::endFrame waits for the frame
    check(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &m_context), "agaaVkCreateContext");
}

Adapter::~Adapter() {
    destroyView();
    agaaDestroyContext(m_context);
}

void Adapter::onLog(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity >= AGAA_SEVERITY_WARNING)
        std::fprintf(stderr, "AGAA: %s\n", message);
    if (severity >= AGAA_SEVERITY_ERROR)
        static_cast<Adapter*>(user)->m_message = message;
}

void Adapter::check(AgaaResult result, const char* call) const {
    if (result < 0 && !m_message.empty())
        throw std::runtime_error(m_message);
    require(result, call);
}

void Adapter::createView(const AgaaConfig& config, const AgaaSceneFacts& facts, uint32_t width, uint32_t height) {
    destroyView();
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = width, desc.height = height;
    desc.config = &config, desc.facts = &facts;
    check(agaaVkCreateView(m_context, &desc, &m_view), "agaaVkCreateView");
    uint32_t count = 0;
    check(agaaGetDrawPasses(m_view, &count, nullptr), "agaaGetDrawPasses");
    m_vkPasses.assign(count, AGAA_VK_DRAW_PASS_INIT);
    m_passes.assign(count, AGAA_DRAW_PASS_INIT);
    for (uint32_t i = 0; i < count; ++i)
        m_passes[i].pNext = &m_vkPasses[i];
    check(agaaGetDrawPasses(m_view, &count, m_passes.data()), "agaaGetDrawPasses");
    m_meshes.setPasses(m_passes);
}

void Adapter::destroyView() {
    m_meshes.setPasses({});
    agaaDestroyView(m_view);
    m_view = nullptr;
    m_passes.clear();
    m_frameIndex = 0;
}

/* ---- the scene ------------------------------------------------------------------------------------ */

/* Qt may calculate the transforms of this frame later: some nodes are still marked as dirty. */
void Adapter::collect(QSSGRenderNode& node, AgaaFrame& frame) {
    node.calculateGlobalVariables();
    if (!node.getGlobalState(QSSGRenderNode::GlobalState::Active))
        return;
    if (node.type == QSSGRenderGraphObject::Type::Model)
        addModel(static_cast<const QSSGRenderModel&>(node));
    else if (QSSGRenderGraphObject::isLight(node.type))
        addLight(static_cast<const QSSGRenderLight&>(node), frame);
    for (QSSGRenderNode& child : node.children)
        collect(child, frame);
}

void Adapter::addLight(const QSSGRenderLight& light, AgaaFrame& frame) {
    AgaaLight each = AGAA_LIGHT_INIT;
    if (light.type == QSSGRenderGraphObject::Type::SpotLight)
        throw std::runtime_error("Spot lights are not supported: Qt's cones have another falloff.");
    const bool isPoint = light.type == QSSGRenderGraphObject::Type::PointLight;
    each.type = isPoint ? AGAA_LIGHT_POINT : AGAA_LIGHT_DIRECTIONAL;
    const float fade = isPoint ? std::min(light.m_quadraticFade, 1000.0f) * 0.0001f : 1.0f; // as Qt's shaders
    copyVector(light.getGlobalPos() - m_eye, each.position);
    copyVector(light.getScalingCorrectDirection().normalized(), each.direction);
    copyVector(light.m_diffuseColor * light.m_brightness / fade, each.color);
    for (int i = 0; i < 3; ++i)
        frame.ambient[i] += light.m_ambientColor[i];
    m_lights.push_back(each);
}

void Adapter::addModel(const QSSGRenderModel& model) {
    const QSSGRenderMesh* mesh = model.geometry ? m_buffers.getCustomMeshMap().value(model.geometry).mesh
                                                : m_buffers.getMeshMap().value(model.meshPath).mesh;
    MeshRenderer::Constants constants;
    std::copy_n(m_clipFromShading.constData(), 16, constants.clipFromShading);
    QMatrix4x4 shadingFromModel = model.globalTransform;
    for (int row = 0; row < 3; ++row)
        shadingFromModel(row, 3) -= m_eye[row];
    std::copy_n(shadingFromModel.transposed().constData(), 12, constants.shadingFromModel);
    for (qsizetype i = 0; mesh && i < std::min(mesh->subsets.size(), model.materials.size()); ++i)
        if (model.materials[i]->type == QSSGRenderGraphObject::Type::CustomMaterial)
            m_meshes.add(mesh->subsets[i], static_cast<const QSSGRenderCustomMaterial&>(*model.materials[i]),
                         constants);
}

/* ---- frames --------------------------------------------------------------------------------------- */

AgaaFrame Adapter::describeFrame(const QVector3D& background) {
    auto& camera = *static_cast<QSSGRenderCamera*>(QQuick3DObjectPrivate::get(m_view3D.camera())->spatialNode);
    auto& root = *static_cast<QSSGRenderNode*>(QQuick3DObjectPrivate::get(m_view3D.scene())->spatialNode);
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.completedFrame = m_frameIndex;
    frame.frameIndex = ++m_frameIndex;
    camera.QSSGRenderNode::calculateGlobalVariables();
    m_eye = camera.getGlobalPos();
    QMatrix4x4 view = camera.globalTransform;
    view.setColumn(3, {0.0f, 0.0f, 0.0f, 1.0f}); // the origin of shading space is the eye
    view = view.transposed();                    // the inverse of a rotation
    const QMatrix4x4 projection = m_rhi->clipSpaceCorrMatrix() * camera.projection;
    std::copy_n(view.constData(), 16, frame.view);
    std::copy_n(projection.constData(), 16, frame.projection);
    m_clipFromShading = projection * view;
    m_lights.clear();
    m_meshes.clear();
    collect(root, frame);
    frame.lights = m_lights.data();
    frame.lightCount = uint32_t(m_lights.size());
    copyVector(background, frame.background);
    frame.draw = onDraw;
    frame.drawUser = this;
    return frame;
}

void Adapter::record(VkImage output, VkImageView outputView, const QVector3D& background) {
    const AgaaFrame frame = describeFrame(background);
    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    vkFrame.outputImage = uint64_t(output), vkFrame.outputView = uint64_t(outputView);
    vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED, vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_GENERAL;
    m_message.clear();
    m_window.beginExternalCommands(); // Qt forgets what is bound
    vkFrame.commandBuffer = *static_cast<VkCommandBuffer*>(
        m_window.rendererInterface()->getResource(&m_window, QSGRendererInterface::CommandListResource));
    const AgaaResult result = agaaVkRecordFrame(m_view, &frame, &vkFrame);
    m_window.endExternalCommands();
    check(result, "agaaVkRecordFrame");
}

AgaaResult Adapter::onDraw(void* user, const AgaaDrawTarget* target) {
    static_cast<Adapter*>(user)->m_meshes.draw(*target);
    return AGAA_OK;
}

} // namespace agaaQt
