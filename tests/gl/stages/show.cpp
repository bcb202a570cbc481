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

IdsView::IdsView(StageContext& context, ViewSettings settings, const Shot& shot)
    : text_(fetchText(settings, storageText, shot.material)), function_(fetchFunction(settings, text_, shot)) {
    settings.chained = &function_;
    view_ = std::make_unique<StageView>(context, settings);
    view_->setTriangles(shot.triangles);
}

IdsView::~IdsView() { sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, 0); }

void IdsView::bind(AgaaGlFrame&) const {
    sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, view_->vertices());
}

FunctionBuffer::FunctionBuffer(const std::vector<glm::vec4>& data)
    : buffer_(harness::gl::createBuffer(sharedEgl().gl())) {
    sharedEgl().gl().NamedBufferData(buffer_.get(), GLsizeiptr(data.size() * sizeof data[0]), data.data(), GL_STATIC_DRAW);
}

FunctionBuffer::~FunctionBuffer() { sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, 0); }

void FunctionBuffer::bind(AgaaGlFrame&) const {
    sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, buffer_.get());
}

Shown show(StageContext& context, ViewSettings settings, const Shot& shot) {
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    const auto shownBy = [&](StageView& view, const auto& bind) {
        const auto render = [&](const AgaaFrame& frame) {
            AgaaGlFrame glFrame = view.glFrame();
            bind(glFrame);
            view.render(frame, glFrame);
        };
        return showBy(view, shot, render, [&] { return rgbOf(view.image()); });
    };
    if (settings.config.generationTier == AGAA_TIER_IDS) {
        IdsView ids(context, settings, shot);
        return shownBy(ids.view(), [&](AgaaGlFrame& frame) { ids.bind(frame); });
    }
    StageView view(context, settings);
    view.setTriangles(shot.triangles);
    return shownBy(view, [](AgaaGlFrame&) {});
}

} // namespace agaa::test
