#include "suite_host.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace agaa::conformance {

namespace {

constexpr uint32_t width = 64, height = 48;
constexpr float cameraAngle = 0.4f; // turn of the camera around y, so that shading space differs from view space

// Transforms from view space to shading space.
void rotateToShading(float* v) {
    const float c = std::cos(cameraAngle), s = std::sin(cameraAngle), x = v[0], z = v[2];
    v[0] = c * x + s * z;
    v[2] = -s * x + c * z;
}

struct Corner {
    float x, y, z;
};

// Adds a quadrilateral in view space, with the normal that faces the camera.
void addQuad(Scene& scene, const Corner (&corners)[4], const Surface& surface, float secondAlpha) {
    const Corner &a = corners[0], &b = corners[1], &d = corners[3];
    const float u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {d.x - a.x, d.y - a.y, d.z - a.z};
    float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float toEye = n[0] * a.x + n[1] * a.y + n[2] * a.z;
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) * (toEye > 0 ? -1.0f : 1.0f);
    for (float& component : n)
        component /= length;
    rotateToShading(n);
    for (const int i : {0, 1, 2, 0, 2, 3}) {
        Vertex vertex{};
        vertex.position[0] = corners[i].x;
        vertex.position[1] = corners[i].y;
        vertex.position[2] = corners[i].z;
        rotateToShading(vertex.position);
        std::memcpy(vertex.normal, n, sizeof n);
        std::memcpy(vertex.diffuse, surface.diffuse, sizeof vertex.diffuse);
        if (scene.size() % 6 >= 3)
            vertex.diffuse[3] = secondAlpha;
        vertex.roughness = surface.roughness;
        vertex.isMasked = surface.isMasked;
        scene.push_back(vertex);
    }
}

// Returns from back to front a wall, two tilted surfaces, and a cut-out whose second triangle is discarded.
Scene engineScene() {
    Scene scene;
    addQuad(scene, {{-8, -6, -9}, {8, -6, -9}, {8, 6, -11}, {-8, 6, -11}}, {.diffuse = {0.8f, 0.7f, 0.2f, 1}}, 1);
    addQuad(scene, {{-3, -2, -6}, {1.5f, -2, -5}, {1.5f, 2.5f, -5}, {-3, 2.5f, -6}}, {.diffuse = {0.2f, 0.4f, 0.9f, 1}},
            1);
    addQuad(scene, {{-0.5f, -1.5f, -3.5f}, {2, -1.2f, -4}, {2, 1, -4}, {-0.5f, 0.7f, -3.5f}},
            {.diffuse = {0.9f, 0.1f, 0.3f, 1}}, 1);
    addQuad(scene, {{-1.2f, -1, -2.5f}, {0.6f, -1, -2.5f}, {0.6f, 0.8f, -2.5f}, {-1.2f, 0.8f, -2.5f}},
            {.diffuse = {0.1f, 0.8f, 0.4f, 1}, .isMasked = true}, 0);
    return scene;
}

void setCamera(AgaaFrame& frame, bool fromMinusOne) {
    const float c = std::cos(cameraAngle), s = std::sin(cameraAngle);
    const float view[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1};
    std::copy(view, view + 16, frame.view);
    const float nearest = 0.5f, farthest = 20.0f, low = fromMinusOne ? -1.0f : 0.0f, depth = farthest - nearest;
    std::fill(frame.projection, frame.projection + 16, 0.0f);
    frame.projection[0] = 1.6f * float(height) / float(width);
    frame.projection[5] = -1.6f;
    frame.projection[10] = (low * nearest - farthest) / depth;
    frame.projection[11] = -1.0f;
    frame.projection[14] = (low - 1.0f) * nearest * farthest / depth;
}

} // namespace

SuiteHost::SuiteHost(Test& test, Device& device)
    : sdk_(test.sdk), device_(device), context_(test), scene_(engineScene()), opaque_(scene_) {
    std::erase_if(opaque_, [](const Vertex& vertex) { return vertex.isMasked != 0; });
    const AgaaSceneFacts initialFacts = AGAA_SCENE_FACTS_INIT;
    const AgaaViewDesc initialDesc = AGAA_VIEW_DESC_INIT;
    facts_ = initialFacts;
    desc_ = initialDesc;
    desc_.width = width;
    desc_.height = height;
    desc_.facts = &facts_;
    desc_.flags = device.viewFlags();
    device.setOutput(width, height);
    host_ = {};
    host_.structSize = sizeof host_;
    host_.api = device.backend() == Backend::Vulkan ? AGAA_CONFORMANCE_VULKAN : AGAA_CONFORMANCE_OPENGL;
    host_.user = this;
    host_.context = context_.get();
    host_.view = &desc_;
    host_.prepareView = prepareView;
    host_.releaseView = releaseView;
    host_.renderFrame = renderFrame;
    host_.takeMessages = device.testsMessages() ? takeMessages : nullptr;
    host_.hideMasked = hideMasked;
}

AgaaResult SuiteHost::prepareView(void* user, AgaaView view) {
    auto& self = *static_cast<SuiteHost*>(user);
    try {
        self.device_.adopt(self.context_.get(), view);
        self.device_.prepare(self.sdk_, view);
    } catch (const std::exception&) {
        return AGAA_ERROR_CALLBACK;
    }
    return AGAA_OK;
}

void SuiteHost::releaseView(void* user, AgaaView view) { static_cast<SuiteHost*>(user)->device_.forget(view); }

AgaaResult SuiteHost::renderFrame(void* user, AgaaView view, AgaaFrame* frame, float* outPixels) {
    auto& self = *static_cast<SuiteHost*>(user);
    setCamera(*frame, self.desc_.flags & AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE);
    const AgaaResult result =
        self.device_.record(self.sdk_, view, *frame, self.isMaskedHidden_ ? self.opaque_ : self.scene_);
    if (result == AGAA_OK) {
        const std::vector<float> pixels = self.device_.readOutput();
        std::copy(pixels.begin(), pixels.end(), outPixels);
    }
    return result;
}

void SuiteHost::hideMasked(void* user, uint32_t isHidden) {
    static_cast<SuiteHost*>(user)->isMaskedHidden_ = isHidden != 0;
}

const char* SuiteHost::takeMessages(void* user) {
    auto& self = *static_cast<SuiteHost*>(user);
    self.messages_.clear();
    for (const std::string& message : self.device_.takeMessages()) {
        std::string line = message;
        std::replace(line.begin(), line.end(), '\n', ' ');
        self.messages_ += line + '\n';
    }
    return self.messages_.empty() ? nullptr : self.messages_.c_str();
}

} // namespace agaa::conformance
