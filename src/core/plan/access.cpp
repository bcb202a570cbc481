#include "core/plan/access.h"

namespace agaa {

static Use useOf(const Binding& binding) {
    switch (binding.type) {
    case BindingType::UniformBuffer:
        return Use::Uniform;
    case BindingType::StorageBuffer:
        return binding.writes ? Use::StorageWrite : Use::StorageRead;
    case BindingType::StorageImage:
        return Use::ImageWrite;
    case BindingType::Texture:
    case BindingType::ShadowTexture:
        break;
    }
    return Use::Fetch;
}

std::vector<Access> accessesOf(const Pass& pass) {
    std::vector<Access> list;
    const bool isDraw = pass.kind == PassKind::HostDraw;
    const auto add = [&](ResourceId resource, Use use) {
        if (resource != noResource)
            list.push_back({resource, use, isDraw});
    };
    for (const Binding& binding : pass.bindings)
        add(binding.resource, useOf(binding));
    for (ResourceId target : pass.colorTargets)
        add(target, pass.drawState.readsAttachments ? Use::FetchedColor : Use::Color);
    add(pass.depthTarget, Use::Depth);
    add(pass.source, Use::CopyFrom);
    add(pass.destination, Use::CopyTo);
    add(pass.dispatch.arguments, Use::Indirect);
    return list;
}

} // namespace agaa
