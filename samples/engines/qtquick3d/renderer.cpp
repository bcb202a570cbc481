/* SPDX-License-Identifier: MIT */
#include "renderer.h"

#include <QtQuick/QQuickGraphicsDevice>
#include <QtQuick/QQuickRenderTarget>

#include <stdexcept>

Renderer::Renderer(VulkanDevice& device, QQuickItem& item, uint32_t width, uint32_t height)
    : m_control(std::make_unique<QQuickRenderControl>()), m_window(std::make_unique<QQuickWindow>(m_control.get())),
      m_target(device, width, height, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT) {
    m_window->setVulkanInstance(&device.instance());
    m_window->setGraphicsDevice(
        QQuickGraphicsDevice::fromDeviceObjects(device.physicalDevice(), device.device(), int(device.queueFamily())));
    m_window->setGeometry(0, 0, int(width), int(height));
    item.setParentItem(m_window->contentItem());
    if (!m_control->initialize())
        throw std::runtime_error("Qt Quick could not use the Vulkan device.");
    m_window->setRenderTarget(QQuickRenderTarget::fromVulkanImage(
        m_target.image(), VK_IMAGE_LAYOUT_UNDEFINED, VK_FORMAT_R32G32B32A32_SFLOAT, QSize(int(width), int(height))));
    QObject::connect(
        m_window.get(), &QQuickWindow::beforeRendering, m_window.get(),
        [this] {
            try {
                if (m_beforeRendering)
                    m_beforeRendering();
            } catch (...) { // exceptions must not pass through Qt
                m_exception = std::current_exception();
            }
        },
        Qt::DirectConnection);
}

Renderer::~Renderer() = default;

Pixels Renderer::render(const std::function<void()>& beforeRendering) {
    m_beforeRendering = beforeRendering;
    m_control->polishItems();
    m_control->beginFrame();
    m_control->sync();
    m_control->render();
    m_control->endFrame(); // waits for the device
    if (m_exception)
        std::rethrow_exception(std::exchange(m_exception, nullptr));
    return m_target.read(VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL); // in which Qt leaves it
}
