// The tests, by what they are about.
#pragma once

#include "../suite.h"

namespace agaa::conformance {

void addAllCases(Suite& suite); // all.cpp

} // namespace agaa::conformance
