/* SPDX-License-Identifier: MIT */
#include "vtk_state.h"

#include <vtkOpenGLState.h>
#include <vtk_glew.h>

#include <algorithm>

namespace {

struct Query {
    const char* name;
    GLenum token;
};
#define QUERY(token)                                                                                                   \
    { #token, token }

} // namespace

/* VTK answers from its copy for these states, and asks the context for others. */
std::string mistakenStates(vtkOpenGLState& copy) {
    constexpr Query remembered[] = {
        QUERY(GL_VIEWPORT),      QUERY(GL_SCISSOR_BOX),   QUERY(GL_CULL_FACE_MODE),  QUERY(GL_DEPTH_FUNC),
        QUERY(GL_BLEND_SRC_RGB), QUERY(GL_BLEND_DST_RGB), QUERY(GL_BLEND_SRC_ALPHA), QUERY(GL_BLEND_DST_ALPHA),
    };
    constexpr Query switches[] = {
        QUERY(GL_BLEND),       QUERY(GL_CULL_FACE),    QUERY(GL_DEPTH_TEST),
        QUERY(GL_MULTISAMPLE), QUERY(GL_SCISSOR_TEST), QUERY(GL_STENCIL_TEST),
    };
    std::string names;
    for (const Query& each : remembered) {
        GLint believed[4] = {}, actual[4] = {};
        copy.vtkglGetIntegerv(each.token, believed);
        glGetIntegerv(each.token, actual);
        if (!std::equal(actual, actual + 4, believed))
            names += std::string(" ") + each.name;
    }
    for (const Query& each : switches)
        if (copy.GetEnumState(each.token) != (glIsEnabled(each.token) == GL_TRUE))
            names += std::string(" ") + each.name;
    unsigned char believedMask = 0, believedColors[4] = {};
    GLboolean actualMask = 0, actualColors[4] = {};
    copy.vtkglGetBooleanv(GL_DEPTH_WRITEMASK, &believedMask);
    copy.vtkglGetBooleanv(GL_COLOR_WRITEMASK, believedColors);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &actualMask);
    glGetBooleanv(GL_COLOR_WRITEMASK, actualColors);
    if (believedMask != actualMask)
        names += " GL_DEPTH_WRITEMASK";
    if (!std::equal(actualColors, actualColors + 4, believedColors))
        names += " GL_COLOR_WRITEMASK";
    unsigned believedFramebuffer = 0, drawBuffer = 0;
    GLint actualFramebuffer = 0;
    copy.GetCurrentDrawFramebufferState(believedFramebuffer, drawBuffer);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &actualFramebuffer);
    if (believedFramebuffer != unsigned(actualFramebuffer))
        names += " GL_DRAW_FRAMEBUFFER_BINDING";
    return names;
}
