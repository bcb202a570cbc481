#include "show.h"

#include "ids_view.h"

namespace agaa::test {

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
