// The plan's bytes against what is really created, recomputed from the intercepted create calls. Each graphics API
// instantiates these for its host, whose Context tells created() of what views create.
#pragma once

#include "prediction.h"
#include "view_settings.h"

#include "core/abi/handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

namespace agaa::test {

struct Created {
    uint64_t imageBytes = 0;
    std::map<uint64_t, uint32_t> bufferSizes; // bytes -> how many
};

struct PayloadSize {
    uint32_t width, height;
};

template <class Host> class PayloadCases : public testing::Test {
protected:
    void expectPayload(const PayloadRow& row, uint32_t c, const char* layoutName, PayloadSize size,
                       uint64_t viewFlags = 0) {
        AgaaLayout layout = AGAA_LAYOUT_INIT;
        agaaGetBuiltinLayout(layoutName, &layout);
        const AgaaFetchFunction fetch = emptyFetch(row.fetchFlags);
        ViewSettings settings;
        settings.config.technique = row.technique;
        settings.config.samples = row.samples;
        settings.config.aggregates = c;
        settings.config.generationTier = row.tier;
        settings.config.flags = row.configFlags;
        settings.config.measurement.flags = row.measurementFlags;
        settings.config.layout = &layout;
        const std::vector<float> pattern(2 * row.samples);
        settings.config.coverage.samplePositions = row.hasOwnPattern ? pattern.data() : nullptr;
        settings.width = size.width;
        settings.height = size.height;
        settings.flags = viewFlags;
        settings.chained = settings.fetches() ? &fetch : nullptr;
        const AgaaViewDesc desc = viewDesc(settings);
        // Views are made, and not drawn.
        AgaaDeviceCaps caps = context.caps();
        caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
        context.get()->caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
        const Prediction predicted = predict(desc, caps);
        Created& created = context.created();
        created = {};
        AgaaView view = nullptr;
        ASSERT_EQ(context.createView(desc, view), AGAA_OK) << context.lines.back().text;
        const uint64_t bufferBytes = takePixelBuffers(predicted, created.bufferSizes);
        EXPECT_EQ(created.imageBytes + bufferBytes, predicted.report.totalBytes + tableBytes(predicted))
            << row.technique << " n=" << row.samples << " c=" << c << " " << agaaTierName(row.tier) << " "
            << row.configFlags << " " << layoutName << " " << size.width << "x" << size.height;
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        EXPECT_EQ(agaaGetFrameStatistics(view, 1, &statistics), AGAA_NOT_READY);
        EXPECT_EQ(statistics.payloadBytes, predicted.report.totalBytes);
        if (Host::sharesMemory) { // what shares it is aligned
            EXPECT_GE(statistics.peakBytes, predicted.report.peakBytes);
        } else {
            EXPECT_EQ(predicted.report.peakBytes, predicted.report.totalBytes);
            EXPECT_EQ(statistics.peakBytes, predicted.report.totalBytes);
        }
        agaaDestroyView(view);
        ++checked;
    }

    typename Host::Context context;
    size_t checked = 0;
};
TYPED_TEST_SUITE_P(PayloadCases);

TYPED_TEST_P(PayloadCases, IsWhatTheQueryPredicts) {
    size_t next = 0; // sizes take turns: each view compiles its passes
    const auto sizeFor = [&](uint32_t n) {
        const auto& sizes = TypeParam::sizes;
        const bool tooWide = n > 8 && std::rbegin(sizes)->width > 1000; // for images of so many samples
        return sizes[next++ % (std::size(sizes) - tooWide)];
    };
    for (const char* layout : {"paper16", "precise"}) {
        for (uint32_t n : {1u, 2u, 4u, 8u, 16u, 32u})
            for (uint32_t c = 0; c <= 4; ++c)
                for (uint32_t i = 0; i < TypeParam::turns; ++i)
                    this->expectPayload({c ? "agaa" : "ssaa", n}, std::max(c, 1u), layout, sizeFor(n));
        for (const PayloadSize& size : TypeParam::sizes)
            this->expectPayload({"single", 1}, 1, layout, size);
    }
    for (uint32_t n : {1u, 8u, 32u})
        this->expectPayload({"agaa", n}, 2, "precise", {17, 5}, AGAA_VIEW_REVERSED_Z);
    for (uint32_t tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER})
        for (uint32_t n : {4u, 8u}) {
            this->expectPayload({"agaa", n, tier}, 2, "precise", {17, 5});
            this->expectPayload(
                {.technique = "agaa", .samples = n, .tier = tier, .measurementFlags = AGAA_MEASURE_NO_STENCIL}, 2,
                "precise", {17, 5}, AGAA_VIEW_REVERSED_Z);
        }
    size_t turn = 0; // layouts take turns: functions are compiled for each view
    for (const PayloadRow& row : payloadRows())
        this->expectPayload(row, 2, TypeParam::runsAll && turn++ % 2 ? "paper16" : "precise", {131, 67});
    EXPECT_EQ(this->checked, 60u * TypeParam::turns + 2 * std::size(TypeParam::sizes) + 11 + payloadRows().size());
}

REGISTER_TYPED_TEST_SUITE_P(PayloadCases, IsWhatTheQueryPredicts);

} // namespace agaa::test
