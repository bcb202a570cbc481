#include "library.h"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

#include <stdexcept>

namespace agaa::conformance {

namespace {

#ifdef _WIN32

void* open(const std::string& path) {
    if (const HMODULE library = LoadLibraryA(path.c_str()))
        return library;
    throw std::runtime_error("Windows cannot load " + path + ": error " + std::to_string(GetLastError()) + ".");
}

void close(void* library) { FreeLibrary(static_cast<HMODULE>(library)); }

AgaaConformanceFunction findIn(void* library, const char* name) {
    return reinterpret_cast<AgaaConformanceFunction>(GetProcAddress(static_cast<HMODULE>(library), name));
}

// Windows has no search in all libraries of a program.
AgaaConformanceFunction findInProgram(void*, const char* name) {
    for (const char* library : {"agaa.dll", "libagaa.dll"})
        if (const HMODULE found = GetModuleHandleA(library))
            return findIn(found, name);
    return findIn(GetModuleHandleA(nullptr), name);
}

#else

void* open(const std::string& path) {
    if (void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
        return library;
    throw std::runtime_error(dlerror());
}

void close(void* library) { dlclose(library); }

AgaaConformanceFunction findIn(void* library, const char* name) {
    return reinterpret_cast<AgaaConformanceFunction>(dlsym(library, name));
}

AgaaConformanceFunction findInProgram(void*, const char* name) { return findIn(RTLD_DEFAULT, name); }

#endif

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

Library::Library(const std::string& path) : path_(path), handle_(open(path)) {}

Library::~Library() { close(handle_); }

AgaaConformanceFunction Library::find(void* library, const char* name) {
    return findIn(static_cast<Library*>(library)->handle_, name);
}

} // namespace agaa::conformance
