// What the small hosts of all graphics APIs are asked to do, and the mistakes that they can be told to make.
#pragma once

#include "log_lines.h"
#include "triangles.h"

#include "render/technique_config.h"

#include <string>
#include <vector>

namespace agaa {
class PlanBuilder;
}

namespace agaa::test {

using harness::TechniqueConfig;

// A stretch of the list of triangles.
struct Run {
    uint32_t first = 0, count = 0;
    bool isMasked = false;
};

// How a host's material pass departs from its prepass.
struct Mistake {
    Run prepassSkips{}, materialSkips{};
    float materialDepth = 1; // factor of depth in clip space
    float materialAlpha = 1; // factor of masked materials' alpha
    bool noDepthTest = false;
    bool noStencilTest = false;
};

struct ViewSettings {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    uint32_t width = 48;
    uint32_t height = 32;
    uint64_t flags = 0;
    const void* chained = nullptr; // to the view: functions of the host's
    glm::mat4 projection = perspective(60, 1.5f, 0.1f, 100);
    glm::mat4 view{1};
    // What the material shader does instead of passing the triangle's material on.
    enum class Shader {
        Material,
        PrimitiveIds,
        UvInside,
        UvAtCentre,
        OwnDepth,       // writes gl_FragDepth and discards
        ThirdUnfetched, // says of each third triangle that it cannot be fetched
    } shader = Shader::Material;
    // GLSL statements in one line that change `AgaaSurfaceInput s` last; `position` is a plain fragment input, `spare`
    // has Material::specular.w and emissive.w.
    const char* surface = "";
    Mistake mistake;
    void (*build)(PlanBuilder&) = nullptr; // of the plan, in place of the technique's
    bool fetches() const {                 // materials, by ids
        return config.generationTier == AGAA_TIER_IDS || config.generationTier == AGAA_TIER_FRAGMENT_LISTS ||
               config.generationTier == AGAA_TIER_FRAGMENTS;
    }
    bool hasInterlock = false;      // the words of the tier interlock stay in shaders
    bool computesTriangles = false; // AgaaFetchFunction::maxTriangles
    uint32_t instances = 1;         // each shifted by instanceStep against the one before, and a draw of its own
};
constexpr uint32_t drawNumber = 5;                            // of the first instance of all triangles
constexpr const char* instanceStep = "vec3(0.75, 0.5, -1.0)"; // GLSL

// Points to the settings.
AgaaViewDesc viewDesc(const ViewSettings& settings);
// Making a view of these settings fails with this code and one sentence, which is returned. what: told in failures.
template <class Context>
std::string expectRefused(Context& context, const ViewSettings& settings, AgaaResult code, const char* what) {
    const AgaaViewDesc desc = viewDesc(settings);
    AgaaView view = nullptr;
    context.lines.clear();
    EXPECT_EQ(context.createView(desc, view), code) << what;
    EXPECT_EQ(view, nullptr) << what;
    expectOneSentence(context.lines, code, what);
    return context.lines.empty() ? std::string() : context.lines[0].text;
}
// The frame after frameIndex, which is waited for. Draw callback, lights and shadows are the caller's.
AgaaFrame nextFrame(const ViewSettings& settings, uint64_t& frameIndex);
// The calls that record a frame.
std::vector<uint64_t> segmentCalls(bool split);

// What a pass draws, in what state and where, the mistake included.
std::vector<Run> drawRuns(const ViewSettings& settings, const std::vector<Triangle>& triangles, uint32_t pass);
AgaaDrawState drawState(const ViewSettings& settings, const AgaaDrawState& wanted, uint32_t pass);
glm::mat4 clipMatrix(const ViewSettings& settings, uint32_t pass);
// The text of a shader without interlock, for devices that rasterise the fragments of a pixel in order. Other text is
// not changed.
std::string rasterisedInOrder(const ViewSettings& settings, std::string text);
// The end of the material shader: GLSL that changes `AgaaSurfaceInput s` as ViewSettings says and emits it. Reads
// `uint triangle`, a number that begins with 0, and `vec2 uv`, a plain fragment input, and what ViewSettings::surface
// may read. It closes main().
extern const char* const emitText;
// Defines for the material shader.
std::string shaderDefines(const ViewSettings& settings, uint32_t pass, bool isMasked);

// "precise" with the attribute `velocity` for motion vectors.
AgaaLayout layoutWithVelocity();
// Directional, along -z, without shadow.
AgaaLight sun();
// The sun, then point and spot lights among randomTriangles(), some of which have no end.
std::vector<AgaaLight> manyLights(uint32_t count, float range, uint32_t seed);
// One light, and one shadow where there is one. They stay where they are.
void setLight(AgaaFrame& frame, const AgaaLight& light, const AgaaShadow* shadow = nullptr);

} // namespace agaa::test
