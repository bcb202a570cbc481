#include "core/plan/techniques/gbuffer.h"

#include <algorithm>

namespace agaa {

namespace {

// Adds a draw into new attachments, which it clears, with the depth of `g`.
Pass& drawGBuffer(PlanBuilder& b, GBuffer& g, const Layout& layout, const char* name) {
    g.packing = packGBuffer(layout);
    for (size_t i = 0; i < g.packing.attachments.size(); ++i)
        g.attachments.push_back(b.image("gbuffer-" + std::to_string(i), g.packing.attachments[i], true));
    Pass& pass = b.hostDraw(name, AGAA_STAGE_GENERATION, AGAA_DRAW_PASS_GBUFFER, AGAA_SEGMENT_PREPASS);
    b.bindCommon(pass);
    pass.draw().state.colorAttachmentCount = uint32_t(g.attachments.size());
    pass.draw().colorTargets = g.attachments;
    pass.draw().depthTarget = g.depth;
    pass.draw().clearsColor = true;
    setFields(pass.constants, AGAA_SOURCE_DIFFUSE_R, g.packing.fields);
    return pass;
}

Pass& drawFirst(PlanBuilder& b, GBuffer& g, const Layout& layout, bool needsStencil) {
    g.depth = b.depth(needsStencil);
    Pass& pass = drawGBuffer(b, g, layout, "gbuffer");
    pass.draw().state.depthCompare = b.view().reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    pass.draw().state.depthWrite = 1;
    pass.draw().clearsDepth = true;
    b.bindSceneSamples = [&b, g](Pass& reader) { g.bind(b, reader); };
    return pass;
}

} // namespace

GBuffer makeGBuffer(PlanBuilder& b) {
    GBuffer g;
    if (b.view().hostGBuffer) {
        g.packing = packGBuffer(b.view().layout);
        b.bindSceneSamples = [&b, g](Pass& pass) { g.bind(b, pass); };
        return g;
    }
    drawFirst(b, g, b.view().layout, false);
    b.sceneAttachments = g.attachments;
    return g;
}

GBuffer drawNormalsAndDepth(PlanBuilder& b) {
    Layout layout = b.view().layout;
    for (const AgaaSemantic dropped :
         {AGAA_SEMANTIC_DIFFUSE, AGAA_SEMANTIC_SPECULAR, AGAA_SEMANTIC_ROUGHNESS, AGAA_SEMANTIC_EMISSIVE})
        layout.attributes[dropped] = {};
    GBuffer g;
    Pass& pass = drawFirst(b, g, layout, b.wantsStencil());
    pass.constants[AGAA_COUNTERS] = pass.constants[AGAA_CHECK_FACTS] = 0;
    std::erase_if(pass.bindings, [](const Binding& binding) { return binding.slot == host_slot::Counters; });
    return g;
}

GBuffer drawGBufferOver(PlanBuilder& b, ResourceId depth) {
    GBuffer g;
    g.depth = depth;
    Pass& pass = drawGBuffer(b, g, b.view().layout, "gbuffer of unfetched draws");
    pass.draw().state.depthCompare = AGAA_COMPARE_EQUAL;
    // The first pass shows the first of equal depths. Masks apply before this stencil test, because the shader's depth
    // and stencil tests are late. The test therefore includes masked materials.
    pass.draw().state.stencilTest = pass.draw().state.stencilTestMasked = b.keepsFirst();
    return g;
}

void GBuffer::bind(PlanBuilder& b, Pass& pass) const {
    setFields(pass.constants, AGAA_SOURCE_DIFFUSE_R, packing.fields);
    if (attachments.empty())
        return b.bindHostGBuffer(pass);
    b.bind(pass, slot::Depth, BindingType::Texture, depth);
    // Shaders declare four attachments. Slots that the layout does not need repeat the last one and are not read.
    for (uint32_t i = 0; i < 4; ++i)
        b.bind(pass, slot::GBuffer0 + i, BindingType::Texture,
               attachments[std::min<size_t>(i, attachments.size() - 1)]);
}

void bindGeometryMask(PlanBuilder& b, Pass& pass, ResourceId mask, ResourceId depth) {
    b.bind(pass, slot::Normals, BindingType::Texture, b.counts() ? mask : depth);
}

void GBuffer::bindDepth(PlanBuilder& b, Pass& pass) const {
    if (attachments.empty())
        return b.bindHostGBuffer(pass);
    b.bind(pass, slot::Depth, BindingType::Texture, depth);
    const Field& normal = packing.fields[ChannelNormalX];
    bindGeometryMask(b, pass, attachments[normal.word], depth);
    pass.constants[AGAA_COVERAGE_COMPONENT] = normal.shift;
}

} // namespace agaa
