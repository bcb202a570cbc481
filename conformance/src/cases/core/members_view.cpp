// Members of AgaaSceneFacts, AgaaViewDesc, AgaaDeviceCaps and the functions of the host.
#include "cases.h"
#include "members.h"

#include <cmath>

namespace agaa::conformance {

namespace {

void addFactsAndView(Suite& suite) {
    addMember(suite, {"AgaaSceneFacts.maxLights/range",
                      "AgaaSceneFacts::maxLights",
                      [](ViewParts& p, double x) { p.facts.maxLights = whole(x); },
                      {0, 1, 4095, 4096},
                      largeNumbers({4097})});
    addMember(suite, {"AgaaSceneFacts.shadowMapCount/range",
                      "AgaaSceneFacts::shadowMapCount",
                      [](ViewParts& p, double x) { p.facts.shadowMapCount = whole(x); },
                      {0, 1, 2, 3, AGAA_MAX_SHADOW_MAPS},
                      largeNumbers({AGAA_MAX_SHADOW_MAPS + 1, 31, 32, 33})});
    addFlags(suite, {"AgaaSceneFacts.flags/flags", "AgaaSceneFacts::flags",
                     [](ViewParts& p, uint64_t flags) { p.facts.flags = flags; },
                     AGAA_FACT_ALL_SHADED | AGAA_FACT_CUSTOM_DEPTH | AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR |
                         AGAA_FACT_ONE_SPECULAR | AGAA_FACT_NO_DIFFUSE | AGAA_FACT_NO_LOCAL_LIGHTS |
                         AGAA_FACT_NO_TRANSLUCENCY | AGAA_FACT_NO_CUTOUTS | AGAA_FACT_PLANE_NORMALS,
                     nullptr});
    addMember(suite, {"AgaaSceneFacts.alpha2/range",
                      "AgaaSceneFacts::alpha2",
                      [](ViewParts& p, double x) { p.facts.alpha2 = float(x); },
                      {5e-6, 0.25, below(1), 1},
                      notNumbers({0, -1, 4e-6, above(1)})});
    addMember(suite, {"AgaaSceneFacts.specular/range",
                      "AgaaSceneFacts::specular",
                      [](ViewParts& p, double x) { p.facts.specular = float(x); },
                      {0, above(0), 0.04, 1},
                      notNumbers({below(0), -1, above(1)})});
    addMember(suite, {"AgaaViewDesc.width/range",
                      "AgaaViewDesc::width",
                      [](ViewParts& p, double x) { p.desc.width = whole(x); },
                      {1, 2, 4099},
                      {0}});
    addMember(suite, {"AgaaViewDesc.height/range",
                      "AgaaViewDesc::height",
                      [](ViewParts& p, double x) { p.desc.height = whole(x); },
                      {1, 2, 4099},
                      {0}});
    addFlags(suite,
             {"AgaaViewDesc.flags/flags", "AgaaViewDesc::flags",
              [](ViewParts& p, uint64_t flags) { p.desc.flags = flags; },
              AGAA_VIEW_REVERSED_Z | AGAA_VIEW_COMPOSITE | AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE | AGAA_VIEW_VERTEX_PULLING,
              nullptr});
}

void addCaps(Suite& suite) {
    addMember(suite, {"AgaaDeviceCaps.subgroupSize/range",
                      "AgaaDeviceCaps::subgroupSize",
                      [](ViewParts& p, double x) { p.caps.subgroupSize = whole(x); },
                      {0, 1, 8, 32, 64, 128},
                      largeNumbers({3, 48, 129, 256}),
                      nullptr,
                      {}});
    addFlags(suite,
             {"AgaaDeviceCaps.flags/flags", "AgaaDeviceCaps::flags",
              [](ViewParts& p, uint64_t flags) { p.caps.flags = flags; },
              idealDeviceFlags | AGAA_DEVICE_NO_ALIASING | AGAA_DEVICE_SOFTWARE | AGAA_DEVICE_CONDITIONAL_RENDERING,
              [](ViewParts& p) { p.config.flags = 0; }});
}

void setPosition(ViewParts& parts, double x) {
    static thread_local float positions[8];
    for (uint32_t i = 0; i < 8; ++i)
        positions[i] = 0.125f * float(i);
    positions[5] = float(x);
    parts.gbuffer.samplePositions = positions;
}

void addFunctions(Suite& suite) {
    const auto gbuffer = [](ViewParts& p) { p.chain(p.gbuffer); };
    const auto fetch = [](ViewParts& p) { p.chain(p.fetch); };
    const auto shading = [](ViewParts& p) { p.chain(p.shading); };
    addMember(suite, {"AgaaGBufferFunction.samplePositions/range",
                      "AgaaGBufferFunction::samplePositions",
                      setPosition,
                      {0, 0.5, below(1)},
                      notNumbers({below(0), -1, 1, 2}),
                      gbuffer});
    addMember(suite, {"AgaaGBufferFunction.depthBits/range",
                      "AgaaGBufferFunction::depthBits",
                      [](ViewParts& p, double x) { p.gbuffer.depthBits = whole(x); },
                      {0, 16, 24},
                      largeNumbers({1, 8, 15, 23, 25, 32}),
                      gbuffer});
    addMember(suite, {"AgaaGBufferFunction.reserved/zero",
                      "AgaaGBufferFunction::reserved",
                      [](ViewParts& p, double x) { p.gbuffer.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      gbuffer,
                      {1}});
    addMember(suite, {"AgaaFetchFunction.maxDraws/range",
                      "AgaaFetchFunction::maxDraws",
                      [](ViewParts& p, double x) { p.fetch.maxDraws = whole(x); },
                      {1, 2, (1u << 22) - 1},
                      {0},
                      fetch});
    addMember(suite, {"AgaaFetchFunction.maxPrimitives/range",
                      "AgaaFetchFunction::maxPrimitives",
                      [](ViewParts& p, double x) { p.fetch.maxPrimitives = whole(x); },
                      {1, 2, 3, 1u << 27},
                      {0},
                      fetch});
    addFlags(suite, {"AgaaFetchFunction.flags/flags", "AgaaFetchFunction::flags",
                     [](ViewParts& p, uint64_t flags) { p.fetch.flags = flags; }, AGAA_FETCH_NOT_ALL_DRAWS, fetch});
    addMember(suite, {"AgaaFetchFunction.maxTriangles/AGAA_ERROR_OUT_OF_RANGE",
                      "AgaaFetchFunction::maxTriangles",
                      [](ViewParts& p, double x) { p.fetch.maxTriangles = whole(x); },
                      {0, 1, 1u << 20, (1u << 31) - 1},
                      {1u << 31, 0xFFFFFFFF},
                      fetch});
    addMember(suite, {"AgaaFetchFunction.reserved/zero",
                      "AgaaFetchFunction::reserved",
                      [](ViewParts& p, double x) { p.fetch.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      fetch,
                      {1}});
    const auto outputs = [](ViewParts& p) { p.chain(p.outputs); };
    addMember(suite, {"AgaaResolvedOutputs.count/range",
                      "AgaaResolvedOutputs::count",
                      [](ViewParts& p, double x) {
                          p.outputs.count = whole(x);
                          for (AgaaResolvedOutput& output : p.outputs.outputs)
                              output.value = AGAA_RESOLVED_COVERAGE;
                      },
                      {1, 2, AGAA_MAX_RESOLVED_OUTPUTS},
                      largeNumbers({0, AGAA_MAX_RESOLVED_OUTPUTS + 1}),
                      outputs});
    addMember(suite, {"AgaaResolvedOutputs.reserved/zero",
                      "AgaaResolvedOutputs::reserved",
                      [](ViewParts& p, double x) { p.outputs.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      outputs,
                      {1}});
    addMember(suite,
              {"AgaaResolvedOutput.value/enum",
               "AgaaResolvedOutput::value",
               [](ViewParts& p, double x) { p.outputs.outputs[0].value = whole(x); },
               {AGAA_RESOLVED_NEAREST_DEPTH, AGAA_RESOLVED_MEAN_DEPTH, AGAA_RESOLVED_NORMAL, AGAA_RESOLVED_COVERAGE},
               largeNumbers({0, AGAA_RESOLVED_CUSTOM + 1}),
               outputs});
    addMember(suite, {"AgaaResolvedOutput.reserved/zero",
                      "AgaaResolvedOutput::reserved",
                      [](ViewParts& p, double x) { p.outputs.outputs[0].reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      outputs,
                      {1}});
    addMember(suite, {"AgaaShadingFunction.level/range",
                      "AgaaShadingFunction::level",
                      [](ViewParts& p, double x) { p.shading.level = whole(x); },
                      {AGAA_SHADING_REFLECTANCE, AGAA_SHADING_EVENT},
                      largeNumbers({2}),
                      shading});
    addMember(suite, {"AgaaShadingFunction.reserved/zero",
                      "AgaaShadingFunction::reserved",
                      [](ViewParts& p, double x) { p.shading.reserved = whole(x); },
                      {0},
                      largeNumbers({}),
                      shading,
                      {1}});
}

// Numbers of draws and primitives whose ids fit 32 bits, and the next larger ones.
void testIds(Test& test) {
    struct Row {
        uint32_t draws, primitives;
        uint64_t flags;
        bool isAccepted;
    };
    for (const Row& row :
         {Row{0xFFFFFFFF, 1, 0, true}, Row{0xFFFFFFFE, 1, AGAA_FETCH_NOT_ALL_DRAWS, true},
          Row{0xFFFFFFFF, 1, AGAA_FETCH_NOT_ALL_DRAWS, false}, Row{0xFFFF, 0x10000, 0, true},
          Row{0xFFFF, 0xFFFF, 0, true}, Row{0x10000, 0x10000, 0, false}, Row{0x10000, 0xFFFF, 0, false},
          Row{0xFFFF, 0x10001, 0, false}, Row{1, 0x80000000, 0, true}, Row{1, 0x80000001, 0, false},
          Row{1, 0xFFFFFFFF, 0, false}, Row{0xFFFFFFFF, 2, 0, false}, Row{0xFFFFFFFF, 0xFFFFFFFF, 0, false}}) {
        ViewParts parts(test.sdk, nullptr);
        parts.chain(parts.fetch);
        parts.fetch.maxDraws = row.draws;
        parts.fetch.maxPrimitives = row.primitives;
        parts.fetch.flags = row.flags;
        const std::string what = "AgaaFetchFunction::maxDraws = " + std::to_string(row.draws) +
                                 ", ::maxPrimitives = " + std::to_string(row.primitives) +
                                 (row.flags ? ", AGAA_FETCH_NOT_ALL_DRAWS" : "");
        if (row.isAccepted)
            expectAccepted(test, parts, what);
        else
            expectViewRefused(test, parts, AGAA_ERROR_TOO_LARGE, what);
    }
}

// Lines other than "#extension NAME : BEHAVIOUR".
template <class Function> void testExtensions(Test& test, Function ViewParts::*member, const std::string& name) {
    const auto partsWith = [&](ViewParts& parts, const char* text) {
        parts.facts.shadowMapCount = 1;
        (parts.*member).glslExtensions = text;
        parts.chain(parts.*member);
    };
    for (const char* text :
         {"#extension GL_EXT_nonuniform_qualifier : require\n", "#extension GL_EXT_nonuniform_qualifier : enable",
          "#extension A : warn\n#extension B : disable\n"}) {
        ViewParts parts(test.sdk, nullptr);
        partsWith(parts, text);
        expectAccepted(test, parts, name + "::glslExtensions = \"" + text + '"');
    }
    for (const char* text : {"int x;", "#define X 1\n", "#extension GL_EXT_nonuniform_qualifier\n",
                             "#extension GL_EXT_nonuniform_qualifier : require\nint x;\n", "#version 450\n",
                             "#extension A : enable int x;\n"}) {
        ViewParts parts(test.sdk, nullptr);
        partsWith(parts, text);
        expectViewRefused(test, parts, AGAA_ERROR_INVALID_ARGUMENT, name + "::glslExtensions = \"" + text + '"',
                          "glslExtensions");
    }
}

} // namespace

void addViewMemberCases(Suite& suite) {
    addFactsAndView(suite);
    addCaps(suite);
    addFunctions(suite);
    suite.core("AgaaFetchFunction.maxPrimitives/AGAA_ERROR_TOO_LARGE", testIds);
    const std::string invalid = ".glslExtensions/AGAA_ERROR_INVALID_ARGUMENT";
    suite.core("AgaaGBufferFunction" + invalid,
               [](Test& test) { testExtensions(test, &ViewParts::gbuffer, "AgaaGBufferFunction"); });
    suite.core("AgaaFetchFunction" + invalid,
               [](Test& test) { testExtensions(test, &ViewParts::fetch, "AgaaFetchFunction"); });
    suite.core("AgaaShadowFunction" + invalid,
               [](Test& test) { testExtensions(test, &ViewParts::shadow, "AgaaShadowFunction"); });
    suite.core("AgaaShadingFunction" + invalid,
               [](Test& test) { testExtensions(test, &ViewParts::shading, "AgaaShadingFunction"); });
    suite.core("AgaaGBufferFunction.samplePositions/of_one_sample", [](Test& test) {
        static const float positions[] = {0.5f, 0.5f, NAN, NAN};
        ViewParts parts(test.sdk, nullptr);
        parts.config.technique = "single"; // one sample, whatever AgaaConfig::samples is
        parts.chain(parts.gbuffer);
        parts.gbuffer.samplePositions = positions;
        expectAccepted(test, parts, "\"single\" and AgaaGBufferFunction::samplePositions of one sample");
    });
    suite.core("AgaaGBufferFunction.samplePositions/null", [](Test& test) {
        ViewParts parts(test.sdk, nullptr);
        parts.chain(parts.gbuffer);
        parts.gbuffer.samplePositions = nullptr;
        expectAccepted(test, parts, "AgaaGBufferFunction::samplePositions = null");
    });
}

} // namespace agaa::conformance
