#include "ids_view.h"

#include <algorithm>
#include <cmath>

namespace agaa::test {
namespace {

std::string matrixText(const glm::mat4& m) {
    std::string text = "mat4(";
    for (int i = 0; i < 16; ++i) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.9g", i ? ", " : "", double(m[i / 4][i % 4]));
        text += number;
    }
    return text + ")";
}

double toneMapped(float x) { return std::pow(double(x) / (1 + double(x)), 1 / 2.2); }

std::string fetchText(const ViewSettings& settings, const char* more) {
    return "const mat4 hostClip = " + matrixText(settings.projection * settings.view) + R"(;
layout(std430, set = 1, binding = 0) readonly buffer Vertices { vec4 data[]; } hostVertices;
struct HostMaterial { vec4 diffuse, specular, emissive, normal, geometricNormal; };
layout(std430, set = 1, binding = 1) readonly buffer Materials { HostMaterial data[]; } hostMaterials;
vec4 hostVertex(uint i) { return hostClip * vec4(hostVertices.data[2u * i].xyz, 1.0); }
void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    a = hostVertex(3u * primitive);
    b = hostVertex(3u * primitive + 1u);
    c = hostVertex(3u * primitive + 2u);
}
void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {
    HostMaterial h = hostMaterials.data[p.primitive];
    m.diffuse = p.draw == )" +
           std::to_string(drawNumber) + R"(u ? h.diffuse.xyz : vec3(1.0, 0.0, 1.0);
    m.specular = h.specular.xyz;
    m.emissive = h.emissive.xyz;
    m.normal = h.normal.xyz;
    m.alpha2 = h.normal.w;
)" + more + "}\n";
}

} // namespace

ViewSettings settingsFor(uint32_t n, uint32_t c, uint32_t tier) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.generationTier = tier;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

IdsView::IdsView(StageContext& context, ViewSettings settings, const std::vector<Triangle>& triangles, const char* more,
                 const void* chained, uint32_t announced, uint64_t flags)
    : set_(sharedDevice(), 2, VK_SHADER_STAGE_COMPUTE_BIT), text_(fetchText(settings, more)) {
    function_.glsl = text_.c_str();
    function_.maxDraws = drawNumber + 1;
    function_.maxPrimitives = announced ? announced : uint32_t(triangles.size());
    function_.descriptorSetLayout = (uint64_t)set_.layout();
    function_.pNext = chained;
    function_.flags = flags;
    settings.chained = &function_;
    view_ = std::make_unique<StageView>(context, settings);
    view_->setTriangles(triangles);
    set_.write({view_->vertices(), view_->materials()});
}

harness::Image IdsView::render(const AgaaLight& light, const AgaaShadow* shadow) {
    AgaaFrame frame = view_->frame();
    frame.lights = &light;
    frame.lightCount = 1;
    frame.shadows = shadow;
    frame.shadowCount = shadow ? 1 : 0;
    frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 0.25f;
    view_->render(frame, [&](AgaaVkFrame& vk) { vk.functionSet = (uint64_t)set_.get(); });
    return view_->image();
}

harness::Image drawn(StageView& view, const std::vector<Triangle>& triangles) {
    view.setTriangles(triangles);
    const AgaaLight light = sun();
    AgaaFrame frame = view.frame();
    frame.lights = &light;
    frame.lightCount = 1;
    frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 0.25f;
    view.render(frame);
    return view.image();
}

Difference compare(const harness::Image& a, const harness::Image& b) {
    double sum = 0;
    size_t far = 0;
    for (size_t p = 0; p < a.pixelCount(); ++p) {
        double most = 0;
        for (size_t i = 3 * p; i < 3 * p + 3; ++i) {
            const double d = std::fabs(toneMapped(a.rgb[i]) - toneMapped(b.rgb[i]));
            sum += d * d;
            most = std::max(most, d);
        }
        far += most > 24.0 / 255;
    }
    return {-10 * std::log10(std::max(sum / double(a.rgb.size()), 1e-20)), double(far) / double(a.pixelCount())};
}

} // namespace agaa::test
