// zstd frames, and bytes as text of a C++ array.
#pragma once

#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

// Returns the result of a function of zstd. Throws std::runtime_error if it is an error.
inline size_t checkedZstd(size_t result) {
    if (ZSTD_isError(result))
        throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(result));
    return result;
}

// Compresses the bytes, by their differences to `base` if that is not empty. Throws std::runtime_error.
inline std::vector<uint8_t> compressed(std::span<const uint8_t> bytes, std::span<const uint8_t> base = {}) {
    const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
    checkedZstd(ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, ZSTD_maxCLevel()));
    checkedZstd(ZSTD_CCtx_refPrefix(context.get(), base.data(), base.size()));
    std::vector<uint8_t> out(ZSTD_compressBound(bytes.size()));
    out.resize(checkedZstd(ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size())));
    return out;
}

inline std::vector<uint8_t> decompressed(std::span<const uint8_t> frame, std::span<const uint8_t> base, size_t size) {
    const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
    checkedZstd(ZSTD_DCtx_refPrefix(context.get(), base.data(), base.size()));
    std::vector<uint8_t> out(size);
    out.resize(checkedZstd(ZSTD_decompressDCtx(context.get(), out.data(), size, frame.data(), frame.size())));
    return out;
}

inline void append(std::string& text, uint64_t value) {
    char number[32];
    std::snprintf(number, sizeof number, "0x%llxull,", static_cast<unsigned long long>(value));
    text += number;
}

// Returns `constexpr uint64_t NAME[] = {…};` with the bytes of a little-endian machine, as those of the library are.
inline std::string arrayText(const std::string& name, std::span<const uint8_t> bytes) {
    std::string text = "constexpr uint64_t " + name + "[] = {";
    for (size_t i = 0; i < bytes.size(); i += sizeof(uint64_t)) {
        uint64_t value = 0;
        for (size_t k = i; k < std::min(i + sizeof value, bytes.size()); ++k)
            value |= uint64_t(bytes[k]) << 8 * (k - i);
        append(text, value);
    }
    return text + "};\n";
}
