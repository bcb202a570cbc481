#include "gl/view.h"

#include "core/base/error.h"
#include "core/plan/planner.h"
#include "gl/errors.h"
#include "gl/formats.h"
#include "gl/program.h"

#include <algorithm>

namespace agaa::gl {

View::View(Context& owner, const ViewSettings& settings)
    : View(owner, makePlan(settings, owner.caps, owner.framesInFlight)) {}

View::View(Context& owner, Plan framePlan)
    : ViewState(owner, std::move(framePlan)), context(owner), barriers(plan.resources.size()) {
    require(plan.view.functionSetLayout == 0, AGAA_ERROR_INVALID_ARGUMENT,
            "set layouts of AgaaGBufferFunction, AgaaFetchFunction and AgaaShadowFunction are of Vulkan.");
    context.requireAlive();
    uint64_t largest = 0;
    for (const Resource& resource : plan.resources)
        if (resource.content != UploadContent::None)
            largest = std::max(largest, resource.bytes);
    upload_.resize(largest);
    try {
        resources.emplace(context, plan);
        hostPasses = makeHostPasses(plan, viewDialect());
        for (const HostPass& pass : hostPasses)
            if (!pass.functionCheck.empty())
                checkFragment(context.gl, pass.functionCheck, pass.functionOrigin);
        createFramebuffers();
        addVariant(plan);
        positions = readPositions();
        if (plan.view.config.flags & AGAA_CONFIG_TIMESTAMPS)
            clock.emplace(context, steps, plan.passes.size(), context.framesInFlight);
        context.checkErrors("creating the view");
    } catch (...) {
        destroy();
        discardErrors(context.gl);
        throw;
    }
}

View::~View() { destroy(); }

ViewState* View::recreate(const ViewSettings& settings) const {
    return construct<View>(context.allocator, context, settings);
}

void View::destroy() {
    context.gl.DeleteFramebuffers(GLsizei(framebuffers.size()), framebuffers.data());
    for (const uint64_t program : variants.programs())
        context.gl.DeleteProgram(GLuint(program));
    framebuffers.clear();
}

Compiled View::compile(const Pass& pass, size_t) {
    const Compiled compiled = compilePass(context, pass);
    try {
        context.label(GL_PROGRAM, GLuint(compiled.program), "agaa " + pass.name);
        context.checkErrors("compiling a pass"); // before a frame uses the program
    } catch (...) {
        context.gl.DeleteProgram(GLuint(compiled.program));
        discardErrors(context.gl);
        throw;
    }
    return compiled;
}

void View::prepare(const ViewSettings& settings, const AgaaSceneFacts& facts) {
    context.requireAlive();
    context.clearHostErrors("agaaPrepareVariants");
    ViewState::prepare(settings, facts);
}

// Attachments with fewer samples than depth need the colour samples' masks of the driver.
HostDialect View::viewDialect() const {
    HostDialect dialect = context.dialect;
    for (const Pass& pass : plan.passes)
        if (pass.kind() == PassKind::HostDraw && pass.draw().state.colorSamples)
            dialect.colorSampleMasks =
                context.colorSampleMasks(pass.draw().state.samples, pass.draw().state.colorSamples);
    return dialect;
}

void View::createFramebuffers() {
    framebuffers.resize(plan.passes.size());
    for (size_t i = 0; i < plan.passes.size(); ++i)
        if (plan.passes[i].kind() == PassKind::HostDraw)
            createFramebuffer(i);
}

void View::createFramebuffer(size_t index) {
    const Pass& pass = plan.passes[index];
    const GladGLContext& gl = context.gl;
    gl.CreateFramebuffers(1, &framebuffers[index]);
    const GLuint framebuffer = requireObject(gl, framebuffers[index], "glCreateFramebuffers");
    context.label(GL_FRAMEBUFFER, framebuffer, "agaa " + pass.name);
    std::vector<GLenum> buffers;
    for (const ColorAttachment& color : hostPasses[index].colors) {
        buffers.push_back(GLenum(GL_COLOR_ATTACHMENT0 + buffers.size()));
        const GLuint texture = (*resources)[color.resource].texture;
        if (plan.resources[color.resource].layers > 1)
            gl.NamedFramebufferTextureLayer(framebuffer, buffers.back(), texture, 0, GLint(color.layer));
        else
            gl.NamedFramebufferTexture(framebuffer, buffers.back(), texture, 0);
    }
    if (pass.draw().depthTarget != noResource)
        gl.NamedFramebufferTexture(framebuffer, depthAttachment(plan.resources[pass.draw().depthTarget].format),
                                   (*resources)[pass.draw().depthTarget].texture, 0);
    if (pass.draw().depthTarget == noResource && buffers.empty()) {
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_WIDTH, GLint(pass.draw().width));
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_HEIGHT, GLint(pass.draw().height));
        const uint32_t samples = pass.draw().state.samples;
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_SAMPLES, samples > 1 ? GLint(samples) : 0);
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS, GL_TRUE);
    }
    if (pass.draw().state.sampleLocations) {
        const std::vector<SamplePosition> texel = texelPositions(plan.view);
        gl.NamedFramebufferSampleLocationsfvARB(framebuffer, 0, GLsizei(texel.size()), &texel[0].x);
        gl.NamedFramebufferParameteri(framebuffer, GL_FRAMEBUFFER_PROGRAMMABLE_SAMPLE_LOCATIONS_ARB, GL_TRUE);
    }
    if (buffers.empty())
        buffers.push_back(GL_NONE);
    gl.NamedFramebufferDrawBuffers(framebuffer, GLsizei(buffers.size()), buffers.data());
    gl.NamedFramebufferReadBuffer(framebuffer, buffers[0]);
    const GLenum status = gl.CheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE)
        return;
    context.checkErrors("creating a framebuffer"); // the status is 0 after an error
    fail(AGAA_ERROR_UNSUPPORTED,
         format("the driver cannot draw to the targets of the pass \"%s\": status 0x%04X.", pass.name.c_str(), status));
}

// Reads the sample locations of a framebuffer. glGetMultisamplefv returns those of the bound framebuffer.
static void readLocations(const GladGLContext& gl, GLuint framebuffer, std::vector<SamplePosition>& texel) {
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    for (size_t i = 0; i < texel.size(); ++i)
        gl.GetMultisamplefv(GL_SAMPLE_POSITION, GLuint(i), &texel[i].x);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
}

namespace {

// A framebuffer with multisampled texels, for plans without a host pass.
struct SampledTarget {
    SampledTarget(const GladGLContext& context, uint32_t samples) : gl(context) {
        gl.CreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &texture);
        gl.CreateFramebuffers(1, &framebuffer);
        if (!texture || !framebuffer)
            return;
        gl.TextureStorage2DMultisample(texture, GLsizei(samples), GL_RGBA8, 1, 1, GL_TRUE);
        gl.NamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
    }
    ~SampledTarget() {
        gl.DeleteFramebuffers(1, &framebuffer);
        gl.DeleteTextures(1, &texture);
    }
    SampledTarget(const SampledTarget&) = delete;
    SampledTarget& operator=(const SampledTarget&) = delete;

    const GladGLContext& gl;
    GLuint framebuffer = 0, texture = 0;
};

} // namespace

// OpenGL defines no standard sample locations.
SamplePositions View::readPositions() const {
    if (!plan.view.samplePositions.empty())
        return samplePositions(plan.view.samplePositions);
    const GladGLContext& gl = context.gl;
    std::vector<SamplePosition> texel(plan.view.hwSamples, SamplePosition{0.5f, 0.5f});
    if (plan.view.placesSamples)
        return samplePositions(plan.view);
    if (plan.view.hwSamples == 1)
        return samplePositions(texel, plan.view);
    const auto draw = std::find_if(plan.passes.begin(), plan.passes.end(),
                                   [](const Pass& pass) { return pass.kind() == PassKind::HostDraw; });
    if (draw != plan.passes.end()) {
        readLocations(gl, framebuffers[size_t(draw - plan.passes.begin())], texel);
    } else {
        const SampledTarget target(gl, plan.view.hwSamples);
        requireObject(gl, target.texture, "glCreateTextures");
        readLocations(gl, requireObject(gl, target.framebuffer, "glCreateFramebuffers"), texel);
    }
    return samplePositions(texel, plan.view);
}

MemoryUse View::memoryUse() const {
    // OpenGL does not alias memory and does not report the driver's size.
    return {resources->payloadBytes(), 0, resources->payloadBytes()};
}

std::byte* View::beginUpload(ResourceId, uint32_t) { return upload_.data(); }

void View::endUpload(ResourceId buffer, uint32_t slot, uint64_t bytes) {
    context.gl.NamedBufferSubData(resources->buffer(buffer, slot), 0, GLsizeiptr(bytes), upload_.data());
}

void View::readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const {
    context.gl.GetNamedBufferSubData(resources->buffer(buffer, slot), GLintptr(offset), GLsizeiptr(data.size()),
                                     data.data());
}

std::vector<double> View::readPassTimes(uint32_t slot) const {
    return clock ? clock->milliseconds(slot) : std::vector<double>{};
}

} // namespace agaa::gl
