// Encodes SPIR-V as core/base/spirv_code.h describes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

struct EncodedModule {
    std::vector<uint32_t> words; // of the module, with new ids
    std::vector<uint8_t> code;
};

// Throws std::runtime_error if SPIRV-Tools cannot read the module or it has too many types, constants and variables.
EncodedModule encoded(std::span<const uint32_t> spirv);
