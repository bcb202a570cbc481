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
    const bool isDraw = pass.kind() == PassKind::HostDraw;
    const auto add = [&](ResourceId resource, Use use) {
        if (resource != noResource)
            list.push_back({resource, use, isDraw});
    };
    for (const Binding& binding : pass.bindings)
        add(binding.resource, useOf(binding));
    switch (pass.kind()) {
    case PassKind::HostDraw:
        for (ResourceId target : pass.draw().colorTargets)
            add(target, pass.draw().state.readsAttachments ? Use::FetchedColor : Use::Color);
        add(pass.draw().depthTarget, Use::Depth);
        break;
    case PassKind::Compute:
        add(pass.compute().dispatch.arguments, Use::Indirect);
        break;
    case PassKind::Fill:
        add(pass.fill().destination, Use::CopyTo);
        break;
    case PassKind::Copy:
        add(pass.copy().source, Use::CopyFrom);
        add(pass.copy().destination, Use::CopyTo);
        break;
    }
    return list;
}

} // namespace agaa
