// agaaQueryPrices: the entries compared with agaaQueryMemory, and the errors.
#include "cases.h"
#include "structs.h"
#include "view_parts.h"
#include "wrong_views.h"

#include <cstring>

namespace agaa::conformance {

namespace {

const AgaaPrice initialPrice = AGAA_PRICE_INIT;

std::vector<AgaaPrice> pricesOf(Test& test, const ViewParts& parts, const AgaaDeviceCaps* caps) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryPrices(parts.get(), caps, nullptr, &count, nullptr),
                   "agaaQueryPrices with prices = null");
    std::vector<AgaaPrice> prices(count, initialPrice);
    test.requireOk(test.sdk.agaaQueryPrices(parts.get(), caps, nullptr, &count, prices.data()), "agaaQueryPrices");
    test.check(count == prices.size(), "agaaQueryPrices returns another count with an array than without.");
    return prices;
}

AgaaMemoryReport memoryReportOf(Test& test, const ViewParts& parts) {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    test.requireOk(test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, &report, nullptr, nullptr),
                   "agaaQueryMemory");
    return report;
}

bool areSame(const std::vector<AgaaPrice>& a, const std::vector<AgaaPrice>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(AgaaPrice)) == 0;
}

void testPricesOfNullCaps(Test& test) {
    for (const char* technique : allTechniques) {
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique(technique, 4);
        test.check(areSame(pricesOf(test, parts, nullptr), pricesOf(test, parts, &parts.caps)),
                   std::string("agaaQueryPrices of \"") + technique +
                       "\" differs for caps = null and an ideal device.");
    }
}

void testPricesNull(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    uint32_t count = 1; // not the length of any array
    test.result(test.sdk.agaaQueryPrices(&parts.desc, nullptr, nullptr, &count, nullptr), AGAA_OK,
                "agaaQueryPrices with prices = null and count = 1");
    test.check(count > 1, "agaaQueryPrices with prices = null does not return the number of entries.");
}

// The first entry is the view and equals agaaQueryMemory. Each price has a name and a description.
void testKinds(Test& test) {
    for (const char* technique : allTechniques) {
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique(technique, 4);
        const std::vector<AgaaPrice> prices = pricesOf(test, parts, &parts.caps);
        const AgaaMemoryReport report = memoryReportOf(test, parts);
        test.check(!prices.empty() && prices[0].kind == AGAA_PRICE_VIEW && prices[0].isPossible == 1,
                   "the first price is not that of the view.");
        test.check(prices[0].totalBytes == int64_t(report.totalBytes) &&
                       prices[0].peakBytes == int64_t(report.peakBytes) &&
                       prices[0].constantBytes == int64_t(report.constantBytes),
                   std::string("the view of \"") + technique +
                       "\" has other bytes in agaaQueryPrices than in agaaQueryMemory.");
        for (const AgaaPrice& price : prices) {
            test.check(price.kind <= AGAA_PRICE_AGGREGATES || !isSameVersion(test), "a price is of no AgaaPriceKind.");
            const bool isStep = price.kind == AGAA_PRICE_SAMPLES || price.kind == AGAA_PRICE_AGGREGATES;
            test.check(isStep == (price.fromCount < price.toCount),
                       "a price that is no step has counts, or a step has none.");
            test.check(price.name && *price.name && price.description && *price.description,
                       "a price has no name or description.");
            test.check(price.isPossible <= 1 && (price.isPossible == 1) == (price.reason[0] == 0),
                       "a price has a reason and is possible, or is not possible without a reason.");
        }
    }
}

// A step of samples is the difference of two views.
void testSteps(Test& test) {
    for (const char* technique : {"msaa", "ssaa", "simple_complex", "sbaa", "agaa", "adaptive"}) {
        const auto partsOf = [&](uint32_t samples) {
            ViewParts parts(test.sdk, nullptr);
            parts.setTechnique(technique, samples);
            return memoryReportOf(test, parts);
        };
        ViewParts parts(test.sdk, nullptr);
        parts.setTechnique(technique, 4);
        for (const AgaaPrice& price : pricesOf(test, parts, &parts.caps)) {
            if (price.kind != AGAA_PRICE_SAMPLES || !price.isPossible || price.toCount > 32)
                continue;
            const AgaaMemoryReport more = partsOf(price.toCount), less = partsOf(price.fromCount);
            test.check(price.totalBytes == int64_t(more.totalBytes) - int64_t(less.totalBytes),
                       std::string("the step of \"") + technique + "\" to " + std::to_string(price.toCount) +
                           " samples is not the difference of the bytes of both views.");
        }
    }
}

void testUnchanged(Test& test) {
    std::vector<AgaaPrice> before(128, initialPrice);
    for (AgaaPrice& price : before)
        price.totalBytes = 777;
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        std::vector<AgaaPrice> prices = before;
        auto count = uint32_t(prices.size());
        const AgaaResult result = test.sdk.agaaQueryPrices(parts.get(), &parts.caps, nullptr, &count, prices.data());
        test.check(result != AGAA_OK && count == before.size() && areSame(before, prices),
                   callWith("agaaQueryPrices", row.what) + " changes prices or count.");
    }
}

AgaaResult query(Test& test, const ViewParts& parts, LogRecorder& log) {
    uint32_t count = 0;
    return test.sdk.agaaQueryPrices(parts.get(), &parts.caps, log.get(), &count, nullptr);
}

void testInvalid(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    AgaaPrice price = initialPrice;
    for (AgaaPrice* array : {static_cast<AgaaPrice*>(nullptr), &price}) {
        LogRecorder log;
        expectRefused(test, test.sdk.agaaQueryPrices(&parts.desc, nullptr, log.get(), nullptr, array),
                      AGAA_ERROR_INVALID_ARGUMENT, log, "agaaQueryPrices", "agaaQueryPrices with count = null",
                      "count");
    }
    test.check(std::memcmp(&price, &initialPrice, sizeof price) == 0, "agaaQueryPrices with count = null writes.");
}

void testStruct(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    std::vector<AgaaPrice> prices(pricesOf(test, parts, nullptr).size(), initialPrice);
    const std::vector<AgaaPrice> before = prices;
    for (size_t wrong = 0; wrong < prices.size(); wrong += 5) {
        prices[wrong].sType = 0;
        LogRecorder log;
        auto count = uint32_t(prices.size());
        expectRefused(test, test.sdk.agaaQueryPrices(&parts.desc, nullptr, log.get(), &count, prices.data()),
                      AGAA_ERROR_STRUCT, log, "agaaQueryPrices",
                      "agaaQueryPrices with element " + std::to_string(wrong) + " that is not initialised",
                      "AgaaPrice");
        prices[wrong].sType = AGAA_STRUCTURE_TYPE_PRICE;
        test.check(areSame(before, prices), "agaaQueryPrices fails and changes elements.");
    }
    LogRecorder log;
    uint32_t count = 0;
    AgaaDeviceCaps caps = parts.caps;
    caps.sType = 0;
    expectRefused(test, test.sdk.agaaQueryPrices(&parts.desc, &caps, log.get(), &count, nullptr), AGAA_ERROR_STRUCT,
                  log, "agaaQueryPrices", "agaaQueryPrices with AgaaDeviceCaps::sType = 0", "AgaaDeviceCaps");
}

void testTooSmall(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    const auto needed = uint32_t(pricesOf(test, parts, nullptr).size());
    std::vector<AgaaPrice> prices(needed + 1, initialPrice);
    const std::vector<AgaaPrice> before = prices;
    for (const uint32_t length : {0u, 1u, needed - 1}) {
        LogRecorder log;
        uint32_t count = length;
        expectRefused(test, test.sdk.agaaQueryPrices(&parts.desc, nullptr, log.get(), &count, prices.data()),
                      AGAA_ERROR_BUFFER_TOO_SMALL, log, "agaaQueryPrices",
                      "agaaQueryPrices with " + std::to_string(length) + " elements");
        test.check(count == length && areSame(before, prices),
                   "agaaQueryPrices with an array that is too short writes.");
    }
    uint32_t count = needed + 1;
    test.requireOk(test.sdk.agaaQueryPrices(&parts.desc, nullptr, nullptr, &count, prices.data()),
                   "agaaQueryPrices with a longer array");
    test.check(count == needed && std::memcmp(&prices[needed], &initialPrice, sizeof initialPrice) == 0,
               "agaaQueryPrices with a longer array writes behind the prices.");
}

// Tests a view that exceeds the device, and one whose traffic needs more than 63 bits.
void testTooLarge(Test& test) {
    ViewParts beyond(test.sdk, nullptr);
    beyond.caps.maxImageSize = 100;
    beyond.desc.width = 101;
    ViewParts huge(test.sdk, nullptr);
    huge.setTechnique("ssaa", 8);
    huge.caps.maxImageSize = 0xFFFFFFFF;
    huge.caps.maxStorageRange = ~UINT64_C(0);
    huge.desc.width = 1u << 31;
    huge.desc.height = 1u << 24;
    for (const ViewParts* parts : {&beyond, &huge}) {
        LogRecorder log;
        expectRefused(test, query(test, *parts, log), AGAA_ERROR_TOO_LARGE, log, "agaaQueryPrices",
                      "agaaQueryPrices of a view of " + std::to_string(parts->desc.width) + " pixels a row");
    }
}

} // namespace

void addPriceCases(Suite& suite) {
    suite.core("agaaQueryPrices/caps.null", testPricesOfNullCaps);
    suite.core("agaaQueryPrices/log.null", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        uint32_t count = 0;
        test.result(test.sdk.agaaQueryPrices(&parts.desc, nullptr, nullptr, &count, nullptr), AGAA_OK,
                    "agaaQueryPrices with log = null");
        parts.desc.width = 0;
        test.result(test.sdk.agaaQueryPrices(&parts.desc, nullptr, nullptr, &count, nullptr), AGAA_ERROR_OUT_OF_RANGE,
                    "agaaQueryPrices with log = null and AgaaViewDesc::width = 0");
    });
    suite.core("agaaQueryPrices/prices.null", testPricesNull);
    suite.core("agaaQueryPrices/prices.unchanged", testUnchanged);
    suite.core("agaaQueryPrices/those_of.agaaQueryMemory", [](Test& test) {
        testWrongViews(test, nullptr, "agaaQueryPrices",
                       [&](const ViewParts& parts, LogRecorder& log) { return query(test, parts, log); });
    });
    suite.core("agaaQueryPrices/AGAA_ERROR_INVALID_ARGUMENT", testInvalid);
    suite.core("agaaQueryPrices/AGAA_ERROR_STRUCT", testStruct);
    suite.core("agaaQueryPrices/AGAA_ERROR_TOO_LARGE", testTooLarge);
    suite.core("agaaQueryPrices/AGAA_ERROR_BUFFER_TOO_SMALL", testTooSmall);
    suite.core("agaaQueryPrices/steps", testSteps);
    suite.core("AgaaPrice.kind/enum", testKinds);
}

} // namespace agaa::conformance
