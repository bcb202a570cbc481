#include "fetch_text.h"

#include <algorithm>
#include <cstdio>

namespace agaa::test {
namespace {

std::string matrixText(const glm::mat4& m) {
    std::string text = "mat4(";
    for (int i = 0; i < 16; ++i) {
        char number[32];
        std::snprintf(number, sizeof number, "%s%.9g", i ? ", " : "", double(m[i / 4][i % 4]));
        text += number;
    }
    return text + ")";
}

} // namespace

// Unmasked triangles have an alpha of 1, so that all may be masked.
static std::string drawText(const Shot& shot) {
    return "#ifdef AGAA_EXPANDS_TRIANGLES\nvoid agaaHostDraw(uint draw, inout AgaaDraw d) {\n"
           "    d.primitives = draw >= hostFirstDraw ? " +
           std::to_string(shot.triangles.size()) + "u : 0u;\n    d.isAlphaMasked = true;\n" + shot.draws + R"(
}
void agaaHostAlpha(AgaaPrimitive p, inout AgaaAlpha a) {
    HostMaterial h = hostMaterial(p.primitive);
    a.alpha = h.diffuse.w;
    a.primitiveSeed = hostSeed(h);
)" + shot.alpha +
           "}\n#endif\n";
}

std::string fetchText(const ViewSettings& settings, const char* storage, const Shot& shot) {
    return std::string("struct HostMaterial { vec4 diffuse, specular, emissive, normal, "
                       "geometricNormal; };\n") +
           storage + "const mat4 hostClip = " + matrixText(settings.projection * settings.view) +
           R"(;
const uint hostFirstDraw = )" +
           std::to_string(drawNumber) + "u;\nconst vec3 hostInstanceStep = " + instanceStep + R"(;
vec4 hostVertex(uint draw, uint vertex) {
    return hostClip * vec4(hostPosition(vertex) + float(draw - hostFirstDraw) * hostInstanceStep, 1.0);
}
void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    a = hostVertex(draw, 3u * primitive);
    b = hostVertex(draw, 3u * primitive + 1u);
    c = hostVertex(draw, 3u * primitive + 2u);
    HostMaterial h = hostMaterial(primitive);
    vec2 spare = vec2(h.specular.w, h.emissive.w);
)" + shot.corners +
           R"(
}
void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {
    HostMaterial h = hostMaterial(p.primitive);
    m.diffuse = p.draw >= hostFirstDraw ? h.diffuse.xyz : vec3(1.0, 0.0, 1.0);
    m.specular = h.specular.xyz;
    m.emissive = h.emissive.xyz;
    m.normal = h.normal.xyz;
    m.alpha2 = h.normal.w;
    vec2 spare = vec2(h.specular.w, h.emissive.w);
)" + shot.material +
           "}\n" + drawText(shot);
}

AgaaFetchFunction fetchFunction(const ViewSettings& settings, const std::string& text, const Shot& shot) {
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = text.c_str();
    function.maxDraws = shot.announcedDraws ? shot.announcedDraws : drawNumber + settings.instances;
    function.maxPrimitives = shot.announced ? shot.announced : std::max(uint32_t(shot.triangles.size()), 1u);
    function.flags = shot.fetchFlags;
    if (settings.computesTriangles)
        function.maxTriangles =
            shot.announcedTriangles ? shot.announcedTriangles : function.maxPrimitives * settings.instances;
    function.pNext = settings.chained;
    return function;
}

} // namespace agaa::test
