// States that glEnable and glDisable set.
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

constexpr StateRow capability(GLenum parameter, const char* name, const char* description,
                              StateProfile profile = StateProfile::Any, StateNeed need = {}) {
    return {name, description, {parameter}, "b", readCapability, writeCapability, StateArray::Once, profile, need};
}

constexpr StateProfile kCompatibility = StateProfile::Compatibility;

// With GL_AMD_depth_clamp_separate, glEnable(GL_DEPTH_CLAMP) sets both planes and glIsEnabled returns true for either,
// so that each plane has its own row.
constexpr StateNeed kDepthClamp{"no GL_AMD_depth_clamp_separate",
                                [](const GladGLContext& gl) { return gl.AMD_depth_clamp_separate == 0; }};
constexpr StateNeed kDepthClampSeparate{"GL_AMD_depth_clamp_separate",
                                        [](const GladGLContext& gl) { return gl.AMD_depth_clamp_separate != 0; }};

// clang-format off
constexpr StateRow kRows[] = {
    {"GL_SCISSOR_TEST", "scissor test", {GL_SCISSOR_TEST}, "b", readCapabilityAt,
     writeCapabilityAt, StateArray::Viewports},
    {"GL_BLEND", "blending", {GL_BLEND}, "b", readCapabilityAt, writeCapabilityAt,
     StateArray::DrawBuffers},
    {"GL_CLIP_DISTANCE0", "user clipping; with fixed functions GL_CLIP_PLANE0", {GL_CLIP_DISTANCE0},
     "b", readCapability, writeCapability, StateArray::ClipDistances},
    capability(GL_DEPTH_TEST, "GL_DEPTH_TEST", "depth test"),
    capability(GL_DEPTH_CLAMP, "GL_DEPTH_CLAMP", "clamping of depths instead of clipping",
               StateProfile::Any, kDepthClamp),
    capability(GL_DEPTH_CLAMP_NEAR_AMD, "GL_DEPTH_CLAMP_NEAR_AMD",
               "clamping at the near plane instead of clipping", StateProfile::Any,
               kDepthClampSeparate),
    capability(GL_DEPTH_CLAMP_FAR_AMD, "GL_DEPTH_CLAMP_FAR_AMD",
               "clamping at the far plane instead of clipping", StateProfile::Any,
               kDepthClampSeparate),
    capability(GL_STENCIL_TEST, "GL_STENCIL_TEST", "stencil test"),
    capability(GL_RASTERIZER_DISCARD, "GL_RASTERIZER_DISCARD", "discarding of all primitives"),
    capability(GL_CULL_FACE, "GL_CULL_FACE", "face culling"),
    capability(GL_POLYGON_OFFSET_FILL, "GL_POLYGON_OFFSET_FILL", "depth offset of filled polygons"),
    capability(GL_POLYGON_OFFSET_LINE, "GL_POLYGON_OFFSET_LINE", "depth offset of outlines"),
    capability(GL_POLYGON_OFFSET_POINT, "GL_POLYGON_OFFSET_POINT", "depth offset of corner points"),
    capability(GL_POLYGON_SMOOTH, "GL_POLYGON_SMOOTH", "smooth polygons"),
    capability(GL_LINE_SMOOTH, "GL_LINE_SMOOTH", "smooth lines"),
    capability(GL_PROGRAM_POINT_SIZE, "GL_PROGRAM_POINT_SIZE", "point size from the shader"),
    capability(GL_MULTISAMPLE, "GL_MULTISAMPLE", "multisample rasterization"),
    capability(GL_SAMPLE_ALPHA_TO_COVERAGE, "GL_SAMPLE_ALPHA_TO_COVERAGE", "alpha to coverage"),
    capability(GL_SAMPLE_ALPHA_TO_ONE, "GL_SAMPLE_ALPHA_TO_ONE", "alpha to one"),
    capability(GL_SAMPLE_COVERAGE, "GL_SAMPLE_COVERAGE", "coverage by a value"),
    capability(GL_SAMPLE_MASK, "GL_SAMPLE_MASK", "coverage by a mask"),
    capability(GL_SAMPLE_SHADING, "GL_SAMPLE_SHADING", "sample shading"),
    capability(GL_COLOR_LOGIC_OP, "GL_COLOR_LOGIC_OP", "logical operation on colours"),
    capability(GL_DITHER, "GL_DITHER", "dithering"),
    capability(GL_FRAMEBUFFER_SRGB, "GL_FRAMEBUFFER_SRGB", "writing and blending in sRGB"),
    capability(GL_PRIMITIVE_RESTART, "GL_PRIMITIVE_RESTART", "primitive restart"),
    capability(GL_PRIMITIVE_RESTART_FIXED_INDEX, "GL_PRIMITIVE_RESTART_FIXED_INDEX",
               "primitive restart at the greatest index"),
    capability(GL_TEXTURE_CUBE_MAP_SEAMLESS, "GL_TEXTURE_CUBE_MAP_SEAMLESS",
               "filtering across cube edges"),
    capability(GL_RASTER_MULTISAMPLE_EXT, "GL_RASTER_MULTISAMPLE_EXT",
               "rasterization with an explicit sample count", StateProfile::Any, kMixedSamples),
    capability(GL_ALPHA_TEST, "GL_ALPHA_TEST", "alpha test", kCompatibility),
    capability(GL_FOG, "GL_FOG", "fog", kCompatibility),
    capability(GL_LIGHTING, "GL_LIGHTING", "lighting", kCompatibility),
    capability(GL_COLOR_MATERIAL, "GL_COLOR_MATERIAL", "material from colours", kCompatibility),
    capability(GL_COLOR_SUM, "GL_COLOR_SUM", "adding of the secondary colour", kCompatibility),
    capability(GL_NORMALIZE, "GL_NORMALIZE", "normals of length one", kCompatibility),
    capability(GL_POINT_SMOOTH, "GL_POINT_SMOOTH", "smooth points", kCompatibility),
    capability(GL_POINT_SPRITE, "GL_POINT_SPRITE", "point sprites", kCompatibility),
    capability(GL_LINE_STIPPLE, "GL_LINE_STIPPLE", "line pattern", kCompatibility),
    capability(GL_POLYGON_STIPPLE, "GL_POLYGON_STIPPLE", "polygon pattern", kCompatibility),
    capability(GL_VERTEX_PROGRAM_TWO_SIDE, "GL_VERTEX_PROGRAM_TWO_SIDE", "back colours",
               kCompatibility),
};
// clang-format on

} // namespace

std::span<const StateRow> capabilityRows() { return kRows; }

} // namespace agaa::gl
