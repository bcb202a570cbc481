#include "core/plan/planner.h"

#include "core/plan/plan_builder.h"
#include "core/plan/resolved_outputs.h"
#include "core/plan/techniques/accumulation.h"
#include "core/view/resolved_view.h"

namespace agaa {

AgaaDeviceCaps idealDevice() {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.sampleCounts = 0x3F;
    caps.maxImageSize = 1u << 20;
    caps.maxStorageRange = UINT64_C(1) << 48;
    caps.maxSharedBytes = 49152;
    caps.subgroupSize = 32;
    caps.flags = AGAA_DEVICE_POST_DEPTH_COVERAGE | AGAA_DEVICE_FRAGMENT_ATOMICS | AGAA_DEVICE_SAMPLE_RATE_SHADING |
                 AGAA_DEVICE_DYNAMIC_RENDERING | AGAA_DEVICE_STORAGE_FORMATS | AGAA_DEVICE_NV_MIXED_SAMPLES |
                 AGAA_DEVICE_D24S8 | AGAA_DEVICE_D32S8 | AGAA_DEVICE_GEOMETRY_SHADERS | AGAA_DEVICE_FRAGMENT_INTERLOCK |
                 AGAA_DEVICE_FRAMEBUFFER_FETCH | AGAA_DEVICE_SAMPLE_LOCATIONS | AGAA_DEVICE_NV_MULTICAST;
    return caps;
}

Plan makePlan(const ViewSettings& settings, const AgaaDeviceCaps& caps, uint32_t framesInFlight) {
    PlanBuilder builder(resolveForDevice(settings, caps, techniques()), caps, framesInFlight);
    settings.technique->build(builder);
    if (builder.plan.runnable) {
        if (builder.view().accumulates())
            accumulateFrames(builder);
        resolveOutputs(builder);
        builder.copyCounters();
        builder.addBreadcrumbs();
    }
    return builder.finish();
}

} // namespace agaa
