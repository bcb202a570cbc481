// What AgaaStructHeader promises of every versioned struct, tested through a call that takes the struct.
#pragma once

#include "log.h"
#include "structs.h"

namespace agaa::conformance {

// The memory of a struct that a case receives ends so many bytes after its size in these headers.
constexpr size_t spareBytes = 4096 + 64;

struct HeaderCase {
    const char* name;     // of the struct, as in structs.inc
    std::string function; // that the message begins with
    // Makes the initialised struct valid. May be null. The struct may be larger than in these headers.
    std::function<void(Test&, void* structure)> fill;
    std::function<AgaaResult(Test&, void* structure, const AgaaLog* log)> call;
    bool isOutput = false;
    bool hasLog = true;     // of the function
    bool isChained = false; // found by its sType: another sType is a struct that is not known
    // A struct that may be chained, which the test chains twice. May be empty.
    std::string chained = "";
    bool holdsLog = false; // the log is in the struct: it is not found if the struct is not initialised
};

// Sizes that are accepted, and the bytes that are written; sizes and types that are refused.
void testSizes(Test& test, const HeaderCase& c);
// Data beyond what the library knows: AGAA_ERROR_VERSION.
void testTail(Test& test, const HeaderCase& c);
// AGAA_ERROR_UNKNOWN_STRUCT.
void testChain(Test& test, const HeaderCase& c);
// A chain that ends is accepted, however long it is.
void testLongChain(Test& test, const HeaderCase& c);

inline void testHeader(Test& test, const HeaderCase& c) {
    testSizes(test, c);
    testTail(test, c);
    testChain(test, c);
}

// The structs that functions without a device take.
const std::vector<HeaderCase>& coreHeaders();

} // namespace agaa::conformance
