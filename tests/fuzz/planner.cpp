// Target planner: queries that need no device, with views of any members, chains, layouts, functions and devices.
#include "api_inputs.h"

namespace fuzz {

namespace {

template <typename Out, typename Call> void runQuery(const char* function, const Out& initial, const Call& call) {
    Messages messages;
    Out out = initial;
    const AgaaResult result = call(messages, &out);
    checkResult(function, result, messages, std::memcmp(&out, &initial, sizeof out) != 0);
}

template <typename Query> void runText(const char* function, Choices& choices, const Query& query) {
    Messages messages;
    std::string text(choices.oneIn(3) ? choices.below(300) : 1 << 17, '#');
    const std::string before = text;
    size_t size = text.size();
    const AgaaResult result = query(messages, &size, choices.oneIn(5) ? nullptr : text.data());
    checkResult(function, result, messages, text != before);
    if (result == AGAA_OK && text != before && (size > text.size() || std::strlen(text.c_str()) + 1 != size))
        report(std::string(function) + " reports a size that is not that of its text");
}

template <typename Element, typename Query>
void runList(const char* function, Choices& choices, const Element& initial, const Query& query) {
    Messages messages;
    std::vector<Element> list(choices.oneIn(3) ? choices.below(20) : 1024, initial);
    uint32_t count = uint32_t(list.size());
    const bool isCounted = choices.oneIn(3);
    const AgaaResult result = query(messages, &count, isCounted ? nullptr : list.data());
    bool isChanged = count != list.size();
    for (const Element& element : list)
        isChanged |= std::memcmp(&element, &initial, sizeof element) != 0;
    checkResult(function, result, messages, isChanged);
}

void listCapabilities(const AgaaDeviceCaps* caps) {
    uint32_t count = 0;
    if (agaaQueryCapabilities(caps, &count, nullptr) != AGAA_OK)
        return;
    countAccepted();
    std::vector<AgaaCapability> list(count, AgaaCapability AGAA_CAPABILITY_INIT);
    if (agaaQueryCapabilities(caps, &count, list.data()) != AGAA_OK)
        report("agaaQueryCapabilities counts elements that it does not list");
    for (const AgaaCapability& capability : list)
        checkLine("agaaQueryCapabilities", capability.reason);
}

} // namespace

void runPlanner(Choices& choices) {
    const ViewInput input(choices);
    const AgaaViewDesc* view = choices.oneIn(500) ? nullptr : input.view;
    const AgaaDeviceCaps* caps = input.caps;
    const uint64_t call = 63 - choices.below(64); // inputs without bytes make the cheapest call
    if (call == 0) {
        runList("agaaQueryPrices", choices, AgaaPrice AGAA_PRICE_INIT,
                [&](Messages& m, uint32_t* count, AgaaPrice* list) {
                    return agaaQueryPrices(view, caps, &m.log, count, list);
                });
    } else if (call == 1) {
        listCapabilities(caps);
    } else if (call < 20) {
        runQuery("agaaQueryTarget", AgaaTarget AGAA_TARGET_INIT,
                 [&](Messages& m, AgaaTarget* out) { return agaaQueryTarget(view, caps, &m.log, out); });
    } else if (call < 32) {
        runText("agaaPlanToJson", choices,
                [&](Messages& m, size_t* size, char* text) { return agaaPlanToJson(view, caps, &m.log, size, text); });
    } else if (call < 36) {
        runText("agaaGetAggregateGlsl", choices, [&](Messages& m, size_t* size, char* text) {
            return agaaGetAggregateGlsl(view, caps, &m.log, size, text);
        });
    } else if (call < 44) {
        runList("agaaQueryMemory", choices, AgaaSurface AGAA_SURFACE_INIT,
                [&](Messages& m, uint32_t* count, AgaaSurface* list) {
                    return agaaQueryMemory(view, caps, &m.log, nullptr, count, list);
                });
    } else {
        runQuery("agaaQueryMemory", AgaaMemoryReport AGAA_MEMORY_REPORT_INIT, [&](Messages& m, AgaaMemoryReport* out) {
            return agaaQueryMemory(view, caps, &m.log, out, nullptr, nullptr);
        });
    }
}

} // namespace fuzz
