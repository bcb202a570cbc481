// Measured settings of a file that benchmark/calibrate.py writes: {"measured": [{"technique": "agaa", "preset": "fast",
// "samples": 8, "aggregates": 1, "tier": "gbuffer", "pixels": 57600,
//                "errorShare": 0.2, "error": 0.001, "geometryMs": 20, "shadingMs": 40}, …]}
// preset and tier may be null. Entries without pixels and times were not timed.
#pragma once

#include "agaa_sdk.h"

#include <list>
#include <string>
#include <vector>

namespace harness {

class MeasuredFile {
public:
    // Throws if the file has another format.
    explicit MeasuredFile(const std::string& path);
    MeasuredFile(const MeasuredFile&) = delete;
    MeasuredFile& operator=(const MeasuredFile&) = delete;

    // The elements point into this object.
    const std::vector<AgaaMeasuredSettings>& settings() const { return settings_; }

private:
    std::vector<AgaaMeasuredSettings> settings_;
    std::list<std::string> names_;
};

} // namespace harness
