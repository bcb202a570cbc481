#include "cases.h"

namespace agaa::conformance {

void addAllCases(Suite& suite) {
    addInitCases(suite);
    addHeaderCases(suite);
    addConfigMemberCases(suite);
    addViewMemberCases(suite);
    addLayoutMemberCases(suite);
    addNameCases(suite);
}

} // namespace agaa::conformance
