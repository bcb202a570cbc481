#include "core/frame/frame_checks.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/structs.h"
#include "core/frame/temporal.h"
#include "core/plan/plan.h"
#include "core/view/facts.h"

#include <string>

namespace agaa {

void checkRotation(const float* m, const char* name) {
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            const float dot = m[4 * i] * m[4 * j] + m[4 * i + 1] * m[4 * j + 1] + m[4 * i + 2] * m[4 * j + 2];
            if (!(std::fabs(dot - (i == j ? 1.0f : 0.0f)) <= 1e-3f))
                fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not a rotation.", name));
        }
    const float determinant =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
    if (determinant < 0)
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s has a reflection; hosts with left-handed axes negate z.", name));
}

void checkProjection(const float (&p)[16], const char* name) {
    for (float element : p)
        checkFinite(element, name);
    const auto bad = [&](const char* what) { fail(AGAA_ERROR_OUT_OF_RANGE, format("%s %s.", name, what)); };
    const bool perspective = p[11] == -1.0f && p[15] == 0.0f;
    const bool orthographic = p[11] == 0.0f && p[15] == 1.0f;
    if (!perspective && !orthographic)
        bad("is neither perspective (looking down -z) nor orthographic");
    // These elements are zero in every projection without shear, roll and oblique near plane.
    bool plain = p[1] == 0 && p[2] == 0 && p[3] == 0 && p[4] == 0 && p[6] == 0 && p[7] == 0;
    plain = plain && (perspective ? p[12] == 0 && p[13] == 0 : p[8] == 0 && p[9] == 0);
    if (!plain)
        bad("has shear, roll or an oblique near plane");
    if (p[0] == 0 || p[5] == 0 || (perspective ? p[14] : p[10]) == 0)
        bad("is singular");
}

static void checkMatrices(const AgaaFrame& frame, bool reversedZ) {
    for (float element : frame.view)
        checkFinite(element, "AgaaFrame::view");
    const float* v = frame.view;
    checkRotation(v, "AgaaFrame::view");
    require(v[3] == 0 && v[7] == 0 && v[11] == 0 && v[15] == 1, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::view has a last row other than 0, 0, 0, 1; matrices are column-major.");
    if (v[12] != 0 || v[13] != 0 || v[14] != 0)
        fail(AGAA_ERROR_OUT_OF_RANGE, "AgaaFrame::view has a translation; shading space has its origin at the eye.");
    checkProjection(frame.projection, "AgaaFrame::projection");
    const float* p = frame.projection;
    const bool perspective = p[11] == -1.0f;
    // A reversed depth falls with the distance from the eye.
    const bool reversed = (perspective ? p[14] : p[10]) > 0;
    require(reversed == reversedZ, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::projection and AGAA_VIEW_REVERSED_Z do not agree on which depth is near.");
}

static void checkLight(const AgaaLight& light, uint32_t index, uint32_t shadowCount, bool isLocalAllowed) {
    const auto bad = [&](const char* what) { fail(AGAA_ERROR_OUT_OF_RANGE, format("light %u: %s.", index, what)); };
    if (light.type > AGAA_LIGHT_SPOT)
        bad(format("its type %u is not known", light.type).c_str());
    if (light.type != AGAA_LIGHT_DIRECTIONAL && !isLocalAllowed)
        bad("it is not directional, against AGAA_FACT_NO_LOCAL_LIGHTS");
    if (light.shadowMap != AGAA_NO_SHADOW && light.shadowMap >= shadowCount)
        bad("its shadow map is not among the frame's shadows");
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(light.position[i]) <= 1e18f)) // its square fits a float
            bad("its position is not in [-1e18;1e18]");
        if (!std::isfinite(light.direction[i]))
            bad("its direction is not finite");
        if (!(light.color[i] >= 0 && light.color[i] <= 1e30f))
            bad("its colour is not in [0;1e30]");
    }
    if (!(light.range >= 0 && light.range <= 1e18f))
        bad("its range is not in [0;1e18]");
    if (light.reserved != 0)
        bad("its reserved member is not 0");
    if (!(light.radius >= 0 && light.radius <= 1e15f))
        bad("its radius is not in [0;1e15]");
    if (light.type != AGAA_LIGHT_POINT) {
        const float* d = light.direction;
        if (std::fabs(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - 1.0f) > 1e-2f)
            bad("its direction is not a unit vector");
    }
    if (light.type == AGAA_LIGHT_SPOT &&
        !(light.cosInner >= light.cosOuter && light.cosOuter >= -1 && light.cosInner <= 1))
        bad("its cone is not inner cosine >= outer cosine in [-1;1]");
}

AgaaLight lightOf(const AgaaFrame& frame, uint32_t index) {
    return readElement<AgaaLight>(frame.lights, frame.lightSize, index, AGAA_LIGHT_INIT);
}

AgaaShadow shadowOf(const AgaaFrame& frame, uint32_t index) {
    return readElement<AgaaShadow>(frame.shadows, frame.shadowSize, index, AGAA_SHADOW_INIT);
}

static void checkShadow(const AgaaShadow& shadow, bool isFunction) {
    if (isFunction) {
        checkRange(uint64_t(shadow.layerCount), 0, 0,
                   "AgaaShadow::layerCount (of a shadow that AgaaShadowFunction answers for)");
        return;
    }
    checkRange(uint64_t(shadow.layerCount), 1, AGAA_MAX_SHADOW_LAYERS, "AgaaShadow::layerCount");
    checkRange(double(shadow.depthBias), 0.0, 1.0, "AgaaShadow::depthBias");
    for (uint32_t i = 0; i < 16 * shadow.layerCount; ++i)
        checkFinite(shadow.matrices[i / 16][i % 16], "AgaaShadow::matrices");
}

AgaaSceneFacts factsOf(const AgaaFrame& frame, const Plan& plan) {
    if (!frame.facts)
        return plan.view.facts;
    const AgaaSceneFacts facts = checkFacts(frame.facts);
    checkWithin(facts, plan.view.facts, "AgaaFrame::facts");
    return facts;
}

FrameExtent extentOf(const AgaaFrame& frame, const Plan& plan) {
    return frame.width ? FrameExtent{frame.width, frame.height} : plan.extent();
}

// The output may be larger than the frame only if the frame names its size, so that a forgotten resize is found.
static void checkPlace(const AgaaFrame& frame, const Plan& plan) {
    checkReserved(frame.reserved, "AgaaFrame::reserved");
    if (!frame.width && !frame.height) {
        require(!frame.outputX && !frame.outputY, AGAA_ERROR_OUT_OF_RANGE,
                "AgaaFrame::outputX and outputY need width and height.");
        return;
    }
    checkRange(uint64_t(frame.width), 1, plan.view.width, "AgaaFrame::width (against AgaaViewDesc::width)");
    checkRange(uint64_t(frame.height), 1, plan.view.height, "AgaaFrame::height (against AgaaViewDesc::height)");
}

void checkFrame(const AgaaFrame& frame, const Plan& plan) {
    const AgaaSceneFacts& facts = *frame.facts;
    require(frame.segments != 0, AGAA_ERROR_OUT_OF_RANGE, "AgaaFrame::segments names no segment.");
    checkFlags(frame.segments, AGAA_SEGMENT_ALL, "AgaaFrame::segments");
    require(frame.completedFrame < frame.frameIndex, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaFrame::completedFrame is not before frameIndex.");
    require(frame.draw || plan.geometryPasses() == 0, AGAA_ERROR_INVALID_ARGUMENT, "AgaaFrame::draw is null.");
    checkMatrices(frame, plan.view.reversedZ);
    checkPlace(frame, plan);
    if (!(frame.segments & AGAA_SEGMENT_SHADING))
        return; // other segments read no lights, shadows and colours
    checkRange(uint64_t(frame.lightCount), 0, facts.maxLights,
               "AgaaFrame::lightCount (against AgaaSceneFacts::maxLights)");
    checkRange(uint64_t(frame.shadowCount), 0, facts.shadowMapCount,
               "AgaaFrame::shadowCount (against AgaaSceneFacts::shadowMapCount)");
    require(!frame.lightCount || frame.lights, AGAA_ERROR_INVALID_ARGUMENT, "AgaaFrame::lights is null.");
    require(!frame.shadowCount || frame.shadows, AGAA_ERROR_INVALID_ARGUMENT, "AgaaFrame::shadows is null.");
    checkElements(frame.lights, frame.lightSize, frame.lightCount, sizeof(AgaaLight), 64, "AgaaFrame::lightSize");
    checkElements(frame.shadows, frame.shadowSize, frame.shadowCount, sizeof(AgaaShadow), 392, "AgaaFrame::shadowSize");
    for (uint32_t i = 0; i < frame.lightCount; ++i)
        checkLight(lightOf(frame, i), i, frame.shadowCount, !(plan.view.facts.flags & AGAA_FACT_NO_LOCAL_LIGHTS));
    for (uint32_t i = 0; i < frame.shadowCount; ++i)
        checkShadow(shadowOf(frame, i), plan.view.functionShadows >> i & 1);
    if (plan.view.accumulates())
        checkTemporalFrame(frame);
    for (float value : frame.ambient)
        checkRange(double(value), 0.0, 65504.0, "AgaaFrame::ambient");
    for (float value : frame.background)
        checkRange(double(value), 0.0, 65504.0, "AgaaFrame::background");
    checkRange(double(frame.exposure), 0.0, 1e9, "AgaaFrame::exposure");
}

void checkComposite(const AgaaFrame& frame, const Plan& plan) {
    require(plan.view.composite || frame.background[3] != 0.0f, AGAA_ERROR_OUT_OF_RANGE,
            "the frame composites over the output, but the view has no AGAA_VIEW_COMPOSITE.");
}

} // namespace agaa
