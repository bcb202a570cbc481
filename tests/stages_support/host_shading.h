// A host that shades aggregates itself: ambient light and emission over black, by the text that reads aggregates.
#pragma once

#include "view_settings.h"

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace agaa::test {

// Settings of views that leave aggregates in memory: by drawnTier, and from a G-buffer.
void forHostShading(uint32_t drawnTier, const std::function<void(const ViewSettings&)>& check);
std::vector<Triangle> hostShadingScene();
// No lights but what the shader below knows.
void lightForHost(AgaaFrame& frame);

// Of a compute shader in groups of 8 x 8 pixels. declarations: the version, AGAA_AGGREGATE_WORD(i) and
// void show(uvec2 pixel, vec3 color).
// light: GLSL of a vec3, of `AgaaAggregate g`.
constexpr const char* ambientLight = "g.emissive + vec3(0.5, 0.4, 0.3) * (g.diffuse + g.specular)";
std::string hostShadingText(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, const std::string& declarations,
                            const char* light = ambientLight);

// Settings of views with attributes of the host's own: `wind`, a mean of range 4; `tangent`, a normal; `part`,
// unfiltered. Their surfaces repeat attributes of the SDK's, which they are compared with.
void forCustomAttributes(const std::vector<uint32_t>& tiers, const std::function<void(ViewSettings)>& check);
// Of fetched materials; s of drawn ones is m here.
constexpr const char* customMaterial = "m.wind = 4.0 * m.diffuse.xy; m.tangent = m.normal; m.part = m.diffuse.z;";
// Differences of wind and tangent; by how much part is beyond the mean of what it repeats; part.
constexpr const char* customLight = "vec3(distance(0.25 * g.wind, g.diffuse.xy) + 0.1 * distance(g.tangent, g.normal), "
                                    "g.part - g.diffuse.z, g.part)";
// Collects images by customLight: each must be within what quantisation allows. Those of c = 1, whose aggregates all
// tiers make of the same samples, must have the same parts.
class CustomImages {
public:
    void add(const ViewSettings& settings, std::span<const float> rgba);

private:
    std::map<uint32_t, std::vector<float>> parts_; // by n
};

// Of all normals and of the mean: the sum of squares, the distance of the moments, and the variance.
constexpr const char* momentLight =
    "vec3(dot(g.normalSquares, vec3(1.0)), distance(g.normalSquares, g.normal * g.normal) + "
    "distance(g.normalProducts, g.normal.yzx * g.normal.zxy), dot(g.normalSquares, vec3(1.0)) - dot(g.normal, "
    "g.normal))";
// Checks an image by momentLight: views without elliptic lobes have no moments.
void expectMoments(const ViewSettings& settings, std::span<const float> rgba);

// RGBA: the image of the SDK's own shading, and the shader's.
void expectShadedAlike(const std::vector<float>& sdk, const std::vector<float>& host);

} // namespace agaa::test
