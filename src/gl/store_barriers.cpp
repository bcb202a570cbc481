#include "gl/store_barriers.h"

#include "core/plan/access.h"

namespace agaa::gl {

static GLbitfield barrierBit(const Access& access, bool drawsUseImages) {
    switch (access.use) {
    case Use::Uniform:
        return GL_UNIFORM_BARRIER_BIT;
    case Use::StorageRead:
    case Use::StorageWrite:
        return access.isDraw && drawsUseImages ? GL_SHADER_IMAGE_ACCESS_BARRIER_BIT : GL_SHADER_STORAGE_BARRIER_BIT;
    case Use::ImageWrite:
        return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case Use::Fetch:
        return GL_TEXTURE_FETCH_BARRIER_BIT;
    case Use::Color:
    case Use::FetchedColor:
    case Use::Depth:
        return GL_FRAMEBUFFER_BARRIER_BIT;
    case Use::CopyFrom:
    case Use::CopyTo:
    case Use::Condition: // read by the CPU
        return GL_BUFFER_UPDATE_BARRIER_BIT;
    case Use::Indirect:
        break;
    }
    return GL_COMMAND_BARRIER_BIT;
}

GLbitfield StoreBarriers::before(const Plan& plan, const Pass& pass, bool drawsUseImages) {
    GLbitfield bits = 0;
    for (const Access& access : accessesOf(pass)) {
        const GLbitfield bit = barrierBit(access, drawsUseImages);
        const State& state = states_[access.resource];
        if (plan.resources[access.resource].isImported())
            continue;
        if ((state.stored && !(state.visible & bit)) || (state.read && access.stores()))
            bits |= bit;
    }
    for (State& state : states_) {
        state.visible |= bits;
        state.read = state.read && !bits;
    }
    return bits;
}

void StoreBarriers::after(const Plan& plan, const Pass& pass) {
    const std::vector<Access> accesses = accessesOf(pass);
    for (const Access& access : accesses)
        if (access.use == Use::StorageRead || access.use == Use::Fetch || access.use == Use::Indirect)
            states_[access.resource].read = true;
    for (const Access& access : accesses)
        if (access.stores() && !plan.resources[access.resource].isImported())
            states_[access.resource] = {true, false, 0};
}

} // namespace agaa::gl
