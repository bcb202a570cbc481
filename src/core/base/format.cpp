#include "core/base/format.h"

namespace agaa {

uint32_t bytesPerTexel(Format format) {
    switch (format) {
    case Format::None:
    case Format::Buffer:
        return 0;
    case Format::R8:
    case Format::R8U:
        return 1;
    case Format::RG8:
    case Format::R16:
    case Format::R16U:
        return 2;
    case Format::D24S8:
    case Format::D32:
    case Format::RGBA8:
    case Format::RG16:
    case Format::RGB10A2:
    case Format::R32U:
        return 4;
    case Format::D32S8:
        return 5;
    case Format::RGB16:
        return 6;
    case Format::RGBA16:
    case Format::RGBA16F:
    case Format::RG32U:
        return 8;
    case Format::RGBA32U:
        return 16;
    }
    return 0;
}

const char* formatName(Format format) {
    switch (format) {
    case Format::None:
        return "none";
    case Format::Buffer:
        return "buffer";
    case Format::D24S8:
        return "D24_UNORM_S8_UINT";
    case Format::D32S8:
        return "D32_FLOAT_S8_UINT";
    case Format::D32:
        return "D32_FLOAT";
    case Format::R8:
        return "R8_UNORM";
    case Format::RG8:
        return "RG8_UNORM";
    case Format::RGBA8:
        return "RGBA8_UNORM";
    case Format::R16:
        return "R16_UNORM";
    case Format::RG16:
        return "RG16_UNORM";
    case Format::RGB16:
        return "RGB16_UNORM";
    case Format::RGBA16:
        return "RGBA16_UNORM";
    case Format::RGBA16F:
        return "RGBA16_FLOAT";
    case Format::RGB10A2:
        return "RGB10A2_UNORM";
    case Format::R8U:
        return "R8_UINT";
    case Format::R16U:
        return "R16_UINT";
    case Format::R32U:
        return "R32_UINT";
    case Format::RG32U:
        return "RG32_UINT";
    case Format::RGBA32U:
        return "RGBA32_UINT";
    }
    return "unknown";
}

} // namespace agaa
