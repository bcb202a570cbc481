#include "corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace fuzz {

std::vector<std::string> readCorpus(const std::string& target) {
    const std::filesystem::path folder = std::filesystem::path(AGAA_FUZZ_CORPUS) / target;
    std::vector<std::filesystem::path> paths;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end()); // runs must not depend on the order of the file system
    std::vector<std::string> texts;
    for (const auto& path : paths) {
        std::ifstream file(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

namespace {

// Replaces the number at or after a place by another one.
void changeNumber(Choices& choices, std::string& text, size_t at) {
    static const char* const numbers[] = {"-1",    "0",    "1",     "2",          "3",     "1e999",
                                          "65535", "-0.5", "1e-45", "4294967295", "5121",  "18446744073709551616",
                                          "5126",  "5123", "1e38",  "2147483647", "34962", "9223372036854775807"};
    const size_t begin = text.find_first_of("0123456789", at);
    if (begin == std::string::npos)
        return;
    const size_t end = text.find_first_not_of("0123456789.eE+-", begin);
    text.replace(begin, (end == std::string::npos ? text.size() : end) - begin, choices.of(numbers));
}

void changeWord(Choices& choices, std::string& text, size_t at) {
    const uint32_t word = choices.word();
    at = choices.oneIn(2) ? at : at / 4 * 4;
    if (at + 4 <= text.size())
        std::memcpy(text.data() + at, &word, 4);
}

} // namespace

void mutate(Choices& choices, std::string& text) {
    static const char* const tokens[] = {"null", "[]",       "{}", "\"\"",    "[[[[", "\"MAT4\"",   "\\u0000", "NaN",
                                         "true", "\"VEC3\"", "}",  "\\ud800", ",",    "\"SCALAR\"", "/*",      "\n"};
    do {
        const size_t at = choices.below(text.size() + 1);
        const size_t length = choices.below(choices.oneIn(8) ? 200 : 12);
        switch (choices.below(7)) {
        case 0:
            text.replace(at, length, choices.of(tokens));
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(choices.below(text.size() + 1), length * 4));
            break;
        case 3:
        case 4:
            changeNumber(choices, text, at);
            break;
        case 5:
            changeWord(choices, text, at);
            break;
        default:
            if (at < text.size())
                text[at] = char(choices.bits(1));
        }
    } while (choices.oneIn(2));
}

} // namespace fuzz
