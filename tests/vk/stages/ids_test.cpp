// The tier ids: one geometry pass that leaves ids, materials fetched by them, against the tiers that draw materials.
#include "ids_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace agaa::test {
namespace {

// Each triangle of one material: what tiers still differ by is where they take positions and how they round.
std::vector<Triangle> scene(uint32_t count) {
    return randomTriangles({.triangles = count, .duplicates = 0.1f, .masked = 0.2f}, 61);
}

// Functions run before the segment that shades, too.
TEST(Ids, EverySegmentThatFetchesWantsItsSet) {
    StageContext context;
    const std::vector<Triangle> triangles = scene(20);
    ViewSettings settings = settingsFor(8, 2, AGAA_TIER_IDS);
    settings.config.flags |= AGAA_CONFIG_BUFFERED;
    IdsView ids(context, settings, {.triangles = triangles});
    AgaaFrame frame = ids.view().frame();
    frame.segments = AGAA_SEGMENT_PREPASS | AGAA_SEGMENT_GENERATION;
    EXPECT_THROW(ids.view().render(frame, [](AgaaVkFrame&) {}), std::exception);
    ASSERT_FALSE(context.lines.empty());
    EXPECT_NE(context.lines.back().text.find("functionSet is null"), std::string::npos);
}

// Each sample's id is that of the triangle which another view's G-buffer finds there.
TEST(Ids, AreThoseOfTheTrianglesSeen) {
    StageContext context;
    const std::vector<Triangle> triangles = scene(150);
    IdsView ids(context, settingsFor(8, 2, AGAA_TIER_IDS), {.triangles = triangles});
    ids.render();
    ViewSettings settings = settingsFor(8, 2, AGAA_TIER_GBUFFER);
    settings.shader = ViewSettings::Shader::PrimitiveIds;
    StageView other(context, settings);
    drawn(other, triangles);
    const Plan& plan = ids.view().plan();
    EXPECT_EQ(plan.view.primitiveBits, 8u);
    const Field red = packGBuffer(other.plan().view.layout).fields[ChannelDiffuseR]; // id + 1 below 256
    const auto words = ids.view().readSurface("ids");
    const auto colors = other.readSurface("gbuffer-" + std::to_string(red.word));
    const auto byteOf = [](uint32_t bits) { return uint32_t(std::lround(255 * std::bit_cast<float>(bits))); };
    ASSERT_EQ(words.size(), colors.size());
    size_t wrong = 0;
    std::set<uint32_t> seen;
    for (size_t i = 0; i < words.size(); ++i) {
        uint32_t id = 0;
        for (int byte = 0; byte < 4; ++byte)
            id |= byteOf(words[i][byte]) << (8 * byte);
        const uint32_t triangle = byteOf(colors[i][int(red.shift)]); // 0: none
        wrong += id != (triangle ? (drawNumber << 8 | (triangle - 1)) + 1 : 0);
        seen.insert(triangle);
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(seen.size(), triangles.size() / 3);
}

// A colour that changes over a triangle, by the weights, against the one that the rasteriser interpolates.
TEST(Ids, AttributesAreThoseOfTheRasteriser) {
    StageContext context;
    const std::vector<Triangle> triangles = randomTriangles({.triangles = 60}, 67);
    const char* byWeights = R"(
    vec2 uv = p.at.x * hostVertices.data[6u * p.primitive + 1u].xy + p.at.y * hostVertices.data[6u * p.primitive + 3u].xy +
              p.at.z * hostVertices.data[6u * p.primitive + 5u].xy;
    m.diffuse = vec3(uv, 0.0);
)";
    for (uint32_t n : {1u, 8u}) {
        IdsView ids(context, settingsFor(n, 1, AGAA_TIER_IDS), {.triangles = triangles, .material = byWeights});
        ViewSettings settings = settingsFor(n, 1, AGAA_TIER_GBUFFER);
        settings.shader = ViewSettings::Shader::UvInside;
        StageView raster(context, settings);
        const Difference d = compare(ids.render(), drawn(raster, triangles));
        std::printf("n=%u: PSNR %.1f dB\n", n, d.psnr);
        EXPECT_GE(d.psnr, 90);
    }
}

// With fine materials, those of the texels of a G-buffer, on triangles that many pixels show in part.
TEST(Ids, FineMaterialsAreThoseOfAGBuffer) {
    StageContext context;
    std::vector<Triangle> triangles = randomTriangles({.triangles = 60}, 67);
    std::mt19937 random(7);
    for (Triangle& t : triangles)
        for (glm::vec2& uv : t.uv)
            uv = {float(random() % 2), float(random() % 2)};
    const char* byWeights = R"(
    vec2 uv = p.at.x * hostVertices.data[6u * p.primitive + 1u].xy + p.at.y * hostVertices.data[6u * p.primitive + 3u].xy +
              p.at.z * hostVertices.data[6u * p.primitive + 5u].xy;
    m.diffuse = vec3(uv, 0.0);
)";
    // One texel a pixel, and with fewer samples in each two, in one layer or in two.
    for (const auto& [n, visibility] : {std::pair{4u, AGAA_TIER_AUTO}, {8u, AGAA_TIER_AUTO}, {8u, AGAA_TIER_LAYERS}}) {
        ViewSettings settings = settingsFor(n, 1, AGAA_TIER_GBUFFER);
        settings.config.visibilityTier = visibility;
        settings.shader = ViewSettings::Shader::UvInside;
        StageView raster(context, settings);
        const harness::Image truth = drawn(raster, triangles);
        const ResolvedView& view = raster.plan().view;
        const uint32_t texels = view.scaleX * view.scaleY * view.layers;
        const auto byId = [&](uint64_t flag, AgaaCounters& counters) {
            ViewSettings own = settingsFor(n, 1, AGAA_TIER_IDS);
            own.config.visibilityTier = visibility;
            own.config.flags |= flag;
            IdsView ids(context, own, {.triangles = triangles, .material = byWeights});
            const double error = std::pow(10, -compare(truth, ids.render()).psnr / 10);
            counters = ids.view().statistics().counters;
            return error;
        };
        AgaaCounters coarse, fine;
        const double coarseError = byId(0, coarse), fineError = byId(AGAA_CONFIG_FINE_MATERIALS, fine);
        std::printf("n=%u: mseTm %.2e, fine %.2e; materials %llu, fine %llu\n", n, coarseError, fineError,
                    static_cast<unsigned long long>(coarse.materials), static_cast<unsigned long long>(fine.materials));
        EXPECT_LT(fineError, 0.25 * coarseError);
        EXPECT_EQ(fine.primitives, coarse.primitives);
        EXPECT_EQ(coarse.materials, coarse.primitives);
        EXPECT_LE(fine.materials, texels * fine.primitives);
        EXPECT_GE(fine.materials, fine.primitives + (texels > 1));
    }
}

// The weights' derivatives, against differences between pixels of what is shown.
TEST(Ids, DerivativesArePerPixel) {
    StageContext context;
    const Material grey;
    std::vector<Triangle> triangles(1);
    triangles[0].position[0] = {-8, -6, -4};
    triangles[0].position[1] = {9, -5, -6};
    triangles[0].position[2] = {0, 8, -9};
    triangles[0].material = grey;
    ViewSettings settings = settingsFor(1, 1, AGAA_TIER_IDS);
    const auto shown = [&](const char* what) {
        return IdsView(context, settings, {.triangles = triangles, .material = what}).render();
    };
    // Emission alone, since shading would filter it.
    const harness::Image at = shown("m.diffuse = m.specular = vec3(0.0); m.emissive = p.at;");
    const harness::Image dx = shown("m.diffuse = m.specular = vec3(0.0); m.emissive = vec3(0.5) + p.dx;");
    const harness::Image dy = shown("m.diffuse = m.specular = vec3(0.0); m.emissive = vec3(0.5) + p.dy;");
    size_t checked = 0;
    for (uint32_t y = 1; y + 1 < at.height; ++y)
        for (uint32_t x = 1; x + 1 < at.width; ++x)
            for (uint32_t i = 0; i < 3; ++i) {
                const auto value = [&](const harness::Image& image, uint32_t px, uint32_t py) {
                    return image.rgb[3 * (size_t(py) * image.width + px) + i];
                };
                float least = 1;
                for (uint32_t k = 0; k < 3; ++k)
                    for (int o = -1; o <= 1; ++o) {
                        const auto weight = [&](uint32_t px, uint32_t py) {
                            return at.rgb[3 * (size_t(py) * at.width + px) + k];
                        };
                        least = std::min({least, weight(x + uint32_t(o), y), weight(x, y + uint32_t(o))});
                    }
                if (least < 0.05f)
                    continue;
                ++checked;
                ASSERT_NEAR(value(dx, x, y) - 0.5f, 0.5f * (value(at, x + 1, y) - value(at, x - 1, y)), 1e-3f);
                ASSERT_NEAR(value(dy, x, y) - 0.5f, 0.5f * (value(at, x, y + 1) - value(at, x, y - 1)), 1e-3f);
            }
    EXPECT_GT(checked, 500u);
}

// Where a light reaches some of an aggregate's samples, and these differ from the others in colour and normal, their
// own means must shade them: per-sample shading is the truth.
TEST(Ids, LitMeansAreCloserToTheTruth) {
    StageContext context;
    const std::vector<Triangle> triangles = randomTriangles({.triangles = 150}, 61);
    AgaaShadowFunction shadows = AGAA_SHADOW_FUNCTION_INIT;
    shadows.glsl = "float agaaHostShadow(uint shadow, vec3 position) {\n"
                   "    return fract(3.0 * position.z) > 0.5 ? 1.0 : 0.0;\n}\n";
    shadows.shadows = 1;
    AgaaLight light = sun();
    light.shadowMap = 0;
    const AgaaShadow shadow{};
    ViewSettings settings = settingsFor(8, 1, AGAA_TIER_IDS);
    settings.facts.shadowMapCount = 1;
    settings.facts.flags = 0; // diffuse alone
    const auto shaded = [&](const char* technique, uint32_t lit) {
        ViewSettings own = settings;
        own.config.technique = technique;
        own.config.aggregation.litShadows = lit;
        if (std::string(technique) == "ssaa") {
            own.config.generationTier = AGAA_TIER_AUTO;
            own.chained = &shadows;
            StageView view(context, own);
            view.setTriangles(triangles);
            AgaaFrame frame = view.frame();
            setLight(frame, light, &shadow);
            view.render(frame);
            return view.image();
        }
        own.chained = &shadows;
        IdsView ids(context, own, {.triangles = triangles});
        const harness::Image image = ids.render(light, &shadow);
        // Eight samples are eight taps, by either way.
        EXPECT_EQ(ids.view().statistics().counters.shadowTaps, ids.view().statistics().counters.visible);
        return image;
    };
    const harness::Image truth = shaded("ssaa", 0);
    const auto error = [&](const harness::Image& image) { return std::pow(10, -compare(truth, image).psnr / 10); };
    const double plain = error(shaded("agaa", 0)), lit = error(shaded("agaa", 1));
    std::printf("mseTm: plain %.2e, lit %.2e\n", plain, lit);
    EXPECT_GT(plain, 1e-5) << "there is something to gain";
    EXPECT_LT(lit, 0.4 * plain);
}

// Narrow lobes tell normals apart that wide ones do not: with the weight, glossy surfaces are parted where rough ones
// stay together, by the tiers that know materials in time.
TEST(Ids, GlossPartsWhatShinesNarrowly) {
    StageContext context;
    const auto events = [&](uint32_t tier, float alpha2, float weight) {
        std::vector<Triangle> triangles = randomTriangles({.triangles = 150}, 61);
        for (size_t i = 0; i < triangles.size(); ++i) { // normals a few degrees apart
            const float tilt = 0.15f * float(i % 5);
            triangles[i].material.normal = glm::vec4(std::sin(tilt), 0, std::cos(tilt), alpha2);
        }
        ViewSettings settings = settingsFor(8, 4, tier);
        settings.config.aggregation.aggregateThreshold = 0.05f;
        settings.config.aggregation.characteristicLength = 1e6f; // normals alone
        settings.config.aggregation.characteristicLengthPerDistance = 0;
        settings.config.aggregation.glossWeight = weight;
        if (tier == AGAA_TIER_IDS) {
            IdsView ids(context, settings, {.triangles = triangles});
            ids.render();
            return ids.view().statistics().counters.shadingEvents;
        }
        StageView view(context, settings);
        drawn(view, triangles);
        return view.statistics().counters.shadingEvents;
    };
    for (const uint32_t tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        SCOPED_TRACE(agaaTierName(tier));
        const uint64_t rough = events(tier, 1.0f, 0.5f);
        EXPECT_GT(events(tier, 1e-4f, 0.5f), rough + rough / 50);
        if (tier == AGAA_TIER_GBUFFER) { // by id, planes decide where there is no weight
            EXPECT_EQ(events(tier, 1e-4f, 0.0f), rough);
        }
    }
}

TEST(Ids, BadFunctionsAreRefusedInASentence) {
    StageContext context;
    constexpr const char* good =
        "void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {}\n"
        "void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {}\n";
    struct Row {
        const char* what;
        AgaaResult code;
        std::function<void(AgaaFetchFunction&, ViewSettings&)> spoil;
    };
    static AgaaGBufferFunction gbuffer = AGAA_GBUFFER_FUNCTION_INIT;
    gbuffer.glsl =
        "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    const Row rows[] = {
        {"no text", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = nullptr; }},
        {"does not compile", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = "float x = ;"; }},
        {"no function", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glsl = "float other;"; }},
        {"extensions", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.glslExtensions = "float x;"; }},
        {"size", AGAA_ERROR_STRUCT, [](auto& f, auto&) { f.structSize = 8; }},
        {"no draws", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&) { f.maxDraws = 0; }},
        {"no primitives", AGAA_ERROR_OUT_OF_RANGE, [](auto& f, auto&) { f.maxPrimitives = 0; }},
        {"more draws than ids", AGAA_ERROR_TOO_LARGE,
         [](auto& f, auto&) {
             f.maxDraws = 1u << 12;
             f.maxPrimitives = (1u << 20) + 1;
         }},
        {"another technique", AGAA_ERROR_UNSUPPORTED,
         [](auto&, auto& s) {
             s.config.technique = "sbaa";
             s.config.generationTier = AGAA_TIER_IDS;
         }},
        {"a G-buffer too", AGAA_ERROR_INVALID_ARGUMENT, [](auto& f, auto&) { f.pNext = &gbuffer; }},
    };
    for (const Row& row : rows) {
        AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
        function.glsl = good;
        function.maxDraws = 10;
        function.maxPrimitives = 1000;
        ViewSettings settings = settingsFor(8, 2, AGAA_TIER_AUTO);
        row.spoil(function, settings);
        settings.chained = &function;
        expectRefused(context, settings, row.code, row.what);
    }
    ViewSettings settings = settingsFor(8, 2, AGAA_TIER_IDS); // without a function
    EXPECT_NE(expectRefused(context, settings, AGAA_ERROR_UNSUPPORTED, "no function").find("AgaaFetchFunction"),
              std::string::npos);
}

} // namespace
} // namespace agaa::test
