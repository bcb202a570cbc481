// AgaaVkDeviceDesc and agaaVkCreateContext.
#include "cases.h"
#include "creation.h"
#include "vk_interposer.h"

#include "cases/core/header_check.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>

namespace agaa::conformance {

std::vector<ContextRow> wrongVulkanContexts(const Device&) {
    const auto initialAllocator = [] {
        AgaaVkAllocator allocator = AGAA_VK_ALLOCATOR_INIT;
        return allocator;
    };
    static AgaaVkAllocator noCallbacks = initialAllocator(), onlyAllocate = initialAllocator(),
                           onlyFree = initialAllocator();
    onlyAllocate.allocate = [](void*, const AgaaVkAllocationInfo*, AgaaVkMemory*) -> AgaaResult {
        return AGAA_ERROR_CALLBACK;
    };
    onlyFree.free = [](void*, const AgaaVkMemory*) {};
    static const VkBaseInStructure noFeatures2 = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES, nullptr};
    std::vector<ContextRow> rows;
    const auto add = [&](const char* what, AgaaResult expected, const char* words, ChangeContext change) {
        rows.push_back({what, expected, words, std::move(change)});
    };
    constexpr AgaaResult invalid = AGAA_ERROR_INVALID_ARGUMENT, range = AGAA_ERROR_OUT_OF_RANGE;
    using D = ContextDescription;
    add("AgaaVkDeviceDesc::instance = null", invalid, "instance", [](D& d) { d.vk.instance = nullptr; });
    add("AgaaVkDeviceDesc::physicalDevice = null", invalid, "physical", [](D& d) { d.vk.physicalDevice = nullptr; });
    add("AgaaVkDeviceDesc::device = null", invalid, "device", [](D& d) { d.vk.device = nullptr; });
    add("AgaaVkDeviceDesc::getProcAddr = null", invalid, "getProcAddr", [](D& d) { d.vk.getProcAddr = nullptr; });
    add("AgaaVkDeviceDesc::enabledExtensions = null", invalid, "enabledExtensions", [](D& d) {
        d.vk.enabledExtensions = nullptr;
        d.vk.enabledExtensionCount = 1;
    });
    add("AgaaVkDeviceDesc::enabledFeatures of another type", invalid, "enabledFeatures",
        [](D& d) { d.vk.enabledFeatures = &noFeatures2; });
    add("an AgaaVkAllocator without callbacks", invalid, "AgaaVkAllocator", [](D& d) { d.desc.pNext = &noCallbacks; });
    add("an AgaaVkAllocator without free", invalid, "AgaaVkAllocator", [](D& d) { d.desc.pNext = &onlyAllocate; });
    add("an AgaaVkAllocator without allocate", invalid, "AgaaVkAllocator", [](D& d) { d.desc.pNext = &onlyFree; });
    add("AgaaVkDeviceDesc::descriptorSet = 8", range, "descriptorSet", [](D& d) { d.vk.descriptorSet = 8; });
    add("AgaaVkDeviceDesc::descriptorSet = 0xFFFFFFFF", range, "descriptorSet",
        [](D& d) { d.vk.descriptorSet = 0xFFFFFFFF; });
    add("AgaaVkDeviceDesc::queueFamily = 0xFFFFFFFF", range, "queueFamily",
        [](D& d) { d.vk.queueFamily = 0xFFFFFFFF; });
    add("AgaaVkDeviceDesc::rendering = 0x7FFFFFFF", range, "rendering", [](D& d) { d.vk.rendering = 0x7FFFFFFF; });
    add("AgaaVkDeviceDesc::rendering = 3", range, "rendering", [](D& d) { d.vk.rendering = 3; });
    add("AgaaVkDeviceDesc::recording = 0x7FFFFFFF", range, "recording", [](D& d) { d.vk.recording = 0x7FFFFFFF; });
    add("AgaaVkDeviceDesc::recording = 2", range, "recording", [](D& d) { d.vk.recording = 2; });
    for (const uint32_t version : {VK_API_VERSION_1_1, VK_API_VERSION_1_0, 0u})
        rows.push_back({"AgaaVkDeviceDesc::apiVersion = " + std::to_string(version), AGAA_ERROR_UNSUPPORTED, "1.2",
                        [=](D& d) { d.vk.apiVersion = version; }});
    return rows;
}

namespace {

void testMember(Test& test, const std::string& member, const std::vector<uint32_t>& accepted,
                const std::function<void(AgaaVkDeviceDesc&, uint32_t)>& set) {
    for (const uint32_t value : accepted)
        expectContextAccepted(test, "AgaaVkDeviceDesc::" + member + " = " + std::to_string(value),
                              [&](ContextDescription& d) { set(d.vk, value); });
    for (const ContextRow& row : wrongVulkanContexts(test.device()))
        if (row.words == member)
            expectContextRefused(test, row);
}

uint32_t setsOf(Test& test) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(static_cast<VkPhysicalDevice>(test.device().description().vk.physicalDevice),
                                  &properties);
    return properties.limits.maxBoundDescriptorSets;
}

void testDescriptorSet(Test& test) {
    std::vector<uint32_t> accepted;
    for (uint32_t i = 0; i < 8 && i < setsOf(test); ++i)
        accepted.push_back(i);
    testMember(test, "descriptorSet", accepted, [](AgaaVkDeviceDesc& d, uint32_t value) { d.descriptorSet = value; });
}

// Simulates a device that can bind four descriptor sets.
void testSetLimit(Test& test) {
    VulkanInterposer vulkan;
    vulkan.changeProperties = [](VkPhysicalDeviceProperties& p) { p.limits.maxBoundDescriptorSets = 4; };
    const auto with = [](uint32_t set) {
        return [=](ContextDescription& d) {
            d.vk.getProcAddr = VulkanInterposer::getProcAddr;
            d.vk.descriptorSet = set;
        };
    };
    expectContextAccepted(test, "AgaaVkDeviceDesc::descriptorSet = 3 on a device with four", with(3));
    expectContextRefused(test, {"AgaaVkDeviceDesc::descriptorSet = 4 on a device with four", AGAA_ERROR_OUT_OF_RANGE,
                                "descriptorSet", with(4)});
}

void testRendering(Test& test) {
    testMember(test, "rendering", {AGAA_VK_RENDERING_AUTO, AGAA_VK_RENDERING_RENDER_PASS},
               [](AgaaVkDeviceDesc& d, uint32_t value) { d.rendering = value; });
    // The suite's device is created without dynamic rendering.
    expectContextRefused(test, {"AGAA_VK_RENDERING_DYNAMIC on a device without it", AGAA_ERROR_UNSUPPORTED,
                                "dynamic rendering",
                                [](ContextDescription& d) { d.vk.rendering = AGAA_VK_RENDERING_DYNAMIC; }});
}

AgaaDeviceCaps capsWith(Test& test, const ChangeContext& change) {
    ScopedContext context(test, change);
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    test.requireOk(test.device().getContextCaps(test.sdk, context.get(), &caps), "agaaVkGetContextCaps");
    return caps;
}

// Null stands for all features of AgaaVkRequirements. The suite's device has only the required ones if its version
// lacks dynamic rendering.
void testFeaturesNull(Test& test) {
    const auto older = [](ContextDescription& d) { d.vk.apiVersion = VK_API_VERSION_1_2; };
    const uint64_t named = capsWith(test, older).flags;
    const uint64_t unnamed = capsWith(test, [&](ContextDescription& d) {
                                 older(d);
                                 d.vk.enabledFeatures = nullptr;
                             }).flags;
    test.check(named == unnamed,
               "AgaaVkDeviceDesc::enabledFeatures = null gives the context other capabilities than the "
               "same features by name.");
    for (const uint64_t flag :
         {AGAA_DEVICE_FRAGMENT_ATOMICS, AGAA_DEVICE_SAMPLE_RATE_SHADING, AGAA_DEVICE_STORAGE_FORMATS})
        test.check(unnamed & flag, "AgaaVkDeviceDesc::enabledFeatures = null: the context lacks the flag " +
                                       std::to_string(flag) + " although the device has the feature.");
}

// The host's cache replaces the SDK's cache in all calls and outlives the context.
void testPipelineCache(Test& test) {
    const auto device = static_cast<VkDevice>(test.device().description().vk.device);
    VkPipelineCacheCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO;
    VkPipelineCache cache = VK_NULL_HANDLE;
    test.require(vkCreatePipelineCache(device, &info, nullptr, &cache) == VK_SUCCESS, "vkCreatePipelineCache fails.");
    {
        VulkanInterposer vulkan;
        ScopedContext context(test, [&](ContextDescription& d) {
            d.vk.getProcAddr = VulkanInterposer::getProcAddr;
            d.vk.pipelineCache = (uint64_t)cache;
        });
        ViewDescription description(&test.device());
        ScopedView view(test, context.get(), description);
        test.check(!vulkan.objects.count("PipelineCache"), "the SDK creates a cache although the host has one.");
        const size_t calls = vulkan.pipelineCaches.size();
        test.check(calls > 0, "a view creates no pipelines.");
        const auto others = calls - size_t(std::ranges::count(vulkan.pipelineCaches, cache));
        test.check(others == 0, std::to_string(others) + " of " + std::to_string(calls) +
                                    " calls that create pipelines do not get the host's cache.");
    }
    size_t size = 0;
    test.check(vkGetPipelineCacheData(device, cache, &size, nullptr) == VK_SUCCESS, "vkGetPipelineCacheData fails.");
    vkDestroyPipelineCache(device, cache, nullptr);
    expectNoMessages(test, "AgaaVkDeviceDesc::pipelineCache");
}

// ---- threads and headers ---------------------------------------------------------------------------

void testThreads(Test& test) {
    std::vector<std::thread> threads;
    std::atomic<uint32_t> wrong = 0;
    for (uint32_t t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (uint32_t i = 0; i < 8; ++i) {
                ContextDescription d = test.device().description();
                d.desc.pNext = &d.vk;
                d.desc.framesInFlight = (t + i) % 5; // 0 is refused
                AgaaContext context = nullptr;
                const AgaaResult result = test.sdk.agaaVkCreateContext(AGAA_HEADER_VERSION, &d.desc, &context);
                wrong += result != (d.desc.framesInFlight ? AGAA_OK : AGAA_ERROR_OUT_OF_RANGE);
                if (result == AGAA_OK)
                    wrong += test.sdk.agaaDestroyContext(context) != AGAA_OK;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    test.check(wrong == 0,
               std::to_string(wrong) + " contexts of 4 threads at once are not created as those of one thread.");
    expectNoMessages(test, "creating contexts in 4 threads");
}

// `link` chains the struct and keeps the chain of the struct.
HeaderCase chainedCase(const char* name, const std::function<void(Test&, void*)>& fill, bool isDevice) {
    const auto call = [isDevice](Test& test, void* structure, const AgaaLog* log) {
        ContextDescription right = test.device().description();
        right.desc.log = log;
        right.desc.pNext = structure;
        if (!isDevice) {
            right.vk.pNext = structure;
            right.desc.pNext = &right.vk;
        }
        AgaaContext context = nullptr;
        const AgaaResult result = test.sdk.agaaVkCreateContext(AGAA_HEADER_VERSION, &right.desc, &context);
        if (result == AGAA_OK)
            test.sdk.agaaDestroyContext(context);
        return result;
    };
    HeaderCase c = {name, "agaaVkCreateContext", fill, call};
    c.isChained = true;
    return c;
}

void fillDevice(Test& test, void* structure) {
    const AgaaVkDeviceDesc right = test.device().description().vk;
    constexpr size_t header = sizeof(AgaaStructHeader);
    std::memcpy(static_cast<char*>(structure) + header, reinterpret_cast<const char*>(&right) + header,
                sizeof right - header);
}

void fillAllocator(Test&, void* structure) {
    auto& allocator = *static_cast<AgaaVkAllocator*>(structure);
    allocator.allocate = [](void*, const AgaaVkAllocationInfo*, AgaaVkMemory*) -> AgaaResult {
        return AGAA_ERROR_CALLBACK;
    };
    allocator.free = [](void*, const AgaaVkMemory*) {};
}

} // namespace

void addVulkanContextCases(Suite& suite) {
    const auto vk = [&](const char* name, void (*run)(Test&)) { suite.add(name, {Backend::Vulkan}, run); };
    vk("AgaaVkDeviceDesc/header",
       [](Test& test) { testHeader(test, chainedCase("AgaaVkDeviceDesc", fillDevice, true)); });
    vk("AgaaVkAllocator/header",
       [](Test& test) { testHeader(test, chainedCase("AgaaVkAllocator", fillAllocator, false)); });
    vk("AgaaVkDeviceDesc.descriptorSet/range", testDescriptorSet);
    vk("AgaaVkDeviceDesc.descriptorSet/range/limit", testSetLimit);
    vk("AgaaVkDeviceDesc.rendering/enum", testRendering);
    vk("AgaaVkDeviceDesc.recording/enum", [](Test& test) {
        testMember(test, "recording", {AGAA_VK_RECORDING_SECONDARY, AGAA_VK_RECORDING_INLINE},
                   [](AgaaVkDeviceDesc& d, uint32_t value) { d.recording = value; });
    });
    vk("AgaaVkDeviceDesc.enabledFeatures/null", testFeaturesNull);
    vk("AgaaVkDeviceDesc.pipelineCache/of_the_host", testPipelineCache);
    vk("agaaVkCreateContext/threads", testThreads);
}

} // namespace agaa::conformance
