#include "vk/view.h"

#include "core/base/embedded.h"
#include "core/base/error.h"
#include "core/glsl/compile_glsl.h"
#include "core/glsl/glsl_text.h"
#include "core/plan/bindings.h"
#include "core/plan/planner.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace agaa::vk {

View::View(Context& device, const ViewSettings& settings)
    : View(device, makePlan(settings, device.caps, device.framesInFlight)) {}

View::View(Context& device, Plan framePlan) : ViewState(device, std::move(framePlan)), context(device) {
    positions = samplePositions(plan.view);
    for (const Pass& pass : plan.passes)
        if (pass.kind() == PassKind::HostDraw)
            context.checkTargets(plan, pass);
    try {
        resources.emplace(context, plan);
        if (plan.breadcrumbs != noResource)
            std::memset(resources->mapped(plan.breadcrumbs, 0), 0, sizeof(BreadcrumbBuffer));
        hostPasses = makeHostPasses(plan, context.dialect);
        for (const HostPass& pass : hostPasses)
            if (!pass.functionCheck.empty())
                checkFragment(pass.functionCheck, pass.functionOrigin.c_str());
        barriers = stepBarriers(plan, steps, *resources, context.conditionalRendering);
        createPassObjects();
        writeStaticDescriptors();
        createPipelineLayouts();
        addVariant(plan);
        createSlots();
    } catch (...) {
        destroy();
        throw;
    }
}

View::~View() { destroy(); }

ViewState* View::recreate(const ViewSettings& settings) const {
    return construct<View>(context.allocator, context, settings);
}

void View::destroy() {
    const DeviceTable& vk = context.vk;
    const VkDevice device = context.device;
    for (FrameSlot& slot : slots)
        vk.DestroyCommandPool(device, slot.pool, nullptr);
    vk.DestroyQueryPool(device, queries, nullptr);
    for (const uint64_t pipeline : variants.programs())
        vk.DestroyPipeline(device, (VkPipeline)pipeline, nullptr);
    for (PassObjects& objects : passes) {
        destroyHostRenderTarget(context, objects.target);
        vk.DestroyPipelineLayout(device, objects.pipelineLayout, nullptr);
        vk.DestroyDescriptorSetLayout(device, objects.setLayout, nullptr);
    }
    vk.DestroyDescriptorPool(device, descriptorPool, nullptr);
}

void View::createPassObjects() {
    passes.resize(plan.passes.size());
    std::map<VkDescriptorType, uint32_t> counts;
    uint32_t setCount = 0;
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        const Pass& pass = plan.passes[i];
        if (pass.bindings.empty())
            continue;
        const auto images = std::ranges::count(pass.bindings, BindingType::StorageImage, &Binding::type);
        if (images > context.maxStorageImages)
            fail(AGAA_ERROR_UNSUPPORTED, format("pass \"%s\" writes %u images; the device allows %u. Ask for fewer "
                                                "outputs.",
                                                pass.name.c_str(), uint32_t(images), context.maxStorageImages));
        std::vector<VkDescriptorSetLayoutBinding> bindings;
        for (const Binding& binding : pass.bindings) {
            const VkDescriptorType type = descriptorType(binding.type);
            const VkShaderStageFlags stages =
                pass.kind() == PassKind::HostDraw ? VK_SHADER_STAGE_ALL_GRAPHICS : VK_SHADER_STAGE_COMPUTE_BIT;
            bindings.push_back({binding.slot, type, 1, stages, nullptr});
            counts[type] += context.framesInFlight;
        }
        if (pass.kind() == PassKind::HostDraw && pass.draw().state.readsAttachments) {
            const uint32_t count = pass.draw().state.colorAttachmentCount;
            bindings.push_back({fetchedTargetsSlot, VK_DESCRIPTOR_TYPE_INPUT_ATTACHMENT, count,
                                VK_SHADER_STAGE_FRAGMENT_BIT, nullptr});
            counts[VK_DESCRIPTOR_TYPE_INPUT_ATTACHMENT] += count * context.framesInFlight;
        }
        setCount += context.framesInFlight;
        VkDescriptorSetLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
        info.bindingCount = uint32_t(bindings.size());
        info.pBindings = bindings.data();
        check(context.vk.CreateDescriptorSetLayout(context.device, &info, nullptr, &passes[i].setLayout),
              "vkCreateDescriptorSetLayout");
        context.name(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, (uint64_t)passes[i].setLayout, "agaa " + pass.name);
        if (pass.kind() == PassKind::HostDraw)
            createHostRenderTarget(context, plan, pass, hostPasses[i], *resources, passes[i].target);
    }
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    info.maxSets = setCount;
    info.poolSizeCount = uint32_t(sizes.size());
    info.pPoolSizes = sizes.data();
    check(context.vk.CreateDescriptorPool(context.device, &info, nullptr, &descriptorPool), "vkCreateDescriptorPool");
    context.name(VK_OBJECT_TYPE_DESCRIPTOR_POOL, (uint64_t)descriptorPool, "agaa view");
    for (PassObjects& objects : passes) {
        if (!objects.setLayout)
            continue;
        objects.sets.resize(context.framesInFlight);
        const std::vector<VkDescriptorSetLayout> layouts(context.framesInFlight, objects.setLayout);
        VkDescriptorSetAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
        allocate.descriptorPool = descriptorPool;
        allocate.descriptorSetCount = context.framesInFlight;
        allocate.pSetLayouts = layouts.data();
        check(context.vk.AllocateDescriptorSets(context.device, &allocate, objects.sets.data()),
              "vkAllocateDescriptorSets");
        for (VkDescriptorSet set : objects.sets)
            context.name(VK_OBJECT_TYPE_DESCRIPTOR_SET, (uint64_t)set, "agaa view");
    }
}

void View::createPipelineLayouts() {
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        const Pass& pass = plan.passes[i];
        if (pass.kind() != PassKind::Compute)
            continue;
        PassObjects& objects = passes[i];
        const VkDescriptorSetLayout sets[] = {objects.setLayout, (VkDescriptorSetLayout)plan.view.functionSetLayout};
        VkPipelineLayoutCreateInfo layout{};
        layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        layout.setLayoutCount = usesHostSet(pass) ? 2 : 1;
        layout.pSetLayouts = sets;
        check(context.vk.CreatePipelineLayout(context.device, &layout, nullptr, &objects.pipelineLayout),
              "vkCreatePipelineLayout");
        context.name(VK_OBJECT_TYPE_PIPELINE_LAYOUT, (uint64_t)objects.pipelineLayout, "agaa " + pass.name);
    }
}

// Other threads may record or compile at the same time: this function does not change the view.
Compiled View::compile(const Pass& pass, size_t index) {
    std::array<VkSpecializationMapEntry, ConstantCount> entries;
    for (uint32_t i = 0; i < ConstantCount; ++i)
        entries[i] = {i, i * uint32_t(sizeof(uint32_t)), sizeof(uint32_t)};
    const ComputePart& program = pass.compute();
    std::vector<uint32_t> words;
    if (program.text.empty() && program.hostCode.empty())
        words = embeddedSpirv(program.shader);
    else
        words = compileCompute(passGlsl(pass),
                               program.hostCode.empty() ? pass.name.c_str() : program.hostCodeOrigin.c_str());
    if (words.empty())
        fail(AGAA_ERROR_INTERNAL, "the library has no shader " + program.shader + ".");
    VkShaderModuleCreateInfo moduleInfo{};
    moduleInfo.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    moduleInfo.codeSize = words.size() * sizeof(uint32_t);
    moduleInfo.pCode = words.data();
    VkShaderModule module = VK_NULL_HANDLE;
    check(context.vk.CreateShaderModule(context.device, &moduleInfo, nullptr, &module), "vkCreateShaderModule");
    const VkSpecializationInfo constants{ConstantCount, entries.data(), sizeof pass.constants, pass.constants.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = &constants;
    if (program.fullSubgroups) // without the flag a subgroup may have fewer lanes than the device reports
        info.stage.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
    info.layout = passes[index].pipelineLayout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result =
        context.vk.CreateComputePipelines(context.device, context.pipelineCache, 1, &info, nullptr, &pipeline);
    context.vk.DestroyShaderModule(context.device, module, nullptr);
    check(result, "vkCreateComputePipelines");
    context.name(VK_OBJECT_TYPE_PIPELINE, (uint64_t)pipeline, "agaa " + pass.name);
    return {(uint64_t)pipeline};
}

void View::createSlots() {
    slots.resize(context.framesInFlight);
    const bool hasDraws = std::ranges::count(plan.passes, PassKind::HostDraw, &Pass::kind) != 0;
    for (FrameSlot& slot : slots) {
        if (!context.secondary || !hasDraws)
            continue;
        VkCommandPoolCreateInfo pool{};
        pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
        pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
        pool.queueFamilyIndex = context.queueFamily;
        check(context.vk.CreateCommandPool(context.device, &pool, nullptr, &slot.pool), "vkCreateCommandPool");
        context.name(VK_OBJECT_TYPE_COMMAND_POOL, (uint64_t)slot.pool, "agaa draw commands");
        slot.secondaries.resize(plan.passes.size());
        VkCommandBufferAllocateInfo allocate{};
        allocate.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
        allocate.commandPool = slot.pool;
        allocate.level = VK_COMMAND_BUFFER_LEVEL_SECONDARY;
        allocate.commandBufferCount = uint32_t(slot.secondaries.size());
        check(context.vk.AllocateCommandBuffers(context.device, &allocate, slot.secondaries.data()),
              "vkAllocateCommandBuffers");
        for (VkCommandBuffer commands : slot.secondaries)
            context.name(VK_OBJECT_TYPE_COMMAND_BUFFER, (uint64_t)commands, "agaa draw commands");
    }
    if (!timed())
        return;
    VkQueryPoolCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = uint32_t(2 * steps.size() * slots.size());
    check(context.vk.CreateQueryPool(context.device, &info, nullptr, &queries), "vkCreateQueryPool");
    context.name(VK_OBJECT_TYPE_QUERY_POOL, (uint64_t)queries, "agaa timestamps");
}

bool View::usesHostSet(const Pass& pass) const {
    return pass.kind() == PassKind::Compute && !pass.compute().hostCode.empty() && plan.view.functionSetLayout != 0;
}

bool View::timed() const { return (plan.view.config.flags & AGAA_CONFIG_TIMESTAMPS) && context.timestampBits != 0; }

} // namespace agaa::vk
