#include "core/abi/tuning_inputs.h"

#include "core/base/error.h"
#include "core/plan/planner.h"
#include "core/view/presets.h"

namespace agaa {

namespace {

ViewSettings withSettings(ViewSettings view, const ChoiceRow& row) {
    applySettings(row, view.config, view.aggregation, &view.measurement);
    view.technique = findTechnique(techniques(), row.technique);
    changeSamples(view, row.samples);
    return view;
}

} // namespace

TunedView tunedView(const ViewSettings& settings, const AgaaDeviceCaps& caps) {
    const auto plan = [settings, caps](const ChoiceRow& row) {
        const Plan planned = makePlan(withSettings(settings, row), caps, 2);
        return PlannedCost{.bytes = planned.totalBytes(), .geometryPasses = planned.geometryPasses()};
    };
    return {.facts = settings.facts, .pixels = uint64_t(settings.width) * settings.height, .plan = plan};
}

AgaaObservation observedSettings(const ViewSettings& settings, const Plan& plan) {
    AgaaObservation o = AGAA_OBSERVATION_INIT;
    o.technique = plan.view.config.technique;
    // Plans have dropped what has no effect, so that the preset is recognised by the settings.
    o.preset = presetOf(settings.config, settings.aggregation, settings.measurement);
    o.samples = plan.view.samples;
    o.aggregates = plan.view.aggregates;
    o.generationTier = plan.view.generationTier;
    o.pixels = uint64_t(plan.view.width) * plan.view.height;
    return o;
}

} // namespace agaa
