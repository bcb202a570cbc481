// Prices of effects, samples and aggregates: what the memory queries say of the two views that a price compares.
#include "plan_support.h"

#include "core/view/effects.h"
#include "core/reports/prices.h"

#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <set>
#include <string>

using namespace agaa;
using namespace agaa::test;

namespace {

void AGAA_CALL keepText(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity == AGAA_SEVERITY_ERROR)
        *static_cast<std::string*>(user) = message;
}

// A host's description of a view.
struct Host {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    AgaaDeviceCaps caps = fourSampleDevice();
    AgaaResolvedOutputs outputs = AGAA_RESOLVED_OUTPUTS_INIT;
    bool fetches = false, resolves = false;

    explicit Host(const char* technique, uint32_t samples = 8, uint32_t generationTier = AGAA_TIER_AUTO,
                  bool hasFetch = false)
        : fetches(hasFetch) {
        outputs.count = 2;
        outputs.outputs[0].value = AGAA_RESOLVED_MEAN_DEPTH;
        outputs.outputs[1].value = AGAA_RESOLVED_NORMAL;
        config.technique = technique;
        config.samples = findTechnique(techniques(), technique)->maxSamples ? samples : 64;
        config.generationTier = generationTier;
        desc.width = 320;
        desc.height = 180;
        fetch.glsl = "";
        fetch.maxDraws = fetch.maxPrimitives = 1;
    }

    const AgaaViewDesc* view() {
        desc.config = &config;
        desc.facts = &facts;
        outputs.pNext = fetches ? &fetch : nullptr;
        desc.pNext = resolves ? &outputs : outputs.pNext;
        return &desc;
    }
};

struct Prices {
    AgaaResult result = AGAA_OK;
    std::string message;
    std::vector<AgaaPrice> list;

    const AgaaPrice& operator[](const std::string& name) const {
        for (const AgaaPrice& price : list)
            if (name == price.name && price.kind <= AGAA_PRICE_EFFECT)
                return price;
        ADD_FAILURE() << "no price of " << name;
        return list.at(0);
    }
    const AgaaPrice& step(AgaaPriceKind kind, uint32_t from, uint32_t to) const {
        for (const AgaaPrice& price : list)
            if (price.kind == uint32_t(kind) && price.fromCount == from && price.toCount == to)
                return price;
        ADD_FAILURE() << "no step from " << from << " to " << to;
        return list.at(0);
    }
};

Prices pricesOf(Host& host) {
    Prices prices;
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = keepText;
    log.user = &prices.message;
    uint32_t count = 0;
    prices.result = agaaQueryPrices(host.view(), &host.caps, &log, &count, nullptr);
    if (prices.result != AGAA_OK)
        return prices;
    const AgaaPrice initial = AGAA_PRICE_INIT;
    prices.list.resize(count, initial);
    prices.result = agaaQueryPrices(host.view(), &host.caps, &log, &count, prices.list.data());
    return prices;
}

// What other queries say of a view.
struct Known {
    AgaaResult result = AGAA_OK;
    std::string message; // without the name of the function
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT;
    AgaaTarget target = AGAA_TARGET_INIT;
};

Known knownOf(Host& host) {
    Known known;
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = keepText;
    log.user = &known.message;
    known.result = agaaQueryMemory(host.view(), &host.caps, &log, &known.memory, nullptr, nullptr);
    known.message = known.message.substr(known.message.find(' ') + 1);
    if (known.result == AGAA_OK) {
        EXPECT_EQ(agaaQueryTarget(host.view(), &host.caps, &log, &known.target), AGAA_OK);
    }
    return known;
}

void expectDifference(const AgaaPrice& price, const Known& with, const Known& without, const std::string& what) {
    if (with.result != AGAA_OK || without.result != AGAA_OK) {
        EXPECT_EQ(price.isPossible, 0u) << what;
        EXPECT_EQ(price.reason, (with.result != AGAA_OK ? with : without).message) << what;
        return;
    }
    EXPECT_EQ(price.isPossible, 1u) << what << ": " << price.reason;
    EXPECT_STREQ(price.reason, "") << what;
    EXPECT_EQ(price.totalBytes, int64_t(with.memory.totalBytes) - int64_t(without.memory.totalBytes)) << what;
    EXPECT_EQ(price.peakBytes, int64_t(with.memory.peakBytes) - int64_t(without.memory.peakBytes)) << what;
    EXPECT_EQ(price.constantBytes, int64_t(with.memory.constantBytes) - int64_t(without.memory.constantBytes)) << what;
    EXPECT_EQ(double(price.aggregateBits), 8 * (with.memory.bytesPerAggregate - without.memory.bytesPerAggregate))
        << what;
    EXPECT_EQ(price.geometryPasses, int64_t(with.target.geometryPasses) - int64_t(without.target.geometryPasses))
        << what;
}

void setFlag(uint64_t& flags, uint64_t flag, bool on) { flags = on ? flags | flag : flags & ~flag; }

// How a host switches each effect, by the headers alone.
using Switch = std::function<void(Host&, bool)>;
const std::map<std::string, Switch>& switches() {
    const auto common = [](uint64_t flag) -> Switch {
        return [flag](Host& h, bool on) { setFlag(h.facts.flags, flag, !on); };
    };
    const auto fact = [](uint64_t flag) -> Switch {
        return [flag](Host& h, bool on) { setFlag(h.facts.flags, flag, on); };
    };
    const auto option = [](uint64_t flag) -> Switch {
        return [flag](Host& h, bool on) { setFlag(h.config.flags, flag, on); };
    };
    const auto unless = [](uint64_t flag) -> Switch {
        return [flag](Host& h, bool on) { setFlag(h.config.measurement.flags, flag, !on); };
    };
    const auto map = [](uint32_t i) -> Switch {
        return [i](Host& h, bool on) { h.facts.shadowMapCount = on ? i + 1 : i; };
    };
    static const std::map<std::string, Switch> table = {
        {"specular", fact(AGAA_FACT_SPECULAR)},
        {"varied-roughness", common(AGAA_FACT_ONE_ROUGHNESS)},
        {"coloured-specular", common(AGAA_FACT_GREY_SPECULAR)},
        {"varied-specular", common(AGAA_FACT_ONE_SPECULAR)},
        {"diffuse", common(AGAA_FACT_NO_DIFFUSE)},
        {"shading-normals", common(AGAA_FACT_PLANE_NORMALS)},
        {"translucency", common(AGAA_FACT_NO_TRANSLUCENCY)},
        {"cut-outs", common(AGAA_FACT_NO_CUTOUTS)},
        {"local-lights", common(AGAA_FACT_NO_LOCAL_LIGHTS)},
        {"emissive", fact(AGAA_FACT_EMISSIVE)},
        {"ambient", fact(AGAA_FACT_AMBIENT)},
        {"alpha-mask", fact(AGAA_FACT_ALPHA_MASKED)},
        {"custom-depth", fact(AGAA_FACT_CUSTOM_DEPTH)},
        {"lights", [](Host& h, bool on) { h.facts.maxLights = on ? 64 : 0; }},
        {"light-culling", unless(AGAA_MEASURE_NO_LIGHT_CULLING)},
        {"shadow-map-0", map(0)},
        {"shadow-map-1", map(1)},
        {"shadow-map-2", map(2)},
        {"shadow-map-3", map(3)},
        {"shadow-filter", unless(AGAA_MEASURE_NO_SHADOW_FILTER)},
        {"lit-aggregates", [](Host& h, bool on) { h.config.aggregation.litShadows = on; }},
        {"filtered-diffuse", unless(AGAA_MEASURE_NO_DIFFUSE_FILTER)},
        {"light-directions",
         [](Host& h, bool on) { setFlag(h.config.measurement.flags, AGAA_MEASURE_LIGHT_DIRECTIONS, on); }},
        {"ndf-widening", [](Host& h, bool on) { h.config.ndf = on ? AGAA_NDF_TOKSVIG : AGAA_NDF_NONE; }},
        {"elliptic-lobes", [](Host& h, bool on) { h.config.ndf = on ? AGAA_NDF_LEAN : AGAA_NDF_TOKSVIG; }},
        {"gloss-weight", [](Host& h, bool on) { h.config.aggregation.glossWeight = on ? 0.5f : 0.0f; }},
        {"buffered", option(AGAA_CONFIG_BUFFERED)},
        {"fine-materials", option(AGAA_CONFIG_FINE_MATERIALS)},
        {"unfetched-draws", [](Host& h, bool on) { setFlag(h.fetch.flags, AGAA_FETCH_NOT_ALL_DRAWS, on); }},
        {"hdr-resolve", option(AGAA_CONFIG_HDR_RESOLVE)},
        {"resolved-outputs", [](Host& h, bool on) { h.resolves = on; }},
        {"composite", [](Host& h, bool on) { setFlag(h.desc.flags, AGAA_VIEW_COMPOSITE, on); }},
        {"counters", option(AGAA_CONFIG_COUNTERS)},
        {"fact-checks", option(AGAA_CONFIG_CHECK_FACTS)},
    };
    return table;
}

std::vector<Host> hosts() {
    std::vector<Host> list;
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"})
        list.emplace_back(technique);
    for (const uint32_t tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
        list.emplace_back("agaa", 8, tier, true);
    list.emplace_back("agaa", 64, AGAA_TIER_FRAGMENTS, true);
    list.emplace_back("adaptive", 4, AGAA_TIER_IDS, true);
    list.emplace_back("dcaa", 64, AGAA_TIER_AUTO, true);
    return list;
}

std::string nameOf(const Host& host) {
    return std::string(host.config.technique) + ", tier " + agaaTierName(host.config.generationTier);
}

const int64_t AgaaPrice::*const numbers[] = {&AgaaPrice::passes,
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

void expectSameNumbers(const AgaaPrice& a, const AgaaPrice& b, const std::string& what) {
    for (size_t i = 0; i < std::size(numbers); ++i)
        EXPECT_EQ(a.*numbers[i], b.*numbers[i]) << what << ", number " << i;
    EXPECT_EQ(a.isPossible, b.isPossible) << what;
    EXPECT_STREQ(a.reason, b.reason) << what;
}

TEST(Prices, EveryEffectIsADifferenceOfViews) {
    std::set<std::string> listed;
    for (const Effect& effect : effects())
        listed.insert(effect.name);
    for (const auto& [name, change] : switches())
        EXPECT_EQ(listed.count(name), 1u) << name;
    EXPECT_EQ(listed.size(), switches().size());
    uint32_t possible = 0, changing = 0;
    for (const Host& described : hosts()) {
        Host host = described;
        const Prices prices = pricesOf(host);
        ASSERT_EQ(prices.result, AGAA_OK) << nameOf(host) << ": " << prices.message;
        for (const auto& [name, change] : switches()) {
            if (name == "unfetched-draws" && !host.fetches)
                continue; // there is no function to say it
            Host with = described, without = described;
            change(with, true);
            change(without, false);
            const AgaaPrice& price = prices[name];
            expectDifference(price, knownOf(with), knownOf(without), nameOf(host) + ", " + name);
            possible += price.isPossible;
            changing += price.totalBytes != 0;
        }
    }
    EXPECT_GT(possible, 250u);
    EXPECT_GT(changing, 40u);
}

TEST(Prices, AreTheSameWhetherTheViewHasTheEffectOrNot) {
    for (const Host& described : hosts())
        for (const auto& [name, change] : switches()) {
            Host with = described, without = described;
            change(with, true);
            change(without, false);
            const Prices ofWith = pricesOf(with), ofWithout = pricesOf(without);
            if (ofWith.result != AGAA_OK || ofWithout.result != AGAA_OK)
                continue; // the effect is not possible, as the test above finds
            if (name != "unfetched-draws" || with.fetches) {
                EXPECT_EQ(ofWith[name].isOn, 1u) << nameOf(described) << ", " << name;
                EXPECT_EQ(ofWithout[name].isOn, 0u) << nameOf(described) << ", " << name;
            }
            expectSameNumbers(ofWith[name], ofWithout[name], nameOf(described) + ", " + name);
        }
}

TEST(Prices, TheFirstIsTheViewItself) {
    for (const Host& described : hosts()) {
        Host host = described;
        const Prices prices = pricesOf(host);
        const Known known = knownOf(host);
        const AgaaPrice& view = prices.list.at(0);
        EXPECT_EQ(view.kind, uint32_t(AGAA_PRICE_VIEW));
        const Known nothing;
        expectDifference(view, known, nothing, nameOf(host));
        EXPECT_EQ(view.maxLightsPerEvent, 64);
    }
}

TEST(Prices, StepsAreDifferencesOfViewsAndAddUp) {
    for (const Host& described : hosts()) {
        Host host = described;
        const Prices prices = pricesOf(host);
        std::set<uint32_t> samples;
        for (const AgaaPrice& price : prices.list) {
            if (price.kind != AGAA_PRICE_SAMPLES && price.kind != AGAA_PRICE_AGGREGATES)
                continue;
            Host more = described, less = described;
            uint32_t AgaaConfig::*member =
                price.kind == AGAA_PRICE_SAMPLES ? &AgaaConfig::samples : &AgaaConfig::aggregates;
            more.config.*member = price.toCount;
            less.config.*member = price.fromCount;
            expectDifference(price, knownOf(more), knownOf(less),
                             nameOf(host) + ", " + price.name + " to " + std::to_string(price.toCount));
            EXPECT_EQ(price.isOn, uint32_t(host.config.*member >= price.toCount)) << nameOf(host) << ", " << price.name;
            if (price.kind == AGAA_PRICE_SAMPLES)
                samples.insert(price.toCount);
        }
        const std::string technique = host.config.technique;
        const std::set<std::string> ofOneSample = {"single", "fxaa", "smaa", "taa"};
        EXPECT_EQ(samples.empty(), ofOneSample.contains(technique)) << technique;
        if (technique == "dcaa" || technique == "sgbc" || host.config.generationTier == AGAA_TIER_FRAGMENTS) {
            EXPECT_EQ(samples, (std::set<uint32_t>{64, 128})) << technique;
        } else if (technique == "ssaa") {
            EXPECT_EQ(samples, (std::set<uint32_t>{2, 4, 8, 16, 32}));
        }
    }
    Host host("ssaa", 4);
    const Prices prices = pricesOf(host);
    Host four("ssaa", 4), sixteen("ssaa", 16);
    const Prices ofFour = pricesOf(four), ofSixteen = pricesOf(sixteen);
    for (const auto number : numbers)
        EXPECT_EQ(prices.step(AGAA_PRICE_SAMPLES, 4, 8).*number + prices.step(AGAA_PRICE_SAMPLES, 8, 16).*number,
                  ofSixteen["view"].*number - ofFour["view"].*number);
}

TEST(Prices, NineSamplesAreAStepOfAViewThatHasThem) {
    Host nine("adaptive", 9), eight("adaptive", 8);
    const Prices prices = pricesOf(nine);
    EXPECT_EQ(prices.step(AGAA_PRICE_SAMPLES, 8, 9).isPossible, 1u);
    EXPECT_EQ(prices.step(AGAA_PRICE_SAMPLES, 9, 16).isPossible, 1u);
    EXPECT_EQ(pricesOf(eight).step(AGAA_PRICE_SAMPLES, 8, 16).isPossible, 1u);
}

TEST(Prices, WhatIsNotPossibleSaysWhy) {
    Host msaa("msaa");
    const AgaaPrice customDepth = pricesOf(msaa)["custom-depth"];
    EXPECT_EQ(customDepth.isPossible, 0u);
    EXPECT_NE(std::string(customDepth.reason).find("AGAA_FACT_CUSTOM_DEPTH"), std::string::npos) << customDepth.reason;
    Host agaa("agaa", 32); // without functions that fetch
    const AgaaPrice coverage = pricesOf(agaa).step(AGAA_PRICE_SAMPLES, 32, 64);
    EXPECT_EQ(coverage.isPossible, 0u);
    EXPECT_NE(std::string(coverage.reason).find("AgaaFetchFunction"), std::string::npos) << coverage.reason;
    EXPECT_EQ(coverage.totalBytes, 0);
    const float positions[16] = {};
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    function.glsl = "";
    function.samplePositions = positions;
    Host host("ssaa");
    AgaaViewDesc view = *host.view();
    view.pNext = &function;
    const auto list = listPrices(resolveView(&view, techniques()), host.caps, 2);
    for (const AgaaPrice& price : list)
        if (price.kind == AGAA_PRICE_SAMPLES) {
            EXPECT_EQ(price.isPossible, 0u);
            EXPECT_NE(std::string(price.reason).find("samplePositions"), std::string::npos) << price.reason;
        }
    const std::vector<float> places(2 * 64);
    Host covering("dcaa", 64);
    covering.config.coverage.samplePositions = places.data();
    const AgaaPrice more = pricesOf(covering).step(AGAA_PRICE_SAMPLES, 64, 128);
    EXPECT_EQ(more.isPossible, 0u);
    EXPECT_NE(std::string(more.reason).find("AgaaDecoupledCoverage::samplePositions"), std::string::npos)
        << more.reason;
    Host other("ssaa", 32); // has no coverage samples
    other.config.coverage.samplePositions = places.data();
    EXPECT_EQ(pricesOf(other).step(AGAA_PRICE_SAMPLES, 8, 16).isPossible, 1u);
    Host small("ssaa", 4);
    small.caps.maxImageSize = 700; // 180 pixels with 2 texels each, not with 4
    EXPECT_EQ(pricesOf(small).step(AGAA_PRICE_SAMPLES, 4, 8).isPossible, 1u);
    const AgaaPrice tooLarge = pricesOf(small).step(AGAA_PRICE_SAMPLES, 16, 32);
    EXPECT_EQ(tooLarge.isPossible, 0u);
    EXPECT_NE(std::string(tooLarge.reason).find("700"), std::string::npos) << tooLarge.reason;
}

TEST(Prices, AShadowFunctionOfMapsThatArePricedAwayGoesWithThem) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "";
    function.shadows = 2;
    Host host("ssaa");
    host.facts.shadowMapCount = 2;
    AgaaViewDesc view = *host.view();
    view.pNext = &function;
    for (const AgaaPrice& price : listPrices(resolveView(&view, techniques()), host.caps, 2))
        if (std::string(price.name).starts_with("shadow-map-")) {
            EXPECT_EQ(price.isPossible, 1u) << price.reason;
            EXPECT_EQ(price.maxShadowTapsPerEvent, 1);
        }
}

TEST(Prices, WorkHasTheBoundsOfTheTechnique) {
    struct Row {
        Host host;
        int64_t events, taps;
    };
    Row rows[] = {{Host("single"), 1, 1},  {Host("fxaa"), 1, 1},           {Host("msaa"), 0, 1},
                  {Host("ssaa"), 8, 1},    {Host("simple_complex"), 8, 8}, {Host("sbaa"), 2, 8},
                  {Host("agaa"), 2, 8},    {Host("agaa", 32), 2, 8},       {Host("agaa", 4), 2, 4},
                  {Host("agaa", 1), 1, 1}, {Host("adaptive"), 8, 8},       {Host("dcaa"), 2, 8}};
    for (Row& row : rows) {
        const AgaaPrice view = pricesOf(row.host)["view"];
        EXPECT_EQ(view.maxEventsPerPixel, row.events) << nameOf(row.host);
        EXPECT_EQ(view.maxShadowTapsPerEvent, row.taps) << nameOf(row.host);
    }
    Host lit("agaa", 32, AGAA_TIER_GBUFFER);
    lit.facts.shadowMapCount = 2;
    EXPECT_EQ(pricesOf(lit)["lit-aggregates"].maxShadowTapsPerEvent, 32 - 8);
    lit.config.measurement.flags = AGAA_MEASURE_SHADOW_ALONG_DEPTH;
    EXPECT_EQ(pricesOf(lit)["view"].maxShadowTapsPerEvent, 2 * 4);
    EXPECT_EQ(pricesOf(lit)["shadow-filter"].maxShadowTapsPerEvent, 2 * (4 - 1));
    lit.config.measurement.flags = AGAA_MEASURE_SHADOW_COVARIANCE;
    EXPECT_EQ(pricesOf(lit)["view"].maxShadowTapsPerEvent, 2 * 4);
    Host exact("dcaa");
    exact.config.coverage.flags = AGAA_COVERAGE_EXACT;
    EXPECT_EQ(pricesOf(exact)["view"].maxEventsPerPixel, 64);
    Host equal("adaptive");
    equal.config.adaptive.flags |= AGAA_ADAPTIVE_EQUAL_WEIGHTS;
    EXPECT_EQ(pricesOf(equal)["view"].maxShadowTapsPerEvent, 1);
}

TEST(Prices, TrafficCountsEachSurfaceOfAPassOnce) {
    Host host("single");
    host.facts.maxLights = 4; // too few to be culled
    const Prices prices = pricesOf(host);
    const AgaaPrice& view = prices["view"];
    EXPECT_EQ(view.sampleBits, 8 * view.totalBytes / (320 * 180));
    EXPECT_EQ(view.trafficBytes, 2 * view.totalBytes); // a G-buffer is written, and read
    EXPECT_EQ(view.pipelines, 2);
    EXPECT_EQ(view.passes, 2);
    // The image that is filtered is written, and read.
    Host fxaa("fxaa");
    fxaa.facts.maxLights = 4;
    EXPECT_EQ(pricesOf(fxaa)["view"].trafficBytes, 2 * (view.totalBytes + 320 * 180 * 8));
    EXPECT_EQ(pricesOf(fxaa)["view"].pipelines, 3);
    EXPECT_EQ(pricesOf(host)["counters"].passes, 2); // cleared, and copied
    Host culled("single");
    EXPECT_EQ(pricesOf(culled)["light-culling"].passes, 1);
    EXPECT_EQ(pricesOf(culled)["light-culling"].pipelines, 1);
    // Depth is read, and for each tile of 64 pixels 64 bits and a word are written, and read.
    EXPECT_EQ(pricesOf(culled)["light-culling"].trafficBytes, 320 * 180 * 4 + 2 * (8 + 4) * 40 * 23);
}

TEST(Prices, EffectsThatChangeTheTierSayIt) {
    Host twoPasses("agaa");
    const Prices prices = pricesOf(twoPasses);
    EXPECT_EQ(prices["lit-aggregates"].changesTier, 1u);
    EXPECT_EQ(prices["specular"].changesTier, 0u);
    EXPECT_EQ(prices["lit-aggregates"].geometryPasses, -1);
}

TEST(Prices, EffectsAsDescribedLeaveThePlanAlone) {
    for (const Host& described : hosts()) {
        Host host = described;
        const ViewSettings view = resolveView(host.view(), techniques());
        const std::string plan = planToJson(makePlan(view, host.caps, 2));
        for (const Effect& effect : effects()) {
            if (std::string(effect.name).starts_with("shadow-map-"))
                continue; // drops the maps behind it
            ViewSettings same = view;
            effect.set(same, effect.isOn(view));
            EXPECT_EQ(planToJson(makePlan(same, host.caps, 2)), plan) << nameOf(host) << ", " << effect.name;
        }
    }
}

TEST(Prices, HaveNamesAndSentences) {
    Host host("agaa");
    const Prices prices = pricesOf(host);
    std::set<std::string> names;
    for (const AgaaPrice& price : prices.list) {
        ASSERT_NE(price.name, nullptr);
        ASSERT_NE(price.description, nullptr);
        const std::string sentence = price.description;
        EXPECT_TRUE(sentence.ends_with(".") && std::isupper(static_cast<unsigned char>(sentence[0]))) << sentence;
        const bool isNamedOnce = price.kind <= AGAA_PRICE_EFFECT;
        EXPECT_TRUE(!isNamedOnce || names.insert(price.name).second) << price.name;
    }
}

TEST(Prices, HugeViewsAreErrorsAndHugeStepsAreNotPossible) {
    Host host("ssaa", 4);
    host.caps.sampleCounts = 0x3F;
    host.caps.maxImageSize = ~0u;
    host.caps.maxStorageRange = ~UINT64_C(0);
    host.desc.width = 1u << 31;
    host.desc.height = 1u << 24;
    host.facts.maxLights = 4;
    const Prices prices = pricesOf(host);
    ASSERT_EQ(prices.result, AGAA_OK) << prices.message;
    EXPECT_GT(prices["view"].trafficBytes, int64_t(1) << 62);
    for (const auto& [from, to] : {std::pair{4u, 8u}, {16u, 32u}}) {
        const AgaaPrice& step = prices.step(AGAA_PRICE_SAMPLES, from, to);
        EXPECT_EQ(step.isPossible, 0u);
        EXPECT_NE(std::string(step.reason).find("bits"), std::string::npos) << step.reason;
    }
    host.config.samples = 8;
    EXPECT_EQ(pricesOf(host).result, AGAA_ERROR_TOO_LARGE);
    host.desc.width = host.desc.height = ~0u;
    EXPECT_EQ(pricesOf(host).result, AGAA_ERROR_TOO_LARGE);
}

} // namespace
