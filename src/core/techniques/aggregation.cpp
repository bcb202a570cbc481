#include "core/techniques/aggregation.h"

#include "core/checked.h"

namespace agaa {

void Prepass::bind(PlanBuilder& b, Pass& pass) const {
    b.bind(pass, slot::Depth, BindingType::Texture, depth);
    b.bind(pass, slot::Surface0, BindingType::Texture, normals);
}

Prepass drawPrepass(PlanBuilder& b, bool stencil) {
    const Prepass s{b.depth(stencil), b.image("normals", Format::RG8, true)};
    Pass& prepass = b.hostDraw("prepass", AGAA_STAGE_PREPASS, AGAA_DRAW_PASS_VISIBILITY,
                               AGAA_SEGMENT_PREPASS);
    b.bindCommon(prepass);
    prepass.drawState.depthCompare = b.plan.reversedZ ? AGAA_COMPARE_GREATER : AGAA_COMPARE_LESS;
    prepass.drawState.depthWrite = 1;
    prepass.drawState.colorAttachmentCount = 1;
    prepass.colorTargets = {s.normals};
    prepass.depthTarget = s.depth;
    prepass.clearsColor = prepass.clearsDepth = true;
    return s;
}

ResourceId aggregateBuffer(PlanBuilder& b, const AggregateRecord& record) {
    b.plan.bytesPerAggregate = 4 * record.stride;
    return b.pixelBuffer("aggregates", checkedMultiply(b.plan.aggregates, 4 * record.stride));
}

void setRecord(Pass& pass, const AggregateRecord& record) {
    setFields(pass.constants, AGAA_FIELD_DIFFUSE_R, record.packing.fields);
    pass.constants[AGAA_WORDS] = record.packing.words;
    pass.constants[AGAA_STRIDE] = record.stride;
    pass.constants[AGAA_FIELD_COVERAGE] = record.packing.coverage.constant();
    pass.constants[AGAA_FOLDED_ROUGHNESS] = record.layout.foldsRoughness();
    pass.constants[AGAA_YCBCR_SPECULAR] = record.layout.specularIsYCbCr();
}

bool wantsStencil(const PlanBuilder& b) { return !(b.plan.config.flags & AGAA_CONFIG_NO_STENCIL); }

void drawAggregates(PlanBuilder& b, const Prepass& prepass, const AggregateRecord& record,
                    ResourceId metadata, ResourceId aggregates) {
    const bool stencil = wantsStencil(b) && hasStencil(b.plan.depthFormat);
    if (wantsStencil(b) && !stencil)
        b.note("no format of depth and stencil: of equal depths the first to come is kept, which is "
               "not repeatable.");
    const bool perSample = b.plan.generationTier == AGAA_TIER_PER_SAMPLE && b.plan.hwSamples > 1;
    Pass& draw = b.hostDraw("generate aggregates", AGAA_STAGE_GENERATION,
                            AGAA_DRAW_PASS_AGGREGATE, AGAA_SEGMENT_GENERATION);
    b.bindCommon(draw);
    draw.drawState.depthCompare = AGAA_COMPARE_EQUAL;
    draw.drawState.stencilTest = stencil;
    // A masked fragment may pass depth and stencil where its mask has no sample; were it to take the
    // stencil, the coplanar fragment that owns the sample would be refused.
    draw.drawState.stencilTestMasked = 0;
    draw.drawState.sampleShading = perSample;
    draw.depthTarget = prepass.depth;
    if (metadata != noResource)
        b.bind(draw, host_slot::Metadata, BindingType::Texture, metadata);
    b.bind(draw, host_slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    if (!perSample && b.plan.hwSamples > 1)
        draw.extensions.push_back("post_depth_coverage");
    setRecord(draw, record);
}

void gatherAggregates(PlanBuilder& b, const GBuffer& gbuffer, const AggregateRecord& record,
                      ResourceId metadata, ResourceId aggregates, const char* permutation) {
    Pass& gather = b.compute("gather aggregates", AGAA_STAGE_GENERATION, "gather", permutation,
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(gather);
    gbuffer.bind(b, gather);
    if (metadata != noResource)
        b.bind(gather, slot::Metadata, BindingType::Texture, metadata);
    b.bind(gather, slot::Aggregates, BindingType::StorageBuffer, aggregates, true);
    setRecord(gather, record);
}

void shadeAggregates(PlanBuilder& b, const AggregateRecord& record, const Generation& generation,
                     const char* permutation) {
    Pass& shade = b.compute("shade aggregates", AGAA_STAGE_SHADING, "shade_aggregates", permutation,
                            AGAA_SEGMENT_SHADING);
    b.bindCommon(shade);
    b.bindLighting(shade);
    b.bindOutput(shade);
    b.bind(shade, slot::Depth, BindingType::Texture, generation.depth);
    b.bind(shade, slot::Aggregates, BindingType::StorageBuffer, generation.aggregates);
    if (b.counts())
        b.bind(shade, slot::Surface0, BindingType::Texture, generation.coverage);
    shade.constants[AGAA_COVERAGE_COMPONENT] = generation.coverageComponent;
    setRecord(shade, record);
    b.copyCounters();
}

Generation generationOf(const Prepass& prepass, ResourceId aggregates) {
    return {prepass.depth, aggregates, prepass.normals, 0};
}

Generation generationOf(const GBuffer& gbuffer, ResourceId aggregates) {
    const Field& normal = gbuffer.packing.fields[ChannelNormalX];
    return {gbuffer.depth, aggregates, gbuffer.attachments[normal.word], normal.shift};
}

} // namespace agaa
