#include "core/plan/techniques/sample_ids.h"

#include "core/base/error.h"

namespace agaa {

void Ids::bind(PlanBuilder& b, Pass& pass) const {
    b.bindHostFetch(pass);
    b.bind(pass, slot::Ids, BindingType::Texture, prepass.values);
    if (unfetched)
        unfetched->bind(b, pass);
    else
        b.bind(pass, slot::Depth, BindingType::Texture, prepass.depth);
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

} // namespace agaa
