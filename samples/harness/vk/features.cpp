#include "vk/features.h"

namespace harness::vk {

FeatureChain::FeatureChain(uint32_t apiVersion, const Extensions& has) {
    core_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    v11_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES;
    v12_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    v13_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
    dynamicRendering_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES;
    synchronization2_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES;
    conditionalRendering_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_CONDITIONAL_RENDERING_FEATURES_EXT;
    interlock_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADER_INTERLOCK_FEATURES_EXT;
    coverageReduction_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_COVERAGE_REDUCTION_MODE_FEATURES_NV;
    attachmentOrder_.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RASTERIZATION_ORDER_ATTACHMENT_ACCESS_FEATURES_EXT;
    core_.pNext = &v11_;
    v11_.pNext = &v12_;
    hasV13_ = apiVersion >= VK_API_VERSION_1_3;
    // A feature must not be in a chain twice, so only older devices use the single structs.
    void** end = &v12_.pNext;
    const auto append = [&end](auto& features) {
        *end = &features;
        end = &features.pNext;
    };
    if (hasV13_)
        append(v13_);
    if (!hasV13_ && has.dynamicRendering)
        append(dynamicRendering_);
    if (!hasV13_ && has.synchronization2)
        append(synchronization2_);
    if (has.conditionalRendering)
        append(conditionalRendering_);
    if (has.interlock)
        append(interlock_);
    if (has.attachmentOrder)
        append(attachmentOrder_);
    if (has.coverageReduction)
        append(coverageReduction_);
}

void FeatureChain::query(VkPhysicalDevice device) { vkGetPhysicalDeviceFeatures2(device, &core_); }

bool FeatureChain::isSet(std::string_view name) const {
    const VkBool32* feature = find(name);
    return feature && *feature;
}

bool FeatureChain::set(std::string_view name) {
    VkBool32* feature = const_cast<VkBool32*>(find(name));
    if (feature)
        *feature = VK_TRUE;
    return feature != nullptr;
}

const VkBool32* FeatureChain::find(std::string_view name) const {
#define FEATURE(object, member)                                                                                        \
    if (name == #member)                                                                                               \
    return &(object).member
    FEATURE(core_.features, robustBufferAccess);
    FEATURE(core_.features, imageCubeArray);
    FEATURE(core_.features, independentBlend);
    FEATURE(core_.features, geometryShader);
    FEATURE(core_.features, sampleRateShading);
    FEATURE(core_.features, depthClamp);
    FEATURE(core_.features, depthBiasClamp);
    FEATURE(core_.features, multiViewport);
    FEATURE(core_.features, samplerAnisotropy);
    FEATURE(core_.features, pipelineStatisticsQuery);
    FEATURE(core_.features, vertexPipelineStoresAndAtomics);
    FEATURE(core_.features, fragmentStoresAndAtomics);
    FEATURE(core_.features, shaderStorageImageExtendedFormats);
    FEATURE(core_.features, shaderStorageImageMultisample);
    FEATURE(core_.features, shaderStorageImageReadWithoutFormat);
    FEATURE(core_.features, shaderStorageImageWriteWithoutFormat);
    FEATURE(core_.features, shaderInt64);
    FEATURE(core_.features, shaderInt16);
    FEATURE(v11_, storageBuffer16BitAccess);
    FEATURE(v11_, shaderDrawParameters);
    FEATURE(v12_, storageBuffer8BitAccess);
    FEATURE(v12_, shaderBufferInt64Atomics);
    FEATURE(v12_, shaderFloat16);
    FEATURE(v12_, shaderInt8);
    FEATURE(v12_, imagelessFramebuffer);
    FEATURE(v12_, scalarBlockLayout);
    FEATURE(v12_, uniformBufferStandardLayout);
    FEATURE(v12_, separateDepthStencilLayouts);
    FEATURE(v12_, hostQueryReset);
    FEATURE(v12_, timelineSemaphore);
    FEATURE(v12_, bufferDeviceAddress);
    FEATURE(v12_, vulkanMemoryModel);
    FEATURE(v12_, shaderOutputViewportIndex);
    FEATURE(v12_, shaderOutputLayer);
    FEATURE(conditionalRendering_, conditionalRendering); // not set if it is not in the chain
    FEATURE(interlock_, fragmentShaderPixelInterlock);
    FEATURE(attachmentOrder_, rasterizationOrderColorAttachmentAccess);
    FEATURE(coverageReduction_, coverageReductionMode);
    if (hasV13_) {
        FEATURE(v13_, dynamicRendering);
        FEATURE(v13_, synchronization2);
        FEATURE(v13_, maintenance4);
        FEATURE(v13_, shaderDemoteToHelperInvocation);
        FEATURE(v13_, subgroupSizeControl);
        FEATURE(v13_, computeFullSubgroups);
    } else {
        FEATURE(dynamicRendering_, dynamicRendering);
        FEATURE(synchronization2_, synchronization2);
    }
#undef FEATURE
    return nullptr;
}

} // namespace harness::vk
