#include "core/reports/prices.h"

#include "core/base/checked.h"
#include "core/base/error.h"
#include "core/plan/traffic.h"
#include "core/view/effects.h"
#include "core/view/technique.h"

#include "shaders/tables/lighting.inc"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace agaa {

namespace {

using Number = int64_t AgaaPrice::*;
constexpr Number numbers[] = {&AgaaPrice::passes,
                              &AgaaPrice::geometryPasses,
                              &AgaaPrice::pipelines,
                              &AgaaPrice::totalBytes,
                              &AgaaPrice::peakBytes,
                              &AgaaPrice::constantBytes,
                              &AgaaPrice::sampleBits,
                              &AgaaPrice::aggregateBits,
                              &AgaaPrice::trafficBytes,
                              &AgaaPrice::maxEventsPerPixel,
                              &AgaaPrice::maxShadowTapsPerEvent,
                              &AgaaPrice::maxLightsPerEvent};

int64_t checkedSigned(uint64_t number) {
    require(number <= uint64_t(std::numeric_limits<int64_t>::max()), AGAA_ERROR_TOO_LARGE,
            "a number of the view's price does not fit 63 bits.");
    return int64_t(number);
}

// Return the members in which the pipelines of passes of one kind differ.
auto pipelineOf(const ComputePart& program, const Constants& constants) {
    return std::tie(constants, program.file, program.shader, program.defines, program.text, program.hostCode);
}
auto pipelineOf(const DrawPart& draw, const Constants& constants) {
    return std::tie(constants, draw.id, draw.sampleContent, draw.fragmentContent, draw.text, draw.expansionText);
}

uint64_t pipelineCount(const Plan& plan) {
    std::set<decltype(pipelineOf(ComputePart{}, {}))> programs;
    std::set<decltype(pipelineOf(DrawPart{}, {}))> draws;
    for (const Pass& pass : plan.passes) {
        if (pass.kind() == PassKind::Compute)
            programs.insert(pipelineOf(pass.compute(), pass.constants));
        if (pass.kind() == PassKind::HostDraw)
            draws.insert(pipelineOf(pass.draw(), pass.constants));
    }
    return programs.size() + draws.size();
}

// Returns the bits per sample of all targets of geometry passes.
uint64_t sampleBits(const Plan& plan) {
    std::set<ResourceId> targets;
    for (const Pass& pass : plan.passes) {
        if (pass.kind() != PassKind::HostDraw)
            continue;
        targets.insert(pass.draw().colorTargets.begin(), pass.draw().colorTargets.end());
        if (pass.draw().depthTarget != noResource)
            targets.insert(pass.draw().depthTarget);
    }
    uint64_t bits = 0;
    for (const ResourceId target : targets)
        bits += 8 * bytesPerTexel(plan.resources[target].format);
    return bits;
}

uint64_t trafficBytes(const Plan& plan) {
    uint64_t total = 0;
    for (const Pass& pass : plan.passes)
        for (const auto& [id, bytes] : trafficOf(plan, pass))
            total = checkedAdd(total, bytes);
    return total;
}

// Returns the taps for a shadow map that an event does not look up at each sample.
uint64_t tapsOfMap(const Technique& technique, const Plan& plan, const Constants& constants, uint32_t samples) {
    constexpr uint64_t lineTaps = 4; // of agaa_tapAlongDepth() and agaa_tapLongestAxis()
    const uint32_t filter = constants[AGAA_SHADOW_FILTER];
    const bool hasDepths =
        technique.maxAggregates > 0 && !technique.countsCoverage(plan.view.config.generationTier, plan.view.samples);
    if ((filter == AGAA_SHADOW_ALONG_DEPTH || filter == AGAA_SHADOW_COVARIANCE) && hasDepths)
        return samples > 1 ? lineTaps : 1;
    return filter != AGAA_SHADOW_AT_MEAN ? std::min(samples, constants[AGAA_SHADOW_TAPS]) : 1;
}

uint64_t shadowTaps(const Technique& technique, const Plan& plan, uint32_t samples) {
    const auto shades = std::find_if(plan.passes.rbegin(), plan.passes.rend(), [](const Pass& pass) {
        return pass.kind() == PassKind::Compute || pass.kind() == PassKind::HostDraw;
    });
    if (shades == plan.passes.rend())
        return 0;
    const Constants& constants = shades->constants;
    const uint32_t maps = constants[AGAA_SHADOW_MAPS], lit = uint32_t(std::popcount(constants[AGAA_LIT_SHADOWS]));
    const uint32_t atOnce = uint32_t(std::popcount(plan.view.footprintShadows)); // by a function of the host
    return (maps - lit - atOnce) * tapsOfMap(technique, plan, constants, samples) + uint64_t(lit) * samples + atOnce;
}

AgaaPrice priceOf(const Plan& plan) {
    const Technique& technique = *plan.view.technique;
    const ShadingWork work = technique.work(plan.view);
    AgaaPrice price = AGAA_PRICE_INIT;
    price.passes = checkedSigned(plan.passes.size());
    price.geometryPasses = plan.geometryPasses();
    price.pipelines = checkedSigned(pipelineCount(plan));
    price.totalBytes = checkedSigned(plan.totalBytes());
    price.peakBytes = checkedSigned(plan.peakBytes());
    price.constantBytes = checkedSigned(plan.constantBytes());
    price.sampleBits = checkedSigned(sampleBits(plan));
    price.aggregateBits = 8 * int64_t(plan.bytesPerAggregate);
    price.trafficBytes = checkedSigned(trafficBytes(plan));
    price.maxEventsPerPixel = work.eventsPerPixel;
    price.maxShadowTapsPerEvent = checkedSigned(shadowTaps(technique, plan, work.samplesPerEvent));
    price.maxLightsPerEvent = plan.view.facts.maxLights;
    price.isPossible = 1;
    return price;
}

// Compares plans of changed views.
class Comparison {
public:
    Comparison(const ViewSettings& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight)
        : view_(view), caps_(caps), framesInFlight_(framesInFlight) {}

    using Change = std::function<void(ViewSettings&)>;

    AgaaPrice view() const {
        return priceOf(planOf([](ViewSettings&) {}));
    }

    AgaaPrice difference(const Change& with, const Change& without) const try {
        const Plan more = planOf(with), less = planOf(without);
        AgaaPrice price = priceOf(more);
        const AgaaPrice other = priceOf(less);
        for (const Number number : numbers) // both are at least 0, so that the difference does not overflow
            price.*number -= other.*number;
        price.changesTier = more.view.visibilityTier != less.view.visibilityTier ||
                            more.view.generationTier != less.view.generationTier;
        return price;
    } catch (const Error& error) {
        if (error.code == AGAA_ERROR_INTERNAL)
            throw;
        AgaaPrice price = AGAA_PRICE_INIT;
        std::strncpy(price.reason, error.message.c_str(), sizeof price.reason - 1);
        return price;
    }

private:
    Plan planOf(const Change& change) const {
        ViewSettings changed = view_;
        change(changed);
        changed.variantFacts = changed.facts;
        return makePlan(changed, caps_, framesInFlight_);
    }

    const ViewSettings& view_;
    const AgaaDeviceCaps& caps_;
    uint32_t framesInFlight_;
};

std::vector<uint32_t> sampleCounts(const Technique& technique, const ViewSettings& view) {
    std::vector<uint32_t> counts;
    for (const uint32_t samples : {1u, 2u, 4u, 8u, gridOnlySamples, 16u, 32u, 64u, 128u}) {
        const bool isCoverage = technique.countsCoverage(view.config.generationTier, samples);
        const bool isOnlyGrid = samples == gridOnlySamples && view.samples != gridOnlySamples;
        if (isCoverage ? samples >= 32 : samples <= technique.maxSamples && !isOnlyGrid)
            counts.push_back(samples);
    }
    return counts;
}

std::vector<uint32_t> aggregateCounts(const Technique& technique, const ViewSettings& view) {
    std::vector<uint32_t> counts;
    for (uint32_t aggregates = 1; aggregates <= std::min(technique.maxAggregates, view.samples); ++aggregates)
        counts.push_back(aggregates);
    return counts;
}

void changeAggregates(ViewSettings& view, uint32_t aggregates) { setCounts(view, view.samples, aggregates); }

// The subject of a price.
struct Subject {
    AgaaPriceKind kind;
    const char* name;
    const char* description;
};

AgaaPrice named(AgaaPrice price, const Subject& subject, bool isOn) {
    price.kind = subject.kind;
    price.name = subject.name;
    price.description = subject.description;
    price.isOn = isOn;
    return price;
}

// Adds the prices of the steps between neighbouring counts.
void addSteps(std::vector<AgaaPrice>& list, const Comparison& comparison, const Subject& subject,
              const std::vector<uint32_t>& counts, uint32_t described, void (*change)(ViewSettings&, uint32_t)) {
    for (size_t i = 1; i < counts.size(); ++i) {
        const uint32_t from = counts[i - 1], to = counts[i];
        AgaaPrice price =
            comparison.difference([&](ViewSettings& v) { change(v, to); }, [&](ViewSettings& v) { change(v, from); });
        price.fromCount = from;
        price.toCount = to;
        list.push_back(named(price, subject, described >= to));
    }
}

} // namespace

std::vector<AgaaPrice> listPrices(const ViewSettings& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight) {
    const Comparison comparison(view, caps, framesInFlight);
    const Technique& technique = *view.technique;
    std::vector<AgaaPrice> list = {
        named(comparison.view(), {AGAA_PRICE_VIEW, "view", "The numbers are those of the described view."}, true)};
    for (const Effect& effect : effects())
        list.push_back(named(comparison.difference([&](ViewSettings& v) { effect.set(v, true); },
                                                   [&](ViewSettings& v) { effect.set(v, false); }),
                             {AGAA_PRICE_EFFECT, effect.name, effect.need}, effect.isOn(view)));
    addSteps(list, comparison,
             {AGAA_PRICE_SAMPLES, "samples", "More samples reduce the error at edges and of thin geometry."},
             sampleCounts(technique, view), view.samples, changeSamples);
    addSteps(list, comparison,
             {AGAA_PRICE_AGGREGATES, "aggregates", "More aggregates or surfaces keep more differences within a pixel."},
             aggregateCounts(technique, view), view.aggregates, changeAggregates);
    return list;
}

} // namespace agaa
