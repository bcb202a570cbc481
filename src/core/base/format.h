// Surface formats of plans, independent of any graphics API.
#pragma once

#include <cstdint>

namespace agaa {

enum class Format {
    None,
    Buffer, // bytes without texels
    D24S8,
    D32S8,
    D32,
    R8,
    RG8,
    RGBA8,
    R16,
    RG16,
    RGB16, // only in models of the papers; no device renders to it
    RGBA16,
    RGBA16F,
    RGB10A2,
    R8U,
    R16U,
    R32U,
    RG32U,
    RGBA32U,
};

// Returns the bytes that carry data. D32S8 has 5, regardless of the driver's padding.
uint32_t bytesPerTexel(Format format);
const char* formatName(Format format);
constexpr bool isDepth(Format format) {
    return format == Format::D24S8 || format == Format::D32S8 || format == Format::D32;
}
constexpr bool hasStencil(Format format) { return format == Format::D24S8 || format == Format::D32S8; }
constexpr bool isInteger(Format format) {
    return format == Format::R8U || format == Format::R16U || format == Format::R32U || format == Format::RG32U ||
           format == Format::RGBA32U;
}

} // namespace agaa
