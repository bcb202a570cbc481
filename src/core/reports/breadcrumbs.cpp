#include "core/reports/breadcrumbs.h"

#include "core/base/error.h"

#include <cstring>

namespace agaa {

// The memory of a lost device may hold anything: passes that the plan lacks count as none.
static AgaaBreadcrumb describe(const Plan& plan, const Breadcrumb& crumb) {
    AgaaBreadcrumb out{};
    if (crumb.frame == 0 || crumb.pass >= plan.passes.size())
        return out;
    std::strncpy(out.name, plan.passes[crumb.pass].name.c_str(), sizeof out.name - 1);
    out.frameIndex = crumb.frame;
    out.pass = crumb.pass;
    out.repetition = crumb.repetition;
    return out;
}

AgaaResult breadcrumbs(const ViewState& view, AgaaBreadcrumbs& out) {
    require(view.plan.breadcrumbs != noResource, AGAA_ERROR_WRONG_ORDER,
            "the view does not record breadcrumbs; create it with AGAA_CONFIG_BREADCRUMBS.");
    const BreadcrumbBuffer read = view.readBreadcrumbs();
    const AgaaBreadcrumb begun = describe(view.plan, read.begun);
    if (begun.frameIndex == 0)
        return AGAA_NOT_READY;
    out.begun = begun;
    out.ended = describe(view.plan, read.ended);
    return AGAA_OK;
}

} // namespace agaa
