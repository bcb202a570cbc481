#include "members.h"

#include "structs.h"

#include <cstdio>

namespace agaa::conformance {

namespace {

std::string bare(const std::string& member) { return member.substr(member.find("::") + 2); }

template <class Row, class Value> void change(ViewParts& parts, const Row& row, Value value) {
    if (row.prepare)
        row.prepare(parts);
    row.set(parts, value);
}

std::string hexText(uint64_t bits) {
    char text[32];
    std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(bits));
    return text;
}

void refuse(Test& test, const MemberRow& row, double value) {
    ViewParts parts(test.sdk, nullptr);
    change(parts, row, value);
    expectViewRefused(test, parts, row.error, std::string(row.member) + " = " + numberText(value), bare(row.member));
}

void testMember(Test& test, const MemberRow& row) {
    for (const double value : row.accepted) {
        ViewParts parts(test.sdk, nullptr);
        change(parts, row, value);
        expectAccepted(test, parts, std::string(row.member) + " = " + numberText(value));
    }
    for (const double value : row.refused)
        refuse(test, row, value);
    if (isSameVersion(test))
        for (const double value : row.refusedToday)
            refuse(test, row, value);
}

void testFlags(Test& test, const FlagRow& row) {
    const uint64_t unlikely = UINT64_C(0xFFFF) << 48; // unused by later libraries, too
    for (uint32_t i = 0; i < 64; ++i) {
        const uint64_t bit = UINT64_C(1) << i;
        ViewParts parts(test.sdk, nullptr);
        change(parts, row, bit);
        const std::string what = std::string(row.member) + " = " + hexText(bit);
        if (row.known & bit)
            expectAccepted(test, parts, what);
        else if (isSameVersion(test) || (unlikely & bit))
            expectViewRefused(test, parts, AGAA_ERROR_OUT_OF_RANGE, what, bare(row.member));
    }
}

} // namespace

std::string numberText(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

std::vector<double> notNumbers(std::vector<double> others) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity})
        others.push_back(value);
    return others;
}

std::vector<double> largeNumbers(std::vector<double> others) {
    for (const double value : {double(0x7FFFFFFF), double(0x80000000u), double(0xFFFFFFFFu)})
        others.push_back(value);
    return others;
}

void addMember(Suite& suite, const MemberRow& row) {
    suite.core(row.promise, [row](Test& test) { testMember(test, row); });
}

void addFlags(Suite& suite, const FlagRow& row) {
    suite.core(row.promise, [row](Test& test) { testFlags(test, row); });
}

} // namespace agaa::conformance
