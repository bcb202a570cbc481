#include "core/plan/traffic.h"

#include "core/base/checked.h"
#include "core/plan/access.h"

namespace agaa {

namespace {

struct Traffic {
    bool reads = false, writes = false;
};

Traffic trafficOf(const Access& access, const Pass& pass) {
    switch (access.use) {
    case Use::Uniform:
    case Use::StorageRead:
    case Use::Fetch:
    case Use::CopyFrom:
        return {.reads = true};
    case Use::StorageWrite: // it may read, too
    case Use::ImageWrite:
    case Use::Color:
    case Use::FetchedColor:
    case Use::CopyTo:
        return {.writes = true};
    case Use::Depth:
        return {.reads = !pass.draw().clearsDepth, .writes = pass.draw().state.depthWrite != 0};
    case Use::Indirect: // both access only a few words
    case Use::Condition:
        break;
    }
    return {};
}

// Returns the bytes of a surface that a pass uses.
uint64_t bytesUsed(const Plan& plan, const Pass& pass, const Resource& resource) {
    switch (pass.kind()) {
    case PassKind::Fill:
        return pass.fill().bytes ? pass.fill().bytes : resource.bytes;
    case PassKind::Copy:
        return plan.bytesOf(pass.copy());
    case PassKind::Compute: // a single lane or workgroup decides by a few words
        return pass.compute().dispatch.kind == DispatchKind::Items && pass.compute().dispatch.items == 1
                   ? 0
                   : resource.bytes;
    case PassKind::HostDraw:
        break;
    }
    return resource.bytes;
}

} // namespace

std::map<ResourceId, uint64_t> trafficOf(const Plan& plan, const Pass& pass) {
    std::map<ResourceId, Traffic> surfaces;
    for (const Access& access : accessesOf(pass)) {
        const Traffic traffic = trafficOf(access, pass);
        Traffic& surface = surfaces[access.resource];
        surface.reads |= traffic.reads;
        surface.writes |= traffic.writes;
    }
    std::map<ResourceId, uint64_t> bytes;
    for (const auto& [id, traffic] : surfaces) {
        const Resource& resource = plan.resources[id];
        if (!resource.isPerPixel())
            continue;
        bytes[id] = checkedMultiply(bytesUsed(plan, pass, resource), uint64_t(traffic.reads) + traffic.writes);
    }
    return bytes;
}

} // namespace agaa
