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
        const bool isPart = pass.kind() == PassKind::Fill && pass.fill().bytes > 0;
        bytes[id] =
            checkedMultiply(isPart ? pass.fill().bytes : resource.bytes, uint64_t(traffic.reads) + traffic.writes);
    }
    return bytes;
}

} // namespace agaa
