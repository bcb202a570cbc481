#include "show.h"

#include "fetch_text.h"

namespace agaa::test {

static constexpr GLuint functionBlock = 6; // beyond what frames touch
static constexpr const char* storageText = R"(
layout(std430, binding = 6) readonly buffer Vertices { float data[]; } hostVertices;
vec3 hostPosition(uint vertex) {
    uint at = 25u * vertex;
    return vec3(hostVertices.data[at], hostVertices.data[at + 1u], hostVertices.data[at + 2u]);
}
vec4 hostVector(uint at) {
    return vec4(hostVertices.data[at], hostVertices.data[at + 1u], hostVertices.data[at + 2u],
                hostVertices.data[at + 3u]);
}
HostMaterial hostMaterial(uint primitive) {
    uint at = 75u * primitive + 3u;
    return HostMaterial(hostVector(at), hostVector(at + 4u), hostVector(at + 8u), hostVector(at + 12u),
                        hostVector(at + 16u));
}
uint hostSeed(HostMaterial h) { return uint(h.geometricNormal.w); }
)";

IdsView::IdsView(StageContext& context, ViewSettings settings, const Shot& shot)
    : text_(fetchText(settings, storageText, shot)), function_(fetchFunction(settings, text_, shot)) {
    settings.chained = &function_;
    view_ = std::make_unique<StageView>(context, settings);
    view_->setTriangles(shot.triangles);
}

void IdsView::setTriangles(const std::vector<Triangle>& triangles) { view_->setTriangles(triangles); }

IdsView::~IdsView() { sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, 0); }

void IdsView::bind(AgaaGlFrame&) const {
    sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, view_->vertices());
}

FunctionBuffer::FunctionBuffer(const std::vector<glm::vec4>& data)
    : buffer_(harness::gl::createBuffer(sharedEgl().gl())) {
    sharedEgl().gl().NamedBufferData(buffer_.get(), GLsizeiptr(data.size() * sizeof data[0]), data.data(),
                                     GL_STATIC_DRAW);
}

FunctionBuffer::~FunctionBuffer() { sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, 0); }

void FunctionBuffer::bind(AgaaGlFrame&) const {
    sharedEgl().gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, functionBlock, buffer_.get());
}

} // namespace agaa::test
