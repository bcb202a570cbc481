// What passes do with resources. Usage flags, barriers and layouts of all graphics APIs follow from it.
#pragma once

#include "core/plan/plan.h"

#include <vector>

namespace agaa {

enum class Use {
    Uniform,     // block
    StorageRead, // block
    StorageWrite, // block, read and written
    Fetch,       // texture
    ImageWrite,  // image stores
    Color,       // target
    FetchedColor, // target whose contents the shader reads, too
    Depth,       // target: the stencil is written where depth is only compared
    CopyFrom,
    CopyTo,      // or filled
    Indirect,    // arguments of a dispatch
    Condition,   // word that says whether a step has anything to do (Step::predicateBuffer)
};

struct Access {
    ResourceId resource = noResource;
    Use use = Use::Uniform;
    bool isDraw = false; // by fragments, else by compute shaders

    bool writes() const { return isTarget() || use == Use::CopyTo || stores(); }
    bool reads() const { return !writes() || use == Use::FetchedColor; } // what earlier passes left, or the same pass
    bool isTarget() const { return use == Use::Color || use == Use::FetchedColor || use == Use::Depth; }
    bool stores() const { return use == Use::StorageWrite || use == Use::ImageWrite; } // of shaders
};
std::vector<Access> accessesOf(const Pass& pass);

} // namespace agaa
