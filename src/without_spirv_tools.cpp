// glslang calls SPIRV-Tools to optimise, validate and print SPIR-V, for which the library does not ask it
// (core/glsl/compile_glsl.cpp). Definitions of these calls here keep SPIRV-Tools, 4.6 MB, out of the shared library.
#include <iosfwd>
#include <vector>

namespace spv {
class SpvBuildLogger;
}

namespace glslang {

class TIntermediate;
struct SpvOptions;

// The declarations are those of glslang.
void SpirvToolsDisassemble(std::ostream&, const std::vector<unsigned int>&) {}
void SpirvToolsValidate(const TIntermediate&, std::vector<unsigned int>&, spv::SpvBuildLogger*, bool) {}
void SpirvToolsTransform(const TIntermediate&, std::vector<unsigned int>&, spv::SpvBuildLogger*, const SpvOptions*) {}
void SpirvToolsStripDebugInfo(const TIntermediate&, std::vector<unsigned int>&, spv::SpvBuildLogger*) {}

} // namespace glslang
