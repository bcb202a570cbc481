// hard-scenes: frames of numerically hard cases in every technique.
#include "cli/commands.h"
#include "hard/run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <set>
#include <tuple>

namespace harness {

using nlohmann::json;
using namespace hard;

namespace {

bool isSelected(const std::vector<std::string>& wanted, const std::string& name) {
    return wanted.empty() || std::ranges::find(wanted, name) != wanted.end();
}

bool isSelected(const std::vector<uint32_t>& wanted, uint32_t number) {
    return wanted.empty() || std::ranges::find(wanted, number) != wanted.end();
}

std::vector<size_t> selectedFrames(const std::vector<std::string>& names) {
    std::vector<size_t> selected;
    std::set<std::string> known;
    for (size_t i = 0; i < hardFrames().size(); ++i) {
        known.insert(hardFrames()[i].name);
        if (isSelected(names, hardFrames()[i].name))
            selected.push_back(i);
    }
    for (const std::string& name : names)
        if (!known.contains(name))
            throw BadArgument("--scene is \"" + name + "\"; `hard-scenes --list` lists the frames of hard cases.");
    return selected;
}

std::vector<size_t> selectedConfigurations(const HardScenesArguments& arguments) {
    std::vector<size_t> selected;
    for (size_t i = 0; i < hardConfigurations().size(); ++i) {
        const HardConfiguration& c = hardConfigurations()[i];
        if (isSelected(arguments.techniques, c.technique) && isSelected(arguments.samples, c.samples) &&
            (c.aggregates == 0 || isSelected(arguments.aggregates, c.aggregates)))
            selected.push_back(i);
    }
    if (selected.empty())
        throw BadArgument("No configuration has this technique, n and c.");
    return selected;
}

// Parses K/N. Returns K - 1 and N.
std::pair<uint32_t, uint32_t> parsePart(const std::string& text) {
    uint32_t part = 0, parts = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%u/%u%c", &part, &parts, &rest) != 2 || part < 1 || part > parts)
        throw BadArgument("--part is \"" + text + "\"; it is written K/N, with K from 1 to N.");
    return {part - 1, parts};
}

const HardFrame& frameOf(const HardResult& result) { return hardFrames()[result.job.frame]; }
const HardConfiguration& configurationOf(const HardResult& result) {
    return hardConfigurations()[result.job.configuration];
}

void print(const HardResult& result) {
    if (result.isRefused())
        return; // printRefusals() groups them
    const std::string name = result.job.backend + " " + configurationOf(result).name();
    std::printf("%-21s %-34s error %.2e of %.2e, mean %.2e of %.2e", frameOf(result).name, name.c_str(), result.mseTm,
                result.maxMseTm, result.meanError, result.maxMeanError);
    if (result.finding)
        std::printf(", check %.3g of %.3g", result.finding->value, result.finding->bound);
    std::printf(", %llu non-finite, %llu sanitised, %llu lost%s%s\n", static_cast<unsigned long long>(result.nonFinite),
                static_cast<unsigned long long>(result.sanitised),
                static_cast<unsigned long long>(result.lostFragments),
                result.isWithin() ? "" : "  EXCEEDS: ", result.excess().c_str());
    std::fflush(stdout);
}

// The configurations that the SDK refuses for one reason, and the number of frames for which it does.
struct Refusal {
    std::set<std::string> configurations, frames;
};

std::map<std::string, Refusal> refusalsOf(const HardReport& report) {
    std::map<std::string, Refusal> refusals;
    for (const HardResult& result : report.results)
        if (result.isRefused()) {
            Refusal& refusal = refusals[result.refusal];
            refusal.configurations.insert(result.job.backend + " " + configurationOf(result).name());
            refusal.frames.insert(frameOf(result).name);
        }
    return refusals;
}

void printRefusals(const HardReport& report) {
    for (const auto& [reason, refusal] : refusalsOf(report)) {
        std::printf("refused in %zu scenes: %s\n", refusal.frames.size(), reason.c_str());
        for (const std::string& configuration : refusal.configurations)
            std::printf("    %s\n", configuration.c_str());
    }
}

json toJson(const HardResult& result) {
    const HardConfiguration& c = configurationOf(result);
    json out = {{"scene", frameOf(result).name},
                {"backend", result.job.backend},
                {"technique", c.technique},
                {"samples", c.samples},
                {"aggregates", c.aggregates},
                {"tier", agaaTierName(c.generationTier)},
                {"preset", c.isAccurate ? "accurate" : ""},
                {"shades", nameOf(c.shading())}};
    out.update({{"size", std::to_string(result.width) + "x" + std::to_string(result.height)},
                {"mseTm", result.mseTm},
                {"maxMseTm", result.maxMseTm},
                {"referenceMseTm", result.referenceMseTm},
                {"maxTm", result.maxTm},
                {"meanError", result.meanError},
                {"maxMeanError", result.maxMeanError},
                {"frames", result.frames},
                {"nonFinite", result.nonFinite},
                {"sanitised", result.sanitised},
                {"lostFragments", result.lostFragments},
                {"exceeds", result.excess()}});
    if (result.finding)
        out["check"] = {{"value", result.finding->value}, {"bound", result.finding->bound}};
    return out;
}

json frameJson(const HardFrame& frame) {
    json bounds = json::object();
    for (size_t i = 0; i < kShadings; ++i)
        bounds[nameOf(Shading(i))] = {{"maxMseTm", frame.maxMseTm[i]}, {"maxMeanError", frame.maxMeanError[i]}};
    return {{"scene", frame.name}, {"builtin", frame.scene}, {"cases", frame.cases},
            {"spp", frame.spp},    {"bounds", bounds},       {"check", frame.checked ? json(frame.checked) : json()}};
}

struct Totals {
    size_t rendered = 0, refused = 0, exceeding = 0;
    uint64_t frames = 0, nonFinite = 0;
};

Totals totalsOf(const HardReport& report) {
    Totals totals;
    for (const HardResult& result : report.results) {
        totals.rendered += !result.isRefused();
        totals.refused += result.isRefused();
        totals.exceeding += !result.isWithin();
        totals.frames += result.frames;
        totals.nonFinite += result.nonFinite;
    }
    return totals;
}

json reportJson(const HardReport& report, const Totals& totals) {
    json devices = json::array(), frames = json::array(), results = json::array();
    for (const HardDevice& device : report.devices)
        devices.push_back({{"backend", device.backend}, {"device", device.device}, {"driver", device.driver}});
    std::set<size_t> used;
    for (const HardResult& result : report.results) {
        if (used.insert(result.job.frame).second)
            frames.push_back(frameJson(frameOf(result)));
        if (!result.isRefused())
            results.push_back(toJson(result));
    }
    json refusals = json::array();
    for (const auto& [reason, refusal] : refusalsOf(report))
        refusals.push_back(
            {{"reason", reason}, {"scenes", refusal.frames.size()}, {"configurations", refusal.configurations}});
    return {{"devices", devices},
            {"scenes", frames},
            {"rendered", totals.rendered},
            {"refused", totals.refused},
            {"refusals", refusals},
            {"exceeding", totals.exceeding},
            {"frames", totals.frames},
            {"nonFinite", totals.nonFinite},
            {"apiMessages", report.messages},
            {"results", results}};
}

} // namespace

void runHardScenes(const HardScenesArguments& arguments, bool asJson) {
    if (arguments.list) {
        json list = json::array();
        for (const HardFrame& frame : hardFrames())
            list.push_back(frameJson(frame));
        if (asJson)
            std::cout << list.dump(2) << '\n';
        else
            for (const HardFrame& frame : hardFrames())
                std::printf("%-21s %-22s cases %s\n", frame.name, frame.scene, frame.cases);
        return;
    }
    std::vector<std::string> backends = {"vk", "gl"};
    if (!arguments.device.backend.empty()) {
        requireBackend(arguments.device.backend);
        backends = {arguments.device.backend};
    }
    const std::vector<HardJob> jobs =
        allJobs(selectedFrames(arguments.scenes), selectedConfigurations(arguments), backends);
    HardOptions options;
    options.perPair = arguments.covering;
    std::tie(options.part, options.parts) = parsePart(arguments.part);
    options.spp = arguments.spp;
    if (!asJson)
        options.report = print;
    const auto makeBackend = [&](const std::string& backend, bool isWithoutD24) {
        DeviceArguments device = arguments.device;
        device.backend = backend;
        device.noD24 = isWithoutD24;
        return makeRenderer(device);
    };
    const HardReport report = runJobs(jobs, makeBackend, options);
    const Totals totals = totalsOf(report);
    if (asJson)
        std::cout << reportJson(report, totals).dump(1) << '\n';
    else {
        printRefusals(report);
        std::printf("%llu non-finite channels in %llu frames; %zu configurations rendered, %zu refused, %zu exceed a "
                    "bound\n",
                    static_cast<unsigned long long>(totals.nonFinite), static_cast<unsigned long long>(totals.frames),
                    totals.rendered, totals.refused, totals.exceeding);
    }
    for (const std::string& message : report.messages)
        std::fprintf(stderr, "API message: %s\n", message.c_str());
    if (totals.exceeding || !report.messages.empty())
        throw std::runtime_error(std::to_string(totals.exceeding) + " frames exceed a bound, and the graphics APIs " +
                                 "reported " + std::to_string(report.messages.size()) + " messages.");
}

} // namespace harness
