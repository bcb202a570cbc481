/* Renders a View3D with Qt Quick into an image of the host, a frame at each call.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "vulkan_device.h"

#include <QtQuick/QQuickItem>
#include <QtQuick/QQuickRenderControl>
#include <QtQuick/QQuickWindow>

#include <functional>
#include <memory>

class Renderer {
public:
    Renderer(VulkanDevice& device, QQuickItem& item, uint32_t width, uint32_t height);
    ~Renderer();

    /* Renders a frame, waits for it and returns Qt's image. The function runs in QQuickWindow::beforeRendering. */
    Pixels render(const std::function<void()>& beforeRendering = {});
    QQuickWindow& window() { return *m_window; }

private:
    std::unique_ptr<QQuickRenderControl> m_control;
    std::unique_ptr<QQuickWindow> m_window;
    Image m_target;
    std::function<void()> m_beforeRendering;
    std::exception_ptr m_exception;
};
