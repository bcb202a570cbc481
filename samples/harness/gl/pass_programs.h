// The sample engine's programs for the SDK's draw passes, by the SDK's pipeline key. All views share them.
#pragma once

#include "render/draw_pass.h"
#include "agaa_gl.h"
#include "gl/program.h"
#include "render/host_material.h"

#include <map>
#include <vector>

namespace harness::gl {

struct PassProgram {
    Program program;
    GLint toShading = -1;
    GLint normalToShading = -1;
    GLint seed = -1;
    GLint handedness = -1;
    GLint index = -1;
    GLint firstIndex = -1;
    GLint firstVertex = -1;
    GLint constants = -1; // location of the SDK's constants

    void setDraw(const GladGLContext& gl, const DrawConstants& constants) const;
};

class PassPrograms {
public:
    PassPrograms(const GladGLContext& gl, const RendererOptions& options);

    // Creates the missing programs for the draws. Must run before the frame, because programs take time to compile.
    void prepare(const DrawPass<AgaaGlDrawPass>& pass, const Scene& scene, const std::vector<Draw>& draws);
    // Throws std::runtime_error if prepare() was not called for the pass.
    const PassProgram& program(uint64_t pipelineKey, const Variant& variant) const;

private:
    PassProgram make(const DrawPass<AgaaGlDrawPass>& pass, const Variant& variant) const;
    std::string fragmentText(const DrawPass<AgaaGlDrawPass>& pass, const Variant& variant) const;
    std::string geometryText(const DrawPass<AgaaGlDrawPass>& pass) const;
    std::string vertexTextOf(const DrawPass<AgaaGlDrawPass>& pass) const;

    const GladGLContext* gl_;
    uint32_t glslVersion_;
    bool hostOutputs_;
    std::map<uint64_t, std::map<Variant, PassProgram>> programs_;
};

} // namespace harness::gl
