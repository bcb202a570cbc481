#include "gl/store_barriers.h"

namespace agaa::gl {

static GLbitfield usageBit(BindingType type, bool asImage) {
    switch (type) {
    case BindingType::UniformBuffer:
        return GL_UNIFORM_BARRIER_BIT;
    case BindingType::StorageBuffer:
        return asImage ? GL_SHADER_IMAGE_ACCESS_BARRIER_BIT : GL_SHADER_STORAGE_BARRIER_BIT;
    case BindingType::StorageImage:
        return GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
    case BindingType::Texture:
    case BindingType::ShadowTexture:
        break;
    }
    return GL_TEXTURE_FETCH_BARRIER_BIT;
}

GLbitfield StoreBarriers::before(const Plan& plan, const Pass& pass, bool drawsUseImages) {
    GLbitfield bits = 0;
    const auto need = [&](ResourceId id, GLbitfield bit) {
        if (id != noResource && !plan.resources[id].isHosts() && states_[id].stored &&
            !(states_[id].visible & bit))
            bits |= bit;
    };
    for (const Binding& binding : pass.bindings)
        need(binding.resource,
             usageBit(binding.type, drawsUseImages && pass.kind == PassKind::HostDraw));
    for (ResourceId target : pass.colorTargets)
        need(target, GL_FRAMEBUFFER_BARRIER_BIT);
    need(pass.source, GL_BUFFER_UPDATE_BARRIER_BIT);
    need(pass.destination, GL_BUFFER_UPDATE_BARRIER_BIT);
    for (State& state : states_)
        state.visible |= bits;
    return bits;
}

void StoreBarriers::after(const Plan& plan, const Pass& pass) {
    for (const Binding& binding : pass.bindings)
        if (binding.writes && !plan.resources[binding.resource].isHosts())
            states_[binding.resource] = {true, 0};
}

} // namespace agaa::gl
