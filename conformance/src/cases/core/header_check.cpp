#include "header_check.h"

#include <cstring>

namespace agaa::conformance {

namespace {

constexpr size_t guard = 64, more = spareBytes - guard;

// A struct as a host with a header of this structSize passes it. A guard follows the memory.
Bytes makeStruct(Test& test, const HeaderCase& c, size_t structSize) {
    const StructRow& row = versionedStruct(c.name);
    Bytes bytes(row.size + spareBytes);
    row.init(test.sdk, bytes.data(), structSize);
    if (c.fill)
        c.fill(test, bytes.data());
    return bytes;
}

std::string what(const HeaderCase& c, const std::string& how) { return c.function + " with " + c.name + how; }

// Checks a call that must fail. An output struct must be unchanged.
void expectStructRefused(Test& test, const HeaderCase& c, Bytes& bytes, AgaaResult expected, const std::string& how,
                         const std::string& words) {
    const Bytes before = bytes;
    LogRecorder log;
    const AgaaResult result = c.call(test, bytes.data(), log.get());
    // The SDK must not call a log that is not initialised.
    const bool isSilent = !c.hasLog || (std::string(c.name) == "AgaaLog" && expected == AGAA_ERROR_STRUCT);
    if (c.holdsLog && expected == AGAA_ERROR_STRUCT)
        expectRefused(test, result, expected, what(c, how));
    else if (isSilent) {
        expectRefused(test, result, expected, what(c, how));
        test.check(log.lines.empty(), what(c, how) + " calls a log that is not initialised.");
    } else
        expectRefused(test, result, expected, log, c.function, what(c, how), words);
    if (c.isOutput)
        test.check(bytes == before, what(c, how) + " fails and changes the struct.");
}

void expectStructAccepted(Test& test, const HeaderCase& c, Bytes& bytes, const std::string& how) {
    LogRecorder log;
    const AgaaResult result = c.call(test, bytes.data(), log.get());
    const std::vector<LogLine> errors = log.errors();
    test.result(result, AGAA_OK, what(c, how) + (errors.empty() ? "" : " (\"" + errors[0].text + "\")"));
}

void expectSizeAccepted(Test& test, const HeaderCase& c, size_t structSize) {
    const std::string how = "::structSize = " + std::to_string(structSize);
    Bytes bytes = makeStruct(test, c, structSize);
    const AgaaStructHeader before = bytes.header();
    expectStructAccepted(test, c, bytes, how);
    if (!c.isOutput)
        return;
    test.check(std::memcmp(&before, bytes.data(), sizeof before) == 0,
               what(c, how) + " changes sType, structSize or pNext.");
    test.check(bytes.findDifference(structSize, bytes.size(), Bytes::pattern) == bytes.size(),
               what(c, how) + " writes beyond structSize.");
}

void expectSizeRefused(Test& test, const HeaderCase& c, uint32_t structSize) {
    Bytes bytes = makeStruct(test, c, versionedStruct(c.name).size);
    bytes.header().structSize = structSize;
    expectStructRefused(test, c, bytes, AGAA_ERROR_STRUCT, "::structSize = " + std::to_string(structSize), c.name);
}

void expectTypeRefused(Test& test, const HeaderCase& c, uint32_t sType) {
    Bytes bytes = makeStruct(test, c, versionedStruct(c.name).size);
    bytes.header().sType = sType;
    expectStructRefused(test, c, bytes, AGAA_ERROR_STRUCT, "::sType = " + std::to_string(sType), c.name);
}

void expectTailRefused(Test& test, const HeaderCase& c, size_t offset) {
    const size_t size = versionedStruct(c.name).size;
    Bytes bytes = makeStruct(test, c, size + more);
    bytes.data()[offset] = 1;
    expectStructRefused(test, c, bytes, AGAA_ERROR_VERSION, ", data at offset " + std::to_string(offset),
                        std::to_string(offset));
}

void expectChainRefused(Test& test, const HeaderCase& c, const void* chain, const std::string& how,
                        const std::string& words = "") {
    Bytes bytes = makeStruct(test, c, versionedStruct(c.name).size);
    bytes.header().pNext = chain;
    expectStructRefused(test, c, bytes, AGAA_ERROR_UNKNOWN_STRUCT, how, words);
}

void expectChainAccepted(Test& test, const HeaderCase& c, const void* chain, const std::string& how) {
    Bytes bytes = makeStruct(test, c, versionedStruct(c.name).size);
    bytes.header().pNext = chain;
    expectStructAccepted(test, c, bytes, how);
}

constexpr uint32_t optionalType = farStructType | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT;

void testTwice(Test& test, const HeaderCase& c, const std::string& name) {
    const StructRow& row = versionedStruct(name);
    Bytes first(row.size), second(row.size);
    row.init(test.sdk, first.data(), row.size);
    row.init(test.sdk, second.data(), row.size);
    first.header().pNext = second.data();
    expectChainRefused(test, c, first.data(), ", " + name + " is chained twice", std::to_string(row.sType));
}

} // namespace

void testSizes(Test& test, const HeaderCase& c) {
    const StructRow& row = versionedStruct(c.name);
    for (const size_t size : {row.firstSize, row.size, row.size + 8, row.size + more})
        expectSizeAccepted(test, c, size);
    for (const size_t size : {size_t(0), size_t(8), row.firstSize - 8, row.size + 4, row.size + 1, row.firstSize - 1})
        expectSizeRefused(test, c, uint32_t(size));
    if (c.isChained)
        return;
    for (const uint32_t sType : {0u, row.sType ^ 0x100, farStructType, row.sType | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT})
        expectTypeRefused(test, c, sType);
}

void testTail(Test& test, const HeaderCase& c) {
    const size_t size = versionedStruct(c.name).size;
    expectTailRefused(test, c, size + more - 1);
    if (!isSameVersion(test))
        return;
    expectTailRefused(test, c, size);
    expectTailRefused(test, c, size + 9);
}

void testLongChain(Test& test, const HeaderCase& c) {
    std::vector<AgaaStructHeader> chain(200);
    for (uint32_t i = 0; i < chain.size(); ++i) // each type once
        chain[i] = {optionalType - i, sizeof(AgaaStructHeader), i + 1 < chain.size() ? &chain[i + 1] : nullptr};
    expectChainAccepted(test, c, chain.data(), ", 200 optional structs are chained");
}

void testChain(Test& test, const HeaderCase& c) {
    const AgaaStructHeader unknown = {farStructType, sizeof(AgaaStructHeader), nullptr};
    expectChainRefused(test, c, &unknown, ", an unknown struct is chained", std::to_string(farStructType));
    const AgaaStructHeader optional = {optionalType, sizeof(AgaaStructHeader), nullptr};
    expectChainAccepted(test, c, &optional, ", an unknown struct with AGAA_STRUCTURE_TYPE_OPTIONAL_BIT is chained");
    const AgaaStructHeader before = {optionalType, sizeof(AgaaStructHeader), &unknown};
    expectChainRefused(test, c, &before, ", an unknown struct is chained behind an optional one",
                       std::to_string(farStructType));
    AgaaStructHeader loop = {optionalType, sizeof(AgaaStructHeader), nullptr};
    loop.pNext = &loop;
    expectChainRefused(test, c, &loop, ", the chain closes on itself");
    if (c.isChained)
        testTwice(test, c, c.name);
    if (!c.chained.empty())
        testTwice(test, c, c.chained);
}

} // namespace agaa::conformance
