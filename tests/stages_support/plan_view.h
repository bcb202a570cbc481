// Views of plans that no technique of the library makes.
#pragma once

#include "core/abi/handles.h"
#include "core/plan/plan_builder.h"
#include "core/plan/planner.h"

namespace agaa::test {

// build: writes the plan of a view that desc describes.
template <class View, class Context>
AgaaView makePlanView(AgaaContext context, const AgaaViewDesc& desc, void (*build)(PlanBuilder&)) {
    const agaa::ViewSettings settings = resolveView(&desc, techniques());
    PlanBuilder builder(resolveForDevice(settings, context->caps, techniques()), context->caps,
                        context->framesInFlight);
    build(builder);
    return createView<View>(static_cast<Context&>(*context), settings, builder.finish());
}

} // namespace agaa::test
