#include "sweep/scene_sweep.h"

#include "render/quantiles.h"

#include <algorithm>
#include <cmath>
#include <future>

namespace harness {

using nlohmann::json;

SweepOptions sweepOptions(bool quick, bool effectsOnly, uint32_t rounds) {
    SweepOptions options;
    if (quick)
        options = {.timedRounds = 2, .effectRounds = 2};
    if (rounds)
        options.rounds = options.timedRounds = options.effectRounds = rounds;
    if (rounds >= 32) // a GPU, whose clock rises with load
        options.warmUpTurns = 32;
    if (effectsOnly)
        options.rounds = options.timedRounds = 1;
    if (quick || effectsOnly) {
        options.referenceSamples = 64;
        options.pathFrames = options.temporalSamples = 0;
    }
    return options;
}

namespace {

// Such rows evaluate the lighting repeatedly, which does not change the image.
bool isHeavier(const SweepRow& row) { return row.shadingCost > 1; }

// Returns the statistics of times in milliseconds, which are in the order of the turns.
json timesJson(const std::vector<double>& milliseconds) {
    const MedianBounds bounds = medianBounds(milliseconds);
    json turns = json::array();
    for (const double each : milliseconds)
        turns.push_back(std::round(each * 1e3) / 1e3);
    return {{"median", quantile(milliseconds, 0.5)},
            {"p95", quantile(milliseconds, 0.95)},
            {"low", bounds.low},
            {"high", bounds.high},
            {"confidence", bounds.confidence},
            {"frames", milliseconds.size()},
            {"turns", turns}};
}

// Returns the errors over time. noise: the sum of the references' own errors.
json temporalJson(const TemporalAccumulator& accumulator, double noise) {
    const TemporalError error = accumulator.result();
    return {{"frames", accumulator.count()},
            {"referenceMseTm", noise / accumulator.count()},
            {"biasSquared", error.biasSquared},
            {"variance", error.variance},
            {"flicker", error.flicker}};
}

} // namespace

SceneSweep::SceneSweep(Renderer& renderer, const Scene& scene, const RenderSettings& base, const SweepOptions& options,
                       const std::vector<SweepRow>& rows, SceneReferences& references, std::filesystem::path images,
                       std::string prefix, Progress progress)
    : renderer_(renderer), scene_(scene), base_(base), options_(options), images_(std::move(images)),
      prefix_(std::move(prefix)), progress_(std::move(progress)), references_(references) {
    base_.frames = 1;
    base_.warmup = 0;
    for (const SweepRow& row : rows) {
        rows_.emplace_back();
        rows_.back().row = row;
    }
    steps_ = 4 + options_.ablation + options_.rounds + options_.timedRounds;
}

void SceneSweep::step(const std::string& what) {
    if (progress_)
        progress_(what, done_, steps_);
    ++done_;
}

RenderResult SceneSweep::render(const SweepRow& row, uint64_t flags, uint32_t debugView) {
    RenderSettings settings = base_;
    settings.config.measurement.debugView = debugView;
    row.apply(settings.config);
    settings.config.flags |= flags;
    if (settings.config.accumulates()) // the image has converged
        settings.warmup = std::max(settings.warmup, 2 * settings.jitterPositions);
    return renderer_.render(settings);
}

json SceneSweep::run() {
    step("reference");
    reference_ = &references_.get("still", renderer_, base_, options_.referenceSamples);
    step("counters");
    countEvents();
    step("images"); // also a warm-up: creates the views of the timed frames, which are kept, and compiles shaders
    takeTurn(0, 0, true, [](Measured& m, RenderResult& result) { m.still = std::move(result); });
    measureErrors();
    measureFrames();
    measurePasses();
    measurePath();
    json effects = json::array();
    if (options_.ablation) {
        step("ablation");
        effects = ablation();
    }
    json rows = json::array();
    for (const Measured& m : rows_)
        rows.push_back(rowJson(m));
    return {{"triangles", scene_.placedTriangles()},
            {"lights", base_.lights.size()},
            {"stresses", scene_.stresses},
            {"pixelsPerDegree", Metrics{}.pixelsPerDegree},
            {"reference", {{"spp", options_.referenceSamples}, {"splitHalfMseTm", reference_->splitHalfMseTm}}},
            {"referenceImage", writeImage("reference", reference_->image)},
            {"rows", rows},
            {"ablation", effects}};
}

// The image shows each event as a light of 0.25: one event is mid-grey, eight are near white.
void SceneSweep::countEvents() {
    for (Measured& m : rows_) {
        if (const Measured* same = sameButCost(m)) {
            m.counters = same->counters;
            m.counters.lightEvaluations *= m.row.shadingCost;
            continue;
        }
        const bool showsEvents = m.row.technique != "msaa";
        RenderResult result =
            render(m.row, AGAA_CONFIG_COUNTERS, showsEvents ? AGAA_DEBUG_VIEW_EVENTS : AGAA_DEBUG_VIEW_NONE);
        m.counters = result.statistics.back().counters;
        if (showsEvents) // a debug view evaluates no lights
            m.counters.lightEvaluations =
                render(m.row, AGAA_CONFIG_COUNTERS).statistics.back().counters.lightEvaluations;
        if (!showsEvents || isHeavier(m.row))
            continue;
        for (float& value : result.image.rgb)
            value *= 0.25f;
        m.heatFile = writeImage(m.row.name() + "-events", result.image);
    }
}

// In the table, rows of heavier lighting follow the rows that they repeat.
const SceneSweep::Measured* SceneSweep::sameButCost(const Measured& row) const {
    SweepRow same = row.row;
    same.shadingCost = 1;
    for (const Measured* m = rows_.data(); m != &row; ++m)
        if (isHeavier(row.row) && m->row.name() == same.name())
            return m;
    return nullptr;
}

void SceneSweep::takeTurn(uint32_t round, uint64_t flags, bool withHeavier,
                          const std::function<void(Measured&, RenderResult&)>& keep) {
    for (size_t i = 0; i < rows_.size(); ++i) {
        Measured& m = rows_[round % 2 ? rows_.size() - 1 - i : i];
        if (isHeavier(m.row) && !withHeavier)
            continue;
        base_.warmup = options_.untimedFrames;
        RenderResult result = render(m.row, flags);
        keep(m, result);
    }
    base_.warmup = 0;
}

const Image* SceneSweep::sameSamples(const SweepRow& row) {
    if (row.samples == 1 || row.samples > 32 || row.technique == "ssaa") // ssaa has at most 32 samples
        return nullptr;
    const auto found = sameSamples_.find(row.samples);
    if (found != sameSamples_.end())
        return &found->second;
    const AgaaLayout layout = referenceLayout(base_.config.layout);
    const SweepRow all{"ssaa", row.samples};
    RenderSettings settings = base_;
    all.apply(settings.config);
    settings.config.layout = &layout;
    return &(sameSamples_[row.samples] = renderer_.render(settings).image);
}

// Two threads are used, because nothing is timed meanwhile.
void SceneSweep::measureErrors() {
    for (Measured& m : rows_)
        sameSamples(m.row); // renders the missing images
    const auto everySecond = [this](size_t first) {
        for (size_t i = first; i < rows_.size(); i += 2)
            measureErrors(rows_[i]);
    };
    std::future<void> other = std::async(std::launch::async, everySecond, 1);
    everySecond(0);
    other.get();
}

void SceneSweep::measureErrors(Measured& m) {
    m.errorReference = metricsJson(compareImages(reference_->image, m.still.image));
    if (const Image* same = sameSamples(m.row))
        m.errorSameSamples = metricsJson(compareImages(*same, m.still.image));
    if (isHeavier(m.row))
        return;
    const std::string name = m.row.name();
    m.imageFile = writeImage(name, m.still.image);
    const std::string difference = prefix_ + "-" + name + "-diff.png";
    writeDifferencePng(images_ / difference, reference_->image, m.still.image, 4);
    m.differenceFile = "images/" + difference;
}

void SceneSweep::measureFrames() {
    const RenderSettings still = base_;
    for (uint32_t turn = 1; turn < options_.warmUpTurns; ++turn)
        takeTurn(turn, 0, true, [](Measured&, RenderResult&) {});
    std::map<const Measured*, TemporalAccumulator> shifts;
    for (uint32_t round = 0; round < options_.rounds; ++round) {
        step("times of frames");
        base_.jitter = pixelOffset(round);
        const Reference* reference = options_.temporalSamples ? &temporalReference("shift", round) : nullptr;
        takeTurn(round, 0, true, [&](Measured& m, RenderResult& result) {
            m.frameMs.insert(m.frameMs.end(), result.frameMs.begin(), result.frameMs.end());
            if (!reference || isHeavier(m.row))
                return;
            shifts[&m].add(result.image, reference->image);
            m.shiftNoise += reference->splitHalfMseTm;
        });
    }
    for (Measured& m : rows_)
        if (shifts.count(&m))
            m.temporal = temporalJson(shifts[&m], m.shiftNoise);
    base_ = still;
}

void SceneSweep::measurePasses() {
    takeTurn(0, AGAA_CONFIG_TIMESTAMPS, true, [](Measured&, RenderResult&) {}); // warm-up
    for (uint32_t round = 0; round < options_.timedRounds; ++round) {
        step("times of passes");
        const bool withHeavier = round < options_.heavierTimedRounds;
        takeTurn(round, AGAA_CONFIG_TIMESTAMPS, withHeavier, [](Measured& m, RenderResult& result) {
            m.timed.insert(m.timed.end(), result.statistics.begin(), result.statistics.end());
        });
    }
}

void SceneSweep::measurePath() {
    step("errors along a camera path");
    const RenderSettings still = base_;
    for (Measured& m : rows_) {
        // A frame of "taa" would need the frames before it.
        if (isHeavier(m.row) || m.row.samples > options_.pathSamples || m.row.technique == "taa")
            continue;
        TemporalAccumulator path;
        for (uint32_t frame = 0; frame < options_.pathFrames; ++frame) {
            base_.camera = walkingCamera(still.camera, frame, base_.height);
            const Reference& reference = temporalReference("path", frame);
            path.add(render(m.row).image, reference.image);
            m.pathNoise += reference.splitHalfMseTm;
        }
        if (path.count())
            m.path = temporalJson(path, m.pathNoise);
    }
    base_ = still;
}

const Reference& SceneSweep::temporalReference(const char* kind, uint32_t frame) {
    RenderSettings settings = base_;
    // If the references of all frames shared random numbers, these would count as bias of the measured rows.
    settings.ditherFrame = 1 + frame;
    return references_.get(kind + std::to_string(frame), renderer_, settings, options_.temporalSamples);
}

// Alternates frames with and without each effect. Errors are against ssaa with all effects.
json SceneSweep::ablation() {
    const Image& reference = *sameSamples(SweepRow{"agaa", 8, 2});
    Scene bare = scene_;
    for (Material& material : bare.materials)
        material.normalTexture = -1;
    json list = json::array();
    for (const SweepEffect& effect : sweepEffects()) {
        if (options_.effectsOfRows && std::none_of(rows_.begin(), rows_.end(), [&](const Measured& m) {
                return m.row.name() == effect.row.name();
            }))
            continue;
        const bool calledFor = isCalledFor(effect, scene_, base_.facts);
        std::vector<double> ms[2];
        double error[2] = {};
        for (uint32_t round = 0; round < 2 * options_.effectRounds; ++round) {
            const bool off = (round % 4 == 1) || (round % 4 == 2); // A B B A
            RenderSettings settings = base_;
            effect.row.apply(settings.config);
            if (off && effect.off)
                effect.off(settings.config);
            else if (off)
                settings.facts.flags &= ~effect.fact;
            const bool loads = effect.ofNormalMaps && calledFor;
            if (loads)
                renderer_.load(off ? bare : scene_);
            settings.warmup = loads || round < 2 ? 1 : options_.untimedFrames;
            const RenderResult result = renderer_.render(settings);
            ms[off].push_back(result.frameMs.back());
            if (round < 2) // one frame with and one without, because the image does not change
                error[off] = compareImages(reference, result.image).mseTm;
        }
        if (effect.ofNormalMaps && calledFor)
            renderer_.load(scene_);
        const auto side = [&](int which) { return json{{"frameMs", timesJson(ms[which])}, {"mseTm", error[which]}}; };
        list.push_back({{"effect", effect.name},
                        {"n", effect.row.samples},
                        {"c", effect.row.aggregates},
                        {"preset", effect.row.preset},
                        {"tier", agaaTierName(effect.row.generationTier)},
                        {"calledFor", calledFor},
                        {"on", side(0)},
                        {"off", side(1)}});
    }
    return list;
}

uint32_t SceneSweep::timeSource() const { return rows_.front().timed.front().timeSource; }

std::string SceneSweep::writeImage(const std::string& name, const Image& image) const {
    const std::string file = prefix_ + "-" + name + (options_.jpegQuality ? ".jpg" : ".png");
    if (options_.jpegQuality)
        writeJpeg(images_ / file, image, int(options_.jpegQuality));
    else
        writePng(images_ / file, image);
    return "images/" + file;
}

json SceneSweep::rowJson(const Measured& m) const {
    json passes = json::array();
    std::map<std::string, double> stages;
    const AgaaFrameStatistics& first = m.timed.front();
    for (uint32_t i = 0; i < first.passCount; ++i) {
        std::vector<double> values;
        for (const AgaaFrameStatistics& frame : m.timed)
            values.push_back(frame.passes[i].milliseconds);
        const char* stage = agaaStageName(first.passes[i].stage);
        passes.push_back({{"name", first.passes[i].name},
                          {"stage", stage},
                          {"ms", first.passes[i].isTimed ? timesJson(values) : json()}});
        stages[stage] += quantile(values, 0.5);
    }
    json tiers = json::object();
    for (const auto& [stage, tier] : m.still.plan.tiers)
        tiers[stage] = tier;
    const AgaaCounters& c = m.counters;
    const double pixels = double(base_.width) * base_.height;
    return {{"technique", m.row.technique},
            {"n", m.row.samples},
            {"c", m.row.aggregates},
            {"shadingCost", m.row.shadingCost},
            {"preset", m.row.preset},
            {"tiers", tiers},
            {"frameMs", timesJson(m.frameMs)},
            {"passes", passes},
            {"stageMs", stages},
            {"geometryPasses", m.still.statistics.back().geometryPasses},
            {"bytesPerPixel", m.still.memory.bytesPerPixel},
            {"peakBytesPerPixel", double(m.still.memory.peakBytes) / pixels},
            {"eventsPerPixel", double(c.shadingEvents) / pixels},
            {"eventsPerCoveredPixel", c.shadedPixels ? double(c.shadingEvents) / double(c.shadedPixels) : 0.0},
            {"shadowTapsPerPixel", double(c.shadowTaps) / pixels},
            {"lightEvaluationsPerPixel", double(c.lightEvaluations) / pixels},
            {"aggregatesPerPixel", double(c.aggregates) / pixels},
            {"primitivesPerPixel", double(c.primitives) / pixels},
            {"materialsPerPixel", double(c.materials) / pixels},
            {"fragmentsPerPixel", double(c.fragments) / pixels},
            {"lostFragments", c.lostFragments},
            {"widenedLobesPerPixel", double(c.widenedLobes) / pixels},
            {"errorSameSamples", m.errorSameSamples},
            {"errorReference", m.errorReference},
            {"temporal", m.temporal},
            {"path", m.path},
            {"image", m.imageFile},
            {"difference", m.differenceFile},
            {"heat", m.heatFile}};
}

} // namespace harness
