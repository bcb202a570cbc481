// price: the cost of effects, samples and aggregates of a view.
#include "cli/commands.h"
#include "cli/planned_view.h"

#include <nlohmann/json.hpp>

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>

namespace harness {

using nlohmann::json;

namespace {

// Times of frames with an effect compared with frames without it, by the labels of prices.
struct MeasuredTimes {
    bool isGiven = false;
    std::string device;
    std::map<std::string, double> ratios;
};

MeasuredTimes readTimes(const std::string& path) {
    MeasuredTimes times;
    if (path.empty())
        return times;
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error("\"" + path + "\" cannot be read.");
    times.isGiven = true;
    try {
        const json data = json::parse(file);
        times.device = data.at("device").get<std::string>();
        for (const auto& [name, row] : data.at("effects").items())
            times.ratios[name] = row.at("ratio").get<double>();
    } catch (const json::exception&) {
        throw std::runtime_error(
            "\"" + path + "\" is no file of times: {\"device\": NAME, \"effects\": {NAME: {\"ratio\": NUMBER}}}.");
    }
    return times;
}

std::vector<AgaaPrice> queryPrices(const AgaaViewDesc& view, const AgaaDeviceCaps* caps) {
    Sdk sdk;
    uint32_t count = 0;
    sdk.check(agaaQueryPrices(&view, caps, sdk.log(), &count, nullptr));
    std::vector<AgaaPrice> prices(count, AgaaPrice AGAA_PRICE_INIT);
    sdk.check(agaaQueryPrices(&view, caps, sdk.log(), &count, prices.data()));
    return prices;
}

std::string labelOf(const AgaaPrice& price) {
    if (price.kind != AGAA_PRICE_SAMPLES && price.kind != AGAA_PRICE_AGGREGATES)
        return price.name;
    return std::string(price.name) + " " + std::to_string(price.fromCount) + " to " + std::to_string(price.toCount);
}

json priceJson(const AgaaPrice& price) {
    json object = {{"name", price.name}, {"description", price.description}, {"isOn", price.isOn != 0}};
    if (price.toCount) {
        object["from"] = price.fromCount;
        object["to"] = price.toCount;
    }
    object["isPossible"] = price.isPossible != 0;
    if (!price.isPossible) {
        object["reason"] = price.reason;
        return object;
    }
    object["changesTier"] = price.changesTier != 0;
    object.update({{"passes", price.passes},
                   {"geometryPasses", price.geometryPasses},
                   {"pipelines", price.pipelines},
                   {"totalBytes", price.totalBytes},
                   {"peakBytes", price.peakBytes},
                   {"constantBytes", price.constantBytes},
                   {"sampleBits", price.sampleBits},
                   {"aggregateBits", price.aggregateBits},
                   {"trafficBytes", price.trafficBytes},
                   {"maxEventsPerPixel", price.maxEventsPerPixel},
                   {"maxShadowTapsPerEvent", price.maxShadowTapsPerEvent},
                   {"maxLightsPerEvent", price.maxLightsPerEvent}});
    return object;
}

void printJson(const std::vector<AgaaPrice>& prices, const MeasuredTimes& times, const AgaaViewDesc& view) {
    json object = {{"width", view.width},
                   {"height", view.height},
                   {"effects", json::array()},
                   {"samples", json::array()},
                   {"aggregates", json::array()}};
    if (times.isGiven)
        object["measuredOn"] = times.device;
    for (const AgaaPrice& price : prices) {
        json row = priceJson(price);
        if (const auto found = times.ratios.find(labelOf(price)); found != times.ratios.end())
            row["measuredRatio"] = found->second;
        if (price.kind == AGAA_PRICE_VIEW)
            object["view"] = row;
        else
            object[price.kind == AGAA_PRICE_EFFECT ? "effects" : price.name].push_back(row);
    }
    std::cout << object.dump(2) << '\n';
}

// Numbers of the view itself have no sign. Differences of 0 are printed as dots, so that the other differences stand
// out.
std::string numberText(const AgaaPrice& price, double number, int digits) {
    if (price.kind != AGAA_PRICE_VIEW && number == 0)
        return ".";
    char text[64];
    std::snprintf(text, sizeof text, price.kind == AGAA_PRICE_VIEW ? "%.*f" : "%+.*f", digits, number);
    return text;
}

std::string measuredText(const MeasuredTimes& times, const AgaaPrice& price) {
    const auto found = times.ratios.find(labelOf(price));
    if (found == times.ratios.end())
        return "";
    char text[64];
    std::snprintf(text, sizeof text, "%+.1f %%", 100 * (found->second - 1));
    return text;
}

void printRow(const std::vector<std::string>& cells) {
    static constexpr int widths[] = {20, 3, 7, 6, 10, 9, 9, 11, 10, 10, 7, 7, 7, 9};
    std::string line;
    for (size_t i = 0; i < cells.size(); ++i) {
        const auto width = size_t(widths[i]);
        const std::string space(cells[i].size() < width ? width - cells[i].size() : 0, ' ');
        line += i < 2 ? cells[i] + space + " " : space + cells[i] + " ";
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::printf("%s\n", line.c_str());
}

void printTable(const std::vector<AgaaPrice>& prices, const MeasuredTimes& times, const AgaaViewDesc& view) {
    const double pixels = double(view.width) * view.height;
    std::printf("%ux%u pixels; bytes and traffic per pixel; events per pixel, taps and lights per event, at most; * "
                "another tier\n",
                view.width, view.height);
    if (times.isGiven)
        std::printf("time: frames with the effect against frames without, on %s\n", times.device.c_str());
    std::vector<std::string> head = {"",       "on",   "passes",      "draws",      "pipelines",
                                     "bytes",  "peak", "sample bits", "aggr. bits", "traffic",
                                     "events", "taps", "lights"};
    if (times.isGiven)
        head.push_back("time");
    printRow(head);
    for (const AgaaPrice& price : prices) {
        if (!price.isPossible)
            continue;
        const auto whole = [&](int64_t number) { return numberText(price, double(number), 0); };
        const auto perPixel = [&](int64_t bytes) { return numberText(price, double(bytes) / pixels, 3); };
        const bool isBounded = price.kind != AGAA_PRICE_VIEW || price.maxEventsPerPixel > 0;
        std::vector<std::string> cells = {labelOf(price) + (price.changesTier ? " *" : ""),
                                          price.isOn ? "yes" : "no",
                                          whole(price.passes),
                                          whole(price.geometryPasses),
                                          whole(price.pipelines),
                                          perPixel(price.totalBytes),
                                          perPixel(price.peakBytes),
                                          whole(price.sampleBits),
                                          whole(price.aggregateBits),
                                          perPixel(price.trafficBytes),
                                          isBounded ? whole(price.maxEventsPerPixel) : "any",
                                          whole(price.maxShadowTapsPerEvent),
                                          whole(price.maxLightsPerEvent)};
        if (times.isGiven)
            cells.push_back(measuredText(times, price));
        printRow(cells);
    }
    for (const AgaaPrice& price : prices)
        if (!price.isPossible)
            std::printf("%s: not possible: %s\n", labelOf(price).c_str(), price.reason);
}

} // namespace

void runPrice(const RenderArguments& arguments, const std::string& timesPath, bool sceneGiven, bool asJson) {
    const Configuration configuration(arguments.plan);
    const MeasuredTimes times = readTimes(timesPath);
    const AgaaSceneFacts facts = plannedFacts(arguments, sceneGiven);
    const auto caps = planningDevice(configuration, arguments.device);
    const AgaaFetchFunction fetch = anyFetch(arguments.plan.unfetchedEvery == 0, configuration.computesTriangles);
    const AgaaViewDesc view =
        viewOf(configuration, facts, fetch, arguments.plan.reversedZ, arguments.device.clipZFromMinusOne);
    const std::vector<AgaaPrice> prices = queryPrices(view, caps ? &*caps : nullptr);
    if (asJson)
        printJson(prices, times, view);
    else
        printTable(prices, times, view);
}

} // namespace harness
