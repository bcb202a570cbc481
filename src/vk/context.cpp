#include "vk/context.h"

#include "core/base/error.h"
#include "vk/formats.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace agaa::vk {

// Removes the capabilities that the host did not enable on its device.
static void removeDisabledCaps(AgaaDeviceCaps& caps, const AgaaVkDeviceDesc& desc, uint32_t apiVersion) {
    const auto enabled = [&](const char* name) {
        for (uint32_t i = 0; i < desc.enabledExtensionCount; ++i)
            if (desc.enabledExtensions[i] && std::strcmp(desc.enabledExtensions[i], name) == 0)
                return true;
        return false;
    };
    if (!enabled(VK_EXT_POST_DEPTH_COVERAGE_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_POST_DEPTH_COVERAGE;
    if (!enabled(VK_NV_FRAMEBUFFER_MIXED_SAMPLES_EXTENSION_NAME) ||
        !enabled(VK_NV_SAMPLE_MASK_OVERRIDE_COVERAGE_EXTENSION_NAME) ||
        !enabled(VK_NV_COVERAGE_REDUCTION_MODE_EXTENSION_NAME) || !desc.enabledFeatures)
        caps.flags &= ~AGAA_DEVICE_NV_MIXED_SAMPLES;
    if (!enabled(VK_EXT_SAMPLE_LOCATIONS_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_SAMPLE_LOCATIONS;
    if (!enabled(VK_NV_VIEWPORT_ARRAY_2_EXTENSION_NAME) || !desc.enabledFeatures)
        caps.flags &= ~AGAA_DEVICE_NV_MULTICAST;
    if (!enabled(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_FRAGMENT_INTERLOCK;
    if (apiVersion < VK_API_VERSION_1_3 && !enabled(VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME))
        caps.flags &= ~AGAA_DEVICE_DYNAMIC_RENDERING;
    // A host may enable all extensions of AgaaVkRequirements by name without enabling their features.
    if (!enabled(VK_EXT_CONDITIONAL_RENDERING_EXTENSION_NAME) || !desc.enabledFeatures)
        caps.flags &= ~AGAA_DEVICE_CONDITIONAL_RENDERING;
    if (!enabled(VK_EXT_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_EXTENSION_NAME) || !desc.enabledFeatures)
        caps.flags &= ~AGAA_DEVICE_FRAMEBUFFER_FETCH;
    if ((apiVersion < VK_API_VERSION_1_3 && !enabled(VK_EXT_SUBGROUP_SIZE_CONTROL_EXTENSION_NAME)) ||
        !desc.enabledFeatures)
        caps.subgroupSize = 0;
    if (!desc.enabledFeatures)
        return;
    const auto* core = static_cast<const VkPhysicalDeviceFeatures2*>(desc.enabledFeatures);
    require(core->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, AGAA_ERROR_INVALID_ARGUMENT,
            "AgaaVkDeviceDesc::enabledFeatures is not a VkPhysicalDeviceFeatures2.");
    const auto keep = [&](VkBool32 on, uint64_t flag) { caps.flags &= on ? ~UINT64_C(0) : ~flag; };
    const VkPhysicalDeviceFeatures& f = core->features;
    keep(f.fragmentStoresAndAtomics, AGAA_DEVICE_FRAGMENT_ATOMICS);
    keep(f.geometryShader, AGAA_DEVICE_GEOMETRY_SHADERS);
    keep(f.sampleRateShading, AGAA_DEVICE_SAMPLE_RATE_SHADING);
    keep(f.multiViewport && f.geometryShader, AGAA_DEVICE_NV_MULTICAST);
    keep(f.shaderStorageImageExtendedFormats && f.shaderStorageImageWriteWithoutFormat, AGAA_DEVICE_STORAGE_FORMATS);
    VkBool32 dynamicRendering = VK_FALSE, conditionalRendering = VK_FALSE, interlock = VK_FALSE, colorOrder = VK_FALSE,
             fullSubgroups = VK_FALSE, coverageReduction = VK_FALSE;
    for (const auto* next = static_cast<const VkBaseInStructure*>(core->pNext); next; next = next->pNext) {
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES) {
            const auto* features = reinterpret_cast<const VkPhysicalDeviceVulkan13Features*>(next);
            dynamicRendering |= features->dynamicRendering;
            fullSubgroups |= features->computeFullSubgroups;
        }
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES)
            dynamicRendering |=
                reinterpret_cast<const VkPhysicalDeviceDynamicRenderingFeatures*>(next)->dynamicRendering;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_FEATURES)
            fullSubgroups |=
                reinterpret_cast<const VkPhysicalDeviceSubgroupSizeControlFeatures*>(next)->computeFullSubgroups;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT)
            conditionalRendering |=
                reinterpret_cast<const VkPhysicalDeviceConditionalRenderingFeaturesEXT*>(next)->conditionalRendering;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADER_INTERLOCK_FEATURES_EXT)
            interlock |= reinterpret_cast<const VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT*>(next)
                             ->fragmentShaderPixelInterlock;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_FEATURES_EXT)
            colorOrder |= reinterpret_cast<const VkPhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT*>(next)
                              ->rasterizationOrderColorAttachmentAccess;
        if (next->sType == VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV)
            coverageReduction |=
                reinterpret_cast<const VkPhysicalDeviceCoverageReductionModeFeaturesNV*>(next)->coverageReductionMode;
    }
    keep(dynamicRendering, AGAA_DEVICE_DYNAMIC_RENDERING);
    keep(conditionalRendering, AGAA_DEVICE_CONDITIONAL_RENDERING);
    keep(interlock, AGAA_DEVICE_FRAGMENT_INTERLOCK);
    keep(colorOrder, AGAA_DEVICE_FRAMEBUFFER_FETCH);
    keep(coverageReduction, AGAA_DEVICE_NV_MIXED_SAMPLES);
    if (!fullSubgroups)
        caps.subgroupSize = 0;
}

static VkSampler createSampler(const Context& context, VkFilter filter, bool compare) {
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = filter;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = compare;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkSampler sampler = VK_NULL_HANDLE;
    check(context.vk.CreateSampler(context.device, &info, nullptr, &sampler), "vkCreateSampler");
    return sampler;
}

Context::Context(const AgaaContextDesc& common, const AgaaVkDeviceDesc& desc,
                 const std::optional<AgaaVkAllocator>& allocatorOfHost)
    : AgaaContext_T(Backend::Vulkan, common),
      instanceFunctions(loadInstanceTable(desc.getProcAddr, static_cast<VkInstance>(desc.instance))),
      instance(static_cast<VkInstance>(desc.instance)),
      physicalDevice(static_cast<VkPhysicalDevice>(desc.physicalDevice)), device(static_cast<VkDevice>(desc.device)),
      queueFamily(desc.queueFamily),
      secondary(desc.recording == AGAA_VK_RECORDING_SECONDARY), dialect{.descriptorSet = desc.descriptorSet},
      pipelineCache((VkPipelineCache)desc.pipelineCache), hostMemory(allocatorOfHost) {
    caps = queryCaps(instanceFunctions, physicalDevice);
    VkPhysicalDeviceMaintenance3Properties maintenance{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES,
                                                       nullptr, 0, 0};
    VkPhysicalDeviceProperties2 device2{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &maintenance, {}};
    instanceFunctions.GetPhysicalDeviceProperties2(physicalDevice, &device2);
    const VkPhysicalDeviceLimits& limits = device2.properties.limits;
    const uint32_t apiVersion = std::min(desc.apiVersion, device2.properties.apiVersion);
    require(apiVersion >= VK_API_VERSION_1_2, AGAA_ERROR_UNSUPPORTED, "the device is below Vulkan 1.2.");
    require(dialect.descriptorSet < limits.maxBoundDescriptorSets, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaVkDeviceDesc::descriptorSet is not below the device's maxBoundDescriptorSets.");
    removeDisabledCaps(caps, desc, apiVersion);
    maxAllocation = maintenance.maxMemoryAllocationSize;
    const bool canBeDynamic = caps.flags & AGAA_DEVICE_DYNAMIC_RENDERING;
    require(canBeDynamic || desc.rendering != AGAA_VK_RENDERING_DYNAMIC, AGAA_ERROR_UNSUPPORTED,
            "dynamic rendering was asked for, but neither Vulkan 1.3 nor VK_KHR_dynamic_rendering "
            "is enabled.");
    dynamicRendering = canBeDynamic && desc.rendering != AGAA_VK_RENDERING_RENDER_PASS;
    require(caps.flags & AGAA_DEVICE_STORAGE_FORMATS, AGAA_ERROR_UNSUPPORTED,
            "the device cannot write storage images without a format.");
    instanceFunctions.GetPhysicalDeviceMemoryProperties(physicalDevice, &memory);
    uint32_t families = 0;
    instanceFunctions.GetPhysicalDeviceQueueFamilyProperties(physicalDevice, &families, nullptr);
    require(queueFamily < families, AGAA_ERROR_OUT_OF_RANGE,
            "AgaaVkDeviceDesc::queueFamily is not a family of the device.");
    std::vector<VkQueueFamilyProperties> properties(families);
    instanceFunctions.GetPhysicalDeviceQueueFamilyProperties(physicalDevice, &families, properties.data());
    constexpr VkQueueFlags needed = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    require((properties[queueFamily].queueFlags & needed) == needed, AGAA_ERROR_UNSUPPORTED,
            "the queue family does not do both graphics and compute.");
    timestampBits = std::min(properties[queueFamily].timestampValidBits, 64u);
    timestampPeriod = limits.timestampPeriod;
    granularity = limits.bufferImageGranularity;
    maxStorageImages = limits.maxPerStageDescriptorStorageImages;
    maxColorAttachments = limits.maxColorAttachments;
    if (!limits.standardSampleLocations)
        log.write(AGAA_SEVERITY_WARNING, AGAA_OK,
                  "the device does not rasterise at the standard sample locations; positions of "
                  "samples are approximate.");
    if (caps.flags & AGAA_DEVICE_NV_MIXED_SAMPLES)
        mixedSamples = truncatedSamples(instanceFunctions, physicalDevice);
    conditionalRendering = caps.flags & AGAA_DEVICE_CONDITIONAL_RENDERING;
    vk = loadDeviceTable(instanceFunctions, desc.getProcAddr, instance, device,
                         {dynamicRendering, conditionalRendering, (caps.flags & AGAA_DEVICE_SAMPLE_LOCATIONS) != 0});
    try {
        createObjects();
    } catch (...) {
        destroyObjects();
        throw;
    }
}

Context::~Context() { destroyObjects(); }

void Context::createObjects() {
    texelSampler = createSampler(*this, VK_FILTER_NEAREST, false);
    name(VK_OBJECT_TYPE_SAMPLER, (uint64_t)texelSampler, "agaa texel sampler");
    linearSampler = createSampler(*this, VK_FILTER_LINEAR, false);
    name(VK_OBJECT_TYPE_SAMPLER, (uint64_t)linearSampler, "agaa linear sampler");
    shadowSampler = createSampler(*this, VK_FILTER_LINEAR, true);
    name(VK_OBJECT_TYPE_SAMPLER, (uint64_t)shadowSampler, "agaa shadow sampler");
    if (pipelineCache)
        return;
    // Resizing recreates a view with the same pipelines, which the cache provides.
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    check(vk.CreatePipelineCache(device, &info, nullptr, &createdCache_), "vkCreatePipelineCache");
    name(VK_OBJECT_TYPE_PIPELINE_CACHE, (uint64_t)createdCache_, "agaa pipeline cache");
    pipelineCache = createdCache_;
}

void Context::destroyObjects() {
    vk.DestroySampler(device, texelSampler, nullptr);
    vk.DestroySampler(device, linearSampler, nullptr);
    vk.DestroySampler(device, shadowSampler, nullptr);
    vk.DestroyPipelineCache(device, createdCache_, nullptr);
}

void Context::checkTargets(const Plan& plan, const Pass& pass) const {
    const AgaaDrawState& state = pass.draw().state;
    const auto matches = [&](const MixedSamples& has) {
        return has.samples == state.samples && has.colors & state.colorSamples;
    };
    if (state.colorSamples && std::ranges::none_of(mixedSamples, matches))
        fail(AGAA_ERROR_UNSUPPORTED,
             format("the pass \"%s\" has %u samples and colour attachments of %u; the device does "
                    "not combine them with truncated coverage.",
                    pass.name.c_str(), state.samples, state.colorSamples));
    if (state.additive && state.colorAttachmentCount > maxColorAttachments)
        fail(AGAA_ERROR_UNSUPPORTED, format("the pass \"%s\" has %u colour attachments; the device allows %u.",
                                            pass.name.c_str(), state.colorAttachmentCount, maxColorAttachments));
    for (size_t i = 0; state.additive && i < pass.draw().colorTargets.size(); ++i) {
        const Resource& target = plan.resources[pass.draw().colorTargets[i]];
        VkFormatProperties properties{};
        instanceFunctions.GetPhysicalDeviceFormatProperties(physicalDevice, vkFormat(target.format), &properties);
        if (!(properties.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT))
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("the device does not blend %s (%s).", target.name.c_str(), formatName(target.format)));
    }
}

void Context::name(VkObjectType type, uint64_t handle, const std::string& text) const {
    if (!vk.SetDebugUtilsObjectNameEXT)
        return;
    const VkDebugUtilsObjectNameInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT, nullptr, type, handle,
                                             text.c_str()};
    vk.SetDebugUtilsObjectNameEXT(device, &info);
}

} // namespace agaa::vk
