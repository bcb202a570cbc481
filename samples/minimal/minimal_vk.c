/* The smallest Vulkan host: draws a few triangles through the SDK, without a window, and writes an image.
 *   minimal_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "agaa_vk.h"
#include "vk_output.h"

#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

enum { maxPasses = 4, maxExtensions = 8, agaaSet = 0 };

typedef struct Pass {
    uint64_t key;
    VkPipelineLayout layout;
    VkPipeline pipeline;
} Pass;

typedef struct Host {
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    uint32_t queueFamily;
    VkPhysicalDeviceFeatures2 features;
    const char* extensions[maxExtensions];
    uint32_t extensionCount;
    AgaaContext context;
    AgaaView view;
    Pass passes[maxPasses];
    uint32_t passCount;
    float clipFromShading[16];
} Host;

static void createInstance(Host* host, uint32_t apiVersion) {
    const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                           .apiVersion = apiVersion};
    const VkInstanceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                       .pApplicationInfo = &application};
    check(vkCreateInstance(&info, NULL, &host->instance), "vkCreateInstance");
}

/* The first device of this version, and its first queue family for graphics and compute. */
static void choosePhysicalDevice(Host* host, uint32_t apiVersion) {
    const VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    VkPhysicalDevice devices[8];
    uint32_t deviceCount = 8, i;
    check(vkEnumeratePhysicalDevices(host->instance, &deviceCount, devices), "vkEnumeratePhysicalDevices");
    for (i = 0; i < deviceCount; ++i) {
        VkPhysicalDeviceProperties properties;
        VkQueueFamilyProperties families[16];
        uint32_t familyCount = 16;
        vkGetPhysicalDeviceProperties(devices[i], &properties);
        vkGetPhysicalDeviceQueueFamilyProperties(devices[i], &familyCount, families);
        host->physicalDevice = devices[i];
        for (host->queueFamily = 0; host->queueFamily < familyCount; ++host->queueFamily)
            if (properties.apiVersion >= apiVersion &&
                (families[host->queueFamily].queueFlags & wanted) == wanted)
                return;
    }
    fail("No Vulkan device is of version 1.2 and has a queue for graphics and compute.");
}

/* [requirements] */
static VkBool32* findFeature(VkPhysicalDeviceFeatures* features, const char* name) {
    if (strcmp(name, "fragmentStoresAndAtomics") == 0)
        return &features->fragmentStoresAndAtomics;
    if (strcmp(name, "sampleRateShading") == 0)
        return &features->sampleRateShading;
    if (strcmp(name, "shaderStorageImageExtendedFormats") == 0)
        return &features->shaderStorageImageExtendedFormats;
    if (strcmp(name, "shaderStorageImageWriteWithoutFormat") == 0)
        return &features->shaderStorageImageWriteWithoutFormat;
    fail("The SDK requires the feature \"%s\", which this host does not know.", name);
    return NULL;
}

/* Enables the required features, and of the optional extensions those that the device has. The optional
 * feature, dynamic rendering, stays off: this host's pipelines are made for render passes. */
static void chooseFeatures(Host* host, const AgaaVkRequirements* sdk) {
    static VkExtensionProperties available[1024];
    VkPhysicalDeviceFeatures supported;
    uint32_t availableCount = 1024, i, j;
    vkGetPhysicalDeviceFeatures(host->physicalDevice, &supported);
    host->features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    for (i = 0; i < sdk->requiredFeatureCount; ++i) {
        if (!*findFeature(&supported, sdk->requiredFeatures[i]))
            fail("The device lacks the feature \"%s\".", sdk->requiredFeatures[i]);
        *findFeature(&host->features.features, sdk->requiredFeatures[i]) = VK_TRUE;
    }
    check(vkEnumerateDeviceExtensionProperties(host->physicalDevice, NULL, &availableCount, available),
          "vkEnumerateDeviceExtensionProperties");
    for (i = 0; i < sdk->optionalDeviceExtensionCount && host->extensionCount < maxExtensions; ++i)
        for (j = 0; j < availableCount; ++j)
            if (strcmp(available[j].extensionName, sdk->optionalDeviceExtensions[i]) == 0)
                host->extensions[host->extensionCount++] = sdk->optionalDeviceExtensions[i];
}
/* [/requirements] */

static void createDevice(Host* host) {
    const float priority = 1.0f;
    const VkDeviceQueueCreateInfo queue = {.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                           .queueFamilyIndex = host->queueFamily,
                                           .queueCount = 1,
                                           .pQueuePriorities = &priority};
    const VkDeviceCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                     .pNext = &host->features,
                                     .queueCreateInfoCount = 1,
                                     .pQueueCreateInfos = &queue,
                                     .enabledExtensionCount = host->extensionCount,
                                     .ppEnabledExtensionNames = host->extensions};
    check(vkCreateDevice(host->physicalDevice, &info, NULL, &host->device), "vkCreateDevice");
}

/* [context] */
static AgaaVkFunction AGAA_CALL getProcAddr(void* instance, const char* name) {
    return (AgaaVkFunction)vkGetInstanceProcAddr((VkInstance)instance, name);
}

static void createContext(Host* host) {
    AgaaLog log = AGAA_LOG_INIT;
    AgaaVkContextDesc desc = AGAA_VK_CONTEXT_DESC_INIT;
    log.callback = onLog;
    desc.instance = host->instance;
    desc.physicalDevice = host->physicalDevice;
    desc.device = host->device;
    desc.queueFamily = host->queueFamily;
    desc.apiVersion = VK_API_VERSION_1_2;
    desc.getProcAddr = getProcAddr;
    desc.enabledExtensions = host->extensions;
    desc.enabledExtensionCount = host->extensionCount;
    desc.enabledFeatures = &host->features;
    desc.descriptorSet = agaaSet;
    desc.framesInFlight = 1; /* this host waits for each frame */
    desc.log = &log;
    checkSdk(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &host->context), "agaaVkCreateContext");
}
/* [/context] */

/* [view] */
static void createView(Host* host) {
    const AgaaConfig config = sceneConfig();
    const AgaaSceneFacts facts = sceneFacts();
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT;
    desc.width = width;
    desc.height = height;
    desc.config = &config;
    desc.facts = &facts;
    checkSdk(agaaVkGetContextCaps(host->context, &caps), "agaaVkGetContextCaps");
    checkSdk(agaaQueryMemory(&desc, &caps, NULL, &memory, NULL, NULL), "agaaQueryMemory");
    printf("%s: %.0f bytes per pixel\n", caps.deviceName, memory.bytesPerPixel);
    checkSdk(agaaVkCreateView(host->context, &desc, &host->view), "agaaVkCreateView");
}
/* [/view] */

/* [compile] */
static VkShaderModule compile(const Host* host, glslang_stage_t stage, const char* extensions,
                              const char* declarations, const char* code) {
    static char text[1 << 18];
    const int messages = GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT;
    const glslang_input_t input = {.language = GLSLANG_SOURCE_GLSL,
                                   .stage = stage,
                                   .client = GLSLANG_CLIENT_VULKAN,
                                   .client_version = GLSLANG_TARGET_VULKAN_1_2,
                                   .target_language = GLSLANG_TARGET_SPV,
                                   .target_language_version = GLSLANG_TARGET_SPV_1_5,
                                   .code = text,
                                   .messages = (glslang_messages_t)messages,
                                   .resource = glslang_default_resource()};
    glslang_program_t* program = glslang_program_create();
    glslang_shader_t* shader = glslang_shader_create(&input);
    VkShaderModuleCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    VkShaderModule module;
    if (snprintf(text, sizeof text, "#version 450\n%s%s%s", extensions, declarations, code) >=
        (int)sizeof text)
        fail("A shader is longer than this host expects.");
    if (!glslang_shader_preprocess(shader, &input) || !glslang_shader_parse(shader, &input))
        fail("A shader does not compile: %s", glslang_shader_get_info_log(shader));
    glslang_program_add_shader(program, shader);
    if (!glslang_program_link(program, messages))
        fail("A shader does not link: %s", glslang_program_get_info_log(program));
    glslang_program_SPIRV_generate(program, stage);
    info.codeSize = glslang_program_SPIRV_get_size(program) * sizeof(uint32_t);
    info.pCode = glslang_program_SPIRV_get_ptr(program);
    check(vkCreateShaderModule(host->device, &info, NULL, &module), "vkCreateShaderModule");
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return module;
}
/* [/compile] */

static Pass createPass(const Host* host, const AgaaVkDrawPass* sdk, VkShaderModule vertex) {
    static const VkCompareOp compareOps[] = {VK_COMPARE_OP_LESS, VK_COMPARE_OP_GREATER,
                                             VK_COMPARE_OP_EQUAL, VK_COMPARE_OP_ALWAYS};
    /* [layout] */
    const VkDescriptorSetLayout set = (VkDescriptorSetLayout)sdk->descriptorSetLayout;
    const VkPushConstantRange push = {VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof host->clipFromShading};
    const VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                               .setLayoutCount = 1, /* agaaSet is 0 */
                                               .pSetLayouts = &set,
                                               .pushConstantRangeCount = 1,
                                               .pPushConstantRanges = &push};
    /* [/layout] */
    const VkPipelineShaderStageCreateInfo stages[2] = {
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_VERTEX_BIT,
         .module = vertex, .pName = "main"},
        {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
         .stage = VK_SHADER_STAGE_FRAGMENT_BIT,
         .module = compile(host, GLSLANG_STAGE_FRAGMENT, sdk->glslExtensions, sdk->glslDeclarations,
                           materialCode),
         .pName = "main"}};
    const VkPipelineVertexInputStateCreateInfo input = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    const VkPipelineInputAssemblyStateCreateInfo assembly = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1, .scissorCount = 1};
    /* [state] */
    const VkPipelineRasterizationStateCreateInfo rasterization = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
        .cullMode = VK_CULL_MODE_NONE, /* the host's choice, but the same in every pass */
        .lineWidth = 1.0f};
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
        .depthCompareOp = compareOps[sdk->state.depthCompare],
        .stencilTestEnable = sdk->state.stencilTest,
        .front = stencil, .back = stencil};
    const VkPipelineColorBlendAttachmentState target = {.colorWriteMask = sdk->state.colorWriteMask};
    const VkPipelineColorBlendAttachmentState targets[4] = {target, target, target, target};
    const VkPipelineColorBlendStateCreateInfo blend = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = sdk->state.colorAttachmentCount,
        .pAttachments = targets};
    /* [/state] */
    const VkDynamicState dynamics[2] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = dynamics};
    VkGraphicsPipelineCreateInfo info = {.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
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
                                         .renderPass = (VkRenderPass)sdk->renderPass};
    Pass pass = {.key = sdk->pipelineKey};
    check(vkCreatePipelineLayout(host->device, &layout, NULL, &pass.layout), "vkCreatePipelineLayout");
    info.layout = pass.layout;
    check(vkCreateGraphicsPipelines(host->device, VK_NULL_HANDLE, 1, &info, NULL, &pass.pipeline),
          "vkCreateGraphicsPipelines");
    vkDestroyShaderModule(host->device, stages[1].module, NULL);
    return pass;
}

/* [passes] */
static void createPasses(Host* host) {
    AgaaVkDrawPass passes[maxPasses] = {AGAA_VK_DRAW_PASS_INIT, AGAA_VK_DRAW_PASS_INIT,
                                        AGAA_VK_DRAW_PASS_INIT, AGAA_VK_DRAW_PASS_INIT};
    VkShaderModule vertex;
    uint32_t i;
    host->passCount = maxPasses;
    checkSdk(agaaVkGetDrawPasses(host->view, &host->passCount, passes), "agaaVkGetDrawPasses");
    glslang_initialize_process();
    vertex = compile(host, GLSLANG_STAGE_VERTEX, "#define VERTEX gl_VertexIndex\n",
                     "layout(push_constant) uniform Push { mat4 clipFromShading; };\n", vertexCode);
    for (i = 0; i < host->passCount; ++i)
        host->passes[i] = createPass(host, &passes[i], vertex);
    glslang_finalize_process();
    vkDestroyShaderModule(host->device, vertex, NULL);
}
/* [/passes] */

/* [draw] */
static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
    const Host* host = (const Host*)user;
    const VkCommandBuffer commands = (VkCommandBuffer)target->commandBuffer;
    const VkDescriptorSet set = (VkDescriptorSet)target->descriptorSet;
    const VkViewport viewport = {0.0f, 0.0f, (float)target->width, (float)target->height, 0.0f, 1.0f};
    const VkRect2D scissor = {{0, 0}, {target->width, target->height}};
    const Pass* pass = host->passes;
    while (pass->key != target->pipelineKey)
        if (++pass == host->passes + host->passCount)
            return AGAA_ERROR_CALLBACK;
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->layout, agaaSet, 1, &set, 0,
                            NULL);
    vkCmdPushConstants(commands, pass->layout, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof host->clipFromShading,
                       host->clipFromShading);
    vkCmdDraw(commands, vertexCount, 1, 0, 0);
    return AGAA_OK;
}
/* [/draw] */

/* [record] */
static void recordFrame(Host* host, uint64_t frameIndex, const Output* output, VkCommandBuffer commands) {
    AgaaFrame frame = sceneFrame(0.0f);
    AgaaVkFrame vkFrame = AGAA_VK_FRAME_INIT;
    memcpy(host->clipFromShading, frame.projection, sizeof host->clipFromShading);
    frame.frameIndex = frameIndex;
    frame.completedFrame = frameIndex - 1; /* the one before has been waited for */
    frame.draw = draw;
    frame.drawUser = host;
    vkFrame.commandBuffer = commands;
    vkFrame.outputImage = (uint64_t)output->image;
    vkFrame.outputView = (uint64_t)output->view;
    vkFrame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED;
    vkFrame.outputLayoutOut = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    checkSdk(agaaVkRecordFrame(host->view, &frame, &vkFrame), "agaaVkRecordFrame");
}
/* [/record] */

static void renderFrames(Host* host, const Output* output) {
    const VkCommandPoolCreateInfo poolInfo = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                              .queueFamilyIndex = host->queueFamily};
    const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                            .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    VkCommandBufferAllocateInfo allocation = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                              .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                              .commandBufferCount = 1};
    VkCommandBuffer commands;
    const VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                                 .commandBufferCount = 1,
                                 .pCommandBuffers = &commands};
    VkQueue queue;
    uint64_t i;
    vkGetDeviceQueue(host->device, host->queueFamily, 0, &queue);
    check(vkCreateCommandPool(host->device, &poolInfo, NULL, &allocation.commandPool), "vkCreateCommandPool");
    check(vkAllocateCommandBuffers(host->device, &allocation, &commands), "vkAllocateCommandBuffers");
    for (i = 1; i <= frameCount; ++i) {
        check(vkResetCommandPool(host->device, allocation.commandPool, 0), "vkResetCommandPool");
        check(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
        recordFrame(host, i, output, commands);
        recordReadback(output, commands);
        check(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
        check(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit");
        check(vkQueueWaitIdle(queue), "vkQueueWaitIdle");
        reportFrame(host->view, i);
    }
    vkDestroyCommandPool(host->device, allocation.commandPool, NULL);
}

/* [destroy] */
static void destroy(Host* host, const Output* output) {
    uint32_t i;
    agaaDestroyView(host->view);
    agaaDestroyContext(host->context);
    for (i = 0; i < host->passCount; ++i) {
        vkDestroyPipeline(host->device, host->passes[i].pipeline, NULL);
        vkDestroyPipelineLayout(host->device, host->passes[i].layout, NULL);
    }
    destroyOutput(host->device, output);
    vkDestroyDevice(host->device, NULL);
    vkDestroyInstance(host->instance, NULL);
}
/* [/destroy] */

int main(int argumentCount, char** arguments) {
    AgaaVkRequirements requirements = AGAA_VK_REQUIREMENTS_INIT;
    Host host = {0};
    Output output;
    if (argumentCount != 2)
        fail("Usage: minimal_vk IMAGE.ppm");
    checkSdk(agaaVkGetRequirements(&requirements), "agaaVkGetRequirements");
    createInstance(&host, requirements.apiVersion);
    choosePhysicalDevice(&host, requirements.apiVersion);
    chooseFeatures(&host, &requirements);
    createDevice(&host);
    createContext(&host);
    createView(&host);
    createPasses(&host);
    output = createOutput(host.physicalDevice, host.device);
    renderFrames(&host, &output);
    writeImage(arguments[1], output.pixels);
    destroy(&host, &output);
    return EXIT_SUCCESS;
}
