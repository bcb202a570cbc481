/* The smallest Vulkan host that fetches materials by id: the SDK draws once, for depth and ids, and asks for the rest.
 *   ids_vk image.ppm
 * SPDX-License-Identifier: MIT
 */
#include "ids.h"
#include "vk.h"

#include <string.h>

static const char fetchCode[] = FETCH_CODE("set = 1, binding = 0");

/* What fetchCode reads, and its set. */
typedef struct Fetch {
    VkBuffer camera;
    VkDeviceMemory memory;
    VkDescriptorSetLayout layout;
    VkDescriptorPool pool;
} Fetch;

static void createCamera(const Host* host, Fetch* fetch) {
    const AgaaFrame frame = describeFrame(1, 0.0f); /* the camera stands still: written once */
    const VkBufferCreateInfo buffer = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = sizeof frame.projection,
                                       .usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT};
    VkMemoryRequirements needed;
    CHECK(vkCreateBuffer(host->device, &buffer, NULL, &fetch->camera));
    vkGetBufferMemoryRequirements(host->device, fetch->camera, &needed);
    memcpy(allocate(host, &needed, mappedMemory, &fetch->memory), frame.projection, sizeof frame.projection);
    CHECK(vkBindBufferMemory(host->device, fetch->camera, fetch->memory, 0));
}

static void createSet(Host* host, Fetch* fetch) {
    const VkDescriptorSetLayoutBinding binding = {.binding = 0, .descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                                  .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT};
    const VkDescriptorSetLayoutCreateInfo layout = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 1, .pBindings = &binding};
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1};
    const VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1,
                                             .poolSizeCount = 1, .pPoolSizes = &size};
    VkDescriptorSetAllocateInfo allocation = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                              .descriptorSetCount = 1, .pSetLayouts = &fetch->layout};
    const VkDescriptorBufferInfo camera = {fetch->camera, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET, .descriptorCount = 1,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .pBufferInfo = &camera};
    CHECK(vkCreateDescriptorSetLayout(host->device, &layout, NULL, &fetch->layout));
    CHECK(vkCreateDescriptorPool(host->device, &pool, NULL, &fetch->pool));
    allocation.descriptorPool = fetch->pool;
    CHECK(vkAllocateDescriptorSets(host->device, &allocation, &host->functionSet));
    write.dstSet = host->functionSet;
    vkUpdateDescriptorSets(host->device, 1, &write, 0, NULL);
}

static void createView(Host* host, const Fetch* fetch) {
    AgaaViewDesc desc = describeView();
    AgaaFetchFunction function = AGAA_FETCH_FUNCTION_INIT;
    function.glsl = fetchCode;
    function.maxDraws = 1;
    function.maxPrimitives = vertexCount / 3;
    function.descriptorSetLayout = (uint64_t)fetch->layout;
    desc.pNext = &function;
    CHECK(agaaVkCreateView(host->context, &desc, &host->view));
}

static void destroyFetch(const Host* host, const Fetch* fetch) {
    vkDestroyDescriptorPool(host->device, fetch->pool, NULL);
    vkDestroyDescriptorSetLayout(host->device, fetch->layout, NULL);
    vkDestroyBuffer(host->device, fetch->camera, NULL);
    vkFreeMemory(host->device, fetch->memory, NULL);
}

int main(int argumentCount, char** arguments) {
    Host host = {0};
    Fetch fetch;
    require(argumentCount == 2, "Usage: ids_vk IMAGE.ppm");
    enabledFeatures.features.geometryShader = VK_TRUE; /* for gl_PrimitiveID */
    createDevice(&host);
    const float* pixels = createOutput(&host);
    createContext(&host);
    createCamera(&host, &fetch);
    createSet(&host, &fetch);
    createView(&host, &fetch);
    createPasses(&host, NULL, idCode);
    renderFrames(&host);
    writeImage(arguments[1], pixels);
    destroyFetch(&host, &fetch);
    destroy(&host);
    return EXIT_SUCCESS;
}
