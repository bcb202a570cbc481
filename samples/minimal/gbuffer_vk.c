/* The smallest Vulkan host that draws its own multisampled G-buffer: the SDK reads it, aggregates and shades.
 *   gbuffer_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "gbuffer.h"
#include "vk.h"

static const char sampleCode[] = SAMPLE_CODE("set = 1, binding = 0", "set = 1, binding = 1", "set = 1, binding = 2");

static const VkFormat formats[imageCount] = {VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R16G16B16A16_SFLOAT,
                                             VK_FORMAT_D32_SFLOAT};

typedef struct GBuffer {
    VkImage images[imageCount];
    VkImageView views[imageCount];
    VkDeviceMemory memory[imageCount];
    VkRenderPass renderPass;
    VkFramebuffer framebuffer;
    VkSampler sampler;
    VkDescriptorSetLayout layout;
    VkDescriptorPool pool;
} GBuffer;

static GBuffer gbuffer;

static void createImage(const Host* host, int i) {
    const int isDepth = i == depthImage;
    const VkImageCreateInfo image = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .imageType = VK_IMAGE_TYPE_2D,
        .extent = {width, height, 1},
        .format = formats[i],
        .mipLevels = 1,
        .arrayLayers = 1,
        .samples = (VkSampleCountFlagBits)samples,
        .usage = VK_IMAGE_USAGE_SAMPLED_BIT |
                 (isDepth ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT)};
    VkMemoryRequirements needed;
    CHECK(vkCreateImage(host->device, &image, NULL, &gbuffer.images[i]));
    vkGetImageMemoryRequirements(host->device, gbuffer.images[i], &needed);
    allocate(host, &needed, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &gbuffer.memory[i]);
    CHECK(vkBindImageMemory(host->device, gbuffer.images[i], gbuffer.memory[i], 0));
    const VkImageViewCreateInfo view = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = gbuffer.images[i],
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = formats[i],
        .subresourceRange = {isDepth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    CHECK(vkCreateImageView(host->device, &view, NULL, &gbuffer.views[i]));
}

static VkImageLayout readLayout(int i) {
    return i == depthImage ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

/* The pass leaves the images in the layouts in which the SDK's compute shaders read them. Its dependency makes these
 * shaders wait. */
static void createRenderPass(const Host* host) {
    VkAttachmentDescription attachments[imageCount];
    const VkAttachmentReference colors[2] = {{diffuseImage, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL},
                                             {normalImage, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}};
    const VkAttachmentReference depth = {depthImage, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    const VkSubpassDescription subpass = {.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                          .colorAttachmentCount = 2,
                                          .pColorAttachments = colors,
                                          .pDepthStencilAttachment = &depth};
    const VkSubpassDependency toCompute = {
        .dstSubpass = VK_SUBPASS_EXTERNAL,
        .dstStageMask = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
        .dstAccessMask = VK_ACCESS_SHADER_READ_BIT,
        .srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                        VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
        .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
    const VkRenderPassCreateInfo info = {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                         .attachmentCount = imageCount,
                                         .pAttachments = attachments,
                                         .subpassCount = 1,
                                         .pSubpasses = &subpass,
                                         .dependencyCount = 1,
                                         .pDependencies = &toCompute};
    for (int i = 0; i < imageCount; ++i)
        attachments[i] = (VkAttachmentDescription){.format = formats[i],
                                                   .samples = (VkSampleCountFlagBits)samples,
                                                   .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                   .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                                   .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                                   .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                                   .finalLayout = readLayout(i)};
    CHECK(vkCreateRenderPass(host->device, &info, NULL, &gbuffer.renderPass));
}

static void createGBuffer(const Host* host) {
    for (int i = 0; i < imageCount; ++i)
        createImage(host, i);
    createRenderPass(host);
    const VkFramebufferCreateInfo info = {.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                          .renderPass = gbuffer.renderPass,
                                          .attachmentCount = imageCount,
                                          .pAttachments = gbuffer.views,
                                          .width = width,
                                          .height = height,
                                          .layers = 1};
    CHECK(vkCreateFramebuffer(host->device, &info, NULL, &gbuffer.framebuffer));
}

/* Creates the descriptor set 1 of the SDK's passes. */
static void createSet(Host* host) {
    const VkSamplerCreateInfo sampler = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO}; /* texelFetch() ignores it */
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, imageCount};
    const VkDescriptorPoolCreateInfo pool = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    VkDescriptorSetLayoutBinding bindings[imageCount];
    const VkDescriptorSetLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                    .bindingCount = imageCount,
                                                    .pBindings = bindings};
    CHECK(vkCreateSampler(host->device, &sampler, NULL, &gbuffer.sampler));
    CHECK(vkCreateDescriptorPool(host->device, &pool, NULL, &gbuffer.pool));
    for (int i = 0; i < imageCount; ++i)
        bindings[i] = (VkDescriptorSetLayoutBinding){.binding = (uint32_t)i,
                                                     .descriptorType = size.type,
                                                     .descriptorCount = 1,
                                                     .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    CHECK(vkCreateDescriptorSetLayout(host->device, &layout, NULL, &gbuffer.layout));
    const VkDescriptorSetAllocateInfo allocation = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                                    .descriptorPool = gbuffer.pool,
                                                    .descriptorSetCount = 1,
                                                    .pSetLayouts = &gbuffer.layout};
    CHECK(vkAllocateDescriptorSets(host->device, &allocation, &host->functionSet));
    for (int i = 0; i < imageCount; ++i) {
        const VkDescriptorImageInfo image = {gbuffer.sampler, gbuffer.views[i], readLayout(i)};
        const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                            .dstSet = host->functionSet,
                                            .dstBinding = (uint32_t)i,
                                            .descriptorCount = 1,
                                            .descriptorType = size.type,
                                            .pImageInfo = &image};
        vkUpdateDescriptorSets(host->device, 1, &write, 0, NULL);
    }
}

static void createView(Host* host) {
    AgaaViewDesc desc = describeView();
    AgaaConfig config = *desc.config;
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    config.samples = samples;
    function.glsl = sampleCode;
    function.descriptorSetLayout = (uint64_t)gbuffer.layout;
    desc.config = &config;
    desc.pNext = &function;
    CHECK(agaaVkCreateView(host->context, &desc, &host->view));
}

/* createPass() builds pipelines from the SDK's description of a pass, so the host describes its own pass in the same
 * struct. */
static void createGBufferPass(Host* host) {
    AgaaDrawPass pass = AGAA_DRAW_PASS_INIT;
    AgaaVkDrawPass vkPass = AGAA_VK_DRAW_PASS_INIT;
    pass.pNext = &vkPass;
    pass.glslExtensions = pass.glslDeclarations = "";
    vkPass.renderPass = (uint64_t)gbuffer.renderPass, vkPass.descriptorSetLayout = (uint64_t)gbuffer.layout;
    pass.state.samples = samples, pass.state.colorAttachmentCount = 2, pass.state.colorWriteMask = 0xF;
    pass.state.depthCompare = AGAA_COMPARE_LESS, pass.state.depthWrite = 1;
    createPasses(host, &pass, vertexCode, gbufferCode);
}

static void drawGBuffer(const Host* host, VkCommandBuffer commands) {
    const VkClearValue clear[imageCount] = {[depthImage] = {.depthStencil = {1.0f, 0}}};
    const VkRenderPassBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                         .renderPass = gbuffer.renderPass,
                                         .framebuffer = gbuffer.framebuffer,
                                         .renderArea = {{0, 0}, {width, height}},
                                         .clearValueCount = imageCount,
                                         .pClearValues = clear};
    AgaaDrawTarget target = {0};
    target.commandBuffer = commands, target.descriptorSet = (uint64_t)host->functionSet; /* bound, but not read */
    target.width = width, target.height = height;
    vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    CHECK(draw((void*)host, &target));
    vkCmdEndRenderPass(commands);
}

static void destroyGBuffer(const Host* host) {
    vkDestroyDescriptorPool(host->device, gbuffer.pool, NULL);
    vkDestroyDescriptorSetLayout(host->device, gbuffer.layout, NULL);
    vkDestroySampler(host->device, gbuffer.sampler, NULL);
    vkDestroyFramebuffer(host->device, gbuffer.framebuffer, NULL);
    vkDestroyRenderPass(host->device, gbuffer.renderPass, NULL);
    for (int i = 0; i < imageCount; ++i) {
        vkDestroyImageView(host->device, gbuffer.views[i], NULL);
        vkDestroyImage(host->device, gbuffer.images[i], NULL);
        vkFreeMemory(host->device, gbuffer.memory[i], NULL);
    }
}

int main(int argumentCount, char** arguments) {
    Host host = {.recordHostPass = drawGBuffer};
    require(argumentCount == 2, "Usage: gbuffer_vk IMAGE.ppm");
    createDevice(&host);
    const float* pixels = createOutput(&host);
    createGBuffer(&host);
    createContext(&host);
    createSet(&host);
    createView(&host);
    createGBufferPass(&host);
    renderFrames(&host);
    writeImage(arguments[1], pixels);
    destroyGBuffer(&host);
    destroy(&host);
    return EXIT_SUCCESS;
}
