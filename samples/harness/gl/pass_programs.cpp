#include "gl/pass_programs.h"

#include "embedded.h"

#include <stdexcept>

namespace harness::gl {

void PassProgram::setDraw(const GladGLContext& gl, const DrawConstants& constants) const {
    const GLuint name = program.get();
    gl.ProgramUniform4fv(name, toShading, 3, &constants.toShading[0].x);
    if (normalToShading >= 0)
        gl.ProgramUniform4fv(name, normalToShading, 3, &constants.normalToShading[0].x);
    if (seed >= 0)
        gl.ProgramUniform1ui(name, seed, constants.seed);
    if (handedness >= 0)
        gl.ProgramUniform1f(name, handedness, constants.handedness);
    if (index >= 0)
        gl.ProgramUniform1ui(name, index, constants.index);
    if (firstIndex >= 0)
        gl.ProgramUniform1ui(name, firstIndex, constants.firstIndex);
    if (firstVertex >= 0)
        gl.ProgramUniform1ui(name, firstVertex, constants.firstVertex);
}

PassPrograms::PassPrograms(const GladGLContext& gl, const RendererOptions& options)
    : gl_(&gl), glslVersion_(options.glslVersion), hostOutputs_(options.hostOutputs) {}

// Culling and winding are not part of a program.
static Variant programVariant(const Scene& scene, const Draw& draw) {
    Variant variant = variantOf(scene, draw);
    variant.isDoubleSided = false;
    variant.isMirrored = false;
    return variant;
}

void PassPrograms::prepare(const DrawPass<AgaaGlDrawPass>& pass, const Scene& scene, const std::vector<Draw>& draws) {
    auto& programs = programs_[pass.pipelineKey];
    for (const Draw& draw : draws) {
        const Variant variant = programVariant(scene, draw);
        if (!programs.contains(variant))
            programs.emplace(variant, make(pass, variant));
    }
}

std::string PassPrograms::fragmentText(const DrawPass<AgaaGlDrawPass>& pass, const Variant& variant) const {
    std::string text = versionLine(glslVersion_) + pass.glslExtensions + "#define HARNESS_GL\n" +
                       embedded::interface_glsl + "#define AGAA_ALPHA_MASKED " + (variant.isMasked ? "1\n" : "0\n") +
                       "#define FEATURES " + std::to_string(variant.features) + "u\n" + "#define MOTION_OUTPUT " +
                       std::to_string(int(variant.motion)) + "\n";
    text += pass.glslDeclarations;
    if (hostOutputs_) {
        std::string copies;
        for (uint32_t i = 0; i < pass.state.colorAttachmentCount; ++i) {
            const std::string n = std::to_string(i);
            text += "layout(location = " + n + ") out vec4 engineOut" + n + ";\n";
            copies += "engineOut" + n + " = agaa_out" + n + "; ";
        }
        text += "#define COPY_OUTPUTS " + copies + "\n";
    }
    return text + classDefineOf(pass) + embedded::material_glsl + embedded::material_inputs_glsl +
           (pass.pass == AGAA_DRAW_PASS_FRAGMENTS ? embedded::corners_frag : embedded::material_frag);
}

std::string PassPrograms::geometryText(const DrawPass<AgaaGlDrawPass>& pass) const {
    if (!pass.glslGeometry)
        return {};
    return versionLine(glslVersion_) + pass.glslExtensions + "#define HARNESS_GL\n" + pass.glslGeometry +
           embedded::interface_glsl + embedded::corner_outputs_glsl + embedded::corners_geom;
}

std::string PassPrograms::vertexTextOf(const DrawPass<AgaaGlDrawPass>& pass) const {
    if (pass.state.multicast)
        return versionLine(glslVersion_) + pass.glslExtensions + "#define HARNESS_GL\n" + pass.glslVertex +
               embedded::interface_glsl + "#define FOR_CORNERS 0\n#define MULTICAST\n" + embedded::object_glsl +
               embedded::material_vert;
    if (pass.glslVertex)
        return versionLine(glslVersion_) + pass.glslExtensions + "#define HARNESS_GL\n" + pass.glslVertex +
               embedded::interface_glsl + embedded::object_glsl + embedded::corner_outputs_glsl +
               embedded::corners_vert;
    const std::string body = "#define FOR_CORNERS " + std::to_string(cornerOutputs(pass)) + "\n" +
                             embedded::object_glsl + embedded::material_vert;
    return vertexText(glslVersion_, body.c_str());
}

PassProgram PassPrograms::make(const DrawPass<AgaaGlDrawPass>& pass, const Variant& variant) const {
    PassProgram made;
    made.program = Program(*gl_, vertexTextOf(pass), fragmentText(pass, variant), std::string("material, ") + pass.name,
                           geometryText(pass));
    made.toShading = made.program.uniform("draw.toShading");
    made.normalToShading = made.program.uniform("draw.normalToShading");
    made.seed = made.program.uniform("draw.seed");
    made.handedness = made.program.uniform("draw.handedness");
    made.index = made.program.uniform("draw.index");
    made.firstIndex = made.program.uniform("draw.firstIndex");
    made.firstVertex = made.program.uniform("draw.firstVertex");
    made.constants = made.program.uniform("agaa_constants");
    return made;
}

const PassProgram& PassPrograms::program(uint64_t pipelineKey, const Variant& variant) const {
    Variant wanted = variant;
    wanted.isDoubleSided = false;
    wanted.isMirrored = false;
    const auto programs = programs_.find(pipelineKey);
    if (programs == programs_.end())
        throw std::runtime_error("The SDK asked for a draw with a pipeline key that it had not told.");
    const auto found = programs->second.find(wanted);
    if (found == programs->second.end())
        throw std::runtime_error("A program was not prepared before its draw.");
    return found->second;
}

} // namespace harness::gl
