/* Renders a scene of Qt Quick 3D without the SDK and with several of its techniques, and checks the integration.
 *   qtquick3d_host [--out DIR] [--frames N] [--size WIDTH HEIGHT]
 * It prints one JSON object. The exit status is 1 if a check fails. It needs an X server, for example xvfb-run.
 * SPDX-License-Identifier: MIT
 */
#include "adapter.h"
#include "renderer.h"
#include "scene.h"
#include "vulkan_device.h"

#include <QtCore/QFile>
#include <QtGui/QGuiApplication>
#include <QtGui/QImage>

#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace {

struct Options {
    std::string out; // empty: no pictures
    uint32_t frames = 3, width = 480, height = 270;
};

struct Technique {
    const char* label; // of the report and of the picture
    const char* name;  // AgaaConfig::technique
    uint32_t samples, aggregates, generationTier;
};

constexpr Technique techniques[] = {
    {"agaa-two-passes", "agaa", 8, 2, AGAA_TIER_AUTO},
    {"agaa-gbuffer", "agaa", 8, 2, AGAA_TIER_GBUFFER},
    {"ssaa", "ssaa", 8, 1, AGAA_TIER_AUTO},
    {"simple_complex", "simple_complex", 8, 1, AGAA_TIER_AUTO},
    {"sbaa", "sbaa", 8, 2, AGAA_TIER_AUTO},
    {"adaptive", "adaptive", 8, 1, AGAA_TIER_AUTO},
};
constexpr Technique single = {"single", "single", 1, 1, AGAA_TIER_AUTO};
constexpr int referenceFrames = 64;
constexpr double modelTolerance = 1e-4; // mean square error between the lighting of engine and SDK at one sample

constexpr char passesAgree[] = "each visible sample is accumulated once";
constexpr char imageKept[] = "Qt's own image keeps its bits";
constexpr char sharedFrames[] = "Qt's frames that contain a frame of the SDK keep their image";
constexpr char noMessages[] = "no validation messages in frames of the SDK";
constexpr char sameModel[] = "engine and SDK light alike";
constexpr char errorsFall[] = "errors are below that of Qt's own image";
constexpr const char* checks[] = {passesAgree, imageKept, sharedFrames, noMessages, sameModel, errorsFall};

struct Result {
    AgaaCounters counters{}; // sums over the frames
    uint64_t invalidPixels = 0, misplaced = 0;
    bool isValid = true;
    double error = 0.0; // mean over the frames
    std::string passes, explanation;
    Pixels picture; // of the last frame
};

std::string readResource(const char* name) {
    QFile file(name);
    if (!file.open(QFile::ReadOnly))
        throw std::runtime_error(std::string(name) + " is missing.");
    return file.readAll().toStdString();
}

/* Returns a text without the characters that JSON does not allow in strings. */
std::string plain(std::string text) {
    for (char& c : text)
        if (c == '"' || c == '\\' || c < ' ')
            c = '\'';
    return text;
}

double display(float linear) { return std::pow(double(linear) / (1.0 + double(linear)), 1.0 / 2.2); }

/* Returns the mean square error of what a display shows. */
double meanSquareError(const Pixels& a, const Pixels& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        if (i % 4 != 3)
            sum += std::pow(display(a[i]) - display(b[i]), 2.0);
    return sum / (0.75 * double(a.size()));
}

class Host {
public:
    explicit Host(const Options& options);
    bool run(); // returns whether all checks passed

private:
    void setFrame(uint32_t frame) { m_scene.setTime(0.7f * float(frame)); }
    Pixels renderEngine(float offsetX = 0.0f, float offsetY = 0.0f);
    Pixels renderReference();
    Result renderSdk(agaaQt::Adapter& adapter, const Technique& technique, const std::vector<Pixels>& references);
    void addStatistics(const agaaQt::Adapter& adapter, Result& result) const;
    void checkEngineImages(const char* when);
    void checkMessages(const char* when);
    void fail(const char* check, const std::string& sentence);
    void writePicture(const std::string& name, const Pixels& pixels) const;
    void report(const std::vector<Result>& results, double engineError, double modelError) const;

    Options m_options;
    VulkanDevice m_device;
    Scene m_scene;
    Renderer m_renderer;
    Image m_output;
    std::vector<Pixels> m_engineImages; // by frame, before the SDK was loaded
    size_t m_engineMessages = 0;        // validation messages before the SDK was loaded
    std::vector<std::string> m_failures;
    std::set<std::string> m_failedChecks;
};

Host::Host(const Options& options)
    : m_options(options), m_scene(options.width, options.height),
      m_renderer(m_device, m_scene.view3D(), options.width, options.height),
      m_output(m_device, options.width, options.height, VK_IMAGE_USAGE_STORAGE_BIT) {
    if (!m_device.hasValidation())
        throw std::runtime_error("The validation layer is missing: install vulkan-validationlayers.");
}

/* Renders with Qt alone; the offset moves the image by a part of a pixel. */
Pixels Host::renderEngine(float offsetX, float offsetY) {
    m_scene.setOffset(offsetX, offsetY);
    Pixels pixels = m_renderer.render();
    m_scene.setOffset(0.0f, 0.0f);
    return pixels;
}

/* Returns the mean of images at the points of a lattice in the pixel. */
Pixels Host::renderReference() {
    std::vector<double> sums(4 * size_t(m_options.width) * m_options.height);
    for (int i = 0; i < referenceFrames; ++i) {
        const float x = (float(i) + 0.5f) / referenceFrames;
        const float y = (float(19 * i % referenceFrames) + 0.5f) / referenceFrames;
        const Pixels pixels = renderEngine(x - 0.5f, y - 0.5f);
        for (size_t k = 0; k < sums.size(); ++k)
            sums[k] += double(pixels[k]);
    }
    Pixels mean;
    for (const double sum : sums)
        mean.push_back(float(sum / referenceFrames));
    return mean;
}

void Host::fail(const char* check, const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    m_failedChecks.insert(check);
    m_failures.push_back(sentence);
}

void Host::checkMessages(const char* when) {
    for (const std::string& message : m_device.takeMessages())
        fail(noMessages, std::string("Validation message ") + when + ": " + message);
}

void Host::checkEngineImages(const char* when) {
    for (uint32_t frame = 0; frame < m_options.frames; ++frame) {
        setFrame(frame);
        if (renderEngine() != m_engineImages[frame])
            fail(imageKept, "Qt's own image of frame " + std::to_string(frame) + " changed " + when + ".");
    }
}

void Host::addStatistics(const agaaQt::Adapter& adapter, Result& result) const {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    if (agaaGetFrameStatistics(adapter.view(), adapter.frameIndex(), &statistics) != AGAA_OK ||
        agaaValidateFrame(adapter.view(), adapter.frameIndex(), &validation) != AGAA_OK) {
        result.isValid = false;
        return;
    }
    result.counters.visible += statistics.counters.visible;
    result.counters.once += statistics.counters.once;
    result.counters.uncovered += statistics.counters.uncovered;
    result.counters.overlapping += statistics.counters.overlapping;
    result.counters.shadingEvents += statistics.counters.shadingEvents;
    result.invalidPixels += validation.invalidPixels;
    result.misplaced += validation.misplaced;
    if (!validation.isValid)
        result.explanation = validation.explanation;
    result.isValid = result.isValid && validation.isValid;
}

Result Host::renderSdk(agaaQt::Adapter& adapter, const Technique& technique, const std::vector<Pixels>& references) {
    AgaaConfig config = AGAA_CONFIG_INIT;
    config.technique = technique.name;
    config.samples = technique.samples;
    config.aggregates = technique.aggregates;
    config.generationTier = technique.generationTier;
    config.flags = AGAA_CONFIG_COUNTERS;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    facts.flags = AGAA_FACT_SPECULAR | AGAA_FACT_AMBIENT | AGAA_FACT_ALPHA_MASKED | AGAA_FACT_NO_TRANSLUCENCY;
    facts.maxLights = 3;
    facts.shadowMapCount = 0;
    adapter.createView(config, facts, m_options.width, m_options.height);
    Result result;
    for (const AgaaDrawPass& pass : adapter.passes())
        result.passes += (result.passes.empty() ? "" : ", ") + std::string(pass.name);
    for (uint32_t frame = 0; frame < m_options.frames; ++frame) {
        setFrame(frame);
        const Pixels engine =
            m_renderer.render([&] { adapter.record(m_output.image(), m_output.view(), Scene::background()); });
        checkMessages((std::string("in a frame of ") + technique.label).c_str());
        if (engine != m_engineImages[frame])
            fail(sharedFrames, std::string("Qt's image in a frame of ") + technique.label + " changed.");
        addStatistics(adapter, result);
        result.picture = m_output.read(VK_IMAGE_LAYOUT_GENERAL);
        result.error += meanSquareError(result.picture, references[frame]) / m_options.frames;
    }
    checkEngineImages((std::string("after frames of ") + technique.label).c_str());
    checkMessages("in Qt's own frames");
    return result;
}

void Host::writePicture(const std::string& name, const Pixels& pixels) const {
    if (m_options.out.empty())
        return;
    QImage image(int(m_options.width), int(m_options.height), QImage::Format_RGB888);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const float* pixel = &pixels[4 * size_t(y * image.width() + x)];
            const auto byte = [pixel](int i) { return int(std::lround(255.0 * display(pixel[i]))); };
            image.setPixel(x, y, qRgb(byte(0), byte(1), byte(2)));
        }
    image.save(QString::fromStdString(m_options.out + "/" + name + ".png"));
}

void Host::report(const std::vector<Result>& results, double engineError, double modelError) const {
    std::printf("{\"engine\": \"Qt Quick 3D %s\", \"device\": \"%s\", \"size\": [%u, %u], \"frames\": %u,\n",
                qVersion(), m_device.name().c_str(), m_options.width, m_options.height, m_options.frames);
    std::printf(" \"engineError\": %.4e, \"modelError\": %.4e, \"engineMessages\": %zu,\n \"techniques\": [\n",
                engineError, modelError, m_engineMessages);
    for (size_t i = 0; i < results.size(); ++i) {
        const Result& r = results[i];
        const AgaaCounters& c = r.counters;
        std::printf("  {\"name\": \"%s\", \"samples\": %u, \"drawPasses\": \"%s\", \"visible\": %" PRIu64
                    ", \"once\": %" PRIu64 ", \"uncovered\": %" PRIu64 ", \"overlapping\": %" PRIu64
                    ", \"misplaced\": %" PRIu64 ", \"invalidPixels\": %" PRIu64 ", \"shadingEvents\": %" PRIu64
                    ", \"isValid\": %s, \"error\": %.4e}%s\n",
                    techniques[i].label, techniques[i].samples, r.passes.c_str(), c.visible, c.once, c.uncovered,
                    c.overlapping, r.misplaced, r.invalidPixels, c.shadingEvents, r.isValid ? "true" : "false", r.error,
                    i + 1 < results.size() ? "," : "");
    }
    std::printf(" ],\n \"checks\": {");
    for (size_t i = 0; i < std::size(checks); ++i)
        std::printf("%s\"%s\": %s", i ? ", " : "", checks[i], m_failedChecks.count(checks[i]) ? "false" : "true");
    std::printf("},\n \"failures\": [");
    for (size_t i = 0; i < m_failures.size(); ++i)
        std::printf("%s\"%s\"", i ? ", " : "", plain(m_failures[i]).c_str());
    std::printf("]}\n");
}

bool Host::run() {
    setFrame(0);
    renderEngine(); // Qt's first frame loads meshes and textures
    std::vector<Pixels> references;
    double engineError = 0.0;
    for (uint32_t frame = 0; frame < m_options.frames; ++frame) {
        setFrame(frame);
        m_engineImages.push_back(renderEngine());
        references.push_back(renderReference());
        engineError += meanSquareError(m_engineImages.back(), references.back()) / m_options.frames;
    }
    for (const std::string& message : m_device.takeMessages()) {
        std::fprintf(stderr, "Validation message before the SDK was loaded: %s\n", message.c_str());
        ++m_engineMessages;
    }
    writePicture("reference", references.back());
    writePicture("before", m_engineImages.back());

    std::vector<Result> results;
    double modelError;
    {
        agaaQt::Adapter adapter(m_renderer.window(), m_scene.view3D(), m_device.enabledFeatures(),
                                readResource(":/surface.vert"), readResource(":/surface.frag"));
        checkEngineImages("although the SDK was not used");
        const Result sameSamples = renderSdk(adapter, single, m_engineImages);
        writePicture(single.label, sameSamples.picture);
        modelError = sameSamples.error;
        if (modelError > modelTolerance)
            fail(sameModel, "The lighting of the engine and of the SDK differ.");
        for (const Technique& technique : techniques) {
            const Result result = renderSdk(adapter, technique, references);
            const AgaaCounters& c = result.counters;
            const std::string label = technique.label;
            if (!result.isValid || result.invalidPixels || c.once != c.visible)
                fail(passesAgree, label + ": the draw passes do not agree. " + result.explanation);
            if (result.error >= engineError)
                fail(errorsFall, label + ": the error is not below that of Qt's own image.");
            writePicture(label, result.picture);
            results.push_back(result);
        }
    }
    checkEngineImages("after the SDK was removed");
    checkMessages("after the SDK was removed");
    report(results, engineError, modelError);
    return m_failures.empty();
}

uint32_t number(const char* text, uint32_t least, uint32_t most) {
    const long value = std::strtol(text, nullptr, 10);
    if (value < long(least) || value > long(most)) {
        std::fprintf(stderr, "%s is not a number in [%u, %u].\n", text, least, most);
        std::exit(2);
    }
    return uint32_t(value);
}

Options parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string name = arguments[i];
        if (name == "--out" && i + 1 < count) {
            options.out = arguments[++i];
        } else if (name == "--frames" && i + 1 < count) {
            options.frames = number(arguments[++i], 1, 100);
        } else if (name == "--size" && i + 2 < count) {
            options.width = number(arguments[++i], 16, 4096);
            options.height = number(arguments[++i], 16, 4096);
        } else {
            std::fprintf(stderr, "Usage: qtquick3d_host [--out DIR] [--frames N] [--size WIDTH HEIGHT]\n");
            std::exit(2);
        }
    }
    return options;
}

} // namespace

int main(int count, char** arguments) {
    const Options options = parse(count, arguments);
    try {
        if (!options.out.empty())
            std::filesystem::create_directories(options.out);
        QQuickWindow::setGraphicsApi(QSGRendererInterface::Vulkan);
        QGuiApplication application(count, arguments);
        return Host(options).run() ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return EXIT_FAILURE;
    }
}
