// Lights and shadows of a frame.
#include "cases.h"
#include "frame_members.h"

namespace agaa::conformance {

namespace {

using Set = std::function<void(AgaaLight&, double)>;

// The member belongs to the second light, so that the sentence must name the light.
std::function<void(FrameParts&, double)> setOfLight(const Set& set, uint32_t type = AGAA_LIGHT_POINT) {
    return [set, type](FrameParts& parts, double value) {
        parts.useLights();
        parts.lights[1].type = type;
        parts.lights[1].position[2] = -1;
        set(parts.lights[1], value);
    };
}

std::function<void(FrameParts&, double)> setOfShadow(const std::function<void(AgaaShadow&, double)>& set) {
    return [set](FrameParts& parts, double value) {
        parts.useShadows();
        parts.useLights();
        parts.lights[0].shadowMap = 1;
        set(parts.shadows[1], value);
    };
}

// Returns a direction of this length along one axis.
Set alongAxis(int axis) {
    return [axis](AgaaLight& light, double length) {
        for (float& d : light.direction)
            d = 0;
        light.direction[axis] = float(length);
    };
}

void addVectors(Suite& suite) {
    std::vector<FrameMember> positions, colors, directions;
    for (int i = 0; i < 3; ++i) {
        const std::string index = "[" + std::to_string(i) + "]";
        positions.push_back({"",
                             "AgaaLight::position" + index,
                             "position",
                             setOfLight([i](AgaaLight& light, double v) { light.position[i] = float(v); }),
                             {-1e18f, 0, 1e18f},
                             notNumbers({above(1e18f), below(-1e18f)})});
        colors.push_back({"",
                          "AgaaLight::color" + index,
                          "light 1",
                          setOfLight([i](AgaaLight& light, double v) { light.color[i] = float(v); }),
                          {0, 1, 1e30f},
                          notNumbers({-1e-20, -1, above(1e30f)})});
        directions.push_back({"",
                              "AgaaLight::direction" + index + " of a point light",
                              "direction",
                              setOfLight([i](AgaaLight& light, double v) { light.direction[i] = float(v); }),
                              {0, 5},
                              notNumbers({})});
        for (const uint32_t type : {AGAA_LIGHT_DIRECTIONAL, AGAA_LIGHT_SPOT})
            directions.push_back({"",
                                  "the length of AgaaLight::direction of a light of type " + std::to_string(type),
                                  "direction",
                                  setOfLight(alongAxis(i), type),
                                  {-1, 1},
                                  notNumbers({0, 0.5, 2, -2})});
    }
    addFrameMembers(suite, "AgaaLight.position/range", positions);
    addFrameMembers(suite, "AgaaLight.color/range", colors);
    addFrameMembers(suite, "AgaaLight.direction/range", directions);
}

void addLightRanges(Suite& suite) {
    addFrameMember(suite, {"AgaaLight.range/range",
                           "AgaaLight::range",
                           "range",
                           setOfLight([](AgaaLight& light, double v) { light.range = float(v); }),
                           {0, 1e-30f, 100, 1e18f},
                           notNumbers({-1e-20, -1, above(1e18f)})});
    addFrameMember(suite, {"AgaaLight.radius/range",
                           "AgaaLight::radius",
                           "radius",
                           setOfLight([](AgaaLight& light, double v) { light.radius = float(v); }),
                           {0, 1e-30f, 1, 1e15f},
                           notNumbers({-1e-20, -1, above(1e15f)})});
}

void addCones(Suite& suite) {
    addFrameMember(suite, {"AgaaLight.cosInner/range",
                           "AgaaLight::cosInner, with cosOuter = 0,",
                           "light 1",
                           setOfLight([](AgaaLight& light, double v) { light.cosInner = float(v); }, AGAA_LIGHT_SPOT),
                           {0, 0.5, 1},
                           notNumbers({-1e-6, -1, above(1)})});
    addFrameMember(suite, {"AgaaLight.cosOuter/range",
                           "AgaaLight::cosOuter, with cosInner = 0.5,",
                           "light 1",
                           setOfLight(
                               [](AgaaLight& light, double v) {
                                   light.cosInner = 0.5f;
                                   light.cosOuter = float(v);
                               },
                               AGAA_LIGHT_SPOT),
                           {-1, 0, 0.5},
                           notNumbers({below(-1), above(0.5f), 1})});
    std::vector<FrameMember> others;
    for (const uint32_t type : {AGAA_LIGHT_DIRECTIONAL, AGAA_LIGHT_POINT})
        others.push_back(
            {"",
             "the cosines of a light that has no cone (type " + std::to_string(type) + ")",
             "",
             setOfLight([](AgaaLight& light, double v) { light.cosInner = light.cosOuter = float(v); }, type),
             notNumbers({-2, 2}),
             {}});
    addFrameMembers(suite, "AgaaLight.cosInner/range/no_cone", others);
}

void addShadows(Suite& suite) {
    addFrameMember(suite, {"AgaaShadow.layerCount/range",
                           "AgaaShadow::layerCount",
                           "AgaaShadow::layerCount",
                           setOfShadow([](AgaaShadow& shadow, double v) { shadow.layerCount = uint32_t(v); }),
                           {1, 2, AGAA_MAX_SHADOW_LAYERS},
                           largeNumbers({0, AGAA_MAX_SHADOW_LAYERS + 1})});
    addFrameMember(suite, {"AgaaShadow.depthBias/range",
                           "AgaaShadow::depthBias",
                           "AgaaShadow::depthBias",
                           setOfShadow([](AgaaShadow& shadow, double v) { shadow.depthBias = float(v); }),
                           {0, 0.5, 1},
                           notNumbers({-1e-20, -1, above(1)})});
    addFrameMember(suite, {"AgaaShadow.matrices/range",
                           "AgaaShadow::matrices",
                           "AgaaShadow::matrices",
                           setOfShadow([](AgaaShadow& shadow, double v) {
                               shadow.layerCount = 2;
                               shadow.matrices[1][15] = float(v);
                           }),
                           {-1, 0, 1, 1e30f},
                           notNumbers({})});
    addFrameMember(suite, {"AgaaShadow.matrices/range/unused",
                           "AgaaShadow::matrices beyond layerCount",
                           "",
                           setOfShadow([](AgaaShadow& shadow, double v) { shadow.matrices[1][0] = float(v); }),
                           notNumbers({1}),
                           {}});
    addFrameMember(suite, {"AgaaLight.shadowMap/range",
                           "AgaaLight::shadowMap",
                           "light 1",
                           [](FrameParts& parts, double v) {
                               parts.useLights();
                               parts.useShadows();
                               parts.lights[1].shadowMap = uint32_t(v);
                           },
                           {0, 1, double(AGAA_NO_SHADOW)},
                           {2, 3, 4, double(AGAA_NO_SHADOW - 1)}});
    addFrameMember(suite, {"AgaaLight.shadowMap/range/without_shadows",
                           "AgaaLight::shadowMap of a frame without shadows",
                           "light 1",
                           setOfLight([](AgaaLight& light, double v) { light.shadowMap = uint32_t(v); }),
                           {double(AGAA_NO_SHADOW)},
                           {0, 1}});
}

} // namespace

void addLightMemberCases(Suite& suite) {
    addFrameMember(suite, {"AgaaLight.type/enum",
                           "AgaaLight::type",
                           "light 1",
                           [](FrameParts& parts, double v) {
                               parts.useLights();
                               parts.lights[1].position[2] = -1;
                               parts.lights[1].type = uint32_t(v);
                           },
                           {AGAA_LIGHT_DIRECTIONAL, AGAA_LIGHT_POINT, AGAA_LIGHT_SPOT},
                           {double(AGAA_LIGHT_MAX_ENUM), double(0x80000000u), double(0xFFFFFFFFu)},
                           {AGAA_LIGHT_SPOT + 1, 100}});
    addFrameMember(suite, {"AgaaLight.reserved/zero",
                           "AgaaLight::reserved",
                           "reserved",
                           setOfLight([](AgaaLight& light, double v) { light.reserved = float(v); }),
                           {0},
                           {},
                           notNumbers({1, -1, 1e-38})});
    addVectors(suite);
    addLightRanges(suite);
    addCones(suite);
    addShadows(suite);
}

} // namespace agaa::conformance
