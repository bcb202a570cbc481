/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include "shaders.h"

#include <cmath>
#include <functional>

namespace {

using Color = Ogre::ColourValue;
using Ogre::Vector3;

const char* const group = Ogre::RGN_DEFAULT;

/* Creates a texture with mip levels from a colour per texel; x and y are in [0, 1). */
Ogre::TexturePtr createTexture(const char* name, uint32_t size, const std::function<Color(float x, float y)>& colorAt) {
    std::vector<uint8_t> texels;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const auto scale = static_cast<float>(size);
            const Color c = colorAt((float(x) + 0.5f) / scale, (float(y) + 0.5f) / scale);
            for (int i = 0; i < 4; ++i)
                texels.push_back(static_cast<uint8_t>(std::lround(c[i] * 255.0f)));
        }
    Ogre::Image image;
    image.loadDynamicImage(texels.data(), size, size, 1, Ogre::PF_BYTE_RGBA);
    return Ogre::TextureManager::getSingleton().loadImage(name, group, image, Ogre::TEX_TYPE_2D, Ogre::MIP_UNLIMITED);
}

/* Alpha of a lobed leaf with a stem: 0.5 at its outline, which is some texels wide. */
Color leafTexel(float x, float y) {
    const float u = 2.0f * x - 1.0f, v = 2.0f * y - 1.0f;
    const float angle = std::atan2(u, -v), radius = std::sqrt(u * u + v * v);
    const float outline = 0.52f + 0.3f * std::cos(5.0f * angle) + 0.06f * std::cos(15.0f * angle);
    const float leaf = (outline - radius) * 12.0f;
    const float stem = v > 0.0f ? (0.04f - std::abs(u)) * 40.0f : -1.0f;
    const float alpha = std::clamp(0.5f + std::max(leaf, stem), 0.0f, 1.0f);
    const float vein = std::abs(u) < 0.03f ? 0.7f : 1.0f;
    return Color(0.20f * vein, 0.42f * vein, 0.08f * vein, alpha);
}

void createPrograms() {
    auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
    const auto vertex = manager.createProgram("scene/vertex", group, "glsl", Ogre::GPT_VERTEX_PROGRAM);
    vertex->setSource(vertexText);
    const auto fragment = manager.createProgram("scene/fragment", group, "glsl", Ogre::GPT_FRAGMENT_PROGRAM);
    fragment->setSource(fragmentText);
    using P = Ogre::GpuProgramParameters;
    vertex->load();
    fragment->load();
    const auto v = vertex->getDefaultParameters(), f = fragment->getDefaultParameters();
    v->setNamedAutoConstant("world", P::ACT_WORLD_MATRIX);
    v->setNamedAutoConstant("normalMatrix", P::ACT_INVERSE_TRANSPOSE_WORLD_MATRIX);
    v->setNamedAutoConstant("viewProjection", P::ACT_VIEWPROJ_MATRIX);
    v->setNamedAutoConstant("eye", P::ACT_CAMERA_POSITION);
    f->setNamedAutoConstant("lightPosition", P::ACT_LIGHT_POSITION_ARRAY, 3);
    f->setNamedAutoConstant("lightColor", P::ACT_LIGHT_DIFFUSE_COLOUR_POWER_SCALED_ARRAY, 3);
    f->setNamedAutoConstant("lightAttenuation", P::ACT_LIGHT_ATTENUATION_ARRAY, 3);
    f->setNamedAutoConstant("ambient", P::ACT_AMBIENT_LIGHT_COLOUR);
    f->setNamedAutoConstant("lightEye", P::ACT_CAMERA_POSITION);
}

void createMaterial(const char* name, const Ogre::TexturePtr& texture, Color tint, float specular, float alpha,
                    bool isLeaf = false) {
    const auto material = Ogre::MaterialManager::getSingleton().create(name, group);
    Ogre::Pass& pass = *material->getTechnique(0)->getPass(0);
    pass.setVertexProgram("scene/vertex");
    pass.setFragmentProgram("scene/fragment");
    pass.setCullingMode(Ogre::CULL_NONE);
    Ogre::TextureUnitState& unit = *pass.createTextureUnitState();
    unit.setTexture(texture);
    unit.setTextureFiltering(Ogre::TFO_TRILINEAR);
    const auto parameters = pass.getFragmentProgramParameters();
    parameters->setNamedConstant("tint", tint);
    parameters->setNamedConstant("reflectance", Ogre::Vector4(specular, specular, specular, alpha * alpha));
    parameters->setNamedConstant("cutoff", isLeaf ? 0.5f : 0.0f);
    parameters->setNamedConstant("isTwoSided", isLeaf ? 1.0f : 0.0f);
    if (isLeaf)
        pass.setAlphaRejectSettings(Ogre::CMPF_GREATER_EQUAL, 128);
    material->load();
}

/* Adds a bar of rectangular cross-section between two points. */
void addBar(Ogre::ManualObject& object, Vector3 from, Vector3 to, float width) {
    const Vector3 along = (to - from).normalisedCopy();
    const Vector3 side = along.perpendicular(), up = along.crossProduct(side);
    for (int face = 0; face < 4; ++face) {
        const Ogre::Quaternion turn(Ogre::Degree(90.0f * float(face)), along);
        const Vector3 normal = turn * side, edge = turn * up * (0.5f * width), at = normal * (0.5f * width);
        const auto first = static_cast<uint32_t>(object.getCurrentVertexCount());
        const Vector3 corners[] = {from + at - edge, from + at + edge, to + at + edge, to + at - edge};
        for (const Vector3& corner : corners) {
            object.position(corner);
            object.normal(normal);
            object.textureCoord(0.5f, 0.5f);
        }
        object.quad(first, first + 1, first + 2, first + 3);
    }
}

/* The same numbers in every run. */
struct Random {
    uint32_t state = 12345;
    float operator()(float low, float high) {
        state = state * 1664525u + 1013904223u;
        return low + (high - low) * float(state >> 8) / 16777216.0f;
    }
};

} // namespace

Scene::Scene(Ogre::Root& root) : m_manager(root.createSceneManager()) {
    m_camera = m_manager->createCamera("camera");
    m_camera->setNearClipDistance(0.1f);
    m_camera->setFarClipDistance(100.0f);
    m_camera->setFOVy(Ogre::Degree(50.0f));
    m_camera->setAutoAspectRatio(false);
    m_cameraNode = m_manager->getRootSceneNode()->createChildSceneNode();
    m_cameraNode->attachObject(m_camera);
    createPrograms();
    createMaterials();
    createGround();
    createObjects();
    createRailings();
    createLeaves();
    createLights();
}

void Scene::createMaterials() {
    const auto white = createTexture("scene/white", 4, [](float, float) { return Color::White; });
    const auto tiles = createTexture("scene/tiles", 256, [](float x, float y) {
        const bool isDark = (int(x * 8.0f) + int(y * 8.0f)) % 2 == 0;
        return isDark ? Color(0.10f, 0.09f, 0.08f) : Color(0.55f, 0.52f, 0.46f);
    });
    const auto leaf = createTexture("scene/leaf", 128, leafTexel);
    createMaterial("ground", tiles, Color::White, 0.04f, 0.5f);
    createMaterial("red", white, Color(0.60f, 0.08f, 0.05f), 0.04f, 0.35f);
    createMaterial("blue", white, Color(0.06f, 0.12f, 0.55f), 0.05f, 0.25f);
    createMaterial("tiled", tiles, Color(1.0f, 0.9f, 0.7f), 0.04f, 0.6f);
    createMaterial("metal", white, Color(0.05f, 0.05f, 0.05f), 0.60f, 0.30f);
    createMaterial("wire", white, Color(0.02f, 0.02f, 0.02f), 0.04f, 0.5f);
    createMaterial("leaf", leaf, Color::White, 0.03f, 0.6f, true);
}

void Scene::createGround() {
    Ogre::MeshManager::getSingleton().createPlane("scene/ground", group, Ogre::Plane(Vector3::UNIT_Y, 0.0f), 40.0f,
                                                  40.0f, 20, 20, true, 1, 5.0f, 5.0f, Vector3::UNIT_Z);
    Ogre::Entity* ground = m_manager->createEntity("scene/ground");
    ground->setMaterialName("ground");
    m_manager->getRootSceneNode()->attachObject(ground);
}

Ogre::SceneNode* Scene::addPrefab(Ogre::SceneManager::PrefabType type, const char* material, Vector3 position,
                                  float size) {
    Ogre::Entity* entity = m_manager->createEntity(type);
    entity->setMaterialName(material);
    Ogre::SceneNode* node = m_manager->getRootSceneNode()->createChildSceneNode(position);
    node->setScale(Vector3(size / 100.0f)); // OGRE's prefabs are 100 units wide
    node->attachObject(entity);
    return node;
}

void Scene::createObjects() {
    for (int i = 0; i < 6; ++i) {
        const float angle = float(i) * Ogre::Math::TWO_PI / 6.0f;
        const Vector3 place(3.0f * std::cos(angle), 0.7f, 3.0f * std::sin(angle));
        if (i % 2 == 0)
            m_moving.push_back(addPrefab(Ogre::SceneManager::PT_CUBE, i % 4 == 0 ? "red" : "tiled", place, 1.0f));
        else
            m_moving.push_back(addPrefab(Ogre::SceneManager::PT_SPHERE, i % 3 == 0 ? "metal" : "blue", place, 1.2f));
    }
}

void Scene::createRailings() {
    Ogre::ManualObject* railings = m_manager->createManualObject("railings");
    railings->begin("metal", Ogre::RenderOperation::OT_TRIANGLE_LIST, group);
    for (int i = 0; i <= 64; ++i)
        addBar(*railings, {-6.4f + 0.2f * float(i), 0.0f, -3.6f}, {-6.4f + 0.2f * float(i), 1.9f, -3.6f}, 0.03f);
    for (int i = 0; i < 4; ++i)
        addBar(*railings, {-6.4f, 0.3f + 0.53f * float(i), -3.6f}, {6.4f, 0.3f + 0.53f * float(i), -3.6f}, 0.035f);
    railings->end();
    railings->begin("wire", Ogre::RenderOperation::OT_TRIANGLE_LIST, group);
    for (int wire = 0; wire < 6; ++wire) {
        const auto at = [wire](float t) { // t in [-1, 1]
            return Vector3(9.0f * t, 2.4f + 0.28f * float(wire) + 0.6f * t * t, -5.0f + 1.5f * float(wire % 2) * t);
        };
        for (int i = 0; i < 24; ++i)
            addBar(*railings, at(float(i) / 12.0f - 1.0f), at(float(i + 1) / 12.0f - 1.0f), 0.014f);
    }
    railings->end();
    m_manager->getRootSceneNode()->attachObject(railings);
}

void Scene::createLeaves() {
    Ogre::ManualObject* leaves = m_manager->createManualObject("leaves");
    Random random;
    leaves->begin("leaf", Ogre::RenderOperation::OT_TRIANGLE_LIST, group);
    for (uint32_t i = 0; i < 260; ++i) {
        const Vector3 centre(random(-1.3f, 1.3f), random(0.2f, 2.6f), random(-1.3f, 1.3f));
        const Ogre::Quaternion turn(Ogre::Radian(random(0.0f, 6.0f)),
                                    Vector3(random(-1, 1), random(-1, 1), random(-1, 1)).normalisedCopy());
        const float size = random(0.10f, 0.22f);
        for (int k = 0; k < 4; ++k) {
            const float u = k == 1 || k == 2 ? 1.0f : 0.0f, v = k >= 2 ? 1.0f : 0.0f;
            leaves->position(centre + turn * Vector3((2.0f * u - 1.0f) * size, (1.0f - 2.0f * v) * size, 0.0f));
            leaves->normal(turn * Vector3::UNIT_Z);
            leaves->textureCoord(u, v);
        }
        leaves->quad(4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3);
    }
    leaves->end();
    m_moving.push_back(m_manager->getRootSceneNode()->createChildSceneNode());
    m_moving.back()->attachObject(leaves);
}

void Scene::createLights() {
    m_manager->setAmbientLight(Color(0.16f, 0.18f, 0.22f));
    const auto add = [this](Ogre::Light::LightTypes type, Vector3 position, Color color, float power) {
        Ogre::Light* light = m_manager->createLight();
        light->setType(type);
        light->setDiffuseColour(color);
        light->setPowerScale(power);
        light->setAttenuation(12.0f, 1.0f, 0.0f, 0.0f);
        Ogre::SceneNode* node = m_manager->getRootSceneNode()->createChildSceneNode(position);
        node->attachObject(light);
        if (type == Ogre::Light::LT_DIRECTIONAL)
            node->setDirection(-position.normalisedCopy(), Ogre::Node::TS_WORLD);
    };
    add(Ogre::Light::LT_DIRECTIONAL, {3.0f, 5.0f, 4.0f}, Color(1.0f, 0.95f, 0.85f), 2.6f);
    add(Ogre::Light::LT_POINT, {-4.0f, 2.2f, -2.5f}, Color(1.0f, 0.55f, 0.25f), 14.0f);
    add(Ogre::Light::LT_POINT, {4.0f, 1.8f, 1.5f}, Color(0.3f, 0.6f, 1.0f), 12.0f);
}

void Scene::setTime(float seconds) {
    for (size_t i = 0; i < m_moving.size(); ++i) {
        const float phase = seconds + float(i);
        m_moving[i]->setOrientation(
            Ogre::Quaternion(Ogre::Radian(0.7f * phase), Vector3(0.2f, 1.0f, 0.1f).normalisedCopy()));
        if (i + 1 < m_moving.size()) { // the leaves only turn
            Vector3 place = m_moving[i]->getPosition();
            place.y = 0.95f + 0.25f * std::sin(1.3f * phase);
            m_moving[i]->setPosition(place);
        }
    }
    const float angle = 0.15f + 0.12f * seconds;
    m_cameraNode->setPosition(6.6f * std::sin(angle), 2.1f + 0.1f * std::sin(seconds), 6.6f * std::cos(angle));
    m_cameraNode->resetOrientation(); // lookAt() turns the node from where it is, which adds up rounding
    m_cameraNode->lookAt({0.0f, 1.3f, -0.5f}, Ogre::Node::TS_WORLD);
}
