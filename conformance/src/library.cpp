#include "library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace agaa::conformance {

namespace {

AgaaConformanceFunction findInProgram(void*, const char* name) {
    return reinterpret_cast<AgaaConformanceFunction>(dlsym(RTLD_DEFAULT, name));
}

} // namespace

Functions findFunctions(AgaaConformanceGetFunction getFunction, void* user, std::vector<std::string>& missing) {
    if (!getFunction)
        getFunction = findInProgram;
    Functions found;
#define AGAA_FUNCTION(name)                                                                                            \
    found.name = reinterpret_cast<decltype(found.name)>(getFunction(user, #name));                                     \
    if (!found.name)                                                                                                   \
        missing.push_back(#name);
#include "functions.inc"
    return found;
}

Library::Library(const std::string& path) : path_(path), handle_(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_)
        throw std::runtime_error(dlerror());
}

Library::~Library() { dlclose(handle_); }

AgaaConformanceFunction Library::find(void* library, const char* name) {
    return reinterpret_cast<AgaaConformanceFunction>(dlsym(static_cast<Library*>(library)->handle_, name));
}

} // namespace agaa::conformance
