// What the rows of the state table need to know of a context.
#pragma once

#include "gl/state_row.h"
#include "gl/state_scope.h"

#include <array>
#include <vector>

namespace agaa::gl {

// Made, used and destroyed while its OpenGL context is current. Changes no state of it.
class StateContext {
public:
    StateContext(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile);
    ~StateContext();
    StateContext(const StateContext&) = delete;
    StateContext& operator=(const StateContext&) = delete;

    const GladGLContext& gl() const { return gl_; }
    bool compatibilityProfile() const { return compatibility_; }
    bool has(const StateRow& row) const;
    // Of a row that the context has.
    const std::vector<uint32_t>& elements(StateArray array) const {
        return elements_[static_cast<size_t>(array)];
    }
    GLuint emptyPipeline() const { return pipeline_; }

private:
    friend class StateReading;
    const GladGLContext& gl_;
    bool compatibility_;
    std::array<std::vector<uint32_t>, kStateArrays> elements_;
    GLuint framebuffer_ = 0; // with a stencil; see StateReading
    GLuint stencil_ = 0;
    GLuint pipeline_ = 0;
};

// While it lives, queries tell what has been set: otherwise a stencil reference is clamped to the
// bits of the draw framebuffer's stencil, and colours are clamped while fragment colours are. What
// it changes for that it keeps for the rows concerned, and sets again when it goes.
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
