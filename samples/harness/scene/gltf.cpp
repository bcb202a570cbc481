#include "scene/gltf.h"

#include "scene/builtin.h"
#include "scene/gltf_document.h"
#include "scene/gltf_meshes.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace harness {

namespace {

glm::dmat4 localTransform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16)
        return glm::make_mat4(node.matrix.data());
    glm::dmat4 transform(1);
    if (node.translation.size() == 3)
        transform[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1);
    if (node.rotation.size() == 4)
        transform *= glm::mat4_cast(
            glm::normalize(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])));
    if (node.scale.size() == 3)
        for (int i = 0; i < 3; ++i)
            transform[i] *= node.scale[size_t(i)];
    return transform;
}

// Returns a unit direction of a node in world space, or the direction itself if the node's scale flattens it to 0.
glm::dvec3 axisOf(const glm::dmat4& transform, const glm::dvec3& axis) {
    const glm::dvec3 v(transform * glm::dvec4(axis, 0));
    const double length = glm::length(v);
    return length > 0 ? v / length : axis;
}

// Returns -1 for a value that is no index.
int indexOf(const tinygltf::Value& value) {
    const double number = value.IsNumber() ? value.GetNumberAsDouble() : -1;
    return number >= 0 && number <= std::numeric_limits<int>::max() ? int(number) : -1;
}

float notNegative(double value) { return std::max(finiteFloat(value), 0.0f); }

Light lightOf(const tinygltf::Light& source, const glm::dmat4& transform, bool& hasSun) {
    Light light;
    light.position = glm::dvec3(transform[3]);
    light.direction = axisOf(transform, {0, 0, -1});
    for (int i = 0; i < 3 && size_t(i) < source.color.size(); ++i)
        light.color[i] = notNegative(source.color[size_t(i)]);
    light.color = glm::min(light.color * notNegative(source.intensity), float(largestNumber));
    light.range = notNegative(source.range);
    if (source.type == "directional") {
        light.type = LightType::Directional;
        light.castsShadow = !hasSun;
        hasSun = true;
    } else if (source.type == "spot") {
        light.type = LightType::Spot;
        light.outerCone = float(std::clamp(source.spot.outerConeAngle, 0.0, glm::half_pi<double>()));
        light.innerCone = float(std::clamp(source.spot.innerConeAngle, 0.0, double(light.outerCone)));
    }
    return light;
}

// Returns nothing for a camera that covers no angle or no height.
std::optional<Camera> cameraOf(const tinygltf::Camera& source, const glm::dmat4& transform) {
    Camera camera;
    camera.name = source.name;
    camera.eye = glm::dvec3(transform[3]);
    camera.target = camera.eye + axisOf(transform, {0, 0, -1});
    camera.up = axisOf(transform, {0, 1, 0});
    if (source.type == "orthographic") {
        camera.height = 2 * std::abs(source.orthographic.ymag);
        return camera.height >= 1 / largestNumber && camera.height <= largestNumber ? std::optional(camera)
                                                                                    : std::nullopt;
    }
    camera.fovDegrees = glm::degrees(source.perspective.yfov);
    return camera.fovDegrees >= 1e-3 && camera.fovDegrees < 180 ? std::optional(camera) : std::nullopt;
}

class NodeWalk {
public:
    explicit NodeWalk(GltfReader& reader) : reader_(reader), meshes_(reader) {
        reader.transforms.resize(reader.model.nodes.size());
    }

    // Transforms come first, because skins need those of other nodes.
    void visit(const std::vector<int>& roots) {
        for (const int index : findTransforms(roots))
            take(reader_.model.nodes[size_t(index)], *reader_.transforms[size_t(index)]);
    }

private:
    // Returns the nodes depth first. The stack is explicit, because a file may nest deeper than the call stack allows.
    std::vector<int> findTransforms(const std::vector<int>& roots) {
        struct Pending {
            int node;
            glm::dmat4 parent;
        };
        std::vector<int> order;
        std::vector<Pending> pending;
        const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
            for (size_t i = nodes.size(); i-- > 0;)
                pending.push_back({nodes[i], parent});
        };
        push(roots, glm::dmat4(1));
        while (!pending.empty()) {
            const Pending next = pending.back();
            pending.pop_back();
            const tinygltf::Node& node = reader_.at(reader_.model.nodes, next.node, "nodes");
            if (reader_.transforms[size_t(next.node)])
                reader_.fail("the node hierarchy is not a tree");
            const glm::dmat4 transform = next.parent * localTransform(node);
            for (int i = 0; i < 16; ++i)
                if (!(std::abs(glm::value_ptr(transform)[i]) <= largestNumber))
                    reader_.fail("a node's transform is not finite, or has a number above 1e15");
            reader_.transforms[size_t(next.node)] = transform;
            order.push_back(next.node);
            push(node.children, transform);
        }
        return order;
    }

    void take(const tinygltf::Node& node, const glm::dmat4& transform) {
        if (node.mesh >= 0)
            for (const PlacedMesh& placed : meshes_.find(node)) {
                const glm::dmat4 toWorld = placed.isSkinned ? glm::dmat4(1) : transform;
                reader_.scene.instances.push_back({placed.mesh, glm::translate(toWorld, placed.origin)});
            }
        if (node.camera >= 0) {
            const auto camera = cameraOf(reader_.at(reader_.model.cameras, node.camera, "cameras"), transform);
            if (camera)
                reader_.scene.cameras.push_back(*camera);
            else
                reader_.drop("a camera that covers no angle between 0.001 and 180 degrees, or no height, is ignored");
        }
        const auto light = node.extensions.find("KHR_lights_punctual");
        if (light != node.extensions.end() && light->second.Has("light"))
            reader_.scene.lights.push_back(lightOf(
                reader_.at(reader_.model.lights, indexOf(light->second.Get("light")), "lights"), transform, hasSun_));
    }

    GltfReader& reader_;
    MeshTable meshes_;
    bool hasSun_ = false;
};

// glTF cameras have no target. The target distance is the depth of the middle of the scene.
void moveTargets(Scene& scene) {
    const glm::dvec3 centre = 0.5 * (scene.boundsMin + scene.boundsMax);
    const double size = glm::length(scene.boundsMax - scene.boundsMin);
    if (!(size > 0))
        return;
    for (Camera& camera : scene.cameras) {
        const glm::dvec3 forward = camera.target - camera.eye;
        const double depth = glm::dot(centre - camera.eye, forward);
        camera.target = camera.eye + std::max(depth, 0.05 * size) * forward;
    }
}

// Lamps of glTF are points. They get a radius of a centimetre, or of a thousandth of a small scene, at which the
// inverse-square law stops. Their range is a hint for culling and says nothing of their size.
void setRadii(Scene& scene) {
    const double size = glm::length(scene.boundsMax - scene.boundsMin);
    for (Light& light : scene.lights)
        light.radius = size > 0 ? float(std::min(0.01, 0.001 * size)) : 0.01f;
}

} // namespace

Scene loadGltf(const std::filesystem::path& path) {
    const std::string file = path.string();
    if (!std::filesystem::is_regular_file(path))
        throw std::runtime_error(file + ": there is no such file.");
    tinygltf::Model model;
    try {
        model = readGltfModel(path);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(file + ": " + error.what() + ".");
    }
    Scene scene;
    scene.name = path.stem().string();
    GltfReader reader{model, file, scene};
    dropUnsupportedFeatures(reader);
    readMaterials(reader);
    NodeWalk walk(reader);
    if (model.scenes.empty())
        reader.fail("it has no scene");
    const int chosen = model.defaultScene >= 0 ? model.defaultScene : 0;
    walk.visit(reader.at(model.scenes, chosen, "scenes").nodes);
    updateBounds(scene);
    moveTargets(scene);
    setRadii(scene);
    return scene;
}

bool isGltfName(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".gltf" || extension == ".glb";
}

Scene loadScene(const std::string& nameOrPath) {
    if (auto scene = makeBuiltinScene(nameOrPath))
        return std::move(*scene);
    if (!isGltfName(nameOrPath))
        throw std::runtime_error("\"" + nameOrPath + "\" is neither a built-in scene nor a .gltf or .glb file.");
    return loadGltf(nameOrPath);
}

} // namespace harness
