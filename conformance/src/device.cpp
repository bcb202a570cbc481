#include "device.h"

namespace agaa::conformance {

ScopedContext::ScopedContext(Test& test, const std::function<void(ContextDescription&)>& change) : test_(test) {
    ContextDescription description = test.device().description();
    description.desc.log = log.get();
    if (change)
        change(description);
    test.requireOk(test.device().createContext(test.sdk, AGAA_HEADER_VERSION, description, &context_),
                   "creating a context");
    log.lines.clear();
}

ScopedContext::~ScopedContext() {
    if (context_)
        test_.result(test_.sdk.agaaDestroyContext(context_), AGAA_OK, "agaaDestroyContext(a context without views)");
}

AgaaFetchFunction emptyFetch() {
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                 "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
    fetch.maxDraws = 16;
    fetch.maxPrimitives = 1000;
    return fetch;
}

bool needsOneSample(const std::string& technique) {
    return technique == "single" || technique == "fxaa" || technique == "smaa" || technique == "taa";
}

bool hasCoverageSamples(const std::string& technique) { return technique == "dcaa" || technique == "sgbc"; }

bool countsCoverage(const AgaaConfig& config) {
    const bool isFragments = config.generationTier == AGAA_TIER_FRAGMENTS || config.samples > 32;
    return hasCoverageSamples(config.technique) || (config.technique == std::string("agaa") && isFragments);
}

uint32_t samplesOf(const std::string& technique, uint32_t samples) {
    return needsOneSample(technique) ? 1 : hasCoverageSamples(technique) ? 16 * samples : samples;
}

ViewDescription::ViewDescription(const Device* device) {
    const AgaaLayout initialLayout = AGAA_LAYOUT_INIT;
    const AgaaConfig initialConfig = AGAA_CONFIG_INIT;
    const AgaaAggregation initialAggregation = AGAA_AGGREGATION_INIT;
    const AgaaDecoupledCoverage initialCoverage = AGAA_DECOUPLED_COVERAGE_INIT;
    const AgaaAdaptiveSampling initialAdaptive = AGAA_ADAPTIVE_SAMPLING_INIT;
    const AgaaTemporal initialTemporal = AGAA_TEMPORAL_INIT;
    const AgaaMeasurement initialMeasurement = AGAA_MEASUREMENT_INIT;
    const AgaaSceneFacts initialFacts = AGAA_SCENE_FACTS_INIT;
    const AgaaViewDesc initialDesc = AGAA_VIEW_DESC_INIT;
    layout = initialLayout;
    config = initialConfig;
    aggregation = initialAggregation;
    coverage = initialCoverage;
    adaptive = initialAdaptive;
    temporal = initialTemporal;
    measurement = initialMeasurement;
    facts = initialFacts;
    desc = initialDesc;
    config.samples = 4;
    config.flags = AGAA_CONFIG_COUNTERS;
    config.pNext = &aggregation;
    aggregation.pNext = &coverage;
    coverage.pNext = &adaptive;
    adaptive.pNext = &temporal;
    temporal.pNext = &measurement;
    facts.shadowMapCount = 0;
    facts.maxLights = 4;
    desc.width = 32;
    desc.height = 24;
    desc.config = &config;
    desc.facts = &facts;
    desc.flags = device ? device->viewFlags() : 0;
    sceneFetch = device ? device->sceneFetch() : emptyFetch();
}

void ViewDescription::setTechnique(const std::string& name, uint32_t samples) {
    technique = name;
    config.technique = technique.c_str();
    config.samples = samplesOf(name, samples);
    if (!hasCoverageSamples(name))
        return;
    sceneFetch.pNext = desc.pNext;
    desc.pNext = &sceneFetch;
}

BareView::BareView(Test& test, AgaaContext context, const ViewDescription& description) : test_(test) {
    test.requireOk(test.device().createView(test.sdk, context, &description.desc, &view_), "creating a view");
}

BareView::~BareView() {
    if (!view_)
        return;
    test_.device().forget(view_);
    test_.sdk.agaaDestroyView(view_);
}

ScopedView::ScopedView(Test& test, AgaaContext context, const ViewDescription& description)
    : BareView(test, context, description) {
    test.device().setOutput(description.desc.width, description.desc.height);
    test.device().prepare(test.sdk, get());
}

AgaaFrame pixelFrame(const Device& device, const ViewDescription& description, uint64_t i) {
    static const AgaaTemporalFrame forgetting = AGAA_TEMPORAL_FRAME_INIT;
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.pNext = &forgetting; // for views that accumulate
    frame.frameIndex = i;
    frame.completedFrame = i - 1;
    frame.ambient[0] = frame.ambient[1] = frame.ambient[2] = 1.0f;
    setPixelCamera(frame, description.desc.width, description.desc.height, 16.0f,
                   description.desc.flags & AGAA_VIEW_REVERSED_Z,
                   device.backend() == Backend::OpenGl && (description.desc.flags & AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE));
    return frame;
}

Scene smallScene(uint32_t width, uint32_t height) {
    const float w = float(width), h = float(height);
    Scene scene;
    Surface surface;
    addRectangle(scene, width, height, 0, 0, w, h, 8, surface);
    surface.diffuse[0] = 0.25f;
    addRectangle(scene, width, height, w / 4, h / 4, w, h, 4, surface);
    surface.diffuse[1] = 0.75f;
    surface.isMasked = true;
    addRectangle(scene, width, height, w / 2, 0, w * 3 / 4, h / 2, 2, surface);
    return scene;
}

} // namespace agaa::conformance
