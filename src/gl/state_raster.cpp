// States between vertices and fragments: viewports, primitives and samples.
#include "gl/state_access.h"
#include "gl/state_table.h"

namespace agaa::gl {
namespace {

using Gl = GladGLContext;

template <GLenum Parameter>
void setPatchLevels(const StateContext& context, const StateRow& row, uint32_t, const StateValue& value) {
    GLfloat levels[4]{};
    for (size_t i = 0; i < row.layout.size(); ++i)
        levels[i] = component<GLfloat>(value, i);
    context.gl().PatchParameterfv(Parameter, levels);
}

void setPolygonModes(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    context.gl().PolygonMode(GL_FRONT, component<GLenum>(value, 0));
    context.gl().PolygonMode(GL_BACK, component<GLenum>(value, 1));
}

// glPolygonOffset sets the clamp to 0. If the context has a clamp, one call sets all three values.
bool hasOffsetClamp(const GladGLContext& gl) {
    return gl.VERSION_4_6 || gl.ARB_polygon_offset_clamp || gl.EXT_polygon_offset_clamp;
}

void readPolygonOffset(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    StateRow had = row;
    if (!hasOffsetClamp(reading.gl()))
        had.layout.remove_suffix(1);
    readValues(reading, had, element, out);
}

void setPolygonOffset(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    if (!hasOffsetClamp(gl))
        callWith(gl.PolygonOffset, value);
    else if (gl.PolygonOffsetClamp)
        callWith(gl.PolygonOffsetClamp, value);
    else
        callWith(gl.PolygonOffsetClampEXT, value);
}

constexpr StateNeed kClipControl{"4.5 or GL_ARB_clip_control", [](const GladGLContext& gl) {
                                     return gl.VERSION_4_5 != 0 || gl.ARB_clip_control != 0;
                                 }};

// clang-format off
constexpr StateRow kRows[] = {
    {"GL_VIEWPORT", "viewport", {GL_VIEWPORT}, "ffff", readValues, setAt<&Gl::ViewportIndexedf>,
     StateArray::Viewports},
    {"GL_DEPTH_RANGE", "depth range", {GL_DEPTH_RANGE}, "ff", readValues,
     setAt<&Gl::DepthRangeIndexed>, StateArray::Viewports},
    {"GL_SCISSOR_BOX", "scissor rectangle", {GL_SCISSOR_BOX}, "iiii", readValues,
     setAt<&Gl::ScissorIndexed>, StateArray::Viewports},
    {"GL_CLIP_ORIGIN, GL_CLIP_DEPTH_MODE", "clip control", {GL_CLIP_ORIGIN, GL_CLIP_DEPTH_MODE},
     "ee", readValues, set<&Gl::ClipControl>, StateArray::Once, StateProfile::Any, kClipControl},

    {"GL_CULL_FACE_MODE", "culled faces", {GL_CULL_FACE_MODE}, "e", readValues,
     set<&Gl::CullFace>},
    {"GL_FRONT_FACE", "winding of front faces", {GL_FRONT_FACE}, "e", readValues,
     set<&Gl::FrontFace>},
    {"GL_POLYGON_MODE", "polygon mode", {GL_POLYGON_MODE}, "e", readValues,
     set<&Gl::PolygonMode, GL_FRONT_AND_BACK>, StateArray::Once, StateProfile::Core},
    {"GL_POLYGON_MODE", "polygon mode, front and back", {GL_POLYGON_MODE},
     "ee", readValues, setPolygonModes, StateArray::Once, StateProfile::Compatibility},
    {"GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS, GL_POLYGON_OFFSET_CLAMP",
     "depth offset; with the clamp if the context has it",
     {GL_POLYGON_OFFSET_FACTOR, GL_POLYGON_OFFSET_UNITS, GL_POLYGON_OFFSET_CLAMP}, "fff",
     readPolygonOffset, setPolygonOffset},
    {"GL_LINE_WIDTH", "line width", {GL_LINE_WIDTH}, "f", readValues, set<&Gl::LineWidth>},
    {"GL_POINT_SIZE", "point size", {GL_POINT_SIZE}, "f", readValues, set<&Gl::PointSize>},
    {"GL_POINT_FADE_THRESHOLD_SIZE", "point size below which points fade",
     {GL_POINT_FADE_THRESHOLD_SIZE}, "f", readValues, setParameter<&Gl::PointParameterf>},
    {"GL_POINT_SPRITE_COORD_ORIGIN", "origin of gl_PointCoord", {GL_POINT_SPRITE_COORD_ORIGIN},
     "e", readValues, setParameter<&Gl::PointParameteri>},
    {"GL_PROVOKING_VERTEX", "vertex that flat attributes come from", {GL_PROVOKING_VERTEX}, "e",
     readValues, set<&Gl::ProvokingVertex>},
    {"GL_PRIMITIVE_RESTART_INDEX", "primitive restart index", {GL_PRIMITIVE_RESTART_INDEX}, "u",
     readValues, set<&Gl::PrimitiveRestartIndex>},
    {"GL_PATCH_VERTICES", "vertices a patch", {GL_PATCH_VERTICES}, "i", readValues,
     setParameter<&Gl::PatchParameteri>},
    {"GL_PATCH_DEFAULT_INNER_LEVEL", "tessellation without a control shader",
     {GL_PATCH_DEFAULT_INNER_LEVEL}, "ff", readValues,
     setPatchLevels<GL_PATCH_DEFAULT_INNER_LEVEL>},
    {"GL_PATCH_DEFAULT_OUTER_LEVEL", "tessellation without a control shader",
     {GL_PATCH_DEFAULT_OUTER_LEVEL}, "ffff", readValues,
     setPatchLevels<GL_PATCH_DEFAULT_OUTER_LEVEL>},

    {"GL_SAMPLE_COVERAGE_VALUE, GL_SAMPLE_COVERAGE_INVERT", "coverage by a value",
     {GL_SAMPLE_COVERAGE_VALUE, GL_SAMPLE_COVERAGE_INVERT}, "fb", readValues,
     set<&Gl::SampleCoverage>},
    {"GL_SAMPLE_MASK_VALUE", "coverage by a mask", {GL_SAMPLE_MASK_VALUE}, "u", readValues,
     setAt<&Gl::SampleMaski>, StateArray::SampleMaskWords},
    {"GL_MIN_SAMPLE_SHADING_VALUE", "minimum fraction of samples that is shaded",
     {GL_MIN_SAMPLE_SHADING_VALUE}, "f", readValues, set<&Gl::MinSampleShading>},
    {"GL_RASTER_SAMPLES_EXT, GL_RASTER_FIXED_SAMPLE_LOCATIONS_EXT",
     "rasterization with an explicit sample count",
     {GL_RASTER_SAMPLES_EXT, GL_RASTER_FIXED_SAMPLE_LOCATIONS_EXT}, "ib", readValues,
     set<&Gl::RasterSamplesEXT>, StateArray::Once, StateProfile::Any, kMixedSamples},
    {"GL_COVERAGE_MODULATION_NV", "components that coverage modulates", {GL_COVERAGE_MODULATION_NV}, "e",
     readValues, set<&Gl::CoverageModulationNV>, StateArray::Once, StateProfile::Any,
     kMixedSamples},

    {"GL_FRAGMENT_SHADER_DERIVATIVE_HINT", "accuracy of derivatives",
     {GL_FRAGMENT_SHADER_DERIVATIVE_HINT}, "e", readValues, setParameter<&Gl::Hint>},
    {"GL_LINE_SMOOTH_HINT", "quality of smooth lines", {GL_LINE_SMOOTH_HINT}, "e", readValues,
     setParameter<&Gl::Hint>},
    {"GL_POLYGON_SMOOTH_HINT", "quality of smooth polygons", {GL_POLYGON_SMOOTH_HINT}, "e",
     readValues, setParameter<&Gl::Hint>},
    {"GL_SHADE_MODEL", "flat or smooth colours", {GL_SHADE_MODEL}, "e", readValues,
     set<&Gl::ShadeModel>, StateArray::Once, StateProfile::Compatibility},
};
// clang-format on

} // namespace

std::span<const StateRow> rasterRows() { return kRows; }

} // namespace agaa::gl
