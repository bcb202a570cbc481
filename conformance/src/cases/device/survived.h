// Counts of injected faults.
#pragma once

#include "device.h"

#include <cstdio>

namespace agaa::conformance {

class Survived {
public:
    // Counts one fault. failures: the number of failures of the test before it.
    void count(const Test& test, size_t failures) {
        ++injected_;
        survived_ += test.failures().size() == failures;
    }
    uint32_t injected() const { return injected_; }
    // Prints the counts. what: the call.
    void print(const Test& test, const std::string& what) const {
        std::printf("%s: %s survived %u of %u faults.\n", backendName(test.device().backend()), what.c_str(), survived_,
                    injected_);
        std::fflush(stdout);
    }

private:
    uint32_t injected_ = 0, survived_ = 0;
};

} // namespace agaa::conformance
