// Frames that no graphics API may take.
#pragma once

#include "agaa_sdk.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace agaa::test {

struct FrameMisuse {
    const char* what;
    AgaaResult expected;
    // A frame with one light and one shadow.
    std::function<void(AgaaFrame&, AgaaLight&, AgaaShadow&)> spoil;
};

inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr AgaaStructHeader unknownStruct = {77, sizeof(AgaaStructHeader), nullptr};

inline const FrameMisuse frameMisuses[] = {
    {"wrong sType", AGAA_ERROR_STRUCT, [](auto& f, auto&, auto&) { f.sType = 3; }},
    {"wrong structSize", AGAA_ERROR_STRUCT, [](auto& f, auto&, auto&) { f.structSize -= 16; }}, // less than version 0.2 has
    {"unknown struct in chain", AGAA_ERROR_UNKNOWN_STRUCT,
     [](auto& f, auto&, auto&) { f.pNext = &unknownStruct; }},
    {"no draw callback", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto& f, auto&, auto&) { f.draw = nullptr; }},
    {"more shadows than declared", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.shadowCount = 2; }},
    {"shadows null", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto& f, auto&, auto&) { f.shadows = nullptr; }},
    {"shadow without layers", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto&, auto& shadow) { shadow.layerCount = 0; }},
    {"shadow with seven layers", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto&, auto& shadow) { shadow.layerCount = 7; }},
    {"shadow bias NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto&, auto& shadow) { shadow.depthBias = nan; }},
    {"shadow bias beyond the map", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto&, auto& shadow) { shadow.depthBias = 1.5f; }},
    {"shadow matrix infinite", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto&, auto& shadow) { shadow.matrices[0][3] = infinity; }},
    {"lights of no size", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.lightSize = 0; }},
    {"shadows of no size", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.shadowSize = 0; }},
    {"a view that reflects", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) {
         for (int i = 0; i < 4; ++i)
             f.view[8 + i] = -f.view[8 + i];
     }},
    {"lights null", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&, auto&) { f.lights = nullptr; }},
    {"more lights than declared", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.lightCount = 65; }},
    {"light of unknown type", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.type = 9; }},
    {"light colour NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.color[1] = nan; }},
    {"light colour negative", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.color[1] = -1; }},
    {"light too far for its square", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.position[0] = -1e20f; }},
    {"light range too far for its square", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.range = 1e25f; }},
    {"light colour too bright", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.color[2] = 2e30f; }},
    {"light of a negative radius", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.radius = -0.1f; }},
    {"light of a radius too large for its square", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.radius = 1e20f; }},
    {"light with a reserved member", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.reserved = 1; }},
    {"cone inside out", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) {
         light.type = AGAA_LIGHT_SPOT;
         light.cosInner = 0.25f;
         light.cosOuter = 0.5f;
     }},
    {"cone of no angle's cosine", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) {
         light.type = AGAA_LIGHT_SPOT;
         light.cosInner = 1.5f;
     }},
    {"light position NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.position[2] = nan; }},
    {"light without direction", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.direction[2] = 0; }},
    {"light position infinite", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.position[1] = infinity; }},
    {"light direction NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.direction[0] = nan; }},
    {"direction of a point light NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) {
         light.type = AGAA_LIGHT_POINT;
         light.direction[0] = nan;
     }},
    {"light colour infinite", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.color[0] = infinity; }},
    {"light range NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.range = nan; }},
    {"light range infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.range = infinity; }},
    {"light radius NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.radius = nan; }},
    {"light radius infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto&, auto& light, auto&) { light.radius = infinity; }},
    {"light with a reserved member NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.reserved = nan; }},
    {"cone's inner cosine NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) {
         light.type = AGAA_LIGHT_SPOT;
         light.cosInner = nan;
     }},
    {"cone's outer cosine NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) {
         light.type = AGAA_LIGHT_SPOT;
         light.cosInner = 1;
         light.cosOuter = nan;
     }},
    {"shadow matrix NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto&, auto& shadow) { shadow.matrices[0][15] = nan; }},
    {"light names no shadow map", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& light, auto&) { light.shadowMap = 3; }},
    {"projection NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.projection[0] = nan; }},
    {"projection of zeros", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { std::fill_n(f.projection, 16, 0.0f); }},
    {"projection of the other depth", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) {
         for (int column = 0; column < 4; ++column) // z becomes w - z
             f.projection[4 * column + 2] = f.projection[4 * column + 3] - f.projection[4 * column + 2];
     }},
    {"projection with shear", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.projection[4] = 0.5f; }},
    {"view infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.view[5] = infinity; }},
    {"view with a translation", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.view[12] = 3; }},
    {"view with a translation in its last row", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.view[7] = 3; }},
    {"view that scales by its last element", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.view[15] = 2; }},
    {"view NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.view[15] = nan; }},
    {"projection infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.projection[10] = infinity; }},
    {"ambient infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.ambient[0] = infinity; }},
    {"ambient too bright", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.ambient[0] = 65505; }},
    {"background infinite", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.background[0] = infinity; }},
    {"background's fourth element NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.background[3] = nan; }},
    {"background's fourth element negative", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.background[3] = -1; }},
    {"view that is no rotation", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.view[0] = 2; }},
    {"ambient NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.ambient[2] = nan; }},
    {"background NaN", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.background[1] = nan; }},
    {"no segment", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.segments = 0; }},
    {"unknown segment", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.segments = 15; }},
    {"begins with the last segment", AGAA_ERROR_WRONG_ORDER,
     [](auto& f, auto&, auto&) { f.segments = AGAA_SEGMENT_SHADING; }},
    {"leaves a segment out", AGAA_ERROR_WRONG_ORDER,
     [](auto& f, auto&, auto&) { f.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_SHADING; }},
    {"frame 0", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&, auto&) { f.frameIndex = 0; }},
    {"a frame completed that has not begun", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto&, auto&) { f.completedFrame = f.frameIndex; }},
};

} // namespace agaa::test
