// Tests of the promises of AgaaStructHeader for every versioned struct, through a call that takes the struct.
#pragma once

#include "log.h"
#include "structs.h"

namespace agaa::conformance {

// Number of bytes after the struct in the memory that a case receives.
constexpr size_t spareBytes = 4096 + 64;

struct HeaderCase {
    const char* name;     // name of the struct in structs.inc
    std::string function; // function with which the message begins
    // Fills the initialised struct with valid values. May be null. The struct may be larger than in these headers.
    std::function<void(Test&, void* structure)> fill;
    std::function<AgaaResult(Test&, void* structure, const AgaaLog* log)> call;
    bool isOutput = false;
    bool hasLog = true;     // the function has a log
    bool isChained = false; // the library finds the struct by its sType: another sType is an unknown struct
    // A struct that may be chained, which the test chains twice. May be empty.
    std::string chained = "";
    bool holdsLog = false; // the struct holds the log, which is not found if the struct is not initialised
};

// Tests accepted sizes and the bytes that are written, and refused sizes and types.
void testSizes(Test& test, const HeaderCase& c);
// Tests data beyond the known members: AGAA_ERROR_VERSION.
void testTail(Test& test, const HeaderCase& c);
// Tests AGAA_ERROR_UNKNOWN_STRUCT.
void testChain(Test& test, const HeaderCase& c);
// Tests that a finite chain of any length is accepted.
void testLongChain(Test& test, const HeaderCase& c);

inline void testHeader(Test& test, const HeaderCase& c) {
    testSizes(test, c);
    testTail(test, c);
    testChain(test, c);
}

// The structs that functions without a device take.
const std::vector<HeaderCase>& coreHeaders();

} // namespace agaa::conformance
