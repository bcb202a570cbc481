#include "scene/gltf.h"

#include "scene/builtin.h"
#include "scene/gltf_document.h"
#include "scene/gltf_reader.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

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

Light lightOf(const tinygltf::Light& source, const glm::dmat4& transform, bool& hasSun) {
    Light light;
    light.position = glm::dvec3(transform[3]);
    light.direction = axisOf(transform, {0, 0, -1});
    for (int i = 0; i < 3 && size_t(i) < source.color.size(); ++i)
        light.color[i] = float(source.color[size_t(i)]);
    light.color *= float(source.intensity);
    light.range = float(source.range);
    if (source.type == "directional") {
        light.type = LightType::Directional;
        light.castsShadow = !hasSun;
        hasSun = true;
    } else if (source.type == "spot") {
        light.type = LightType::Spot;
        light.innerCone = float(source.spot.innerConeAngle);
        light.outerCone = float(source.spot.outerConeAngle);
    }
    return light;
}

Camera cameraOf(const tinygltf::Camera& source, const glm::dmat4& transform) {
    Camera camera;
    camera.name = source.name;
    camera.eye = glm::dvec3(transform[3]);
    camera.target = camera.eye + axisOf(transform, {0, 0, -1});
    camera.up = axisOf(transform, {0, 1, 0});
    camera.fovDegrees = glm::degrees(source.perspective.yfov);
    return camera;
}

class NodeWalk {
public:
    NodeWalk(GltfReader& reader, std::vector<uint32_t> firstMesh)
        : reader_(reader), firstMesh_(std::move(firstMesh)), seen_(reader.model.nodes.size(), false) {}

    // Traverses depth first with an explicit stack, because a file may nest deeper than the call stack allows.
    void visit(const std::vector<int>& roots) {
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
            if (seen_[size_t(next.node)])
                reader_.fail("the node hierarchy is not a tree");
            seen_[size_t(next.node)] = true;
            const glm::dmat4 transform = next.parent * localTransform(node);
            for (int i = 0; i < 16; ++i)
                if (!std::isfinite(glm::value_ptr(transform)[i]))
                    reader_.fail("a node's transform is not finite");
            take(node, transform);
            push(node.children, transform);
        }
    }

private:
    struct Pending {
        int node;
        glm::dmat4 parent;
    };

    void take(const tinygltf::Node& node, const glm::dmat4& transform) {
        if (node.mesh >= 0) {
            reader_.at(reader_.model.meshes, node.mesh, "meshes");
            for (uint32_t mesh = firstMesh_[size_t(node.mesh)]; mesh < firstMesh_[size_t(node.mesh) + 1]; ++mesh)
                reader_.scene.instances.push_back({mesh, transform});
        }
        if (node.camera >= 0) {
            const auto& camera = reader_.at(reader_.model.cameras, node.camera, "cameras");
            if (camera.type == "perspective")
                reader_.scene.cameras.push_back(cameraOf(camera, transform));
        }
        const auto light = node.extensions.find("KHR_lights_punctual");
        if (light != node.extensions.end() && light->second.Has("light"))
            reader_.scene.lights.push_back(
                lightOf(reader_.at(reader_.model.lights, light->second.Get("light").GetNumberAsInt(), "lights"),
                        transform, hasSun_));
    }

    GltfReader& reader_;
    std::vector<uint32_t> firstMesh_;
    std::vector<bool> seen_;
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
    readMaterials(reader);
    NodeWalk walk(reader, readMeshes(reader));
    if (model.scenes.empty())
        reader.fail("it has no scene");
    const int chosen = model.defaultScene >= 0 ? model.defaultScene : 0;
    walk.visit(reader.at(model.scenes, chosen, "scenes").nodes);
    updateBounds(scene);
    moveTargets(scene);
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
