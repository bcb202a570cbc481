// The fuzz targets, and how they report findings.
#pragma once

#include "choices.h"

#include <string>
#include <string_view>

namespace fuzz {

// A target runs from choices, or reads a file. Files are kept inputs in corpus/<name>, mutated; choices are kept there
// as bytes.
struct Target {
    const char* name;
    void (*choose)(Choices& choices);      // null for files
    void (*read)(const std::string& text); // null for choices
};

void runPlanner(Choices& choices);
void runChoose(Choices& choices);
void runGlsl(Choices& choices);
void readGltf(const std::string& text);
void readLayoutFile(const std::string& text);
void readMeasuredFile(const std::string& text);
void readExrFile(const std::string& text);
void readProgramCache(const std::string& text);

inline constexpr Target targets[] = {
    {"planner", runPlanner, nullptr}, {"choose", runChoose, nullptr},       {"glsl", runGlsl, nullptr},
    {"gltf", nullptr, readGltf},      {"layout", nullptr, readLayoutFile},  {"measured", nullptr, readMeasuredFile},
    {"exr", nullptr, readExrFile},    {"cache", nullptr, readProgramCache},
};

// Reports that a run broke a rule. The program decides whether it ends.
void report(const std::string& text);
// Counts runs whose input was accepted, so that targets show whether they test more than refusals.
void countAccepted();
// Checks a message that a program prints: one line without control characters.
void checkLine(std::string_view call, std::string_view message);

} // namespace fuzz
