/* A small animated scene. scene.qml describes it; this class makes its meshes and textures and moves its camera.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <QtQml/QQmlEngine>
#include <QtQuick3D/QQuick3DGeometry>
#include <QtQuick3D/QQuick3DTextureData>
#include <QtQuick3D/private/qquick3dcustomcamera_p.h>
#include <QtQuick3D/private/qquick3dviewport_p.h>

#include <memory>

class Mesh;
class Texels;

class Scene {
public:
    Scene(uint32_t width, uint32_t height);
    ~Scene();
    void setTime(float seconds);                  // moves the objects and the camera
    void setOffset(float offsetX, float offsetY); // moves the image by a part of a pixel

    QQuick3DViewport& view3D() { return *m_view3D; }
    static QVector3D background() { return {0.30f, 0.42f, 0.62f}; } // linear

private:
    uint32_t m_width, m_height;
    std::vector<std::unique_ptr<QObject>> m_resources; // meshes and textures
    QQmlEngine m_engine;
    std::unique_ptr<QQuick3DViewport> m_view3D;
    QQuick3DCustomCamera* m_camera;
};
