#include "stage_host.h"

#include "plan_view.h"

#include "surface_reader.h"

#include "render/messages.h"
#include "vk/barrier.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <stdexcept>

using namespace harness::vk;

namespace agaa::test {

namespace {

constexpr const char* vertexText = R"(
layout(std430, set = 1, binding = 0) readonly buffer Vertices { vec4 data[]; } vertices;
layout(push_constant) uniform Push { mat4 clip; };
layout(location = 0) out vec3 position;
layout(location = 1) flat out uint triangle;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint instance;
invariant gl_Position;
void main() {
    position = vertices.data[2 * gl_VertexIndex].xyz + float(gl_InstanceIndex) * STAGE_INSTANCE_STEP;
    instance = uint(gl_InstanceIndex);
    uv = vertices.data[2 * gl_VertexIndex + 1].xy;
    triangle = uint(gl_VertexIndex) / 3u;
    precise vec4 place = clip * vec4(position, 1.0); // as pullingText
    gl_Position = place;
}
)";

// Of passes with AgaaDrawPass::glslVertex, in place of vertexText: an instance is a triangle.
constexpr const char* pullingText = R"(
layout(std430, set = 1, binding = 0) readonly buffer Vertices { vec4 data[]; } vertices;
layout(push_constant) uniform Push { mat4 clip; uint drawnInstance; };
layout(location = 0) out vec3 position;
layout(location = 1) flat out uint triangle;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint instance;
vec3 placeOf(uint vertex) { return vertices.data[2u * vertex].xyz + float(drawnInstance) * STAGE_INSTANCE_STEP; }
void main() {
    triangle = uint(gl_InstanceIndex);
    instance = drawnInstance;
    position = placeOf(3u * triangle);
    uv = vertices.data[6u * triangle + 1u].xy;
    precise vec4 a = clip * vec4(position, 1.0);
    precise vec4 b = clip * vec4(placeOf(3u * triangle + 1u), 1.0);
    precise vec4 c = clip * vec4(placeOf(3u * triangle + 2u), 1.0);
    agaa_pullVertex(a, b, c, uint(gl_VertexIndex));
}
)";

struct Push {
    glm::mat4 clip;
    uint32_t drawnInstance;
};

// Of passes with expansionText of a test, which moves each corner by its agaa_place().
constexpr const char* geometryText = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 0) in vec3 positions[];
layout(location = 1) flat in uint triangles[];
layout(location = 2) in vec2 uvs[];
layout(location = 3) flat in uint instances[];
layout(location = 0) out vec3 position;
layout(location = 1) flat out uint triangle;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint instance;
void main() {
    for (int i = 0; i < 3; ++i) {
        position = positions[i];
        triangle = triangles[i];
        uv = uvs[i];
        instance = instances[i];
        gl_Position = agaa_place(gl_in[i].gl_Position);
        EmitVertex();
    }
}
)";

// Of passes whose fragments need the corners of their triangle.
constexpr const char* hullText = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out;
layout(location = 0) in vec3 positions[];
layout(location = 1) flat in uint triangles[];
layout(location = 2) in vec2 uvs[];
layout(location = 3) flat in uint instances[];
layout(location = 0) out vec3 position;
layout(location = 1) flat out uint triangle;
layout(location = 2) out vec2 uv;
layout(location = 3) flat out uint instance;
void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        position = positions[0];
        triangle = triangles[0];
        uv = uvs[0];
        instance = instances[0];
        agaa_setVertex(i);
        EmitVertex();
    }
}
)";

constexpr const char* fragmentText = R"(
struct Material { vec4 diffuse, specular, emissive, normal, geometricNormal; };
layout(std430, set = 1, binding = 1) readonly buffer Materials { Material data[]; } materials;
layout(location = 0) in vec3 position;
layout(location = 1) flat in uint triangle;
layout(location = 2) in vec2 uv;
layout(location = 3) flat in uint instance;
void main() {
    Material m = materials.data[triangle];
    vec2 spare = vec2(m.specular.w, m.emissive.w);
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = position;
    s.geometricNormal = m.geometricNormal.xyz;
    s.alpha = m.diffuse.w * STAGE_ALPHA_FACTOR;
    s.primitiveSeed = floatBitsToUint(m.geometricNormal.w);
    s.draw = STAGE_DRAW + instance;
    s.primitive = triangle;
    s.diffuse = m.diffuse.xyz;
    s.specular = m.specular.xyz;
    s.emissive = m.emissive.xyz;
    s.normal = m.normal.xyz;
    s.alpha2 = m.normal.w;
)";

void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message) {
    auto& context = *static_cast<StageContext*>(user);
    if (severity >= AGAA_SEVERITY_WARNING)
        context.lines.push_back({code, message});
    context.warnings += severity == AGAA_SEVERITY_WARNING;
}

void require(AgaaResult result, const StageContext& context, const char* call) {
    if (result >= 0)
        return;
    throw std::runtime_error(context.lines.empty() ? call : context.lines.back().text);
}

// Cases compile the same texts again and again.
std::span<const uint32_t> spirvOf(ShaderStage stage, const std::string& text, const std::string& name) {
    static std::map<std::pair<ShaderStage, std::string>, std::vector<uint32_t>> compiled;
    std::vector<uint32_t>& spirv = compiled[{stage, text}];
    if (spirv.empty())
        spirv = compileGlsl(stage, text, name);
    return spirv;
}

std::unique_ptr<Device> device;

// When the device goes, the layers tell of objects that were left.
class DeviceEnd : public testing::Environment {
    void TearDown() override {
        device.reset();
        for (const harness::ApiMessage& message : harness::takeLeftoverMessages())
            ADD_FAILURE() << message.id << ": " << message.text;
    }
};
const testing::Environment* const deviceEnd = testing::AddGlobalTestEnvironment(new DeviceEnd);

} // namespace

Device& sharedDevice() {
    if (!device)
        device = std::make_unique<Device>(harness::RendererOptions{});
    return *device;
}

VulkanContextDesc contextDesc(const HostOptions& options) {
    Device& device = sharedDevice();
    VulkanContextDesc desc(AGAA_VK_DEVICE_DESC_INIT);
    desc.device.instance = device.instance();
    desc.device.physicalDevice = device.physicalDevice();
    desc.device.device = device.get();
    desc.device.queueFamily = device.queueFamily();
    desc.device.apiVersion = device.apiVersion();
    desc.device.getProcAddr = options.getProcAddr;
    desc.device.enabledExtensions = device.extensions().data();
    desc.device.enabledExtensionCount = uint32_t(device.extensions().size());
    desc.device.enabledFeatures = device.features();
    desc.device.rendering = options.renderPass ? AGAA_VK_RENDERING_RENDER_PASS : AGAA_VK_RENDERING_AUTO;
    desc.device.recording = options.inlineRecording ? AGAA_VK_RECORDING_INLINE : AGAA_VK_RECORDING_SECONDARY;
    desc.framesInFlight = options.framesInFlight;
    return desc;
}

StageContext::StageContext(const HostOptions& options) {
    Device& device = sharedDevice();
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onLog;
    log.user = this;
    require(agaaVkGetDeviceCaps(device.instance(), device.physicalDevice(), Device::getProcAddr, &log, &caps_), *this,
            "agaaVkGetDeviceCaps");
    VulkanContextDesc desc = contextDesc(options);
    desc.log = &log;
    if (options.change)
        options.change(desc);
    require(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &context_), *this, "agaaVkCreateContext");
}

StageContext::~StageContext() {
    agaaDestroyContext(context_);
    for (const harness::ApiMessage& message : sharedDevice().takeMessages())
        ADD_FAILURE() << message.id << ": " << message.text;
}

ShadowLayers::ShadowLayers(const std::vector<float>& layers, uint32_t size) : arena_(sharedDevice()) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_D32_SFLOAT;
    info.extent = {size, size, 1};
    info.mipLevels = 1;
    info.arrayLayers = uint32_t(layers.size());
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    image_ = arena_.image(info, VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_ASPECT_DEPTH_BIT);
    constexpr ImageUse nothing{VK_PIPELINE_STAGE_TRANSFER_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    constexpr ImageUse cleared{VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT,
                               VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    constexpr ImageUse read{VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT,
                            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        imageBarrier(commands, image_.image.get(), VK_IMAGE_ASPECT_DEPTH_BIT, nothing, cleared);
        for (uint32_t layer = 0; layer < layers.size(); ++layer) {
            const VkClearDepthStencilValue value{layers[layer], 0};
            const VkImageSubresourceRange range{VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, layer, 1};
            vkCmdClearDepthStencilImage(commands, image_.image.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1,
                                        &range);
        }
        imageBarrier(commands, image_.image.get(), VK_IMAGE_ASPECT_DEPTH_BIT, cleared, read);
    });
}

StageView::StageView(StageContext& context, const ViewSettings& settings)
    : context_(context), settings_(settings), output_(sharedDevice(), settings.width, settings.height),
      arena_(sharedDevice()) {
    const AgaaViewDesc desc = viewDesc(settings_);
    if (settings.build)
        view_ = makePlanView<agaa::vk::View, agaa::vk::Context>(context.get(), desc, settings.build);
    else
        require(agaaVkCreateView(context.get(), &desc, &view_), context, "agaaVkCreateView");

    set_ = StorageSet(sharedDevice(), 2, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT);
    const auto check = [this](AgaaResult result) { require(result, context_, "agaaGetDrawPasses"); };
    for (const auto& pass : harness::drawPassesOf(view_, AgaaVkDrawPass AGAA_VK_DRAW_PASS_INIT, check))
        addPass(pass);
}

StageView::~StageView() { agaaDestroyView(view_); }

void StageView::addPass(const harness::DrawPass<AgaaVkDrawPass>& pass) {
    const VkDescriptorSetLayout layouts[] = {(VkDescriptorSetLayout)pass.native.descriptorSetLayout, set_.layout()};
    const VkPushConstantRange push{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(Push)};
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 2;
    layout.pSetLayouts = layouts;
    layout.pushConstantRangeCount = 1;
    layout.pPushConstantRanges = &push;
    PassPipelines& made = passes_[pass.pipelineKey];
    made.layout =
        make<PipelineLayout>(sharedDevice().get(), vkCreatePipelineLayout, layout, "create a pipeline layout");
    made.pass = pass;
    made.pass.state = drawState(settings_, pass.state, pass.pass);
    const auto textOf = [](const char* text) { return std::string(text ? text : ""); };
    made.extensions = textOf(pass.glslExtensions);
    made.declarations = textOf(pass.glslDeclarations);
    made.vertexText = textOf(pass.glslVertex);
    made.geometryText = textOf(pass.glslGeometry);
    made.name = textOf(pass.name);
}

VkPipeline StageView::pipelineOf(PassPipelines& made, bool isMasked) {
    if (made.pipelines[isMasked])
        return made.pipelines[isMasked].get();
    const auto shader = [&](ShaderStage stage, const std::string& text) {
        return makeShader(sharedDevice(), spirvOf(stage, "#version 450\n" + text, made.name));
    };
    const auto inOrder = [&](const std::string& text) { return rasterisedInOrder(settings_, made.extensions + text); };
    const uint32_t pass = made.pass.pass;
    if (!made.vertex)
        made.vertex = shader(ShaderStage::Vertex,
                             made.vertexText.empty()
                                 ? shaderDefines(settings_, AGAA_DRAW_PASS_VISIBILITY, false) + vertexText
                                 : inOrder(shaderDefines(settings_, pass, false) + made.vertexText + pullingText));
    if (!made.geometryText.empty() && !made.geometry)
        made.geometry =
            shader(ShaderStage::Geometry,
                   inOrder(made.geometryText + (pass == AGAA_DRAW_PASS_FRAGMENTS ? hullText : geometryText)));
    const ShaderModule fragment = shader(ShaderStage::Fragment, inOrder(shaderDefines(settings_, pass, isMasked) +
                                                                        made.declarations + fragmentText + emitText));
    PipelineState state(made.pass, isMasked);
    state.vertexLocations = 0;
    state.geometry = made.geometry.get();
    if (made.pass.state.vertexPulling)
        state.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    const auto renderPass = (VkRenderPass)made.pass.native.renderPass;
    made.pipelines[isMasked] = state.create(sharedDevice(), made.vertex.get(), fragment.get(), made.layout.get(),
                                            renderPass, renderPass == VK_NULL_HANDLE ? &state.rendering : nullptr);
    return made.pipelines[isMasked].get();
}

void StageView::setTriangles(const std::vector<Triangle>& triangles) {
    const size_t count = std::max<size_t>(triangles.size(), 1);
    vertices_ = arena_.hostBuffer(count * 3 * 2 * sizeof(glm::vec4), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    materials_ = arena_.hostBuffer(count * sizeof(Material), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    for (uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE, AGAA_DRAW_PASS_GBUFFER,
                          AGAA_DRAW_PASS_FORWARD, AGAA_DRAW_PASS_FRAGMENTS})
        runs_[pass] = drawRuns(settings_, triangles, pass);
    for (uint32_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (uint32_t corner = 0; corner < 3; ++corner) {
            const glm::vec4 data[2] = {glm::vec4(t.position[corner], 0), glm::vec4(t.uv[corner], 0, 0)};
            std::memcpy(vertices_.mapped + (3 * i + corner) * sizeof data, data, sizeof data);
        }
        Material material = t.material;
        material.geometricNormal.w = std::bit_cast<float>(t.seed ? t.seed : i);
        std::memcpy(materials_.mapped + i * sizeof(Material), &material, sizeof(Material));
    }
    set_.write({vertices_.buffer.get(), materials_.buffer.get()});
}

AgaaFrame StageView::frame() {
    AgaaFrame frame = nextFrame(settings_, frameIndex_);
    frame.draw = onDraw;
    frame.drawUser = this;
    return frame;
}

AgaaVkFrame StageView::vkFrame(VkCommandBuffer commands) {
    AgaaVkFrame frame = AGAA_VK_FRAME_INIT;
    frame.commandBuffer = commands;
    frame.outputImage = (uint64_t)output_.image();
    frame.outputView = (uint64_t)output_.view();
    frame.outputLayoutIn = VK_IMAGE_LAYOUT_UNDEFINED;
    frame.outputLayoutOut = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    return frame;
}

void StageView::render(const AgaaFrame& wanted, const std::function<void(AgaaVkFrame&)>& change, bool splitSegments) {
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = vkFrame(commands);
        if (change)
            change(vk);
        AgaaFrame frame = wanted;
        for (uint64_t segments : segmentCalls(splitSegments)) {
            frame.segments = segments;
            require(agaaVkRecordFrame(view_, &frame, &vk), context_, "agaaVkRecordFrame");
        }
    });
}

AgaaFrameStatistics StageView::statistics() const {
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    require(agaaGetFrameStatistics(view_, frameIndex_, &statistics), context_, "agaaGetFrameStatistics");
    return statistics;
}

AgaaResult AGAA_CALL StageView::onDraw(void* user, const AgaaDrawTarget* target) {
    return static_cast<StageView*>(user)->draw(*target);
}

AgaaResult StageView::draw(const AgaaDrawTarget& target) {
    ++drawCalls;
    batches.push_back(target.batch);
    states.push_back(target.state);
    const auto result = drawResults.find(target.pass);
    if (result != drawResults.end())
        return result->second;
    const auto commands = static_cast<VkCommandBuffer>(target.commandBuffer);
    PassPipelines& pass = passes_.at(target.pipelineKey);
    const VkDescriptorSet sets[] = {(VkDescriptorSet)target.descriptorSet, set_.get()};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass.layout.get(), 0, 2, sets, 0, nullptr);
    for (const std::span<const AgaaViewport> viewports : harness::viewportGroups(target)) {
        setViewports(commands, viewports);
        drawAll(target, commands, pass);
    }
    return AGAA_OK;
}

void StageView::drawAll(const AgaaDrawTarget& target, VkCommandBuffer commands, PassPipelines& pass) {
    Push push{clipMatrix(settings_, target.pass), 0};
    const auto pushConstants = [&] {
        vkCmdPushConstants(commands, pass.layout.get(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof push, &push);
    };
    pushConstants();
    for (const Run& run : runs_.at(target.pass)) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelineOf(pass, run.isMasked));
        if (!target.state.vertexPulling) {
            vkCmdDraw(commands, 3 * run.count, settings_.instances, 3 * run.first, 0);
            continue;
        }
        for (push.drawnInstance = 0; push.drawnInstance < settings_.instances; ++push.drawnInstance) {
            pushConstants();
            vkCmdDraw(commands, 8, run.count, 0, run.first);
        }
    }
}

std::vector<glm::uvec4> StageView::readSurface(const std::string& name) const {
    const ResourceId id = findResource(plan(), name);
    return readTexels(sharedDevice(), plan().resources[id], (*executor().resources)[id].fetchView);
}

std::vector<uint32_t> StageView::readBuffer(const std::string& name) const {
    const ResourceId id = findResource(plan(), name);
    const Resource& resource = plan().resources[id];
    if (resource.kind == ResourceKind::Image)
        return byPixels(resource, readImage(sharedDevice(), resource, (*executor().resources)[id].image));
    return readWords(sharedDevice(), (*executor().resources)[id].buffers[0], plan().resources[id].bytes);
}

} // namespace agaa::test
