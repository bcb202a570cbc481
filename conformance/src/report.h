// The results of a run, for people, tools and continuous integration.
#pragma once

#include "suite.h"

#include <iosfwd>

namespace agaa::conformance {

struct Report {
    std::string library;  // path of the library
    uint32_t version = 0; // version of the library, as from agaaGetVersion
    struct DeviceRow {
        Backend backend;
        std::string name, driver;
    };
    std::vector<DeviceRow> devices;
    std::vector<Outcome> outcomes;

    size_t count(AgaaConformanceStatus status) const;
};

const char* statusName(AgaaConformanceStatus status); // "passed", "failed", "skipped"
std::string versionText(uint32_t version);            // "0.2.0"
void writeJson(std::ostream& out, const Report& report);
void writeJunit(std::ostream& out, const Report& report); // writes one test suite per backend

} // namespace agaa::conformance
