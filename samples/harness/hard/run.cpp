#include "hard/run.h"

#include "image/tonemap.h"
#include "render/reference.h"
#include "scene/builtin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace harness::hard {

namespace {

struct Errors {
    double mseTm = 0, maxTm = 0, meanError = 0;
};

bool isBlack(const Image& image) {
    return std::ranges::all_of(image.rgb, [](float value) { return value <= 0; });
}

Errors errorsOf(const Image& image, const Image& reference) {
    Errors errors;
    double sum = 0, expected = 0;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const double a = double(image.rgb[i]), b = double(reference.rgb[i]);
        const double difference = toneMap(a) - toneMap(b);
        errors.mseTm += difference * difference;
        errors.maxTm = std::max(errors.maxTm, std::fabs(difference));
        sum += a;
        expected += b;
    }
    errors.mseTm /= double(image.rgb.size());
    errors.meanError = std::fabs(sum - expected) / std::max(expected, 1e-9);
    return errors;
}

// The standard error of the reference's mean, by its mean. The channels of a pixel share their noise.
double meanErrorOf(const Reference& reference) {
    const size_t count = reference.image.rgb.size();
    const double sum = std::accumulate(reference.image.rgb.begin(), reference.image.rgb.end(), 0.0);
    return std::sqrt(3 * reference.splitHalfMse * double(count)) / std::max(sum, 1e-9);
}

uint64_t nonFiniteOf(const Image& image) {
    return uint64_t(std::ranges::count_if(image.rgb, [](float value) { return !std::isfinite(value); }));
}

// Asks the planner about a view. Returns its sentence, or an empty one if it plans the view.
class Planner {
public:
    AgaaResult plan(const RenderSettings& settings, const AgaaDeviceCaps& caps) {
        message_.clear();
        AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
        view.width = settings.width;
        view.height = settings.height;
        view.config = &settings.config;
        view.facts = &settings.facts;
        view.flags = settings.reversedZ ? AGAA_VIEW_REVERSED_Z : 0;
        AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
        fetch.glsl = "";
        fetch.maxDraws = fetch.maxPrimitives = 1u << 15;
        if (settings.config.fetches())
            view.pNext = &fetch;
        const AgaaLog log = {AGAA_STRUCTURE_TYPE_LOG, sizeof(AgaaLog), nullptr, keep, &message_};
        AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
        uint32_t count = 0;
        return agaaQueryMemory(&view, &caps, &log, &report, &count, nullptr);
    }
    const std::string& message() const { return message_; }

private:
    static void AGAA_CALL keep(void* user, uint32_t, AgaaResult, const char* message) {
        *static_cast<std::string*>(user) = message;
    }
    std::string message_;
};

// Returns the largest width in [1, caps.maxImageSize] that the planner accepts.
uint32_t widestTarget(RenderSettings settings, const AgaaDeviceCaps& caps) {
    Planner planner;
    uint32_t accepted = 1, refused = caps.maxImageSize + 1;
    while (accepted + 1 < refused) {
        settings.width = accepted + (refused - accepted) / 2;
        (planner.plan(settings, caps) >= 0 ? accepted : refused) = settings.width;
    }
    return accepted;
}

// Returns a sentence of the SDK without the name of the call.
std::string_view withoutCall(std::string_view sentence) {
    const size_t colon = sentence.find(": ");
    return colon == std::string_view::npos ? sentence : sentence.substr(colon + 2);
}

// Expects that the planner and the view refuse one pixel more than the widest target for the same reason. Returns what
// differs from that, or nothing.
std::string acceptanceBeyond(Renderer& renderer, RenderSettings settings) {
    ++settings.width;
    Planner planner;
    if (planner.plan(settings, renderer.caps()) != AGAA_ERROR_TOO_LARGE || planner.message().empty())
        return "The planner does not refuse " + std::to_string(settings.width) + " pixels as too large.";
    try {
        renderer.render(settings);
    } catch (const std::runtime_error& error) {
        if (withoutCall(error.what()) == withoutCall(planner.message()))
            return {};
        return std::string("Another sentence refuses one pixel more: ") + error.what();
    }
    return "A view of " + std::to_string(settings.width) + " pixels is created.";
}

// Returns every parts-th job of each frame. Neighbouring frames begin with different jobs.
std::vector<HardJob> partOf(const std::vector<HardJob>& jobs, uint32_t part, uint32_t parts) {
    std::vector<HardJob> chosen;
    size_t index = 0; // within the frame
    for (size_t i = 0; i < jobs.size(); ++i) {
        index = i > 0 && jobs[i].frame == jobs[i - 1].frame ? index + 1 : 0;
        if ((index + jobs[i].frame) % parts == part)
            chosen.push_back(jobs[i]);
    }
    return chosen;
}

class Runner {
public:
    Runner(const MakeBackend& makeBackend, const HardOptions& options) : makeBackend_(makeBackend), options_(options) {}

    HardReport run(const std::vector<HardJob>& all) {
        std::vector<HardJob> jobs = planned(all);
        if (options_.perPair)
            jobs = coveringJobs(jobs, options_.perPair);
        jobs = partOf(jobs, options_.part, options_.parts);
        for (size_t begin = 0; begin < jobs.size();) {
            size_t end = begin;
            while (end < jobs.size() && jobs[end].frame == jobs[begin].frame &&
                   jobs[end].backend == jobs[begin].backend)
                ++end;
            runGroup({jobs.begin() + ptrdiff_t(begin), jobs.begin() + ptrdiff_t(end)});
            begin = end;
        }
        return std::move(report_);
    }

private:
    Renderer& backend(const HardJob& job) {
        const bool isWithoutD24 = hardFrames()[job.frame].isWithoutD24;
        std::unique_ptr<Renderer>& renderer = backends_[{job.backend, isWithoutD24}];
        if (!renderer) {
            renderer = makeBackend_(job.backend, isWithoutD24);
            if (!isWithoutD24)
                report_.devices.push_back({job.backend, renderer->caps().deviceName, renderer->caps().driverName});
        }
        return *renderer;
    }

    // Returns the jobs that the SDK plans, and reports the others.
    std::vector<HardJob> planned(const std::vector<HardJob>& all) {
        std::vector<HardJob> jobs;
        std::optional<Scene> scene;
        for (size_t i = 0; i < all.size(); ++i) {
            const HardFrame& frame = hardFrames()[all[i].frame];
            if (i == 0 || all[i].frame != all[i - 1].frame)
                scene = makeBuiltinScene(frame.scene);
            RenderSettings settings = settingsOf(frame, *scene);
            settings.width = std::max(settings.width, 1u);
            hardConfigurations()[all[i].configuration].apply(settings.config);
            Planner planner;
            if (planner.plan(settings, backend(all[i]).caps()) >= 0) {
                jobs.push_back(all[i]);
                continue;
            }
            HardResult refused;
            refused.job = all[i];
            refused.refusal = planner.message();
            add(std::move(refused));
        }
        return jobs;
    }

    void add(HardResult result) {
        if (options_.report)
            options_.report(result);
        report_.results.push_back(std::move(result));
    }

    // Runs jobs of one frame on one backend.
    void runGroup(const std::vector<HardJob>& jobs) {
        const HardFrame& frame = hardFrames()[jobs[0].frame];
        Renderer& renderer = backend(jobs[0]);
        const Scene scene = *makeBuiltinScene(frame.scene);
        std::map<size_t, Image> others; // by configuration
        if (frame.other)
            others = renderOthers(frame, scene, jobs, renderer);
        renderer.load(scene);
        for (const HardJob& job : jobs) {
            HardResult result = runJob(job, scene, renderer, others);
            for (const ApiMessage& message : renderer.takeMessages())
                report_.messages.push_back(message.id + ": " + message.text);
            add(std::move(result));
        }
    }

    std::map<size_t, Image> renderOthers(const HardFrame& frame, const Scene& own, const std::vector<HardJob>& jobs,
                                         Renderer& renderer) {
        const Scene scene = frame.other->scene ? *makeBuiltinScene(frame.other->scene) : own;
        renderer.load(scene);
        std::map<size_t, Image> images;
        for (const HardJob& job : jobs) {
            RenderSettings settings = settingsOf(frame, scene);
            if (frame.other->adjust)
                frame.other->adjust(settings);
            hardConfigurations()[job.configuration].apply(settings.config);
            images[job.configuration] = renderer.render(settings).image;
        }
        return images;
    }

    HardResult runJob(const HardJob& job, const Scene& scene, Renderer& renderer,
                      const std::map<size_t, Image>& others) {
        const HardFrame& frame = hardFrames()[job.frame];
        const HardConfiguration& configuration = hardConfigurations()[job.configuration];
        HardResult result;
        result.job = job;
        RenderSettings settings = settingsOf(frame, scene);
        configuration.apply(settings.config);
        try {
            if (frame.isWidest)
                settings.width = widestTarget(settings, renderer.caps());
            result.width = settings.width;
            result.height = settings.height;
            render(result, frame, configuration, settings, renderer, others);
            if (frame.isWidest)
                result.failure = acceptanceBeyond(renderer, settings);
        } catch (const std::exception& error) {
            result.failure = error.what();
        }
        return result;
    }

    void render(HardResult& result, const HardFrame& frame, const HardConfiguration& configuration,
                const RenderSettings& settings, Renderer& renderer, const std::map<size_t, Image>& others) {
        Rendered rendered{renderer, settings,       configuration,    renderer.render(settings),
                          nullptr,  &result.frames, &result.nonFinite};
        ++result.frames;
        const AgaaCounters& counters = rendered.result.statistics.back().counters;
        result.sanitised = counters.sanitised;
        result.lostFragments = counters.lostFragments;
        result.nonFinite += nonFiniteOf(rendered.result.image);
        const Reference& reference = referenceOf(result.job.frame, frame, settings, renderer);
        const Errors errors = errorsOf(rendered.result.image, reference.image);
        result.mseTm = errors.mseTm;
        result.maxTm = errors.maxTm;
        result.meanError = errors.meanError;
        const size_t shading = size_t(configuration.shading());
        // The reference has an error of its own.
        result.referenceMseTm = reference.splitHalfMseTm;
        result.maxMseTm = frame.maxMseTm[shading] + 4 * result.referenceMseTm;
        result.maxMeanError = frame.maxMeanError[shading] + 4 * meanErrorOf(reference);
        const auto other = others.find(result.job.configuration);
        if (other != others.end()) {
            rendered.other = &other->second;
            ++result.frames;
            result.nonFinite += nonFiniteOf(other->second);
        }
        if (frame.check)
            result.finding = frame.check(rendered);
        if (configuration.samples >= 8 && isBlack(rendered.result.image) && !isBlack(reference.image))
            result.failure = "black image";
    }

    // Backends share references, whose errors are larger than the difference of the backends.
    const Reference& referenceOf(size_t index, const HardFrame& frame, const RenderSettings& settings,
                                 Renderer& renderer) {
        const auto key = std::tuple(index, settings.width, settings.height);
        const auto known = references_.find(key);
        if (known != references_.end())
            return known->second;
        uint32_t spp = options_.spp ? std::min(options_.spp, frame.spp) : frame.spp;
        RenderSettings plain = settings;
        plain.config = TechniqueConfig();
        plain.config.layout = settings.config.layout;
        return references_[key] = renderReference(renderer, plain, std::max(spp, 2u));
    }

    const MakeBackend& makeBackend_;
    const HardOptions& options_;
    std::map<std::pair<std::string, bool>, std::unique_ptr<Renderer>> backends_; // by API and absence of D24
    std::map<std::tuple<size_t, uint32_t, uint32_t>, Reference> references_;
    HardReport report_;
};

} // namespace

std::string HardResult::excess() const {
    if (isRefused())
        return {};
    std::string text;
    const auto add = [&text](const std::string& phrase) { text += (text.empty() ? "" : ", ") + phrase; };
    if (!failure.empty())
        add(failure);
    if (nonFinite)
        add("non-finite pixels");
    if (sanitised)
        add("sanitised materials");
    if (lostFragments)
        add("lost fragments");
    if (!(mseTm <= maxMseTm))
        add("error");
    if (!(meanError <= maxMeanError))
        add("mean");
    if (finding && !finding->isWithin())
        add("check");
    return text;
}

bool HardResult::isWithin() const { return excess().empty(); }

std::vector<HardJob> allJobs(const std::vector<size_t>& frames, const std::vector<size_t>& configurations,
                             const std::vector<std::string>& backends) {
    std::vector<HardJob> jobs;
    for (const size_t frame : frames)
        for (const std::string& backend : backends)
            for (const size_t configuration : configurations) {
                const HardFrame& row = hardFrames()[frame];
                const bool isPossible = backend == "vk" || !row.isWithoutD24;
                if (isPossible && (!row.isFor || row.isFor(hardConfigurations()[configuration])))
                    jobs.push_back({frame, configuration, backend});
            }
    return jobs;
}

HardReport runJobs(const std::vector<HardJob>& jobs, const MakeBackend& makeBackend, const HardOptions& options) {
    return Runner(makeBackend, options).run(jobs);
}

} // namespace harness::hard
