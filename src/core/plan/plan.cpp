#include "core/plan/plan.h"

#include "core/base/names.h"
#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/plan/arena.h"

#include <algorithm>

namespace agaa {

uint32_t Plan::depthBits() const {
    if (depthFormat == Format::None)
        return view.depthBits;
    return depthFormat == Format::D24S8 ? 24 : 0;
}

uint64_t Plan::totalBytes() const {
    uint64_t total = 0;
    for (const Resource& resource : resources)
        if (resource.isPerPixel())
            total = checkedAdd(total, resource.bytes);
    return total;
}

uint64_t Plan::constantBytes() const {
    uint64_t total = 0;
    for (const Resource& resource : resources)
        if (!resource.isPerPixel() && !resource.isImported())
            total = checkedAdd(total, checkedMultiply(resource.bytes, resource.copies));
    return total;
}

uint64_t Plan::peakBytes() const {
    std::vector<ArenaBlock> blocks;
    for (const Resource& resource : resources)
        if (resource.isPerPixel())
            blocks.push_back({resource.bytes, 1, resource.firstPass, resource.lastPass, 0});
    return aliases ? placeBlocks(blocks) : totalBytes();
}

uint32_t Plan::geometryPasses() const {
    return uint32_t(std::count_if(passes.begin(), passes.end(),
                                  [](const Pass& pass) { return pass.kind() == PassKind::HostDraw; }));
}

std::pair<uint32_t, uint32_t> Plan::groups(const Dispatch& dispatch, FrameExtent extent) const {
    const auto divide = [](uint64_t count, uint64_t by) { return uint32_t((count + by - 1) / by); };
    if (dispatch.kind == DispatchKind::Pixels)
        return {divide(extent.width, dispatch.groupSide), divide(extent.height, dispatch.groupSide)};
    const uint32_t groups = divide(dispatch.items, itemsPerGroup);
    return {std::min(groups, groupsPerRow), divide(groups, groupsPerRow)};
}

uint64_t Plan::bytesOf(const CopyPart& copy) const { return copy.bytes ? copy.bytes : resources[copy.source].bytes; }

std::vector<Step> Plan::steps() const {
    std::vector<Step> list;
    auto repeat = repeats.begin();
    for (uint32_t i = 0; i < passes.size();) {
        if (repeat == repeats.end() || i < repeat->firstPass) {
            list.push_back({i++, 0, true, true});
            continue;
        }
        for (uint32_t batch = 0; batch < repeat->times; ++batch)
            for (uint32_t pass = repeat->firstPass; pass <= repeat->lastPass; ++pass) {
                list.push_back({pass, batch, batch == 0, batch + 1 == repeat->times});
                const bool isDraw = passes[pass].kind() == PassKind::HostDraw;
                if (pass < repeat->lastPass && (batch > 0 || isDraw)) {
                    list.back().predicateBuffer = repeat->predicateBuffer;
                    list.back().predicateOffset = repeat->predicateOffset;
                }
            }
        i = repeat->lastPass + 1;
        ++repeat;
    }
    return list;
}

void checkRepeats(const Plan& plan) {
    for (const Repeat& repeat : plan.repeats) {
        if (repeat.predicateBuffer == noResource)
            continue;
        for (uint32_t i = repeat.firstPass; i <= repeat.lastPass; ++i) {
            const Pass& pass = plan.passes[i];
            require(pass.kind() == PassKind::Compute || pass.kind() == PassKind::HostDraw, AGAA_ERROR_INTERNAL,
                    "a repetition that ends early fills or copies.");
            require(pass.kind() == PassKind::Compute || (!pass.draw().clearsColor && !pass.draw().clearsDepth),
                    AGAA_ERROR_INTERNAL, "a repetition that ends early clears targets.");
        }
        const std::vector<Binding>& bindings = plan.passes[repeat.lastPass].bindings;
        require(std::any_of(bindings.begin(), bindings.end(),
                            [&](const Binding& b) { return b.resource == repeat.predicateBuffer && b.writes; }),
                AGAA_ERROR_INTERNAL, "the last pass of a repetition does not write the word that ends it.");
    }
}

ResourceId Plan::surface(const char* surfaceName) const {
    for (ResourceId id = 0; id < resources.size(); ++id)
        if (resources[id].isPerPixel() && resources[id].name == surfaceName)
            return id;
    fail(AGAA_ERROR_INVALID_ARGUMENT, format("the view has no surface called \"%s\".", printable(surfaceName).c_str()));
}

} // namespace agaa
