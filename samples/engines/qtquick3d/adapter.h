/* Connects Qt Quick 3D 6.4 on Vulkan to the AGAA SDK. docs/integration/engine-qtquick3d.md describes the order of
 * calls. SPDX-License-Identifier: MIT
 */
#pragma once

#include "mesh_renderer.h"

#include <QtGui/private/qrhi_p.h>
#include <QtQuick3D/private/qquick3dviewport_p.h>
#include <QtQuick3DRuntimeRender/private/qssgrendercontextcore_p.h>
#include <QtQuick3DRuntimeRender/private/qssgrenderlight_p.h>
#include <QtQuick3DRuntimeRender/private/qssgrendermodel_p.h>

#include <string>
#include <vector>

namespace agaaQt {

/* A view of the SDK that draws the scene of a View3D. All functions need Qt's render thread.
 *
 * Models       Those that MeshRenderer draws.
 * Lights       Directional and point lights. A point light has constantFade and linearFade 0. */
class Adapter {
public:
    /* enabledFeatures is the chain with which the host created the device that Qt uses. Both texts are for
     * MeshRenderer. */
    Adapter(QQuickWindow& window, QQuick3DViewport& view3D, const VkPhysicalDeviceFeatures2& enabledFeatures,
            const std::string& vertexShader, const std::string& surfaceText);
    ~Adapter();
    Adapter(const Adapter&) = delete;

    /* Creates the view, in place of an earlier one. It throws a std::runtime_error with the SDK's sentence if the SDK
     * refuses the view. */
    void createView(const AgaaConfig& config, const AgaaSceneFacts& facts, uint32_t width, uint32_t height);
    void destroyView();

    /* Records a frame into Qt's command buffer, in a slot of QQuickWindow::beforeRendering. The output has the size of
     * the view. Its contents are discarded, and the SDK leaves it in VK_IMAGE_LAYOUT_GENERAL. */
    void record(VkImage output, VkImageView outputView, const QVector3D& background);

    AgaaView view() const { return m_view; }
    uint64_t frameIndex() const { return m_frameIndex; } // of the newest frame
    const std::vector<AgaaDrawPass>& passes() const { return m_passes; }

private:
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    static void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message);
    void check(AgaaResult result, const char* call) const;
    AgaaFrame describeFrame(const QVector3D& background);
    void collect(QSSGRenderNode& node, AgaaFrame& frame);
    void addLight(const QSSGRenderLight& light, AgaaFrame& frame);
    void addModel(const QSSGRenderModel& model);

    QQuickWindow& m_window;
    QQuick3DViewport& m_view3D;
    QRhi* m_rhi;
    QSSGBufferManager& m_buffers; // Qt's meshes and textures on the device
    MeshRenderer m_meshes;
    std::string m_message; // the SDK's last error
    AgaaContext m_context = nullptr;
    AgaaView m_view = nullptr;
    std::vector<AgaaVkDrawPass> m_vkPasses;
    std::vector<AgaaDrawPass> m_passes;
    std::vector<AgaaLight> m_lights; // of the frame that is recorded, like the following members
    QVector3D m_eye;
    QMatrix4x4 m_clipFromShading;
    uint64_t m_frameIndex = 0;
};

} // namespace agaaQt
