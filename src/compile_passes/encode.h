// Encodes SPIR-V as core/base/spirv_code.h describes.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

struct EncodedModule {
    std::vector<uint32_t> words; // of the module, with new ids
    std::vector<uint8_t> code;
    std::set<uint32_t> constants; // SpecId of the specialisation constants that its instructions use
};

// Throws std::runtime_error if the module is invalid or has too many types, constants and variables.
EncodedModule encoded(std::span<const uint32_t> spirv);
