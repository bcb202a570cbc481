#include "view_settings.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace agaa::test {

AgaaViewDesc viewDesc(const ViewSettings& settings) {
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = settings.width;
    desc.height = settings.height;
    desc.config = &settings.config;
    desc.facts = &settings.facts;
    desc.flags = settings.flags;
    desc.pNext = settings.chained;
    return desc;
}

AgaaFrame nextFrame(const ViewSettings& settings, uint64_t& frameIndex) {
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.completedFrame = frameIndex;
    frame.frameIndex = ++frameIndex;
    std::memcpy(frame.view, &settings.view, sizeof frame.view);
    std::memcpy(frame.projection, &settings.projection, sizeof frame.projection);
    return frame;
}

std::vector<uint64_t> segmentCalls(bool split) {
    if (split)
        return {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING};
    return {AGAA_SEGMENT_ALL};
}

static bool isMaterialPass(uint32_t pass) { return pass != AGAA_DRAW_PASS_VISIBILITY; }

std::vector<Run> drawRuns(const ViewSettings& settings, const std::vector<Triangle>& triangles, uint32_t pass) {
    const Run& skipped = isMaterialPass(pass) ? settings.mistake.materialSkips : settings.mistake.prepassSkips;
    std::vector<Run> runs;
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        if (i - skipped.first < skipped.count)
            continue;
        const bool follows = !runs.empty() && runs.back().isMasked == triangles[i].isMasked &&
                             runs.back().first + runs.back().count == i;
        if (!follows)
            runs.push_back({i, 0, triangles[i].isMasked});
        ++runs.back().count;
    }
    return runs;
}

AgaaDrawState drawState(const ViewSettings& settings, const AgaaDrawState& wanted, uint32_t pass) {
    AgaaDrawState state = wanted;
    state.conservative = 0;
    if (isMaterialPass(pass) && settings.mistake.noDepthTest)
        state.depthCompare = AGAA_COMPARE_ALWAYS;
    if (isMaterialPass(pass) && settings.mistake.noStencilTest)
        state.stencilTest = state.stencilTestMasked = 0;
    return state;
}

glm::mat4 clipMatrix(const ViewSettings& settings, uint32_t pass) {
    glm::mat4 clip = settings.projection * settings.view;
    if (isMaterialPass(pass))
        for (int column = 0; column < 4; ++column)
            clip[column][2] *= settings.mistake.materialDepth;
    return clip;
}

std::string rasterisedInOrder(const ViewSettings& settings, std::string text) {
    if (settings.hasInterlock)
        return text;
    const auto erase = [&](std::string_view part) {
        const size_t at = text.find(part);
        if (at != std::string::npos)
            text.erase(at, part.size());
        return at != std::string::npos;
    };
    if (!erase("#extension GL_ARB_fragment_shader_interlock : require\n"))
        return text;
    const bool merges = erase("layout(pixel_interlock_ordered) in;\n"); // geometry shaders do not
    EXPECT_EQ(erase("beginInvocationInterlockARB();"), merges);
    EXPECT_EQ(erase("endInvocationInterlockARB()"), merges);
    return text;
}

const char* const emitText = R"(
#if STAGE_SHADER == 1
    uint id = triangle + 1u;
    s.diffuse = vec3(id & 255u, id >> 8u & 255u, id >> 16u) / 255.0;
#elif STAGE_SHADER == 2
    s.diffuse = vec3(AGAA_INSIDE(uv), 0.0);
#elif STAGE_SHADER == 3
    s.diffuse = vec3(uv, 0.0);
#elif STAGE_SHADER == 4
    gl_FragDepth = triangle % 2u == 0u ? gl_FragCoord.z : 0.999 * gl_FragCoord.z;
    if ((uint(gl_FragCoord.x) + triangle) % 5u == 0u)
        discard;
#elif STAGE_SHADER == 5
    s.draw = triangle % 3u == 0u ? AGAA_UNFETCHED : s.draw;
#endif
    STAGE_SURFACE
    agaa_emit(s);
}
)";

std::string shaderDefines(const ViewSettings& settings, uint32_t pass, bool isMasked) {
    const float alpha = isMaterialPass(pass) ? settings.mistake.materialAlpha : 1;
    return std::string("#define AGAA_ALPHA_MASKED ") + (isMasked ? "1\n" : "0\n") + "#define STAGE_SHADER " +
           std::to_string(int(settings.shader)) + "\n" + "#define STAGE_ALPHA_FACTOR " + std::to_string(alpha) + "\n" +
           "#define STAGE_SURFACE " + settings.surface + "\n" + "#define STAGE_DRAW " + std::to_string(drawNumber) +
           "u\n" + "#define STAGE_INSTANCE_STEP " + instanceStep + "\n";
}

AgaaLayout layoutWithVelocity() {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    EXPECT_EQ(agaaGetBuiltinLayout("precise", &layout), AGAA_OK);
    AgaaLayoutAttribute velocity = AGAA_LAYOUT_ATTRIBUTE_INIT;
    velocity.semantic = AGAA_SEMANTIC_CUSTOM;
    velocity.channels = 2;
    velocity.sampleBits = 16;
    velocity.name = "velocity";
    layout.attributes[layout.attributeCount++] = velocity;
    return layout;
}

AgaaLight sun() {
    AgaaLight light{};
    light.type = AGAA_LIGHT_DIRECTIONAL;
    light.shadowMap = AGAA_NO_SHADOW;
    light.direction[2] = -1;
    light.color[0] = light.color[1] = light.color[2] = 3;
    return light;
}

std::vector<AgaaLight> manyLights(uint32_t count, float range, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<AgaaLight> lights = {sun()};
    while (lights.size() < count) {
        AgaaLight light = sun();
        const float z = 1 + 19 * unit(random);
        light.type = lights.size() % 3 == 2 ? AGAA_LIGHT_SPOT : AGAA_LIGHT_POINT;
        light.position[0] = z * (unit(random) - 0.5f) * 1.8f;
        light.position[1] = z * (unit(random) - 0.5f) * 1.2f;
        light.position[2] = -z;
        const glm::vec3 direction = glm::normalize(glm::vec3(unit(random), unit(random), unit(random)) - 0.5f);
        for (int axis = 0; axis < 3; ++axis) {
            light.direction[axis] = direction[axis];
            light.color[axis] = range * range * unit(random);
        }
        light.range = lights.size() % 16 == 5 ? 0 : range * (0.5f + unit(random)); // some without end
        light.cosInner = 0.95f;
        light.cosOuter = lights.size() % 2 ? 0.8f : -0.2f;
        light.radius = 0.01f;
        lights.push_back(light);
    }
    return lights;
}

void setLight(AgaaFrame& frame, const AgaaLight& light, const AgaaShadow* shadow) {
    frame.lights = &light;
    frame.lightCount = 1;
    frame.shadows = shadow;
    frame.shadowCount = shadow ? 1 : 0;
}

} // namespace agaa::test
