// Errors of OpenGL calls. The functions call glGetError, which waits for drivers with a thread of their own.
#pragma once

#include <glad/gl.h>

namespace agaa::gl {

// Throws if OpenGL has a pending error. what: the beginning of the sentence.
void checkErrors(const GladGLContext& gl, const char* what);
// Returns the name, or throws if it is 0: the driver created no object. Calls on the name 0 would change the default
// framebuffer or other objects of the host. call: the function that returned the name.
GLuint requireObject(const GladGLContext& gl, GLuint name, const char* call);
// Removes pending errors of the SDK's own calls after a failure: the host would take them for its own.
void discardErrors(const GladGLContext& gl) noexcept;

} // namespace agaa::gl
