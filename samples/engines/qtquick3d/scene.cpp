/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <QtQml/QQmlComponent>

#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace {

/* A mesh of quads, with a position, a normal and texture coordinates per vertex. */
class Mesh : public QQuick3DGeometry {
public:
    void addQuad(const QVector3D (&corners)[4], QVector3D normal, const QVector2D (&uv)[4]) {
        for (const int i : {0, 1, 2, 0, 2, 3})
            for (const float value : {corners[i].x(), corners[i].y(), corners[i].z(), normal.x(), normal.y(),
                                      normal.z(), uv[i].x(), uv[i].y()})
                m_values.push_back(value);
    }

    /* Adds a bar of square cross-section between two points. */
    void addBar(QVector3D from, QVector3D to, float width) {
        const QVector3D along = (to - from).normalized();
        const QVector3D axis = std::abs(along.y()) > 0.9f ? QVector3D(1, 0, 0) : QVector3D(0, 1, 0);
        const QVector3D side = QVector3D::crossProduct(along, axis).normalized();
        for (int face = 0; face < 4; ++face) {
            const QVector3D normal = QQuaternion::fromAxisAndAngle(along, 90.0f * float(face)) * side;
            const QVector3D edge = QVector3D::crossProduct(along, normal) * (0.5f * width);
            const QVector3D at = normal * (0.5f * width);
            addQuad({from + at - edge, from + at + edge, to + at + edge, to + at - edge}, normal,
                    {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}});
        }
    }

    std::unique_ptr<QObject> finish(std::unique_ptr<Mesh> self) {
        setPrimitiveType(PrimitiveType::Triangles);
        setStride(8 * sizeof(float));
        addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
        addAttribute(Attribute::NormalSemantic, 3 * sizeof(float), Attribute::F32Type);
        addAttribute(Attribute::TexCoord0Semantic, 6 * sizeof(float), Attribute::F32Type);
        setVertexData(
            QByteArray(reinterpret_cast<const char*>(m_values.data()), qsizetype(m_values.size() * sizeof(float))));
        setBounds({-20, -20, -20}, {20, 20, 20});
        return self;
    }

private:
    std::vector<float> m_values;
};

/* The same numbers in every run. */
struct Random {
    uint32_t state = 12345;
    float operator()(float low, float high) {
        state = state * 1664525u + 1013904223u;
        return low + (high - low) * float(state >> 8) / 16777216.0f;
    }
};

/* Creates a texture from a colour per texel; x and y are in [0, 1). */
std::unique_ptr<QObject> createTexture(int size, const std::function<QVector4D(float x, float y)>& colorAt) {
    QByteArray texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const QVector4D c = colorAt((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size));
            for (int i = 0; i < 4; ++i)
                texels.push_back(char(std::lround(c[i] * 255.0f)));
        }
    auto texture = std::make_unique<QQuick3DTextureData>();
    texture->setSize({size, size});
    texture->setFormat(QQuick3DTextureData::RGBA8);
    texture->setTextureData(texels);
    return texture;
}

QVector4D tileTexel(float x, float y) {
    const bool isDark = (int(x * 8.0f) + int(y * 8.0f)) % 2 == 0;
    return isDark ? QVector4D(0.10f, 0.09f, 0.08f, 1.0f) : QVector4D(0.55f, 0.52f, 0.46f, 1.0f);
}

/* Alpha of a lobed leaf with a stem: 0.5 at its outline, which is some texels wide. */
QVector4D leafTexel(float x, float y) {
    const float u = 2.0f * x - 1.0f, v = 2.0f * y - 1.0f;
    const float angle = std::atan2(u, -v), radius = std::sqrt(u * u + v * v);
    const float outline = 0.52f + 0.3f * std::cos(5.0f * angle) + 0.06f * std::cos(15.0f * angle);
    const float leaf = (outline - radius) * 12.0f;
    const float stem = v > 0.0f ? (0.04f - std::abs(u)) * 40.0f : -1.0f;
    const float alpha = std::clamp(0.5f + std::max(leaf, stem), 0.0f, 1.0f);
    const float vein = std::abs(u) < 0.03f ? 0.7f : 1.0f;
    return {0.20f * vein, 0.42f * vein, 0.08f * vein, alpha};
}

std::unique_ptr<QObject> createGround() {
    auto mesh = std::make_unique<Mesh>();
    for (int x = -10; x < 10; ++x)
        for (int z = -10; z < 10; ++z) {
            const float left = 2.0f * float(x), back = 2.0f * float(z), u = 0.25f * float(x), v = 0.25f * float(z);
            mesh->addQuad({{left, 0, back + 2}, {left + 2, 0, back + 2}, {left + 2, 0, back}, {left, 0, back}},
                          {0, 1, 0}, {{u, v + 0.25f}, {u + 0.25f, v + 0.25f}, {u + 0.25f, v}, {u, v}});
        }
    return mesh->finish(std::move(mesh));
}

std::unique_ptr<QObject> createRailings() {
    auto mesh = std::make_unique<Mesh>();
    for (int i = 0; i <= 64; ++i)
        mesh->addBar({-6.4f + 0.2f * float(i), 0.0f, -3.6f}, {-6.4f + 0.2f * float(i), 1.9f, -3.6f}, 0.03f);
    for (int i = 0; i < 4; ++i)
        mesh->addBar({-6.4f, 0.3f + 0.53f * float(i), -3.6f}, {6.4f, 0.3f + 0.53f * float(i), -3.6f}, 0.035f);
    return mesh->finish(std::move(mesh));
}

std::unique_ptr<QObject> createWires() {
    auto mesh = std::make_unique<Mesh>();
    for (int wire = 0; wire < 6; ++wire) {
        const auto at = [wire](float t) { // t in [-1, 1]
            return QVector3D(9.0f * t, 2.4f + 0.28f * float(wire) + 0.6f * t * t, -5.0f + 1.5f * float(wire % 2) * t);
        };
        for (int i = 0; i < 24; ++i)
            mesh->addBar(at(float(i) / 12.0f - 1.0f), at(float(i + 1) / 12.0f - 1.0f), 0.014f);
    }
    return mesh->finish(std::move(mesh));
}

std::unique_ptr<QObject> createLeaves() {
    auto mesh = std::make_unique<Mesh>();
    Random random;
    for (int i = 0; i < 260; ++i) {
        const float x = random(-1.3f, 1.3f), y = random(0.2f, 2.6f), z = random(-1.3f, 1.3f);
        const QVector3D centre(x, y, z);
        const float angle = random(0.0f, 344.0f), a = random(-1, 1), b = random(-1, 1), c = random(-1, 1);
        const QQuaternion turn = QQuaternion::fromAxisAndAngle(QVector3D(a, b, c).normalized(), angle);
        const float size = random(0.10f, 0.22f);
        const auto corner = [&](float u, float v) { return centre + turn * QVector3D(u * size, v * size, 0.0f); };
        mesh->addQuad({corner(-1, 1), corner(-1, -1), corner(1, -1), corner(1, 1)}, turn * QVector3D(0, 0, 1),
                      {{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    }
    return mesh->finish(std::move(mesh));
}

} // namespace

Scene::Scene(uint32_t width, uint32_t height) : m_width(width), m_height(height) {
    const auto white = [](float, float) { return QVector4D(1, 1, 1, 1); };
    QVariantMap properties = {{"width", width}, {"height", height}};
    const auto add = [&](const char* name, std::unique_ptr<QObject> resource) {
        QQmlEngine::setObjectOwnership(resource.get(), QQmlEngine::CppOwnership);
        properties[name] = QVariant::fromValue(resource.get());
        m_resources.push_back(std::move(resource));
    };
    add("groundMesh", createGround());
    add("railingMesh", createRailings());
    add("wireMesh", createWires());
    add("leafMesh", createLeaves());
    add("white", createTexture(4, white));
    add("tiles", createTexture(256, tileTexel));
    add("leaf", createTexture(128, leafTexel));
    QQmlComponent component(&m_engine, QUrl("qrc:/scene.qml"));
    m_view3D.reset(qobject_cast<QQuick3DViewport*>(component.createWithInitialProperties(properties)));
    if (!m_view3D)
        throw std::runtime_error("The scene could not be created. " + component.errorString().toStdString());
    m_camera = m_view3D->findChild<QQuick3DCustomCamera*>("eye");
    setTime(0.0f);
    setOffset(0.0f, 0.0f);
}

Scene::~Scene() { m_view3D.reset(); }

void Scene::setTime(float seconds) {
    m_view3D->setProperty("time", seconds);
    const float angle = 0.15f + 0.12f * seconds;
    const QVector3D eye(6.6f * std::sin(angle), 2.1f + 0.1f * std::sin(seconds), 6.6f * std::cos(angle));
    m_camera->setPosition(eye);
    m_camera->setRotation(QQuaternion::fromDirection(eye - QVector3D(0.0f, 1.3f, -0.5f), {0.0f, 1.0f, 0.0f}));
}

void Scene::setOffset(float offsetX, float offsetY) {
    QMatrix4x4 projection;
    projection.perspective(50.0f, float(m_width) / float(m_height), 0.1f, 100.0f);
    projection(0, 2) += 2.0f * offsetX / float(m_width);
    projection(1, 2) += 2.0f * offsetY / float(m_height);
    m_camera->setProjection(projection);
}
