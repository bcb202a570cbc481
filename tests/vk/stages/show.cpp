#include "show.h"

#include "ids_view.h"

#include <cstring>

namespace agaa::test {

FunctionBuffer::FunctionBuffer(const std::vector<glm::vec4>& data)
    : arena_(sharedDevice()), set_(sharedDevice(), 1, VK_SHADER_STAGE_COMPUTE_BIT) {
    buffer_ = arena_.hostBuffer(data.size() * sizeof data[0], VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(buffer_.mapped, data.data(), data.size() * sizeof data[0]);
    set_.write({buffer_.buffer.get()});
}

Shown show(StageContext& context, ViewSettings settings, const Shot& shot) {
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    if (settings.config.generationTier == AGAA_TIER_IDS) {
        IdsView ids(context, settings, shot);
        return showBy(
            ids.view(), shot, [&](const AgaaFrame& frame) { ids.render(frame); },
            [&] { return ids.view().image().rgb; });
    }
    StageView view(context, settings);
    view.setTriangles(shot.triangles);
    return showBy(
        view, shot, [&](const AgaaFrame& frame) { view.render(frame); },
        [&] { return view.image().rgb; });
}

} // namespace agaa::test
