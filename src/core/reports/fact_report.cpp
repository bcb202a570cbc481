#include "core/reports/fact_report.h"

#include "core/base/error.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace agaa {

namespace {

// Bits of AgaaSceneFacts::flags: effects of materials, and properties that all materials share.
constexpr uint64_t effects = AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_AMBIENT;
constexpr uint64_t ofSpecular = AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR | AGAA_FACT_ONE_SPECULAR;
constexpr uint64_t ofMasks = AGAA_FACT_NO_TRANSLUCENCY | AGAA_FACT_NO_CUTOUTS;

// A fact, and the number of materials that demand the bit of an effect or contradict a shared property.
struct FactRow {
    uint64_t fact;
    const char* name;
    uint64_t AgaaFactReport::*demands; // materials
};
constexpr FactRow rows[] = {
    {AGAA_FACT_SPECULAR, "SPECULAR", &AgaaFactReport::withSpecular},
    {AGAA_FACT_EMISSIVE, "EMISSIVE", &AgaaFactReport::withEmission},
    {AGAA_FACT_ALPHA_MASKED, "ALPHA_MASKED", &AgaaFactReport::alphaMasked},
    {AGAA_FACT_ONE_ROUGHNESS, "ONE_ROUGHNESS", &AgaaFactReport::otherRoughness},
    {AGAA_FACT_GREY_SPECULAR, "GREY_SPECULAR", &AgaaFactReport::coloredSpecular},
    {AGAA_FACT_ONE_SPECULAR, "ONE_SPECULAR", &AgaaFactReport::otherSpecular},
    {AGAA_FACT_NO_DIFFUSE, "NO_DIFFUSE", &AgaaFactReport::withDiffuse},
    {AGAA_FACT_NO_TRANSLUCENCY, "NO_TRANSLUCENCY", &AgaaFactReport::translucent},
    {AGAA_FACT_NO_CUTOUTS, "NO_CUTOUTS", &AgaaFactReport::cutouts},
    {AGAA_FACT_PLANE_NORMALS, "PLANE_NORMALS", &AgaaFactReport::otherNormals},
    {AGAA_FACT_AMBIENT, "AMBIENT", nullptr},
    {AGAA_FACT_NO_LOCAL_LIGHTS, "NO_LOCAL_LIGHTS", nullptr},
};

} // namespace

uint64_t sufficientFacts(const AgaaFactReport& report, uint64_t viewFlags) {
    uint64_t flags = viewFlags & AGAA_FACT_CUSTOM_DEPTH;
    for (const FactRow& row : rows)
        if (row.demands) {
            const bool isDemanded = report.*row.demands != 0;
            flags |= isDemanded == ((row.fact & effects) != 0) ? row.fact : 0;
        }
    flags |= report.hasAmbient ? AGAA_FACT_AMBIENT : 0;
    flags |= report.localLights ? 0 : AGAA_FACT_NO_LOCAL_LIGHTS;
    return flags;
}

namespace {

uint64_t contradictedFacts(const AgaaFactReport& report, uint64_t viewFlags) {
    uint64_t flags = 0;
    for (const FactRow& row : rows)
        if (row.demands && report.*row.demands && ((viewFlags & row.fact) != 0) != ((row.fact & effects) != 0))
            flags |= row.fact;
    if (report.hasAmbient)
        flags |= ~viewFlags & AGAA_FACT_AMBIENT;
    return viewFlags & AGAA_FACT_SPECULAR ? flags : flags & ~ofSpecular;
}

// Returns the facts without common values that do not matter beside the others.
uint64_t withoutImplied(uint64_t flags) {
    if (!(flags & AGAA_FACT_SPECULAR))
        flags &= ~ofSpecular;
    if (flags & AGAA_FACT_ONE_SPECULAR)
        flags &= ~AGAA_FACT_GREY_SPECULAR;
    if (!(flags & AGAA_FACT_ALPHA_MASKED))
        flags &= ~ofMasks;
    if (flags & AGAA_FACT_NO_TRANSLUCENCY)
        flags &= ~AGAA_FACT_NO_CUTOUTS;
    return flags;
}

std::string namesOf(uint64_t flags) {
    std::string names;
    for (const FactRow& row : rows)
        if (flags & row.fact)
            names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

// Counts of fetched, masked materials are per fragment; there are more fragments than materials.
double shareOf(uint64_t part, uint64_t whole) {
    return whole ? std::min(100.0 * double(part) / double(whole), 100.0) : 100.0;
}

std::string explain(const AgaaFactReport& report, uint64_t viewFlags) {
    std::string text;
    for (const FactRow& row : rows) {
        if (!(report.contradicted & row.fact))
            continue;
        text += text.empty() ? "The frame contradicts " : "; ";
        text += std::string(row.fact & effects ? "the missing " : "") + "AGAA_FACT_" + row.name;
        if (row.demands)
            text += format(" (%.3g %% of %llu materials)", shareOf(report.*row.demands, report.inspected),
                           static_cast<unsigned long long>(report.inspected));
    }
    if (!text.empty())
        return text + ".";
    if (!report.inspected)
        return "No material was inspected: nothing was drawn.";
    text = "The frame keeps the facts.";
    const std::string needless = namesOf(viewFlags & ~report.sufficient & effects);
    const uint64_t holding = withoutImplied(report.sufficient | (viewFlags & ~effects));
    const std::string common = namesOf(holding & ~viewFlags & ~effects);
    if (!needless.empty())
        text += " It does not need " + needless + ".";
    if (!common.empty())
        text += " These hold, too: " + common + ".";
    return text;
}

AgaaFactReport reportOf(const Plan& plan, const FrameSequence::Slot& frame, const CounterBuffer& counts) {
    AgaaFactReport report = AGAA_FACT_REPORT_INIT;
    const auto wide = [&](Counter counter) {
        return uint64_t(counts.counts[counter][0]) | uint64_t(counts.counts[counter][1]) << 32;
    };
#define AGAA_COUNTER(index, name, member)
#define AGAA_COUNTER_MAX(index, name, member)
#define AGAA_COUNTER_FACT(index, name, member, fact) report.member = wide(name);
#include "shaders/tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
    report.frameIndex = frame.frame;
    report.lightCount = frame.content.lights;
    report.localLights = frame.content.localLights;
    report.shadowCount = frame.content.shadows;
    report.hasAmbient = frame.content.hasAmbient;
    report.contradicted = contradictedFacts(report, plan.view.facts.flags);
    report.sufficient = sufficientFacts(report, plan.view.facts.flags);
    if (plan.view.hostGBuffer) {
        constexpr uint64_t unknown = AGAA_FACT_ALPHA_MASKED | ofMasks | AGAA_FACT_PLANE_NORMALS;
        report.sufficient = (report.sufficient & ~unknown) | (plan.view.facts.flags & unknown);
    }
    std::strncpy(report.explanation, explain(report, plan.view.facts.flags).c_str(), sizeof report.explanation - 1);
    return report;
}

} // namespace

AgaaResult factReport(const ViewState& view, uint64_t completedFrame, AgaaFactReport& out) {
    const Plan& plan = view.plan;
    require(plan.view.config.flags & AGAA_CONFIG_CHECK_FACTS, AGAA_ERROR_WRONG_ORDER,
            "the view was created without AGAA_CONFIG_CHECK_FACTS.");
    const FrameSequence::Slot* newest = view.finished(completedFrame);
    if (!newest)
        return AGAA_NOT_READY;
    out = reportOf(plan, *newest, view.readCounters(view.sequence.indexOf(*newest)));
    return AGAA_OK;
}

} // namespace agaa
