// OpenGL equivalents of plan formats.
#pragma once

#include "core/base/format.h"

#include <glad/gl.h>

namespace agaa::gl {

inline GLenum internalFormat(Format format) {
    switch (format) {
    case Format::D24S8:
        return GL_DEPTH24_STENCIL8;
    case Format::D32S8:
        return GL_DEPTH32F_STENCIL8;
    case Format::D32:
        return GL_DEPTH_COMPONENT32F;
    case Format::R8:
        return GL_R8;
    case Format::RG8:
        return GL_RG8;
    case Format::RGBA8:
        return GL_RGBA8;
    case Format::R16:
        return GL_R16;
    case Format::RG16:
        return GL_RG16;
    case Format::RGBA16:
        return GL_RGBA16;
    case Format::RGBA16F:
        return GL_RGBA16F;
    case Format::RGB10A2:
        return GL_RGB10_A2;
    case Format::R8U:
        return GL_R8UI;
    case Format::R16U:
        return GL_R16UI;
    case Format::R32U:
        return GL_R32UI;
    case Format::RG32U:
        return GL_RG32UI;
    case Format::RGBA32U:
        return GL_RGBA32UI;
    case Format::None:
    case Format::Buffer:
    case Format::RGB16:
        break;
    }
    return GL_NONE;
}

inline GLenum depthAttachment(Format format) {
    return hasStencil(format) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

} // namespace agaa::gl
