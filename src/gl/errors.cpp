#include "gl/errors.h"

#include "core/base/error.h"

namespace agaa::gl {

void checkErrors(const GladGLContext& gl, const char* what) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR)
        return;
    if (error == GL_OUT_OF_MEMORY)
        fail(AGAA_ERROR_OUT_OF_MEMORY, format("%s: the driver is out of memory.", what));
    if (error == GL_CONTEXT_LOST)
        fail(AGAA_ERROR_DEVICE, format("%s: the OpenGL context is lost.", what));
    fail(AGAA_ERROR_DEVICE, format("%s: OpenGL reports error 0x%04X.", what, error));
}

GLuint requireObject(const GladGLContext& gl, GLuint name, const char* call) {
    if (name != 0)
        return name;
    checkErrors(gl, call);
    fail(AGAA_ERROR_OUT_OF_MEMORY, format("%s created no object: the driver is out of memory.", call));
}

void discardErrors(const GladGLContext& gl) noexcept {
    // The loop is bounded because a lost context may repeat its error forever.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
    }
}

} // namespace agaa::gl
