// `sbaa`: prepass, selection of the surfaces that cover most, their attributes, shading once each (Salvi and
// Vidimce 2012, merge mode).
#include "core/techniques/aggregation.h"
#include "core/techniques/techniques.h"

#include <algorithm>

namespace agaa {

namespace {

// A surface keeps one sample's attributes, at the precision that samples have.
AggregateRecord recordOf(const PlanBuilder& b) {
    Layout layout = b.plan.layout;
    for (AgaaLayoutAttribute& attribute : layout.attributes) {
        attribute.encoding = AGAA_ENCODING_UNORM;
        attribute.aggregateBits = std::max(attribute.sampleBits, 6u);
    }
    const AggregatePacking packing = packAggregate(layout, 1);
    const uint32_t ownWords = b.plan.samples > 16 ? 2 : 1; // of src/shaders/math/records.glsl
    return {layout, packing, packing.words + ownWords};
}

template <class Samples>
void selectSurfaces(PlanBuilder& b, const Samples& samples, const AggregateRecord& record,
                    ResourceId surfaces) {
    Pass& select = b.compute("select surfaces", AGAA_STAGE_DEFINITION, "select", "mg",
                             AGAA_SEGMENT_GENERATION);
    b.bindCommon(select);
    samples.bind(b, select);
    b.bind(select, slot::Aggregates, BindingType::StorageBuffer, surfaces, true);
    setRecord(select, record);
}

// The papers' memory (AGAA section 5.4 and its slides): nine bytes a sample, and the G-buffer of a sample
// and two bytes more a surface.
void buildNative(PlanBuilder& b) {
    drawPrepass(b, true);
    b.image("primitive-ids", Format::R8, true);
    b.image("depth-slopes", Format::RG8, true);
    uint64_t bytes = bytesPerTexel(Format::R16U);
    const GBufferPacking packing = packGBuffer(b.plan.layout);
    for (size_t i = 0; i < packing.attachments.size(); ++i) {
        b.modelSurface("surface-gbuffer-" + std::to_string(i), packing.attachments[i], b.plan.aggregates);
        bytes += bytesPerTexel(packing.attachments[i]);
    }
    b.modelSurface("surface-data", Format::R16U, b.plan.aggregates);
    b.plan.bytesPerAggregate = uint32_t(bytes);
}

// A second geometry pass: fragments that own a surface's sample leave their attributes.
void buildTwoPasses(PlanBuilder& b) {
    const AggregateRecord record = recordOf(b);
    const Prepass prepass = drawPrepass(b, wantsStencil(b));
    const ResourceId surfaces = aggregateBuffer(b, record);
    selectSurfaces(b, prepass, record, surfaces);
    drawAggregates(b, prepass, record, noResource, surfaces);
    shadeAggregates(b, record, generationOf(prepass, surfaces), "mscbr1");
}

void buildFromGBuffer(PlanBuilder& b) {
    const AggregateRecord record = recordOf(b);
    const GBuffer gbuffer = drawGBuffer(b);
    const ResourceId surfaces = aggregateBuffer(b, record);
    selectSurfaces(b, gbuffer, record, surfaces);
    gatherAggregates(b, gbuffer, record, noResource, surfaces, "ma0r1");
    shadeAggregates(b, record, generationOf(gbuffer, surfaces), "mscbr1");
}

void build(PlanBuilder& b) {
    b.defaultSurface(0.9f, 1.0f, 1.0f);
    switch (b.plan.generationTier) {
    case AGAA_TIER_NV_MIXED_SAMPLES:
        return buildNative(b);
    case AGAA_TIER_GBUFFER:
        return buildFromGBuffer(b);
    default:
        return buildTwoPasses(b);
    }
}

} // namespace

const Technique sbaaTechnique = {"sbaa", 6, true, build};

} // namespace agaa
