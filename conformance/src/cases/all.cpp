#include "cases.h"

namespace agaa::conformance {

void addAllCases(Suite& suite) {
    addInitCases(suite);
}

} // namespace agaa::conformance
