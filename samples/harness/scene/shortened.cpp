#include "scene/shortened.h"

namespace harness {

std::string shortened(std::string_view text) {
    constexpr size_t longWord = 80, kept = 50, mostBytes = 300;
    std::string out, word;
    const auto isContinuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    const auto cut = [&](std::string& s, size_t length) {
        while (length > 0 && isContinuation(s[length]))
            --length;
        s.resize(length);
    };
    const auto takeWord = [&] {
        const size_t size = word.size();
        if (size > longWord) {
            cut(word, kept);
            word += "… (" + std::to_string(size) + " bytes)";
        }
        out += word;
        word.clear();
    };
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code > ' ' && code != 0x7F) {
            word += c;
            continue;
        }
        takeWord();
        out += ' ';
    }
    takeWord();
    if (out.size() > mostBytes) {
        cut(out, mostBytes);
        out += "…";
    }
    return out;
}

} // namespace harness
