/* SPDX-License-Identifier: MIT */
#include "adapter.h"

#include "surface_shader.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderState.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTransform.h>
#include <vtkUniforms.h>
#include <vtk_glew.h>

#include <EGL/egl.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace agaaVtk {

vtkStandardNewMacro(Adapter);

namespace {

constexpr uint32_t firstUnit = 10; // texture units of the SDK in the host's shaders; VTK uses the lowest free ones

AgaaGlFunction AGAA_CALL getProcAddr(void*, const char* name) { return eglGetProcAddress(name); }

bool isMasked(vtkActor& actor) {
    float cutoff = 0.0f;
    return actor.GetShaderProperty()->GetFragmentCustomUniforms()->GetUniformf("alphaCutoff", cutoff);
}

/* Returns null unless the SDK's passes draw the prop. */
vtkActor* drawnActor(vtkProp& prop) {
    vtkActor* actor = vtkActor::SafeDownCast(&prop);
    auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
    if (!mapper || !actor->GetVisibility() || !actor->HasOpaqueGeometry())
        return nullptr;
    mapper->Update();
    vtkPolyData* data = mapper->GetInput();
    const bool hasTriangles =
        data && data->GetPointData()->GetNormals() && data->GetNumberOfVerts() == 0 && data->GetNumberOfLines() == 0;
    vtkProperty& property = *actor->GetProperty();
    const bool isSurface = property.GetRepresentation() == VTK_SURFACE && property.GetInterpolation() == VTK_PBR;
    return hasTriangles && isSurface && property.GetLighting() ? actor : nullptr;
}

bool isTextured(vtkActor& actor) {
    vtkPolyData* data = static_cast<vtkPolyDataMapper*>(actor.GetMapper())->GetInput();
    return data->GetPointData()->GetTCoords() && actor.GetProperty()->GetTexture("albedoTex");
}

/* Textures of the units that VTK uses. VTK leaves textures bound at units that it considers free, and the SDK restores
 * only the units that it uses. */
class TextureBindings {
public:
    TextureBindings() {
        glGetIntegerv(GL_ACTIVE_TEXTURE, &m_active);
        forEachUnit([](GLint& texture) { glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture); });
    }
    ~TextureBindings() {
        forEachUnit([](GLint& texture) { glBindTexture(GL_TEXTURE_2D, GLuint(texture)); });
    }
    TextureBindings(const TextureBindings&) = delete;

private:
    template <typename Function> void forEachUnit(Function function) {
        for (uint32_t i = 0; i < firstUnit; ++i) {
            glActiveTexture(GL_TEXTURE0 + i);
            function(m_textures[i]);
        }
        glActiveTexture(GLenum(m_active));
    }
    GLint m_active = 0, m_textures[firstUnit] = {};
};

/* Gives the state of a draw pass to VTK, except for the stencil test. Culling is that of the actors' properties. */
void applyState(const AgaaDrawState& from, vtkOpenGLState& to) {
    constexpr GLenum compare[] = {GL_LESS, GL_GREATER, GL_EQUAL, GL_ALWAYS};
    const auto writes = [&from](uint32_t bit) -> GLboolean { return (from.colorWriteMask & bit) != 0; };
    to.vtkglEnable(GL_DEPTH_TEST);
    to.vtkglDepthFunc(compare[from.depthCompare]);
    to.vtkglDepthMask(from.depthWrite != 0);
    to.vtkglColorMask(writes(1), writes(2), writes(4), writes(8));
    to.SetEnumState(GL_BLEND, from.keepFirst != 0);
    to.vtkglBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
    to.vtkglBlendEquation(GL_FUNC_ADD);
    to.vtkglStencilFunc(GL_EQUAL, 0, 0xFF);
    to.vtkglStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    to.vtkglStencilMask(0xFF);
    to.vtkglDisable(GL_SCISSOR_TEST);
    to.vtkglEnable(GL_MULTISAMPLE);
    // VTK does not know these states, and the SDK restores them.
    (from.sampleShading ? glEnable : glDisable)(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
    glDisable(GL_DITHER);
}

} // namespace

/* ---- context and views ---------------------------------------------------------------------------- */

void Adapter::createContext() {
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onLog, log.user = this;
    AgaaGlDeviceDesc device = AGAA_GL_DEVICE_DESC_INIT; // with AGAA_GL_STATE_RESTORE, which VTK's cache needs
    device.getProcAddr = getProcAddr;
    device.outputs = AGAA_GL_OUTPUTS_HOST; // VTK declares the outputs and binds their locations
    device.bindings[AGAA_GL_BINDING_METADATA] = firstUnit;
    for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i)
        device.bindings[AGAA_GL_BINDING_SHADOW0 + i] = firstUnit + 1 + i;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    desc.pNext = &device, desc.log = &log;
    desc.framesInFlight = 1; // Render() waits for the frame
    check(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &m_context), "agaaGlCreateContext");
}

Adapter::~Adapter() {
    destroyView();
    agaaDestroyContext(m_context);
}

void Adapter::onLog(void* user, uint32_t severity, AgaaResult, const char* message) {
    if (severity >= AGAA_SEVERITY_ERROR)
        static_cast<Adapter*>(user)->m_message = message;
    else if (severity >= AGAA_SEVERITY_WARNING)
        vtkGenericWarningMacro("AGAA: " << message);
}

void Adapter::check(AgaaResult result, const char* call) const {
    if (result < 0)
        throw std::runtime_error(std::string(call) + ": " +
                                 (m_message.empty() ? agaaResultString(result) : m_message.c_str()));
}

void Adapter::createView(vtkOpenGLRenderWindow& window, const AgaaConfig& config, const AgaaSceneFacts& facts,
                         uint32_t width, uint32_t height) {
    destroyView();
    AgaaShadingFunction function = AGAA_SHADING_FUNCTION_INIT;
    function.level = AGAA_SHADING_REFLECTANCE, function.glsl = reflectanceText;
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.pNext = &function;
    desc.width = width, desc.height = height;
    desc.config = &config, desc.facts = &facts;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; // VTK does not call glClipControl
    check(agaaGlCreateView(m_context, &desc, &m_view), "agaaGlCreateView");
    uint32_t count = 0;
    check(agaaGetDrawPasses(m_view, &count, nullptr), "agaaGetDrawPasses");
    m_passes.resize(count);
    for (AgaaDrawPass& pass : m_passes)
        agaaInitDrawPass(&pass, sizeof pass);
    check(agaaGetDrawPasses(m_view, &count, m_passes.data()), "agaaGetDrawPasses");
    m_output->SetContext(&window);
    m_output->Create2D(width, height, 4, VTK_FLOAT, false);
}

void Adapter::destroyView() {
    agaaDestroyView(m_view);
    m_view = nullptr, m_pass = nullptr;
    m_passes.clear();
    m_frameIndex = 0;
}

void Adapter::ReleaseGraphicsResources(vtkWindow* window) {
    destroyView();
    m_output->ReleaseGraphicsResources(window);
}

/* ---- shaders -------------------------------------------------------------------------------------- */

/* VTK's text for the fragment shader is replaced by one with the same marks, so VTK writes the declarations. */
bool Adapter::PreReplaceShaderValues(std::string&, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*) {
    ++m_shadersWritten;
    fragment = fragmentText;
    return true;
}

/* The SDK's text is inserted last, as it is long and VTK searches the text for each mark. */
bool Adapter::PostReplaceShaderValues(std::string& vertex, std::string&, std::string& fragment, vtkAbstractMapper*,
                                      vtkProp* prop) {
    auto& actor = static_cast<vtkActor&>(*prop);
    const std::string textured = isTextured(actor) ? "#define TEXTURED 1\n" : "#define TEXTURED 0\n";
    const std::string masked = isMasked(actor) ? "#define AGAA_ALPHA_MASKED 1\n" : "";
    std::string outputs;
    for (uint32_t i = 0; i < m_pass->state.colorAttachmentCount; ++i)
        outputs += "gl_FragData[" + std::to_string(i) + "] = agaa_out" + std::to_string(i) + ";\n";
    vtkShaderProgram::Substitute(fragment, "OUTPUTS", outputs);
    vtkShaderProgram::Substitute(fragment, "//VTK::System::Dec",
                                 "#version 450\n" + textured + m_pass->glslExtensions + masked +
                                     m_pass->glslDeclarations);
    vertex.insert(vertex.rfind('}'), vertexEnd);
    vtkShaderProgram::Substitute(vertex, "void main()", std::string(vertexDeclarations) + "void main()");
    return true;
}

/* ---- frames --------------------------------------------------------------------------------------- */

/* Describes the lights in view space, which is shading space. */
void Adapter::addLights(vtkRenderer& renderer) {
    vtkTransform* view = renderer.GetActiveCamera()->GetModelViewTransformObject();
    m_lights.clear();
    for (int item = 0; item < renderer.GetLights()->GetNumberOfItems(); ++item) {
        auto* light = static_cast<vtkLight*>(renderer.GetLights()->GetItemAsObject(item));
        if (!light->GetSwitch())
            continue;
        AgaaLight each = AGAA_LIGHT_INIT;
        const bool isSpot = light->GetConeAngle() < 90.0;
        each.type = !light->GetPositional() ? AGAA_LIGHT_DIRECTIONAL : isSpot ? AGAA_LIGHT_SPOT : AGAA_LIGHT_POINT;
        double position[3], target[3], direction[3];
        view->TransformPoint(light->GetTransformedPosition(), position);
        view->TransformPoint(light->GetTransformedFocalPoint(), target);
        vtkMath::Subtract(target, position, direction);
        vtkMath::Normalize(direction);
        const double fall = light->GetPositional() ? light->GetAttenuationValues()[2] : 1.0;
        if (!(fall > 0))
            throw std::runtime_error("A light of the scene does not fall off with the square of the distance.");
        for (int i = 0; i < 3; ++i) {
            each.position[i] = float(position[i]);
            each.direction[i] = float(direction[i]);
            each.color[i] = float(light->GetDiffuseColor()[i] * light->GetIntensity() / fall);
        }
        each.cosInner = each.cosOuter = float(std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle())));
        m_lights.push_back(each);
    }
}

AgaaFrame Adapter::describeFrame(vtkRenderer& renderer) {
    AgaaFrame frame = AGAA_FRAME_INIT; // the view matrix is the identity
    frame.completedFrame = m_frameIndex;
    frame.frameIndex = ++m_frameIndex;
    const vtkMatrix4x4& projection =
        *renderer.GetActiveCamera()->GetProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1.0, 1.0);
    for (int i = 0; i < 16; ++i)
        frame.projection[i] = float(projection.GetElement(i % 4, i / 4));
    addLights(renderer);
    frame.lights = m_lights.data(), frame.lightCount = uint32_t(m_lights.size());
    for (int i = 0; i < 3; ++i)
        frame.background[i] = float(renderer.GetBackground()[i]);
    frame.draw = onDraw, frame.drawUser = this;
    return frame;
}

void Adapter::Render(const vtkRenderState* state) {
    record(state);
    copyOutput(state);
}

void Adapter::record(const vtkRenderState* state) {
    m_message.clear();
    m_state = state;
    const AgaaFrame frame = describeFrame(*state->GetRenderer());
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    glFrame.outputTexture = m_output->GetHandle();
    PreRender(state); // VTK asks this pass for shaders from now on
    const AgaaResult result = agaaGlRecordFrame(m_view, &frame, &glFrame);
    PostRender(state);
    glFinish(); // a host that lets frames overlap sets completedFrame from its fences instead
    if (result < 0 && m_message.empty())
        m_message = agaaResultString(result);
    if (!m_message.empty())
        vtkErrorMacro("agaaGlRecordFrame: " << m_message);
}

void Adapter::copyOutput(const vtkRenderState* state) {
    auto* openGl = static_cast<vtkOpenGLRenderer*>(state->GetRenderer())->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(openGl, GL_DEPTH_TEST), blend(openGl, GL_BLEND);
    openGl->vtkglDisable(GL_DEPTH_TEST);
    openGl->vtkglDisable(GL_BLEND);
    m_output->CopyToFrameBuffer(nullptr, nullptr);
}

AgaaResult Adapter::onDraw(void* user, const AgaaDrawTarget* target) {
    static_cast<Adapter*>(user)->draw(*target);
    return AGAA_OK;
}

/* The SDK restores the context's state on entry, before each draw callback and on return. VTK's copy of the state is
 * that of the entry after Pop(), so both agree. */
void Adapter::draw(const AgaaDrawTarget& target) {
    auto& renderer = static_cast<vtkOpenGLRenderer&>(*m_state->GetRenderer());
    vtkOpenGLState& state = *renderer.GetState();
    const auto pass = std::ranges::find(m_passes, target.pipelineKey, &AgaaDrawPass::pipelineKey);
    if (std::exchange(m_pass, &*pass) != &*pass)
        m_stageTime.Modified(); // VTK makes new shaders
    const TextureBindings textures;
    const vtkOpenGLState::ScopedglEnableDisable multisample(&state, GL_MULTISAMPLE); // Pop() does not restore it
    state.Push();
    state.vtkglBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    state.vtkglViewport(0, 0, int(target.width), int(target.height));
    applyState(target.state, state);
    for (int i = 0; i < m_state->GetPropArrayCount(); ++i)
        if (vtkActor* actor = drawnActor(*m_state->GetPropArray()[i])) {
            state.SetEnumState(GL_STENCIL_TEST,
                               (isMasked(*actor) ? target.state.stencilTestMasked : target.state.stencilTest) != 0);
            actor->GetProperty()->Render(actor, &renderer); // culling and textures
            actor->GetMapper()->Render(&renderer, actor);   // vtkActor::Render() would write depth
            actor->GetProperty()->PostRender(actor, &renderer);
        }
    state.Pop();
}

} // namespace agaaVtk
