#include "prediction.h"

#include <gtest/gtest.h>

#include <cstring>

namespace agaa::test {

Prediction predict(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps) {
    Prediction p;
    uint32_t count = 0;
    EXPECT_EQ(agaaQueryMemory(&desc, &caps, nullptr, &p.report, &count, nullptr), 0);
    p.surfaces.resize(count, AgaaSurface AGAA_SURFACE_INIT);
    EXPECT_EQ(agaaQueryMemory(&desc, &caps, nullptr, &p.report, &count, p.surfaces.data()), 0);
    return p;
}

uint64_t takePixelBuffers(const Prediction& prediction, std::map<uint64_t, uint32_t>& created) {
    uint64_t bytes = 0;
    for (const AgaaSurface& surface : prediction.surfaces) {
        if (!surface.isPerPixel || surface.format[0] != 0)
            continue;
        uint32_t& count = created[surface.bytes];
        EXPECT_GT(count, 0u) << surface.name;
        count -= count > 0;
        bytes += surface.bytes;
    }
    return bytes;
}

uint64_t tableBytes(const Prediction& prediction) {
    uint64_t bytes = 0;
    for (const AgaaSurface& surface : prediction.surfaces)
        bytes += surface.format[0] && !surface.isPerPixel ? surface.bytes : 0;
    return bytes;
}

const std::vector<PayloadRow>& payloadRows() {
    static const std::vector<PayloadRow> rows = [] {
        std::vector<PayloadRow> list = {{"fxaa", 1}};
        for (const uint32_t n : {4u, 8u})
            list.push_back({"msaa", n});
        for (const uint32_t n : {8u, 16u, 32u}) {
            list.push_back({"simple_complex", n});
            list.push_back({"adaptive", n});
            list.push_back({"sbaa", n});
            list.push_back({"sbaa", n, AGAA_TIER_GBUFFER});
            for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
                list.push_back({"agaa", n, AGAA_TIER_GBUFFER, flags});
                list.push_back({"agaa", n, AGAA_TIER_IDS, flags});
                list.push_back({"agaa", n, AGAA_TIER_IDS, flags, AGAA_FETCH_NOT_ALL_DRAWS});
            }
        }
        for (const uint32_t n : {32u, 64u, 128u})
            for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS,
                                        AGAA_TIER_FRAGMENT_INTERLOCK, AGAA_TIER_FRAGMENTS})
                list.push_back({tier == AGAA_TIER_FRAGMENTS ? "agaa" : "dcaa", n, tier});
        list.push_back({.technique = "dcaa", .samples = 64, .tier = AGAA_TIER_FRAGMENT_LISTS, .hasOwnPattern = true});
        return list;
    }();
    return rows;
}

AgaaFetchFunction emptyFetch(uint64_t flags) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
                    "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
    function.maxDraws = function.maxPrimitives = 1000;
    function.flags = flags;
    return function;
}

} // namespace agaa::test
