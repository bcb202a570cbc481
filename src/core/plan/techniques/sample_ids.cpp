#include "core/plan/techniques/sample_ids.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/plan/techniques/triangle_expansion.h"
#include "shaders/tables/layouts.inc"

namespace agaa {

void Ids::bindDepth(PlanBuilder& b, Pass& pass) const {
    if (b.visibleSamples != noResource)
        b.bind(pass, slot::Visible, BindingType::StorageBuffer, b.visibleSamples);
    else
        b.bind(pass, slot::Depth, BindingType::Texture, prepass.depth);
}

void Ids::bindGeometry(PlanBuilder& b, Pass& pass) const {
    bindDepth(b, pass);
    if (b.visibleSamples != noResource)
        return;
    bindGeometryMask(b, pass, prepass.values, prepass.depth);
    pass.constants[AGAA_COVERAGE_COMPONENT] = AGAA_ANY_COMPONENT;
}

void Ids::bind(PlanBuilder& b, Pass& pass) const {
    b.bindHostFetch(pass);
    if (b.visibleSamples == noResource)
        b.bind(pass, slot::Ids, BindingType::Texture, prepass.values);
    if (unfetched)
        unfetched->bind(b, pass);
    else
        bindDepth(b, pass);
}

Ids drawIds(PlanBuilder& b) {
    Ids ids{drawPrepass(b, b.view().someUnfetched && b.wantsStencil(), "ids", Format::RGBA8, SampleContent::Id), {}};
    if (b.view().someUnfetched) {
        require(!b.hasFact(AGAA_FACT_CUSTOM_DEPTH), AGAA_ERROR_UNSUPPORTED,
                "materials that write depth or discard on their own (AGAA_FACT_CUSTOM_DEPTH) cannot be drawn a second "
                "time at equal depth, which AGAA_FETCH_NOT_ALL_DRAWS asks for.");
        if (b.wantsStencil() && !b.keepsFirst())
            b.note("no format of depth and stencil: of unfetched draws at equal depth the last is shown.");
        ids.unfetched = drawGBufferOver(b, ids.prepass.depth);
    }
    return ids;
}

bool expandsIds(const ResolvedView& view) {
    const bool needsDraw = view.someUnfetched || view.accumulates() || view.facts.flags & AGAA_FACT_CUSTOM_DEPTH;
    return view.maxTriangles > 0 && !needsDraw;
}

static ResourceId makeVisibleSamples(PlanBuilder& b) {
    const uint64_t samples = checkedMultiply(uint64_t(b.view().width) * b.view().height, b.view().samples);
    const uint64_t bytes = checkedMultiply(samples, 8);
    if (bytes > b.caps().maxStorageRange)
        fail(AGAA_ERROR_TOO_LARGE,
             format("the samples that compute passes find need %llu bytes, and one storage buffer of the device has "
                    "%llu; with 0 as AgaaFetchFunction::maxTriangles the host draws them.",
                    static_cast<unsigned long long>(bytes), static_cast<unsigned long long>(b.caps().maxStorageRange)));
    return b.itemBuffer("visible-samples", samples, 8);
}

Ids expandIds(PlanBuilder& b) {
    b.plan.depthFormat = Format::D32; // later passes read depths of this precision
    b.visibleSamples = makeVisibleSamples(b);
    b.fill("clear samples", AGAA_STAGE_PREPASS, b.visibleSamples, AGAA_SEGMENT_PREPASS);
    TriangleExpansion expansion{.stage = AGAA_STAGE_PREPASS, .segment = AGAA_SEGMENT_PREPASS};
    expansion.defines = "#define AGAA_COVERS_TARGET 1\n#define AGAA_COVERS_BY_TABLE 0\n";
    expansion.bind = [](Pass&) {};
    expansion.bindFragments = [&b](Pass& pass) {
        b.bind(pass, slot::Visible, BindingType::StorageBuffer, b.visibleSamples, true);
    };
    expansion.count(b);
    const auto find = [&](const char* step) {
        expansion.expand(b, dispatchOf(expansion.triangles, AGAA_TRIANGLE_DISPATCH), step);
    };
    find(" for depths");
    static_assert(AGAA_FINDS_DEPTHS == 0, "the word is at the beginning of the buffer");
    b.fill("begin ids", AGAA_STAGE_PREPASS, expansion.triangles, AGAA_SEGMENT_PREPASS).fill().bytes = 4;
    find(" for ids");
    return {};
}

} // namespace agaa
