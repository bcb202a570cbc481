#include "ids_view.h"

#include "fetch_text.h"

namespace agaa::test {

static constexpr const char* storageText = R"(
layout(std430, set = 1, binding = 0) readonly buffer Vertices { vec4 data[]; } hostVertices;
layout(std430, set = 1, binding = 1) readonly buffer Materials { HostMaterial data[]; } hostMaterials;
vec3 hostPosition(uint vertex) { return hostVertices.data[2u * vertex].xyz; }
HostMaterial hostMaterial(uint primitive) { return hostMaterials.data[primitive]; }
uint hostSeed(HostMaterial h) { return floatBitsToUint(h.geometricNormal.w); }
)";

ViewSettings settingsFor(uint32_t n, uint32_t c, uint32_t tier) {
    ViewSettings settings;
    settings.config.samples = n;
    settings.config.aggregates = c;
    settings.config.generationTier = tier;
    settings.config.flags = AGAA_CONFIG_READBACK | AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

IdsView::IdsView(StageContext& context, ViewSettings settings, const Shot& shot)
    : set_(sharedDevice(), 2, VK_SHADER_STAGE_COMPUTE_BIT), text_(fetchText(settings, storageText, shot)),
      function_(fetchFunction(settings, text_, shot)) {
    function_.descriptorSetLayout = (uint64_t)set_.layout();
    settings.chained = &function_;
    view_ = std::make_unique<StageView>(context, settings);
    setTriangles(shot.triangles);
}

void IdsView::setTriangles(const std::vector<Triangle>& triangles) {
    view_->setTriangles(triangles);
    set_.write({view_->vertices(), view_->materials()});
}

void IdsView::render(const AgaaFrame& frame) {
    view_->render(frame, [&](AgaaVkFrame& vk) { bind(vk); });
}

harness::Image IdsView::render(const AgaaLight& light, const AgaaShadow* shadow) {
    AgaaFrame frame = view_->frame();
    setLight(frame, light, shadow);
    addAmbient(frame);
    render(frame);
    return view_->image();
}

harness::Image drawn(StageView& view, const std::vector<Triangle>& triangles) {
    view.setTriangles(triangles);
    const AgaaLight light = sun();
    AgaaFrame frame = view.frame();
    setLight(frame, light);
    addAmbient(frame);
    view.render(frame);
    return view.image();
}

Difference compare(const harness::Image& a, const harness::Image& b) {
    return compare(std::span(a.rgb), std::span(b.rgb));
}

} // namespace agaa::test
