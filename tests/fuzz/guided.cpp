// libFuzzer's entry: AGAA_FUZZ_TARGET names the target. A finding ends the program, so that the input is kept.
#include "target.h"

#include <cstdio>
#include <cstdlib>

void fuzz::report(const std::string& text) {
    std::fprintf(stderr, "FINDING: %s\n", text.c_str());
    std::abort();
}

void fuzz::countAccepted() {}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const fuzz::Target* const target = [] {
        const char* name = std::getenv("AGAA_FUZZ_TARGET");
        for (const fuzz::Target& candidate : fuzz::targets)
            if (name && std::string(name) == candidate.name)
                return &candidate;
        std::fprintf(stderr, "AGAA_FUZZ_TARGET names no target.\n");
        std::exit(2);
    }();
    fuzz::Choices choices(std::span(data, size));
    if (target->choose)
        target->choose(choices);
    else
        target->read({reinterpret_cast<const char*>(data), size});
    return 0;
}
