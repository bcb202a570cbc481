// The accesses of passes to resources. The usage flags, barriers and layouts of both graphics APIs are derived from
// them.
#pragma once

#include "core/plan/plan.h"

#include <vector>

namespace agaa {

enum class Use {
    Uniform,      // block
    StorageRead,  // block
    StorageWrite, // block, read and written
    Fetch,        // texture
    ImageWrite,   // image stores
    Color,        // target
    FetchedColor, // target that the shader also reads
    Depth,        // target; a pass that only compares depth may write the stencil
    CopyFrom,
    CopyTo,    // copied to or filled
    Indirect,  // arguments of a dispatch
    Condition, // predicate of a step (Step::predicateBuffer)
};

struct Access {
    ResourceId resource = noResource;
    Use use = Use::Uniform;
    bool isDraw = false; // by fragment shaders; otherwise by compute shaders

    bool writes() const { return isTarget() || use == Use::CopyTo || stores(); }
    bool reads() const { return !writes() || use == Use::FetchedColor; } // results of earlier passes or of this one
    bool isTarget() const { return use == Use::Color || use == Use::FetchedColor || use == Use::Depth; }
    bool stores() const { return use == Use::StorageWrite || use == Use::ImageWrite; } // by shaders
};
std::vector<Access> accessesOf(const Pass& pass);

} // namespace agaa
