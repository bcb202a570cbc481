#include "report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace agaa::conformance {

size_t Report::count(AgaaConformanceStatus status) const {
    return size_t(
        std::count_if(outcomes.begin(), outcomes.end(), [&](const Outcome& o) { return o.status == status; }));
}

const char* statusName(AgaaConformanceStatus status) {
    switch (status) {
    case AGAA_CONFORMANCE_PASSED:
        return "passed";
    case AGAA_CONFORMANCE_FAILED:
        return "failed";
    default:
        return "skipped";
    }
}

std::string versionText(uint32_t version) {
    return std::to_string(version >> 22) + "." + std::to_string(version >> 12 & 0x3FF) + "." +
           std::to_string(version & 0xFFF);
}

void writeJson(std::ostream& out, const Report& report) {
    nlohmann::ordered_json devices = nlohmann::ordered_json::array(), results = nlohmann::ordered_json::array();
    for (const Report::DeviceRow& device : report.devices)
        devices.push_back(
            {{"backend", backendName(device.backend)}, {"device", device.name}, {"driver", device.driver}});
    for (const Outcome& o : report.outcomes)
        results.push_back({{"name", o.name},
                           {"backend", backendName(o.backend)},
                           {"status", statusName(o.status)},
                           {"reason", o.reason},
                           {"milliseconds", o.milliseconds}});
    const nlohmann::ordered_json document = {{"library", report.library},
                                             {"version", versionText(report.version)},
                                             {"devices", devices},
                                             {"passed", report.count(AGAA_CONFORMANCE_PASSED)},
                                             {"failed", report.count(AGAA_CONFORMANCE_FAILED)},
                                             {"skipped", report.count(AGAA_CONFORMANCE_SKIPPED)},
                                             {"results", results}};
    // Messages of drivers need not be UTF-8.
    out << document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

namespace {

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (c == '\n')
            out += "&#10;";
        else if (code < 0x20 || code > 0x7E) // not allowed in XML, or possibly not UTF-8
            out += '?';
        else
            out += c;
    }
    return out;
}

} // namespace

void writeJunit(std::ostream& out, const Report& report) {
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n" << std::fixed << std::setprecision(6);
    for (const Backend backend : {Backend::Core, Backend::Vulkan, Backend::OpenGl, Backend::Host}) {
        std::vector<const Outcome*> rows;
        size_t failed = 0, skipped = 0;
        double seconds = 0;
        for (const Outcome& o : report.outcomes)
            if (o.backend == backend) {
                rows.push_back(&o);
                failed += o.status == AGAA_CONFORMANCE_FAILED;
                skipped += o.status == AGAA_CONFORMANCE_SKIPPED;
                seconds += o.milliseconds / 1000;
            }
        if (rows.empty())
            continue;
        out << "  <testsuite name=\"" << backendName(backend) << "\" tests=\"" << rows.size() << "\" failures=\""
            << failed << "\" errors=\"0\" skipped=\"" << skipped << "\" time=\"" << seconds << "\">\n";
        for (const Outcome* o : rows) {
            out << "    <testcase classname=\"" << backendName(backend) << "\" name=\"" << escaped(o->name)
                << "\" time=\"" << o->milliseconds / 1000 << '"';
            if (o->status == AGAA_CONFORMANCE_PASSED)
                out << "/>\n";
            else
                out << "><" << (o->status == AGAA_CONFORMANCE_FAILED ? "failure" : "skipped") << " message=\""
                    << escaped(o->reason) << "\"/></testcase>\n";
        }
        out << "  </testsuite>\n";
    }
    out << "</testsuites>\n";
}

} // namespace agaa::conformance
