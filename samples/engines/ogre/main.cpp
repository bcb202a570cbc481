/* Renders a scene of OGRE without the SDK and with several of its techniques, and checks the integration.
 *   ogre_host [--out DIR] [--frames N] [--size WIDTH HEIGHT]
 * It prints one JSON object. The exit status is 1 if a check fails. It needs an X server, for example xvfb-run.
 * SPDX-License-Identifier: MIT
 */
#include "adapter.h"
#include "common/gl_state.h"
#include "scene.h"
#include "shaders.h"

#include <RenderSystems/GL3Plus/OgreGL3PlusRenderSystem.h>

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
constexpr char imageKept[] = "OGRE's own image keeps its bits";
constexpr char stateKept[] = "the OpenGL state is as before";
constexpr char noErrors[] = "no OpenGL errors";
constexpr char sameModel[] = "engine and SDK light alike";
constexpr char errorsFall[] = "errors are below that of OGRE's own image";
constexpr const char* checks[] = {passesAgree, imageKept, stateKept, noErrors, sameModel, errorsFall};

using Pixels = std::vector<float>; // linear RGBA, row 0 on top

struct Result {
    AgaaCounters counters{}; // sums over the frames
    uint64_t invalidPixels = 0, misplaced = 0;
    bool isValid = true;
    double error = 0.0; // mean over the frames
    std::string passes, explanation;
    Pixels picture; // of the last frame
};

Pixels readTexture(const Ogre::TexturePtr& texture) {
    Pixels pixels(4 * size_t(texture->getWidth()) * texture->getHeight());
    texture->getBuffer()->blitToMemory(
        Ogre::PixelBox(texture->getWidth(), texture->getHeight(), 1, Ogre::PF_FLOAT32_RGBA, pixels.data()));
    return pixels;
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
    Ogre::TexturePtr createTarget(const char* name) const;
    void setFrame(uint32_t frame) { m_scene->setTime(0.7f * float(frame)); }
    Pixels renderEngine(float offsetX = 0.0f, float offsetY = 0.0f);
    Pixels renderReference();
    Result renderSdk(agaaOgre::Adapter& adapter, const Technique& technique, const std::vector<Pixels>& references);
    void addStatistics(const agaaOgre::Adapter& adapter, Result& result) const;
    void checkEngineImages(const char* when);
    void checkErrors(const char* when);
    void fail(const char* check, const std::string& sentence);
    void writePicture(const std::string& name, const Pixels& pixels) const;
    void report(const std::vector<Result>& results, double engineError, double modelError) const;

    Options m_options;
    Ogre::Root m_root;
    std::unique_ptr<Scene> m_scene;
    Ogre::GL3PlusRenderSystem* m_renderSystem;
    Ogre::TexturePtr m_engineTarget, m_output;
    std::vector<Pixels> m_engineImages; // by frame, before the SDK was loaded
    std::vector<std::string> m_failures;
    std::set<std::string> m_failedChecks;
};

Host::Host(const Options& options) : m_options(options), m_root("", "", "") {
    m_root.loadPlugin(OGRE_PLUGINS "/RenderSystem_GL3Plus");
    m_root.loadPlugin(OGRE_PLUGINS "/Codec_STBI");
    m_root.setRenderSystem(m_root.getAvailableRenderers().at(0));
    m_renderSystem = dynamic_cast<Ogre::GL3PlusRenderSystem*>(m_root.getRenderSystem());
    m_root.initialise(false);
    const Ogre::NameValuePairList hidden = {{"hidden", "true"}};
    m_root.createRenderWindow("ogre_host", 64, 64, false, &hidden);
    Ogre::ResourceGroupManager::getSingleton().initialiseAllResourceGroups();
    countSevereMessages();
    m_scene = std::make_unique<Scene>(m_root);
    m_scene->camera().setAspectRatio(float(options.width) / float(options.height));
    m_engineTarget = createTarget("host/engine");
    m_output = createTarget("host/output");
    Ogre::RenderTarget& target = *m_engineTarget->getBuffer()->getRenderTarget();
    target.setAutoUpdated(false);
    Ogre::Viewport* viewport = target.addViewport(&m_scene->camera());
    viewport->setBackgroundColour(Scene::background());
}

Ogre::TexturePtr Host::createTarget(const char* name) const {
    return Ogre::TextureManager::getSingleton().createManual(name, Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D,
                                                             m_options.width, m_options.height, 0,
                                                             Ogre::PF_FLOAT32_RGBA, Ogre::TU_RENDERTARGET);
}

/* Renders with OGRE alone; the offset moves the image by a part of a pixel. */
Pixels Host::renderEngine(float offsetX, float offsetY) {
    Ogre::Camera& camera = m_scene->camera();
    if (offsetX != 0.0f || offsetY != 0.0f) {
        Ogre::Matrix4 projection = camera.getProjectionMatrix();
        projection[0][2] += 2.0f * offsetX / float(m_options.width);
        projection[1][2] += 2.0f * offsetY / float(m_options.height);
        camera.setCustomProjectionMatrix(true, projection);
    }
    m_engineTarget->getBuffer()->getRenderTarget()->update();
    camera.setCustomProjectionMatrix(false);
    return readTexture(m_engineTarget);
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

void Host::checkErrors(const char* when) {
    if (const unsigned count = takeGlErrors())
        fail(noErrors, std::to_string(count) + " OpenGL errors " + when + ".");
}

void Host::checkEngineImages(const char* when) {
    for (uint32_t frame = 0; frame < m_options.frames; ++frame) {
        setFrame(frame);
        if (renderEngine() != m_engineImages[frame])
            fail(imageKept, "OGRE's own image of frame " + std::to_string(frame) + " changed " + when + ".");
    }
}

void Host::addStatistics(const agaaOgre::Adapter& adapter, Result& result) const {
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

Result Host::renderSdk(agaaOgre::Adapter& adapter, const Technique& technique, const std::vector<Pixels>& references) {
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
        adapter.synchroniseState();
        const GlState before = readGlState();
        checkErrors("before a frame of the SDK");
        adapter.record(m_scene->camera(), m_output, Scene::background());
        checkErrors((std::string("in a frame of ") + technique.label).c_str());
        const std::string states = differingStates(before, readGlState());
        if (!states.empty())
            fail(stateKept, std::string("A frame of ") + technique.label + " changed the state " + states + ".");
        addStatistics(adapter, result);
        result.picture = readTexture(m_output);
        result.error += meanSquareError(result.picture, references[frame]) / m_options.frames;
    }
    checkEngineImages((std::string("after frames of ") + technique.label).c_str());
    checkErrors("in OGRE's own frames");
    return result;
}

void Host::writePicture(const std::string& name, const Pixels& pixels) const {
    if (m_options.out.empty())
        return;
    std::vector<uint8_t> bytes;
    for (size_t i = 0; i < pixels.size(); ++i)
        bytes.push_back(i % 4 == 3 ? 255 : uint8_t(std::lround(255.0 * display(pixels[i]))));
    Ogre::Image image;
    image.loadDynamicImage(bytes.data(), m_options.width, m_options.height, 1, Ogre::PF_BYTE_RGBA);
    image.save(m_options.out + "/" + name + ".png");
}

void Host::report(const std::vector<Result>& results, double engineError, double modelError) const {
    std::printf("{\"engine\": \"OGRE %d.%d.%d\", \"device\": \"%s\", \"size\": [%u, %u], \"frames\": %u,\n",
                OGRE_VERSION_MAJOR, OGRE_VERSION_MINOR, OGRE_VERSION_PATCH,
                m_renderSystem->getCapabilities()->getDeviceName().c_str(), m_options.width, m_options.height,
                m_options.frames);
    std::printf(" \"engineError\": %.4e, \"modelError\": %.4e,\n \"techniques\": [\n", engineError, modelError);
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
        std::printf("%s\"%s\"", i ? ", " : "", m_failures[i].c_str());
    std::printf("]}\n");
}

bool Host::run() {
    std::vector<Pixels> references;
    double engineError = 0.0;
    for (uint32_t frame = 0; frame < m_options.frames; ++frame) {
        setFrame(frame);
        m_engineImages.push_back(renderEngine());
        references.push_back(renderReference());
        engineError += meanSquareError(m_engineImages.back(), references.back()) / m_options.frames;
    }
    checkErrors("before the SDK was loaded");
    writePicture("reference", references.back());
    writePicture("before", m_engineImages.back());

    std::vector<Result> results;
    double modelError;
    {
        agaaOgre::Adapter adapter(*m_renderSystem, m_scene->manager());
        adapter.setSurfaceText("scene/fragment", fragmentText);
        checkEngineImages("although the SDK was not used");
        modelError = renderSdk(adapter, single, m_engineImages).error;
        if (modelError > modelTolerance)
            fail(sameModel, "The lighting of the engine and of the SDK differ.");
        for (const Technique& technique : techniques) {
            const Result result = renderSdk(adapter, technique, references);
            const AgaaCounters& c = result.counters;
            const std::string label = technique.label;
            if (!result.isValid || result.invalidPixels || c.once != c.visible)
                fail(passesAgree, label + ": the draw passes do not agree. " + result.explanation);
            if (result.error >= engineError)
                fail(errorsFall, label + ": the error is not below that of OGRE's own image.");
            writePicture(label, result.picture);
            results.push_back(result);
        }
    }
    checkEngineImages("after the SDK was removed");
    if (severeMessages())
        fail(noErrors, "OpenGL reported " + std::to_string(severeMessages()) + " messages of high severity.");
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
            std::fprintf(stderr, "Usage: ogre_host [--out DIR] [--frames N] [--size WIDTH HEIGHT]\n");
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
        // OGRE's messages go to a file or nowhere: standard output is for the result.
        Ogre::LogManager log;
        log.createLog(options.out.empty() ? "ogre.log" : options.out + "/ogre.log", true, false, options.out.empty());
        return Host(options).run() ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return EXIT_FAILURE;
    }
}
