/* The parts that the minimal Vulkan hosts share: a device without a window, the SDK's context, passes, frames and
 * the output.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "agaa_vk.h"
#include "host.h"

#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>
#include <vulkan/vulkan.h>

typedef struct Host {
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    VkImage output;
    VkImageView outputView;
    VkDeviceMemory outputMemory;
    AgaaContext context;
    AgaaView view;
    uint32_t passCount;
    uint64_t keys[maxPasses];
    VkPipelineLayout layouts[maxPasses];
    VkPipeline pipelines[maxPasses];
    VkDescriptorSet functionSet;     /* set of the host's functions; null in minimal_vk */
    VkDescriptorSetLayout vertexSet; /* layout of functionSet if vertex shaders read it, too */
    void (*recordHostPass)(const struct Host*, VkCommandBuffer); /* records the host's pass, or NULL */
    AgaaFrame frame;
} Host;

/* The features that agaaVkGetRequirements requires. ids_vk adds one more. Dynamic rendering is optional and stays
 * off. */
static VkPhysicalDeviceFeatures2 enabledFeatures = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2,
                                                    .features = {.fragmentStoresAndAtomics = VK_TRUE,
                                                                 .sampleRateShading = VK_TRUE,
                                                                 .shaderStorageImageExtendedFormats = VK_TRUE,
                                                                 .shaderStorageImageWriteWithoutFormat = VK_TRUE}};

/* Creates the first device with its first queue family, which supports graphics and compute on every common driver. */
static void createDevice(Host* host) {
    const VkApplicationInfo app = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_2};
    const VkInstanceCreateInfo instance = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &app};
    const VkDeviceQueueCreateInfo queue = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = (float[]){1.0f}};
    const VkDeviceCreateInfo device = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                       .pNext = &enabledFeatures,
                                       .queueCreateInfoCount = 1,
                                       .pQueueCreateInfos = &queue};
    uint32_t count = 1;
    CHECK(vkCreateInstance(&instance, NULL, &host->instance));
    CHECK(vkEnumeratePhysicalDevices(host->instance, &count, &host->physicalDevice));
    require(count == 1, "There is no Vulkan device.");
    CHECK(vkCreateDevice(host->physicalDevice, &device, NULL, &host->device));
}

enum { mappedMemory = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT };
/* Returns the address of the mapped memory, or NULL if the memory is not host-visible. */
static void* allocate(const Host* host, const VkMemoryRequirements* needed, VkFlags wanted, VkDeviceMemory* memory) {
    VkMemoryAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needed->size};
    VkPhysicalDeviceMemoryProperties types;
    void* mapped = NULL;
    vkGetPhysicalDeviceMemoryProperties(host->physicalDevice, &types);
    while (!(needed->memoryTypeBits >> info.memoryTypeIndex & 1) ||
           (types.memoryTypes[info.memoryTypeIndex].propertyFlags & wanted) != wanted)
        require(++info.memoryTypeIndex < types.memoryTypeCount, "No memory serves what is asked of it.");
    CHECK(vkAllocateMemory(host->device, &info, NULL, memory));
    if (wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
        CHECK(vkMapMemory(host->device, *memory, 0, VK_WHOLE_SIZE, 0, &mapped));
    return mapped;
}

/* Creates a linear, mapped image, so that the CPU can read the output. An engine passes its own image. */
static const float* createOutput(Host* host) {
    const VkImageCreateInfo image = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                     .imageType = VK_IMAGE_TYPE_2D,
                                     .extent = {width, height, 1},
                                     .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                                     .mipLevels = 1,
                                     .arrayLayers = 1,
                                     .samples = VK_SAMPLE_COUNT_1_BIT,
                                     .tiling = VK_IMAGE_TILING_LINEAR,
                                     .usage = VK_IMAGE_USAGE_STORAGE_BIT};
    const VkImageSubresource color = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0};
    VkImageFormatProperties limits;
    VkSubresourceLayout rows;
    VkMemoryRequirements needed;
    CHECK(vkGetPhysicalDeviceImageFormatProperties(host->physicalDevice, image.format, image.imageType, image.tiling,
                                                   image.usage, 0, &limits));
    CHECK(vkCreateImage(host->device, &image, NULL, &host->output));
    vkGetImageMemoryRequirements(host->device, host->output, &needed);
    vkGetImageSubresourceLayout(host->device, host->output, &color, &rows);
    require(rows.offset == 0 && rows.rowPitch == width * 4 * sizeof(float), "The rows of the image have gaps.");
    const void* pixels = allocate(host, &needed, mappedMemory, &host->outputMemory);
    CHECK(vkBindImageMemory(host->device, host->output, host->outputMemory, 0));
    const VkImageViewCreateInfo view = {.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                        .image = host->output,
                                        .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                        .format = image.format,
                                        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    CHECK(vkCreateImageView(host->device, &view, NULL, &host->outputView));
    return pixels;
}

static void createContext(Host* host) {
    AgaaLog log = AGAA_LOG_INIT;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    AgaaVkDeviceDesc device = AGAA_VK_DEVICE_DESC_INIT;
    log.callback = onLog;
    device.instance = host->instance, device.physicalDevice = host->physicalDevice, device.device = host->device;
    device.queueFamily = 0, device.apiVersion = VK_API_VERSION_1_2;
    device.getProcAddr = (AgaaVkGetInstanceProcAddr)vkGetInstanceProcAddr;
    device.enabledFeatures = &enabledFeatures, device.descriptorSet = 0;
    desc.pNext = &device, desc.log = &log;
    desc.framesInFlight = 1; /* the hosts wait for each frame */
    CHECK(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &host->context));
}

static VkShaderModule compile(const Host* host, glslang_stage_t stage, const char* extensions, const char* declarations,
                              const char* code) {
    static char text[1 << 18];
    const glslang_messages_t messages = GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT;
    const glslang_input_t input = {.language = GLSLANG_SOURCE_GLSL,
                                   .stage = stage,
                                   .code = text,
                                   .resource = glslang_default_resource(),
                                   .client = GLSLANG_CLIENT_VULKAN,
                                   .client_version = GLSLANG_TARGET_VULKAN_1_2,
                                   .messages = messages,
                                   .target_language = GLSLANG_TARGET_SPV,
                                   .target_language_version = GLSLANG_TARGET_SPV_1_5};
    const int length = snprintf(text, sizeof text, "#version 450\n%s%s%s", extensions, declarations, code);
    glslang_program_t* program = glslang_program_create();
    glslang_shader_t* shader = glslang_shader_create(&input);
    VkShaderModule module;
    require(length < (int)sizeof text, "A shader is longer than this host expects.");
    require(glslang_shader_preprocess(shader, &input) && glslang_shader_parse(shader, &input),
            glslang_shader_get_info_log(shader));
    glslang_program_add_shader(program, shader);
    require(glslang_program_link(program, messages), glslang_program_get_info_log(program));
    glslang_program_SPIRV_generate(program, stage);
    const VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                           .pCode = glslang_program_SPIRV_get_ptr(program),
                                           .codeSize = glslang_program_SPIRV_get_size(program) * sizeof(uint32_t)};
    CHECK(vkCreateShaderModule(host->device, &info, NULL, &module));
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return module;
}

static void createPass(Host* host, uint32_t i, const AgaaDrawPass* sdk, VkShaderModule vertex, const char* code) {
    const AgaaVkDrawPass* vk = sdk->pNext;
    const VkCompareOp ops[] = {VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER, VK_COMPARE_OP_EQUAL, VK_COMPARE_OP_ALWAYS};
    const VkShaderModule fragment =
        compile(host, GLSLANG_STAGE_FRAGMENT, sdk->glslExtensions, sdk->glslDeclarations, code);
    const VkDescriptorSetLayout sets[2] = {(VkDescriptorSetLayout)vk->descriptorSetLayout, host->vertexSet};
    const VkPushConstantRange push = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof host->frame.projection};
    const VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                               .setLayoutCount = host->vertexSet ? 2 : 1,
                                               .pSetLayouts = sets,
                                               .pushConstantRangeCount = 1,
                                               .pPushConstantRanges = &push};
    const VkPipelineShaderStageCreateInfo stages[2] = {{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                        .stage = VK_SHADER_STAGE_VERTEX_BIT,
                                                        .module = vertex,
                                                        .pName = "main"},
                                                       {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                        .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
                                                        .module = fragment,
                                                        .pName = "main"}};
    const VkPipelineVertexInputStateCreateInfo input = {.sType =
                                                            VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO, .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO, .viewportCount = 1, .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo rasterization = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1.0f}; /* no pass culls */
    const VkPipelineMultisampleStateCreateInfo multisample = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = (VkSampleCountFlagBits)sdk->state.samples,
        .sampleShadingEnable = sdk->state.sampleShading,
        .minSampleShading = 1.0f};
    const VkStencilOpState stencil = {.passOp = VK_STENCIL_OP_INCREMENT_AND_CLAMP,
                                      .compareOp = VK_COMPARE_OP_EQUAL,
                                      .compareMask = 0xFF,
                                      .writeMask = 0xFF};
    const VkPipelineDepthStencilStateCreateInfo depthStencil = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = VK_TRUE,
        .depthWriteEnable = sdk->state.depthWrite,
        .depthCompareOp = ops[sdk->state.depthCompare],
        .stencilTestEnable = sdk->state.stencilTest,
        .front = stencil,
        .back = stencil};
    const VkPipelineColorBlendAttachmentState target = {.blendEnable = sdk->state.keepFirst,
                                                        .colorWriteMask = sdk->state.colorWriteMask,
                                                        .srcColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
                                                        .dstColorBlendFactor = VK_BLEND_FACTOR_ONE,
                                                        .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
                                                        .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE};
    const VkPipelineColorBlendAttachmentState targets[4] = {target, target, target, target};
    const VkPipelineColorBlendStateCreateInfo blend = {.sType =
                                                           VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
                                                       .attachmentCount = sdk->state.colorAttachmentCount,
                                                       .pAttachments = targets};
    const VkPipelineDynamicStateCreateInfo dynamic = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = (VkDynamicState[]){VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR}};
    host->keys[i] = sdk->pipelineKey;
    CHECK(vkCreatePipelineLayout(host->device, &layout, NULL, &host->layouts[i]));
    const VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
                                               .stageCount = 2,
                                               .pStages = stages,
                                               .pVertexInputState = &input,
                                               .pInputAssemblyState = &assembly,
                                               .pViewportState = &viewport,
                                               .pRasterizationState = &rasterization,
                                               .pMultisampleState = &multisample,
                                               .pDepthStencilState = &depthStencil,
                                               .pColorBlendState = &blend,
                                               .pDynamicState = &dynamic,
                                               .layout = host->layouts[i],
                                               .renderPass = (VkRenderPass)vk->renderPass};
    CHECK(vkCreateGraphicsPipelines(host->device, VK_NULL_HANDLE, 1, &info, NULL, &host->pipelines[i]));
    vkDestroyShaderModule(host->device, fragment, NULL);
}

/* Creates the pipelines of the SDK's passes, and of the host's own pass if it is not NULL.
 * vertices   code of the vertex shader, which all passes share
 * materials  code of the fragment shaders */
static void createPasses(Host* host, const AgaaDrawPass* hostPass, const char* vertices, const char* materials) {
    AgaaDrawPass passes[maxPasses];
    AgaaVkDrawPass vkPasses[maxPasses];
    for (int i = 0; i < maxPasses; ++i) {
        agaaInitDrawPass(&passes[i], sizeof passes[i]);
        agaaInitVkDrawPass(&vkPasses[i], sizeof vkPasses[i]);
        passes[i].pNext = &vkPasses[i];
    }
    host->passCount = maxPasses;
    CHECK(agaaGetDrawPasses(host->view, &host->passCount, passes));
    require(!hostPass || host->passCount < maxPasses, "The SDK has more passes than this host expects.");
    if (hostPass)
        passes[host->passCount++] = *hostPass;
    glslang_initialize_process();
    const VkShaderModule vertex = compile(host, GLSLANG_STAGE_VERTEX, "#define VERTEX gl_VertexIndex\n",
                                          "layout(push_constant) uniform Push { mat4 clipFromShading; };\n", vertices);
    for (uint32_t i = 0; i < host->passCount; ++i)
        createPass(host, i, &passes[i], vertex, materials);
    vkDestroyShaderModule(host->device, vertex, NULL);
    glslang_finalize_process();
}

static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = user;
    const VkCommandBuffer commands = target->commandBuffer;
    const VkDescriptorSet sets[2] = {(VkDescriptorSet)target->descriptorSet, host->functionSet};
    const VkViewport viewport = {0.0f, 0.0f, (float)target->width, (float)target->height, 0.0f, 1.0f};
    const VkRect2D scissor = {{0, 0}, {target->width, target->height}};
    uint32_t pass = 0;
    while (host->keys[pass] != target->pipelineKey)
        if (++pass == host->passCount)
            return AGAA_ERROR_CALLBACK;
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, host->pipelines[pass]);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, host->layouts[pass], 0, host->vertexSet ? 2 : 1,
                            sets, 0, NULL);
    vkCmdPushConstants(commands, host->layouts[pass], VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof host->frame.projection,
                       host->frame.projection);
    for (uint32_t i = 0; i < drawCount; ++i) /* the first instance is the number of the draw */
        vkCmdDraw(commands, drawBegin[i + 1] - drawBegin[i], 1, drawBegin[i], i);
    return AGAA_OK;
}

static void renderFrames(Host* host) {
    const VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    const VkMemoryBarrier out = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                 .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
                                 .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    VkCommandBufferAllocateInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandBufferCount = 1};
    VkCommandBuffer commands;
    const VkSubmitInfo submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    VkQueue queue;
    vkGetDeviceQueue(host->device, 0, 0, &queue);
    CHECK(vkCreateCommandPool(host->device, &poolInfo, NULL, &info.commandPool));
    CHECK(vkAllocateCommandBuffers(host->device, &info, &commands));
    vkFrame.commandBuffer = commands;
    vkFrame.outputImage = (uint64_t)host->output, vkFrame.outputView = (uint64_t)host->outputView;
    vkFrame.functionSet = (uint64_t)host->functionSet;
    vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED, vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_GENERAL;
    for (uint64_t i = 1; i <= frameCount; ++i) {
        host->frame = describeFrame(i, 0.0f);
        host->frame.draw = host->passCount > 0 ? draw : NULL, host->frame.drawUser = host;
        CHECK(vkResetCommandPool(host->device, info.commandPool, 0));
        CHECK(vkBeginCommandBuffer(commands, &begin));
        if (host->recordHostPass)
            host->recordHostPass(host, commands);
        CHECK(agaaVkRecordFrame(host->view, &host->frame, &vkFrame));
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &out, 0,
                             NULL, 0, NULL);
        CHECK(vkEndCommandBuffer(commands));
        CHECK(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE));
        CHECK(vkQueueWaitIdle(queue));
        reportFrame(host->view, i);
    }
    vkDestroyCommandPool(host->device, info.commandPool, NULL);
}

static void destroy(Host* host) {
    agaaDestroyView(host->view);
    CHECK(agaaDestroyContext(host->context));
    for (uint32_t i = 0; i < host->passCount; ++i) {
        vkDestroyPipeline(host->device, host->pipelines[i], NULL);
        vkDestroyPipelineLayout(host->device, host->layouts[i], NULL);
    }
    vkDestroyImageView(host->device, host->outputView, NULL);
    vkDestroyImage(host->device, host->output, NULL);
    vkFreeMemory(host->device, host->outputMemory, NULL);
    vkDestroyDevice(host->device, NULL);
    vkDestroyInstance(host->instance, NULL);
}
