#include "show.h"

#include "fetch_text.h"

namespace agaa::test {

static constexpr GLuint functionBlock = 6; // beyond what frames touch
static constexpr const char* storageText = R"(
layout(std430, binding = 6) readonly buffer Vertices { float data[]; } hostVertices;
vec3 hostPosition(uint vertex) {
    uint at = 23u * vertex;
    return vec3(hostVertices.data[at], hostVertices.data[at + 1u], hostVertices.data[at + 2u]);
}
vec4 hostVector(uint at) {
    return vec4(hostVertices.data[at], hostVertices.data[at + 1u], hostVertices.data[at + 2u],
                hostVertices.data[at + 3u]);
}
HostMaterial hostMaterial(uint primitive) {
    uint at = 69u * primitive + 3u;
    return HostMaterial(hostVector(at), hostVector(at + 4u), hostVector(at + 8u), hostVector(at + 12u),
                        hostVector(at + 16u));
}
)";

static std::vector<float> rgbOf(const std::vector<float>& rgba) {
    std::vector<float> rgb;
    for (size_t i = 0; i < rgba.size(); i += 4)
        rgb.insert(rgb.end(), &rgba[i], &rgba[i] + 3);
    return rgb;
}

Shown show(StageContext& context, ViewSettings settings, const Shot& shot) {
    const GladGLContext& gl = context.egl().gl();
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    const bool fetches = settings.config.generationTier == AGAA_TIER_IDS;
    std::string text;
    AgaaFetchFunction function;
    if (fetches) {
        text = fetchText(settings, storageText, shot.material);
        function = fetchFunction(settings, text, shot);
        settings.chained = &function;
    }
    StageView view(context, settings);
    view.setTriangles(shot.triangles);
    const auto render = [&](const AgaaFrame& frame) {
        if (fetches)
            gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, view.vertices());
        view.render(frame);
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, 0);
    };
    return showBy(view, shot, render, [&] { return rgbOf(view.image()); });
}

} // namespace agaa::test
