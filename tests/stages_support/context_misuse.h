// Descriptions of contexts that no graphics API may take.
#pragma once

#include "frame_misuse.h"
#include "log_lines.h"

#include <functional>
#include <vector>

namespace agaa::test {

inline void* AGAA_CALL noMemory(void*, size_t, size_t) { return nullptr; }
inline void AGAA_CALL noFree(void*, void*) {}

template <class Desc>
struct ContextMisuse {
    const char* what;
    AgaaResult expected;
    std::function<void(Desc&)> spoil;
};

// Of the members that all such descriptions have, then those given.
template <class Desc>
std::vector<ContextMisuse<Desc>> contextMisuses(std::vector<ContextMisuse<Desc>> own) {
    std::vector<ContextMisuse<Desc>> rows = {
        {"unknown struct", AGAA_ERROR_UNKNOWN_STRUCT, [](Desc& d) { d.device.pNext = &unknownStruct; }},
        {"no getProcAddr", AGAA_ERROR_INVALID_ARGUMENT, [](Desc& d) { d.device.getProcAddr = nullptr; }},
        {"no device", AGAA_ERROR_INVALID_ARGUMENT, [](Desc& d) { d.pNext = nullptr; }},
        {"device's structSize", AGAA_ERROR_STRUCT, [](Desc& d) { d.device.structSize = 20; }},
        {"reserved", AGAA_ERROR_OUT_OF_RANGE, [](Desc& d) { d.reserved = 1; }},
        {"no frames in flight", AGAA_ERROR_OUT_OF_RANGE, [](Desc& d) { d.framesInFlight = 0; }},
        {"nine frames in flight", AGAA_ERROR_OUT_OF_RANGE, [](Desc& d) { d.framesInFlight = 9; }},
        {"no free", AGAA_ERROR_INVALID_ARGUMENT, [](Desc& d) { d.allocate = noMemory; }},
        {"no memory", AGAA_ERROR_OUT_OF_MEMORY, [](Desc& d) {
             d.allocate = noMemory;
             d.free = noFree;
         }},
    };
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
}

// By the API's function, from a description that it takes.
template <class Desc>
void expectContextsRefused(AgaaResult (*create)(uint32_t, const AgaaContextDesc*, AgaaContext*), const Desc& right,
                           const std::vector<ContextMisuse<Desc>>& rows) {
    AgaaContext context = nullptr;
    for (const ContextMisuse<Desc>& row : rows) {
        Desc desc = right;
        row.spoil(desc);
        std::vector<LogLine> lines;
        const AgaaLog log = logInto(lines);
        desc.log = &log;
        EXPECT_EQ(create(AGAA_HEADER_VERSION, &desc, &context), row.expected) << row.what;
        EXPECT_EQ(context, nullptr) << row.what;
        expectOneSentence(lines, row.expected, row.what);
    }
    // Where a log would be is not known.
    EXPECT_EQ(create(AGAA_HEADER_VERSION, nullptr, &context), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(create(AGAA_HEADER_VERSION, &right, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(create(77u << 22, &right, &context), AGAA_ERROR_VERSION);
    Desc desc = right;
    desc.structSize -= 8;
    EXPECT_EQ(create(AGAA_HEADER_VERSION, &desc, &context), AGAA_ERROR_STRUCT);
    desc = right;
    desc.sType = 1;
    EXPECT_EQ(create(AGAA_HEADER_VERSION, &desc, &context), AGAA_ERROR_STRUCT);
    desc = right;
    AgaaLog log = AGAA_LOG_INIT;
    log.structSize = 0;
    desc.log = &log;
    EXPECT_EQ(create(AGAA_HEADER_VERSION, &desc, &context), AGAA_ERROR_STRUCT);
    EXPECT_EQ(context, nullptr);
}

} // namespace agaa::test
