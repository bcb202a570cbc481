// Properties of a context that the rows of the state table need.
#pragma once

#include "gl/state_row.h"
#include "gl/state_scope.h"

#include <array>
#include <vector>

namespace agaa::gl {

// Its OpenGL context must be current whenever it is created, used or destroyed. It changes no state of the context.
class StateContext {
public:
    StateContext(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile);
    ~StateContext();
    StateContext(const StateContext&) = delete;
    StateContext& operator=(const StateContext&) = delete;

    const GladGLContext& gl() const { return gl_; }
    bool compatibilityProfile() const { return compatibility_; }
    bool has(const StateRow& row) const;
    // Returns the elements of rows with this array. The context must have the row.
    const std::vector<uint32_t>& elements(StateArray array) const { return elements_[static_cast<size_t>(array)]; }
    GLuint emptyPipeline() const { return pipeline_; }

private:
    friend class StateReading;
    void createObjects();
    void destroyObjects();

    const GladGLContext& gl_;
    bool compatibility_;
    std::array<std::vector<uint32_t>, kStateArrays> elements_;
    GLuint framebuffer_ = 0; // has a stencil buffer; used by StateReading
    GLuint stencil_ = 0;
    GLuint pipeline_ = 0;
};

// Makes queries return the values that were set, during the lifetime of an object. Without it OpenGL clamps a stencil
// reference to the bits of the draw framebuffer's stencil, and colours while fragment colours are clamped. It changes
// the draw framebuffer and the clamping, keeps their values for the rows that read them, and restores them at its end.
class StateReading {
public:
    explicit StateReading(const StateContext& context);
    ~StateReading();
    StateReading(const StateReading&) = delete;
    StateReading& operator=(const StateReading&) = delete;

    const StateContext& context() const { return context_; }
    const GladGLContext& gl() const { return context_.gl(); }
    GLint activeTexture() const { return activeTexture_; } // rows of texture units change it
    GLint drawFramebuffer() const { return drawFramebuffer_; }
    GLint clampFragmentColor() const { return clampFragmentColor_; }

private:
    const StateContext& context_;
    GLint activeTexture_ = 0;
    GLint drawFramebuffer_ = 0;
    GLint clampFragmentColor_ = GL_FALSE;
};

} // namespace agaa::gl
