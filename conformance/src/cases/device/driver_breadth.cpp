// Drivers with fewer features: every tier that agaaQueryCapabilities lists renders a frame, other views are refused
// with a reason, and no tier is missing that the lesser driver could run.
#include "cases.h"
#include "frame_rig.h"
#include "gl_interposer.h"
#include "vk_interposer.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <set>
#include <utility>

namespace agaa::conformance {

namespace {

struct Counts {
    uint32_t rendered = 0, refused = 0;
};

bool needs(const AgaaCapability& row, const char* what) { return std::strstr(row.reason, what); }

// The techniques that a driver runs, each with one of its tiers of generation.
using Tiers = std::set<std::pair<std::string, uint32_t>>;

// The tiers of one context.
class Breadth {
public:
    Breadth(Test& test, ScopedContext& context, const std::string& driver)
        : test_(test), context_(context), driver_(driver), scene_(smallScene(16, 16)) {
        test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps_), "the caps of " + driver);
    }

    // Renders with each tier of every technique.
    Counts runAll() { return run(techniques(test_), true); }
    // Renders with three techniques, which have all kinds of passes, and with their automatic tiers or with each tier.
    Counts runSome(bool hasAllTiers) { return run({"msaa", "agaa", "dcaa"}, hasAllTiers); }

    Tiers tiers() {
        Tiers found;
        for (const std::string& technique : techniques(test_))
            if (unsupportedReason(test_, technique).empty())
                for (const AgaaCapability& row : rowsOf(technique))
                    if (row.tier != AGAA_TIER_AUTO)
                        found.insert({technique, row.tier});
        return found;
    }

private:
    Counts run(const std::vector<std::string>& names, bool hasAllTiers) {
        for (const std::string& technique : names) {
            if (!unsupportedReason(test_, technique).empty())
                continue;
            bool isFirst = true;
            for (const AgaaCapability& row : rowsOf(technique)) {
                if (isFirst || hasAllTiers)
                    expect(technique, row, isFirst);
                isFirst = false;
            }
        }
        return counts_;
    }

    // The rows of the stage that varies, for n = samplesOf(technique, 4); the first is that of AUTO.
    std::vector<AgaaCapability> rowsOf(const std::string& technique) {
        uint32_t count = 0;
        test_.requireOk(test_.sdk.agaaQueryCapabilities(&caps_, &count, nullptr), "agaaQueryCapabilities");
        const AgaaCapability initial = AGAA_CAPABILITY_INIT;
        std::vector<AgaaCapability> all(count, initial), rows, others;
        test_.requireOk(test_.sdk.agaaQueryCapabilities(&caps_, &count, all.data()), "agaaQueryCapabilities");
        for (const AgaaCapability& row : all)
            if (technique == row.technique && row.samples == samplesOf(technique, 4)) {
                test_.check(row.reason[0] != 0, driver_ + ": a row of " + technique + " has no reason.");
                if (row.stage == AGAA_STAGE_GENERATION)
                    rows.push_back(row);
                else if (row.stage == AGAA_STAGE_PREPASS)
                    others.push_back(row);
            }
        test_.check(!others.empty(), driver_ + ": " + technique + " has no rows.");
        if (rows.empty() && !others.empty()) { // the technique has one way of generation
            rows.push_back(others.front());
            rows.back().tier = others.front().tier == AGAA_TIER_AUTO ? AGAA_TIER_AUTO : AGAA_TIER_NATIVE;
        }
        return rows;
    }

    void expect(const std::string& technique, const AgaaCapability& row, bool isFirst) {
        ViewDescription d(&test_.device());
        setTechnique(d, technique, 4);
        d.desc.width = d.desc.height = 16;
        if (!(caps_.flags & AGAA_DEVICE_FRAGMENT_ATOMICS))
            d.config.flags = 0; // counters need them
        const bool isFetched = row.tier == AGAA_TIER_IDS || needs(row, "AgaaFetchFunction");
        if (isFetched && !hasCoverageSamples(technique)) {
            d.sceneFetch.pNext = d.desc.pNext;
            d.desc.pNext = &d.sceneFetch;
        }
        const bool isExpanded = needs(row, "maxTriangles");
        if (isExpanded && row.tier != AGAA_TIER_AUTO)
            d.sceneFetch.maxTriangles = 1000;
        else if (needs(row, "AGAA_VIEW_VERTEX_PULLING") || (isFetched && !(caps_.flags & AGAA_DEVICE_GEOMETRY_SHADERS)))
            d.desc.flags |= AGAA_VIEW_VERTEX_PULLING;
        if (!isFirst)
            d.config.generationTier = row.tier;
        const std::string what = driver_ + ": \"" + technique + "\" with the tier " + test_.sdk.agaaTierName(row.tier);
        AgaaView view = nullptr;
        context_.log.lines.clear();
        const AgaaResult result = test_.device().createView(test_.sdk, context_.get(), &d.desc, &view);
        if (row.tier == AGAA_TIER_AUTO) {
            expectRefused(test_, result, AGAA_ERROR_UNSUPPORTED, context_.log, apiName(test_.device(), "CreateView"),
                          what);
            ++counts_.refused;
            return;
        }
        if (result != AGAA_OK) {
            const std::string reason = context_.log.lines.empty() ? "" : context_.log.lines.back().text;
            test_.check(false, what + " should run, because " + row.reason + " It is refused: " + reason);
            return;
        }
        render(d, view, what);
        test_.device().forget(view);
        test_.sdk.agaaDestroyView(view);
        ++counts_.rendered;
    }

    void render(const ViewDescription& d, AgaaView view, const std::string& what) {
        test_.device().setOutput(16, 16);
        test_.device().prepare(test_.sdk, view);
        AgaaFrame frame = pixelFrame(test_.device(), d, 1);
        if (!test_.result(test_.device().record(test_.sdk, view, frame, scene_), AGAA_OK, "a frame of " + what))
            return;
        const float back[] = {0.5f, 0.5f, 0.5f}, second[] = {0.25f, 0.5f, 0.5f};
        const Image image = test_.device().readOutput();
        expectColor(test_, image, 16, {1, 1, 3, 15}, back, 0.01f, what + ": the rectangle at the back");
        expectColor(test_, image, 16, {5, 10, 15, 15}, second, 0.01f, what + ": the second rectangle");
        expectNoMessages(test_, what);
    }

    Test& test_;
    ScopedContext& context_;
    std::string driver_;
    Scene scene_;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
    Counts counts_;
};

void print(Test& test, const std::string& driver, const Counts& counts) {
    std::printf("%s: %s: %u views render, %u are refused with a reason.\n", backendName(test.device().backend()),
                driver.c_str(), counts.rendered, counts.refused);
}

// ---- Vulkan -----------------------------------------------------------------------------------------

// The features that are left of a Vulkan device.
struct LesserDriver {
    VulkanInterposer api;
    std::vector<const char*> extensions;
    VkPhysicalDeviceFeatures2 features;
    uint32_t apiVersion;
    std::set<VkFormat> withoutFormats;
    VkSampleCountFlags samples = ~0u;
    bool hasLeastLimits = false;

    explicit LesserDriver(Device& device) {
        const AgaaVkDeviceDesc vk = device.description().vk;
        extensions.assign(vk.enabledExtensions, vk.enabledExtensions + vk.enabledExtensionCount);
        features = *static_cast<const VkPhysicalDeviceFeatures2*>(vk.enabledFeatures);
        apiVersion = vk.apiVersion;
        api.changeProperties = [this](VkPhysicalDeviceProperties& p) { change(p.limits); };
        api.changeFormat = [this](VkFormat format, VkFormatProperties& p) {
            if (withoutFormats.count(format))
                p = {};
        };
    }
    // Limits that Vulkan guarantees.
    void change(VkPhysicalDeviceLimits& limits) const {
        for (VkSampleCountFlags* counts :
             {&limits.framebufferColorSampleCounts, &limits.framebufferDepthSampleCounts,
              &limits.framebufferStencilSampleCounts, &limits.sampledImageColorSampleCounts,
              &limits.sampledImageDepthSampleCounts})
            *counts &= samples;
        if (!hasLeastLimits)
            return;
        limits.maxImageDimension2D = limits.maxFramebufferWidth = limits.maxFramebufferHeight = 4096;
        limits.maxViewportDimensions[0] = limits.maxViewportDimensions[1] = 4096;
        limits.maxStorageBufferRange = 1u << 27;
        limits.maxComputeSharedMemorySize = 16384;
        limits.maxColorAttachments = 4;
        limits.bufferImageGranularity = 131072;
    }
    void remove(const char* extension) {
        std::erase_if(extensions, [&](const char* name) { return !std::strcmp(name, extension); });
    }
    void use(ContextDescription& d) {
        api.chainTo(d);
        d.vk.enabledExtensions = extensions.data();
        d.vk.enabledExtensionCount = uint32_t(extensions.size());
        d.vk.enabledFeatures = &features;
        d.vk.apiVersion = apiVersion;
        d.vk.rendering = AGAA_VK_RENDERING_AUTO;
    }
};

struct Removal {
    const char* what;
    void (*remove)(LesserDriver&);
    std::vector<uint32_t> needing = {}; // tiers that need what is removed
};
const Removal removals[] = {
    {"all features", [](LesserDriver&) {}},
    {"no order of attachment accesses",
     [](LesserDriver& d) { d.remove(VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME); },
     {AGAA_TIER_RASTER_ORDER}},
    {"no conditional rendering", [](LesserDriver& d) { d.remove(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME); }},
    {"no interlock",
     [](LesserDriver& d) { d.remove(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME); },
     {AGAA_TIER_FRAGMENT_INTERLOCK}},
    {"no post-depth coverage",
     [](LesserDriver& d) { d.remove(VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME); },
     {AGAA_TIER_POST_DEPTH_ATOMICS}},
    {"no dynamic rendering",
     [](LesserDriver& d) {
         d.remove(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME);
         d.apiVersion = VK_API_VERSION_1_2;
     }},
    {"no D24S8", [](LesserDriver& d) { d.withoutFormats.insert(VK_FORMAT_D24_UNORM_S8_UINT); }},
    {"no D32S8", [](LesserDriver& d) { d.withoutFormats.insert(VK_FORMAT_D32_SFLOAT_S8_UINT); }},
    {"the least limits", [](LesserDriver& d) { d.hasLeastLimits = true; }, {AGAA_TIER_RASTER_ORDER}},
    {"one sample", [](LesserDriver& d) { d.samples = VK_SAMPLE_COUNT_1_BIT; }},
    {"no geometry shaders: the minimum", [](LesserDriver& d) { d.features.features.geometryShader = VK_FALSE; }},
    {"no sample rate shading, which is required",
     [](LesserDriver& d) { d.features.features.sampleRateShading = VK_FALSE; },
     {AGAA_TIER_PER_SAMPLE}},
    {"no atomics in fragments, which are required",
     [](LesserDriver& d) { d.features.features.fragmentStoresAndAtomics = VK_FALSE; },
     {AGAA_TIER_PER_SAMPLE, AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_MATERIAL_LISTS, AGAA_TIER_RASTER_ORDER}}};

// Features are removed one after the other. The first driver and the minimum run all techniques, the others some.
// isAlone: each driver lacks one feature only.
void testLesserDrivers(Test& test, bool isAlone) {
    const std::unique_ptr<Device> device = makeVulkanDevice(test.sdk, test.device().deviceName(), true);
    runOn(test, *device, [&](Test& inner) {
        Tiers all;
        for (const Removal& last : removals) {
            LesserDriver driver(*device);
            std::set<uint32_t> needing;
            for (const Removal& removal : removals) {
                if (!isAlone || &removal == &last) {
                    removal.remove(driver);
                    needing.insert(removal.needing.begin(), removal.needing.end());
                }
                if (&removal == &last)
                    break;
            }
            ScopedContext context(inner, [&](ContextDescription& d) { driver.use(d); });
            const bool isEnd = std::strstr(last.what, "all") || std::strstr(last.what, "minimum");
            Breadth breadth(inner, context, last.what);
            const Tiers left = breadth.tiers();
            if (all.empty())
                all = left;
            for (const auto& [technique, tier] : all)
                inner.check(left.count({technique, tier}) || needing.count(tier),
                            std::string(last.what) + ": \"" + technique + "\" lacks the tier " +
                                inner.sdk.agaaTierName(tier) + ", which does not need what is missing.");
            print(inner, last.what, isEnd && !isAlone ? breadth.runAll() : breadth.runSome(isAlone));
        }
    });
}

// ---- OpenGL -----------------------------------------------------------------------------------------

struct OtherContext {
    const char* what;
    OpenGlVersion version;
    const char* reported; // the version that the SDK sees; empty: the context's
};
constexpr OtherContext otherContexts[] = {{"OpenGL 4.3, core", {4, 3, false}, "4.3 of the suite"},
                                          {"OpenGL 4.3, compatibility", {4, 3, true}, "4.3 of the suite"},
                                          {"OpenGL 4.5, core", {4, 5, false}, ""},
                                          {"OpenGL 4.5, compatibility", {4, 5, true}, ""},
                                          {"OpenGL 4.6, core", {4, 6, false}, ""},
                                          {"OpenGL 4.6, compatibility", {4, 6, true}, ""}};

// The driver may return a later version than the one that was asked for, so that the interposer reports 4.3.
void testVersions(Test& test) {
    uint32_t contexts = 0;
    for (const OtherContext& other : otherContexts) {
        std::unique_ptr<Device> device;
        try {
            device = makeOpenGlDevice(test.device().deviceName(), other.version);
        } catch (const Skipped& skipped) {
            std::printf("gl: %s is skipped, because %s\n", other.what, skipped.reason.c_str());
            continue;
        }
        ++contexts;
        runOn(test, *device, [&](Test& inner) {
            OpenGlInterposer api;
            api.version = other.reported;
            ScopedContext context(inner, [&](ContextDescription& d) { api.chainTo(d); });
            const std::string what = std::string(other.what) + " (" + device->driverName() + ")";
            Breadth breadth(inner, context, other.what);
            print(inner, what, &other == otherContexts ? breadth.runAll() : breadth.runSome(true));
        });
    }
    test.check(contexts > 0, "EGL has no context of any version.");
}

} // namespace

void addDriverBreadthCases(Suite& suite) {
    suite.add("general/techniques/lesser_drivers", {Backend::Vulkan},
              [](Test& test) { testLesserDrivers(test, false); });
    suite.add("general/techniques/lesser_drivers/long", {Backend::Vulkan},
              [](Test& test) { testLesserDrivers(test, true); });
    suite.add("general/techniques/versions", {Backend::OpenGl}, testVersions);
}

} // namespace agaa::conformance
