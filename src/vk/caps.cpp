// Requirements and capabilities of Vulkan devices.
#include "core/abi/api_guard.h"
#include "core/base/error.h"
#include "core/plan/plan.h"
#include "core/view/tiers.h"
#include "vk/context.h"
#include "vk/structs.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace agaa::vk {

constexpr const char* mixedSamplesCall = "vkGetPhysicalDeviceSupportedFramebufferMixedSamplesCombinationsNV";

std::vector<MixedSamples> truncatedSamples(const InstanceTable& vk, VkPhysicalDevice device) {
    std::vector<MixedSamples> list;
    const auto get = reinterpret_cast<PFN_vkGetPhysicalDeviceSupportedFramebufferMixedSamplesCombinationsNV>(
        vk.getProcAddr(vk.instance, mixedSamplesCall));
    if (!get)
        return list;
    uint32_t count = 0;
    check(get(device, &count, nullptr), mixedSamplesCall);
    std::vector<VkFramebufferMixedSamplesCombinationNV> combinations(count);
    for (VkFramebufferMixedSamplesCombinationNV& combination : combinations)
        combination.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_MIXED_SAMPLES_COMBINATION_NV;
    check(get(device, &count, combinations.data()), mixedSamplesCall);
    for (const VkFramebufferMixedSamplesCombinationNV& c : combinations) {
        const auto samples = uint32_t(c.rasterizationSamples);
        if (c.coverageReductionMode == VK_COVERAGE_REDUCTION_MODE_TRUNCATE_NV && c.depthStencilSamples & samples)
            list.push_back({samples, c.colorSamples});
    }
    return list;
}

namespace {

constexpr const char* requiredFeatures[] = {
    "fragmentStoresAndAtomics",
    "sampleRateShading", // also needed by interpolateAtCentroid() in the host's material shaders
    "shaderStorageImageExtendedFormats",
    "shaderStorageImageWriteWithoutFormat",
};
constexpr const char* optionalFeatures[] = {"dynamicRendering",
                                            "geometryShader",
                                            "conditionalRendering",
                                            "fragmentShaderPixelInterlock",
                                            "rasterizationOrderColorAttachmentAccess",
                                            "coverageReductionMode",
                                            "multiViewport",
                                            "computeFullSubgroups"};
constexpr const char* optionalExtensions[] = {VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME,
                                              VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME,
                                              VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME,
                                              VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME,
                                              VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME,
                                              VK_NV_FRAMEBUFFER_MIXED_SAMPLES_EXTENSION_NAME,
                                              VK_NV_SAMPLE_MASK_OVERRIDE_COVERAGE_EXTENSION_NAME,
                                              VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME,
                                              VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME,
                                              VK_NV_VIEWPORT_ARRAY_2_EXTENSION_NAME,
                                              VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME};

std::vector<VkExtensionProperties> deviceExtensions(const InstanceTable& vk, VkPhysicalDevice device) {
    uint32_t count = 0;
    check(vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr),
          "vkEnumerateDeviceExtensionProperties");
    std::vector<VkExtensionProperties> list(count);
    check(vk.EnumerateDeviceExtensionProperties(device, nullptr, &count, list.data()),
          "vkEnumerateDeviceExtensionProperties");
    return list;
}

// The device must have the extension.
bool rendersConditionally(const InstanceTable& vk, VkPhysicalDevice device) {
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditional{};
    conditional.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &conditional, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    return conditional.conditionalRendering;
}

// Returns the sample counts with which depth, normals and G-buffers of any layout can be rendered and fetched. Formats
// that the device lacks are ignored.
VkSampleCountFlags usableSamples(const InstanceTable& vk, VkPhysicalDevice device, const VkPhysicalDeviceLimits& limits,
                                 VkFormat depth) {
    VkSampleCountFlags counts = limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts &
                                limits.framebufferStencilSampleCounts & limits.sampledImageColorSampleCounts &
                                limits.sampledImageDepthSampleCounts;
    const auto restrict = [&](VkFormat format, VkImageUsageFlags usage) {
        VkImageFormatProperties properties{};
        const VkResult result = vk.GetPhysicalDeviceImageFormatProperties(
            device, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, usage, 0, &properties);
        if (result == VK_ERROR_FORMAT_NOT_SUPPORTED) // only views with such a surface fail
            return;
        check(result, "vkGetPhysicalDeviceImageFormatProperties");
        counts &= properties.sampleCounts;
    };
    for (VkFormat format : {VK_FORMAT_R8_UNORM, VK_FORMAT_R8G8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R16_UNORM,
                            VK_FORMAT_R16G16_UNORM, VK_FORMAT_R16G16B16A16_UNORM, VK_FORMAT_R16G16B16A16_SFLOAT,
                            VK_FORMAT_A2B10G10R10_UNORM_PACK32})
        restrict(format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    restrict(depth, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    return counts;
}

// The device must have the extension.
bool hasPixelInterlock(const InstanceTable& vk, VkPhysicalDevice device) {
    VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADER_INTERLOCK_FEATURES_EXT, nullptr, 0, 0, 0};
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &interlock, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    return interlock.fragmentShaderPixelInterlock;
}

// Tests the feature for as many attachments as a tier can need. The device must have the extension.
bool ordersColorAccess(const InstanceTable& vk, VkPhysicalDevice device, const VkPhysicalDeviceLimits& limits) {
    VkPhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT order{};
    order.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_FEATURES_EXT;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &order, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    const uint32_t withCounters = maxFetchedTargets + 1;
    return order.rasterizationOrderColorAttachmentAccess && limits.maxColorAttachments >= maxFetchedTargets &&
           limits.maxPerStageDescriptorInputAttachments >= maxFetchedTargets &&
           limits.maxFragmentCombinedOutputResources >= withCounters;
}

// Tests whether samples may lie on the grid of texelPositions(), for 2 samples and more. The device must have
// VK_EXT_sample_locations.
bool placesSamples(const InstanceTable& vk, VkPhysicalDevice device, VkSampleCountFlags counts) {
    VkPhysicalDeviceSampleLocationsPropertiesEXT locations{};
    locations.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SAMPLE_LOCATIONS_PROPERTIES_EXT;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &locations, {}};
    vk.GetPhysicalDeviceProperties2(device, &properties);
    const VkSampleCountFlags multiple = counts & ~VkSampleCountFlags(VK_SAMPLE_COUNT_1_BIT);
    // Without variableSampleLocations a render pass must know the locations when it begins, and dynamic rendering
    // cannot.
    return locations.variableSampleLocations && locations.sampleLocationSubPixelBits >= 4 &&
           locations.sampleLocationCoordinateRange[0] <= 0.0f &&
           locations.sampleLocationCoordinateRange[1] >= 15.0f / 16 &&
           (locations.sampleLocationSampleCounts & multiple) == multiple;
}

// The device must have VK_NV_coverage_reduction_mode.
bool reducesCoverage(const InstanceTable& vk, VkPhysicalDevice device) {
    VkPhysicalDeviceCoverageReductionModeFeaturesNV reduction{};
    reduction.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &reduction, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    return reduction.coverageReductionMode && !truncatedSamples(vk, device).empty();
}

// Returns AgaaDeviceCaps::subgroupSize. The device must have Vulkan 1.3 or the extension.
uint32_t fullSubgroupSize(const InstanceTable& vk, VkPhysicalDevice device) {
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &subgroup, {}};
    vk.GetPhysicalDeviceProperties2(device, &properties);
    VkPhysicalDeviceSubgroupSizeControlFeatures control{};
    control.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_FEATURES;
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &control, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    constexpr VkSubgroupFeatureFlags operations = VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT |
                                                  VK_SUBGROUP_FEATURE_BALLOT_BIT | VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
    const bool has = control.computeFullSubgroups && subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT &&
                     (subgroup.supportedOperations & operations) == operations;
    return has ? subgroup.subgroupSize : 0;
}

bool rendersAndSamples(const InstanceTable& vk, VkPhysicalDevice device, VkFormat format) {
    VkFormatProperties properties{};
    vk.GetPhysicalDeviceFormatProperties(device, format, &properties);
    constexpr VkFormatFeatureFlags needed =
        VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    return (properties.optimalTilingFeatures & needed) == needed;
}

} // namespace

AgaaDeviceCaps queryCaps(const InstanceTable& vk, VkPhysicalDevice device) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    VkPhysicalDeviceDriverProperties driver{
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES, nullptr, VkDriverId(0), {}, {}, {}};
    VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &driver, {}};
    vk.GetPhysicalDeviceProperties2(device, &properties);
    const VkPhysicalDeviceLimits& limits = properties.properties.limits;
    std::snprintf(caps.deviceName, sizeof caps.deviceName, "%.127s", properties.properties.deviceName);
    std::snprintf(caps.driverName, sizeof caps.driverName, "%.60s %.60s", driver.driverName, driver.driverInfo);
    VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, nullptr, {}};
    vk.GetPhysicalDeviceFeatures2(device, &features);
    const VkPhysicalDeviceFeatures& f = features.features;

    caps.maxImageSize = limits.maxImageDimension2D;
    caps.maxImageSize = std::min({caps.maxImageSize, limits.maxFramebufferWidth, limits.maxFramebufferHeight,
                                  limits.maxViewportDimensions[0], limits.maxViewportDimensions[1]});
    caps.maxStorageRange = limits.maxStorageBufferRange;
    caps.maxSharedBytes = limits.maxComputeSharedMemorySize;
    const auto set = [&](bool on, uint64_t flag) { caps.flags |= on ? flag : 0; };
    set(properties.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU, AGAA_DEVICE_SOFTWARE);
    set(f.fragmentStoresAndAtomics, AGAA_DEVICE_FRAGMENT_ATOMICS);
    set(f.geometryShader, AGAA_DEVICE_GEOMETRY_SHADERS);
    set(f.sampleRateShading, AGAA_DEVICE_SAMPLE_RATE_SHADING);
    set(f.shaderStorageImageExtendedFormats && f.shaderStorageImageWriteWithoutFormat, AGAA_DEVICE_STORAGE_FORMATS);
    set(rendersAndSamples(vk, device, VK_FORMAT_D24_UNORM_S8_UINT), AGAA_DEVICE_D24S8);
    set(rendersAndSamples(vk, device, VK_FORMAT_D32_SFLOAT_S8_UINT), AGAA_DEVICE_D32S8);
    set(properties.properties.apiVersion >= VK_API_VERSION_1_3, AGAA_DEVICE_DYNAMIC_RENDERING);
    std::set<std::string_view> mixedSamples; // extensions
    bool hasSampleLocations = false;
    bool controlsSubgroups = properties.properties.apiVersion >= VK_API_VERSION_1_3;
    const std::vector<VkExtensionProperties> extensions = deviceExtensions(vk, device);
    for (const VkExtensionProperties& extension : extensions) {
        const std::string_view name = extension.extensionName;
        controlsSubgroups |= name == VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME;
        if (name == VK_NV_FRAMEBUFFER_MIXED_SAMPLES_EXTENSION_NAME ||
            name == VK_NV_SAMPLE_MASK_OVERRIDE_COVERAGE_EXTENSION_NAME ||
            name == VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME)
            mixedSamples.insert(name);
        hasSampleLocations |= name == VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME;
        set(name == VK_NV_VIEWPORT_ARRAY_2_EXTENSION_NAME && f.multiViewport && f.geometryShader &&
                limits.maxViewports >= maxLayers,
            AGAA_DEVICE_NV_MULTICAST);
        set(name == VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME, AGAA_DEVICE_POST_DEPTH_COVERAGE);
        set(name == VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME, AGAA_DEVICE_DYNAMIC_RENDERING);
        set(name == VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME && rendersConditionally(vk, device),
            AGAA_DEVICE_CONDITIONAL_RENDERING);
        set(name == VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME && hasPixelInterlock(vk, device),
            AGAA_DEVICE_FRAGMENT_INTERLOCK);
        set(name == VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME &&
                ordersColorAccess(vk, device, limits),
            AGAA_DEVICE_FRAMEBUFFER_FETCH);
    }
    set(mixedSamples.size() == 3 && reducesCoverage(vk, device), AGAA_DEVICE_NV_MIXED_SAMPLES);
    if (controlsSubgroups)
        caps.subgroupSize = fullSubgroupSize(vk, device);
    VkSampleCountFlags counts = usableSamples(vk, device, limits, VK_FORMAT_D32_SFLOAT);
    for (VkFormat depth : {VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT})
        if (rendersAndSamples(vk, device, depth))
            counts &= usableSamples(vk, device, limits, depth);
    caps.sampleCounts = counts & 0x1F; // Vulkan defines no standard pattern of 32 samples
    set(hasSampleLocations && placesSamples(vk, device, caps.sampleCounts), AGAA_DEVICE_SAMPLE_LOCATIONS);
    return caps;
}

} // namespace agaa::vk

using namespace agaa;

extern "C" {

AgaaResult AGAA_CALL agaaVkGetRequirements(AgaaVkRequirements* out) {
    return guarded(Log(), "agaaVkGetRequirements", [&]() -> AgaaResult {
        checkOutput(out);
        AgaaVkRequirements requirements = AGAA_VK_REQUIREMENTS_INIT;
        requirements.apiVersion = VK_API_VERSION_1_2;
        requirements.requiredFeatureCount = uint32_t(std::size(vk::requiredFeatures));
        requirements.requiredFeatures = vk::requiredFeatures;
        requirements.optionalFeatureCount = uint32_t(std::size(vk::optionalFeatures));
        requirements.optionalFeatures = vk::optionalFeatures;
        requirements.optionalDeviceExtensionCount = uint32_t(std::size(vk::optionalExtensions));
        requirements.optionalDeviceExtensions = vk::optionalExtensions;
        writeStruct(out, requirements);
        return AGAA_OK;
    });
}

AgaaResult AGAA_CALL agaaVkGetDeviceCaps(void* instance, void* physicalDevice, AgaaVkGetInstanceProcAddr getProcAddr,
                                         const AgaaLog* log, AgaaDeviceCaps* outCaps) {
    return guarded(log, "agaaVkGetDeviceCaps", [&]() -> AgaaResult {
        require(instance, AGAA_ERROR_INVALID_ARGUMENT, "the instance is null.");
        require(physicalDevice, AGAA_ERROR_INVALID_ARGUMENT, "the physical device is null.");
        require(getProcAddr, AGAA_ERROR_INVALID_ARGUMENT, "getProcAddr is null.");
        checkOutput(outCaps);
        const vk::InstanceTable functions = vk::loadInstanceTable(getProcAddr, static_cast<VkInstance>(instance));
        writeStruct(outCaps, vk::queryCaps(functions, static_cast<VkPhysicalDevice>(physicalDevice)));
        return AGAA_OK;
    });
}

} // extern "C"
