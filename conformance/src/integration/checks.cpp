#include "checks.h"

namespace agaa::conformance {

bool isComplete(const AgaaConformanceHost* host) {
    return host && host->structSize == sizeof *host && host->context && host->view && host->renderFrame &&
           host->api <= AGAA_CONFORMANCE_OPENGL;
}

Suite makeHostChecks(const AgaaConformanceHost&, const Functions&) { return {}; }

} // namespace agaa::conformance
