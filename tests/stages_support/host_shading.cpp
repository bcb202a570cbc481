#include "host_shading.h"

#include <gtest/gtest.h>

namespace agaa::test {

std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations) {
    size_t size = 0;
    EXPECT_EQ(agaaGetAggregateGlsl(&desc, &caps, nullptr, &size, nullptr), AGAA_OK);
    std::string aggregates(size, '\0');
    EXPECT_EQ(agaaGetAggregateGlsl(&desc, &caps, nullptr, &size, aggregates.data()), AGAA_OK);
    aggregates.pop_back(); // the final zero
    return declarations + "layout(local_size_x = 8, local_size_y = 8) in;\nconst uvec2 hostSize = uvec2(" +
           std::to_string(desc.width) + "u, " + std::to_string(desc.height) + "u);\n" + aggregates + R"(
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, hostSize)))
        return;
    vec3 color = vec3(0.0);
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
        AgaaAggregate g = agaaAggregate(pixel, a);
        vec3 light = g.emissive + vec3(0.5, 0.4, 0.3) * (g.diffuse + g.specular);
        color += light * float(bitCount(g.samples)) / float(AGAA_SAMPLES);
    }
    show(pixel, color);
}
)";
}

} // namespace agaa::test
