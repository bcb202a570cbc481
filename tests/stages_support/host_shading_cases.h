// Hosts that shade aggregates themselves, by the text that reads them, against the SDK's own shading. Each graphics API
// instantiates these for its host, with a pass of the host's: Pass(context, settings, view, light) has record(frame)
// after the library's commands, clear() and rgba().
#pragma once

#include "host_shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace agaa::test {

template <class Host> class HostShadingCases : public testing::Test {
protected:
    // What the pass makes of a frame of the view, by the segments; bind: what the view's functions read.
    template <class Bind>
    std::vector<float> shaded(typename Host::View& view, const typename Host::Pass& pass, uint64_t segments,
                              const Bind& bind) {
        AgaaFrame frame = view.frame();
        lightForHost(frame);
        frame.segments = segments;
        pass.clear();
        Host::run(view, [&](typename Host::Frame& native) {
            bind(native);
            ASSERT_EQ(Host::recordFrame(view.get(), &frame, &native), AGAA_OK);
            pass.record(native);
        });
        return pass.rgba();
    }
    std::vector<float> shaded(typename Host::View& view, const typename Host::Pass& pass,
                              uint64_t segments = AGAA_SEGMENT_ALL) {
        return shaded(view, pass, segments, [](auto&) {});
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(HostShadingCases);

// Between segments of frames, and after frames that can be read back; in the other way than the host's only for n = 1.
TYPED_TEST_P(HostShadingCases, ReadsWhatTheSdkShades) {
    forHostShading(TypeParam::drawnTier, [&](const ViewSettings& settings) {
        for (const uint64_t readback : {uint64_t(0), uint64_t(AGAA_CONFIG_READBACK)}) {
            if (readback != TypeParam::readback && settings.config.samples > 1)
                continue;
            ViewSettings own = settings;
            own.config.flags |= readback;
            typename TypeParam::View view(this->context, own);
            view.setTriangles(hostShadingScene());
            const typename TypeParam::Pass pass(this->context, own, view, ambientLight);
            std::vector<std::vector<float>> images;
            for (int i = 0; i < 2; ++i)
                images.push_back(this->shaded(view, pass, AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION));
            if (readback) {
                images.push_back(this->shaded(view, pass));
            } else {
                AgaaFrame frame = view.frame();
                lightForHost(frame);
                view.render(frame);
            }
            for (const std::vector<float>& image : images)
                expectShadedAlike(TypeParam::rgba(view), image);
        }
    });
}

TYPED_TEST_P(HostShadingCases, ReadsAttributesOfItsOwn) {
    CustomImages images;
    const std::set<uint32_t> tiers = {TypeParam::drawnTier, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER, AGAA_TIER_IDS};
    forCustomAttributes({tiers.begin(), tiers.end()}, [&](const ViewSettings& settings) {
        if (settings.config.generationTier == AGAA_TIER_IDS) {
            if (!TypeParam::runsAll && settings.config.samples != 8)
                return;
            for (uint32_t flags : {0u, uint32_t(AGAA_FETCH_NOT_ALL_DRAWS)}) {
                ViewSettings some = settings;
                some.shader = flags ? ViewSettings::Shader::ThirdUnfetched : ViewSettings::Shader::Material;
                typename TypeParam::Ids ids(
                    this->context, some,
                    {.triangles = hostShadingScene(), .material = customMaterial, .fetchFlags = flags});
                const typename TypeParam::Pass pass(this->context, ids.view().settings(), ids.view(), customLight);
                const auto bind = [&](auto& native) { ids.bind(native); };
                images.add(some, this->shaded(ids.view(), pass, AGAA_SEGMENT_ALL, bind));
            }
            return;
        }
        typename TypeParam::View view(this->context, settings);
        view.setTriangles(hostShadingScene());
        const typename TypeParam::Pass pass(this->context, settings, view, customLight);
        images.add(settings, this->shaded(view, pass));
    });
}

TYPED_TEST_P(HostShadingCases, ReadsMomentsOfNormals) {
    forHostShading(TypeParam::drawnTier, [&](ViewSettings settings) {
        const AgaaLayout& layout = *settings.config.layout;
        if (std::any_of(layout.attributes, layout.attributes + layout.attributeCount,
                        [](const auto& attribute) { return attribute.encoding == AGAA_ENCODING_FOLDED; }))
            return;
        for (const uint32_t ndf : {AGAA_NDF_TOKSVIG, AGAA_NDF_LEAN}) {
            settings.config.ndf = ndf;
            typename TypeParam::View view(this->context, settings);
            view.setTriangles(hostShadingScene());
            const typename TypeParam::Pass pass(this->context, settings, view, momentLight);
            expectMoments(settings, this->shaded(view, pass));
        }
    });
}

TYPED_TEST_P(HostShadingCases, IsRefusedWhereNothingIsKept) {
    for (const char* technique : {"ssaa", "sbaa", "agaa"}) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.generationTier = technique == std::string("agaa") ? AGAA_TIER_GBUFFER : AGAA_TIER_AUTO;
        const AgaaViewDesc desc = viewDesc(settings);
        std::vector<LogLine> lines;
        const AgaaLog log = logInto(lines);
        size_t size = 0;
        EXPECT_EQ(agaaGetAggregateGlsl(&desc, &this->context.caps(), &log, &size, nullptr), AGAA_ERROR_UNSUPPORTED);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_NE(lines[0].text.find("no aggregates in memory"), std::string::npos);
    }
}

REGISTER_TYPED_TEST_SUITE_P(HostShadingCases, ReadsWhatTheSdkShades, ReadsAttributesOfItsOwn, ReadsMomentsOfNormals,
                            IsRefusedWhereNothingIsKept);

} // namespace agaa::test
