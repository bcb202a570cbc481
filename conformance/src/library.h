// The library under test: its functions by name.
#pragma once

#include "agaa_conformance.h"
#include "agaa_gl.h"
#include "agaa_vk.h"

#include <string>
#include <vector>

namespace agaa::conformance {

// Members have the names of the functions, so that calls look as in C. A member is null if the library lacks the
// function.
struct Functions {
#define AGAA_FUNCTION(name) decltype(&::name) name = nullptr;
#include "functions.inc"
};

Functions findFunctions(AgaaConformanceGetFunction getFunction, void* user, std::vector<std::string>& missing);

// A library that is loaded by its path.
class Library {
public:
    explicit Library(const std::string& path); // throws std::runtime_error with the loader's sentence
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    const std::string& path() const { return path_; }
    static AgaaConformanceFunction find(void* library, const char* name); // an AgaaConformanceGetFunction

private:
    std::string path_;
    void* handle_;
};

} // namespace agaa::conformance
