#include "cases.h"

namespace agaa::conformance {

void addAllCases(Suite& suite) {
    addInitCases(suite);
    addHeaderCases(suite);
}

} // namespace agaa::conformance
