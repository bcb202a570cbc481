#include "scene/gltf.h"

#include "scene/builtin.h"
#include "scene/gltf_reader.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

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
        transform *= glm::mat4_cast(glm::normalize(
            glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])));
    if (node.scale.size() == 3)
        for (int i = 0; i < 3; ++i)
            transform[i] *= node.scale[size_t(i)];
    return transform;
}

Light lightOf(const tinygltf::Light& source, const glm::dmat4& transform, bool& hasSun) {
    Light light;
    light.position = glm::dvec3(transform[3]);
    light.direction = glm::normalize(glm::dvec3(transform * glm::dvec4(0, 0, -1, 0)));
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
    camera.target = camera.eye + glm::normalize(glm::dvec3(transform * glm::dvec4(0, 0, -1, 0)));
    camera.up = glm::normalize(glm::dvec3(transform * glm::dvec4(0, 1, 0, 0)));
    camera.fovDegrees = glm::degrees(source.perspective.yfov);
    return camera;
}

class NodeWalk {
public:
    NodeWalk(GltfReader& reader, std::vector<uint32_t> firstMesh)
        : reader_(reader), firstMesh_(std::move(firstMesh)), seen_(reader.model.nodes.size(), false) {}

    void visit(int index, const glm::dmat4& parent) {
        const tinygltf::Node& node = reader_.at(reader_.model.nodes, index, "nodes");
        if (seen_[size_t(index)])
            reader_.fail("the node hierarchy is not a tree");
        seen_[size_t(index)] = true;
        const glm::dmat4 transform = parent * localTransform(node);
        for (int i = 0; i < 16; ++i)
            if (!std::isfinite(glm::value_ptr(transform)[i]))
                reader_.fail("a node's transform is not finite");
        if (node.mesh >= 0) {
            reader_.at(reader_.model.meshes, node.mesh, "meshes");
            for (uint32_t mesh = firstMesh_[size_t(node.mesh)];
                 mesh < firstMesh_[size_t(node.mesh) + 1]; ++mesh)
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
                lightOf(reader_.at(reader_.model.lights,
                                   light->second.Get("light").GetNumberAsInt(), "lights"),
                        transform, hasSun_));
        for (int child : node.children)
            visit(child, transform);
    }

private:
    GltfReader& reader_;
    std::vector<uint32_t> firstMesh_;
    std::vector<bool> seen_;
    bool hasSun_ = false;
};

} // namespace

Scene loadGltf(const std::filesystem::path& path) {
    const std::string file = path.string();
    if (!std::filesystem::exists(path))
        throw std::runtime_error(file + ": there is no such file.");
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string errors, warnings;
    const bool binary = path.extension() == ".glb";
    const bool loaded = binary ? loader.LoadBinaryFromFile(&model, &errors, &warnings, file)
                               : loader.LoadASCIIFromFile(&model, &errors, &warnings, file);
    if (!loaded) {
        const std::string first = errors.substr(0, errors.find('\n'));
        throw std::runtime_error(file + ": not a readable glTF file" +
                                 (first.empty() ? "." : " (" + first + ")."));
    }
    Scene scene;
    scene.name = path.stem().string();
    GltfReader reader{model, file, scene};
    readMaterials(reader);
    NodeWalk walk(reader, readMeshes(reader));
    if (model.scenes.empty())
        reader.fail("it has no scene");
    const int chosen = model.defaultScene >= 0 ? model.defaultScene : 0;
    for (int node : reader.at(model.scenes, chosen, "scenes").nodes)
        walk.visit(node, glm::dmat4(1));
    updateBounds(scene);
    return scene;
}

Scene loadScene(const std::string& nameOrPath) {
    if (auto scene = makeBuiltinScene(nameOrPath))
        return std::move(*scene);
    const std::string extension = std::filesystem::path(nameOrPath).extension().string();
    if (extension != ".gltf" && extension != ".glb")
        throw std::runtime_error("\"" + nameOrPath +
                                 "\" is neither a built-in scene nor a .gltf or .glb file.");
    return loadGltf(nameOrPath);
}

} // namespace harness
