/* SPDX-License-Identifier: MIT */
#include "adapter.h"

#include "sdk_target.h"

// OGRE's OpenGL header defines macros, which exclude <GL/glx.h>.
extern "C" void (*glXGetProcAddressARB(const unsigned char* name))(void);

namespace agaaOgre {

namespace {

constexpr uint32_t firstUnit = 10; // texture units of the SDK in the host's shaders; materials use lower ones
const char* const group = "AGAA";  // resource group of the materials and programs for draw passes
AgaaGlFunction AGAA_CALL getProcAddr(void*, const char* name) {
    return glXGetProcAddressARB(reinterpret_cast<const unsigned char*>(name));
}

/* Writes a matrix of OGRE, which is row-major, in the SDK's order. */
void copyMatrix(const Ogre::Matrix4& from, float* to) {
    for (int i = 0; i < 16; ++i)
        to[i] = from[i % 4][i / 4];
}

template <typename Vector> void copyVector(const Vector& from, float* to) {
    for (int i = 0; i < 3; ++i)
        to[i] = from[i];
}

Ogre::String schemeOf(uint64_t pipelineKey) { return "agaa_" + std::to_string(pipelineKey); }

bool isMasked(const Ogre::Pass& pass) { return pass.getAlphaRejectFunction() != Ogre::CMPF_ALWAYS_PASS; }

/* Gives the state of a draw pass to a material. Culling stays that of the material. */
void applyState(const AgaaDrawState& state, Ogre::Pass& pass) {
    constexpr Ogre::CompareFunction compare[] = {Ogre::CMPF_LESS, Ogre::CMPF_GREATER, Ogre::CMPF_EQUAL,
                                                 Ogre::CMPF_ALWAYS_PASS};
    const auto writes = [&state](uint32_t bit) { return (state.colorWriteMask & bit) != 0; };
    pass.setDepthCheckEnabled(true);
    pass.setDepthFunction(compare[state.depthCompare]);
    pass.setDepthWriteEnabled(state.depthWrite != 0);
    pass.setColourWriteEnabled(writes(1), writes(2), writes(4), writes(8));
    pass.setSceneBlending(state.keepFirst ? Ogre::SBF_ONE_MINUS_DEST_ALPHA : Ogre::SBF_ONE,
                          state.keepFirst ? Ogre::SBF_ONE : Ogre::SBF_ZERO);
    pass.setDepthBias(0.0f, 0.0f);
    pass.setAlphaToCoverageEnabled(false);
    pass.setPolygonMode(Ogre::PM_SOLID);
}

/* Sets the state of a draw pass for which OGRE has no setting. OGRE does not change it, and the SDK restores it. */
void applyOpenGlState(const AgaaDrawState& state) {
    if (state.sampleShading)
        glEnable(GL_SAMPLE_SHADING);
    else
        glDisable(GL_SAMPLE_SHADING);
    glMinSampleShading(1.0f);
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_DITHER);
}

} // namespace

/* ---- context and views ---------------------------------------------------------------------------- */

Adapter::Adapter(Ogre::GL3PlusRenderSystem& renderSystem, Ogre::SceneManager& scene)
    : m_renderSystem(renderSystem), m_scene(scene), m_target(std::make_unique<SdkTarget>(renderSystem)) {
    if (renderSystem.getCapabilities()->hasCapability(Ogre::RSC_SEPARATE_SHADER_OBJECTS))
        OGRE_EXCEPT(Ogre::Exception::ERR_INVALID_STATE, "OGRE's separate shader objects must be off.", "Adapter");
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onLog;
    log.user = this;
    AgaaGlDeviceDesc device = AGAA_GL_DEVICE_DESC_INIT; // with AGAA_GL_STATE_RESTORE
    device.getProcAddr = getProcAddr;
    // OGRE looks for a set of shared parameters for every block that a shader declares, so the shaders have no blocks.
    // It also asserts that OpenGL reports the declared size of uniform arrays, of which drivers cut off unused
    // elements.
    device.storage = AGAA_GL_STORAGE_IMAGES;
    device.constants = AGAA_GL_CONSTANTS_TEXELS;
    device.bindings[AGAA_GL_BINDING_FRAME] = firstUnit;
    device.bindings[AGAA_GL_BINDING_METADATA] = firstUnit + 1;
    for (uint32_t i = 0; i < AGAA_MAX_SHADOW_MAPS; ++i)
        device.bindings[AGAA_GL_BINDING_SHADOW0 + i] = firstUnit + 2 + i;
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    desc.pNext = &device;
    desc.log = &log;
    desc.framesInFlight = 1; // record() waits for the frame
    check(agaaGlCreateContext(AGAA_HEADER_VERSION, &desc, &m_context), "agaaGlCreateContext");
    Ogre::ResourceGroupManager::getSingleton().createResourceGroup(group);
    Ogre::MaterialManager::getSingleton().addListener(this);
    m_scene.addRenderObjectListener(this);
}

Adapter::~Adapter() {
    destroyView();
    agaaDestroyContext(m_context);
    m_scene.removeRenderObjectListener(this);
    Ogre::MaterialManager::getSingleton().removeListener(this);
    Ogre::ResourceGroupManager::getSingleton().destroyResourceGroup(group);
}

void Adapter::onLog(void* user, uint32_t severity, AgaaResult, const char* message) {
    Ogre::LogManager::getSingleton().logMessage(Ogre::String("AGAA: ") + message);
    if (severity >= AGAA_SEVERITY_ERROR)
        static_cast<Adapter*>(user)->m_message = message;
}

void Adapter::check(AgaaResult result, const char* call) const {
    if (result < 0)
        OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR, m_message.empty() ? agaaResultString(result) : m_message,
                    call);
}

void Adapter::createView(const AgaaConfig& config, const AgaaSceneFacts& facts, uint32_t width, uint32_t height) {
    destroyView();
    AgaaViewDesc desc = AGAA_VIEW_DESC_INIT;
    desc.width = width, desc.height = height;
    desc.config = &config, desc.facts = &facts;
    desc.flags = AGAA_VIEW_CLIP_Z_FROM_MINUS_ONE; // OGRE's default, without its option "Reversed Z-Buffer"
    check(agaaGlCreateView(m_context, &desc, &m_view), "agaaGlCreateView");
    uint32_t count = 0;
    check(agaaGetDrawPasses(m_view, &count, nullptr), "agaaGetDrawPasses");
    m_passes.resize(count);
    for (AgaaDrawPass& pass : m_passes)
        agaaInitDrawPass(&pass, sizeof pass);
    check(agaaGetDrawPasses(m_view, &count, m_passes.data()), "agaaGetDrawPasses");
    std::vector<Ogre::ResourcePtr> materials;
    for (const auto& [handle, resource] : Ogre::MaterialManager::getSingleton().getResourceIterator())
        if (resource->getGroup() != group)
            materials.push_back(resource);
    for (const Ogre::ResourcePtr& material : materials)
        for (const AgaaDrawPass& pass : m_passes)
            techniqueFor(static_cast<const Ogre::Material&>(*material), pass);
}

void Adapter::destroyView() {
    agaaDestroyView(m_view);
    m_view = nullptr;
    m_passes.clear();
    m_frameIndex = 0;
}

/* ---- materials ------------------------------------------------------------------------------------ */

/* Returns the technique that draws a material in a draw pass. It belongs to a copy of the material, and has no pass if
 * the material is not to be drawn. */
Ogre::Technique* Adapter::techniqueFor(const Ogre::Material& material, const AgaaDrawPass& pass) {
    const Ogre::String name = material.getName() + "/" + schemeOf(pass.pipelineKey);
    Ogre::MaterialPtr copy = Ogre::MaterialManager::getSingleton().getByName(name, group);
    if (copy)
        return copy->getTechnique(0);
    copy = material.clone(name, true, group);
    if (copy->getNumTechniques() == 0)
        copy->createTechnique();
    Ogre::Technique& technique = *copy->getTechnique(0);
    while (technique.getNumPasses() > 1)
        technique.removePass(1);
    const bool isDrawn = technique.getNumPasses() == 1 && !technique.isTransparent() &&
                         technique.getPass(0)->hasFragmentProgram() &&
                         m_surfaceTexts.count(technique.getPass(0)->getFragmentProgramName());
    if (isDrawn)
        convert(*technique.getPass(0), pass);
    else
        technique.removeAllPasses();
    copy->load();
    return &technique;
}

/* OGRE sets every sampler and image uniform, to 0 if the material does not name it, in place of the binding that the
 * shader declares. So these bindings become constants of the material. */
void Adapter::setBindings(Ogre::GpuProgramParameters& parameters, const AgaaDrawPass& pass) {
    const uint32_t index = static_cast<uint32_t>(&pass - m_passes.data());
    uint32_t count = 0;
    check(agaaGetGlslResources(m_view, index, &count, nullptr), "agaaGetGlslResources");
    std::vector<AgaaGlslResource> resources(count);
    check(agaaGetGlslResources(m_view, index, &count, resources.data()), "agaaGetGlslResources");
    for (const AgaaGlslResource& resource : resources)
        if (parameters._findNamedConstantDefinition(resource.name)) // null if the compiler removed the resource
            parameters.setNamedConstant(resource.name, static_cast<int>(resource.binding));
}

/* Gives the fragment program and the state of a draw pass to a material. The program consists of the version, the SDK's
 * extensions and declarations, and the engine's text. */
void Adapter::convert(Ogre::Pass& material, const AgaaDrawPass& pass) {
    const Ogre::String original = material.getFragmentProgramName();
    const Ogre::String name = original + "/" + schemeOf(pass.pipelineKey) + (isMasked(material) ? "/masked" : "");
    const Ogre::String& text = m_surfaceTexts.at(original);
    const size_t line = text.find('\n') + 1;
    const Ogre::String source = text.substr(0, line) + pass.glslExtensions +
                                (isMasked(material) ? "#define AGAA_ALPHA_MASKED 1\n" : "") + pass.glslDeclarations +
                                text.substr(line);
    auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
    if (!manager.getByName(name, group))
        manager.createProgram(name, group, "glsl", Ogre::GPT_FRAGMENT_PROGRAM)->setSource(source);
    const Ogre::GpuProgramParametersSharedPtr values = material.getFragmentProgramParameters();
    material.setFragmentProgram(name);
    material.getFragmentProgramParameters()->copyMatchingNamedConstantsFrom(*values);
    setBindings(*material.getFragmentProgramParameters(), pass);
    applyState(pass.state, material);
}

/* OGRE asks for each object whose material has no technique of the viewport's scheme. */
Ogre::Technique* Adapter::handleSchemeNotFound(unsigned short, const Ogre::String& scheme, Ogre::Material* material,
                                               unsigned short, const Ogre::Renderable*) {
    for (const AgaaDrawPass& pass : m_passes)
        if (schemeOf(pass.pipelineKey) == scheme)
            return techniqueFor(*material, pass);
    return nullptr;
}

/* ---- frames --------------------------------------------------------------------------------------- */

/* The SDK restores the context's state on entry, before each draw callback and on return, and OGRE does not know. So
 * the states that OGRE remembers have the same values on entry and at the end of each draw callback. */
void Adapter::synchroniseState() {
    m_renderSystem._setViewport(nullptr);
    m_renderSystem._disableTextureUnitsFrom(0);
    glBindTextures(0, firstUnit, nullptr); // OGRE binds further textures when it reads and writes them
    glBindSamplers(0, firstUnit, nullptr);
    m_renderSystem._setDepthBufferParams(true, true, Ogre::CMPF_LESS_EQUAL);
    m_renderSystem.setColourBlendState(Ogre::ColourBlendState());
    m_renderSystem.setStencilCheckEnabled(false);
    m_renderSystem.setStencilBufferParams();
    m_renderSystem.unbindGpuProgram(Ogre::GPT_VERTEX_PROGRAM);
    m_renderSystem.unbindGpuProgram(Ogre::GPT_FRAGMENT_PROGRAM);
}

AgaaFrame Adapter::describeFrame(Ogre::Camera& camera, const Ogre::ColourValue& background) {
    AgaaFrame frame = AGAA_FRAME_INIT;
    frame.completedFrame = m_frameIndex;
    frame.frameIndex = ++m_frameIndex;
    Ogre::Matrix4 view = camera.getViewMatrix(true);
    view.setTrans(Ogre::Vector3::ZERO); // the origin of shading space is the eye
    copyMatrix(view, frame.view);
    Ogre::Matrix4 projection = camera.getProjectionMatrixWithRSDepth();
    for (int column = 0; column < 4; ++column)
        projection[1][column] = -projection[1][column]; // as OGRE does for targets that it flips
    copyMatrix(projection, frame.projection);
    m_lights.clear();
    for (const auto& [name, object] : m_scene.getMovableObjects("Light")) {
        const auto& light = static_cast<const Ogre::Light&>(*object);
        if (!light.isVisible())
            continue;
        AgaaLight each = AGAA_LIGHT_INIT;
        constexpr uint32_t types[] = {AGAA_LIGHT_POINT, AGAA_LIGHT_DIRECTIONAL, AGAA_LIGHT_SPOT}; // as LightTypes
        each.type = types[light.getType()];
        copyVector(light.getDerivedPosition() - camera.getDerivedPosition(), each.position);
        copyVector(light.getDerivedDirection().normalisedCopy(), each.direction);
        copyVector((light.getDiffuseColour() * light.getPowerScale()).ptr(), each.color);
        each.range = light.getAttenuationRange();
        each.cosInner = std::cos(0.5f * light.getSpotlightInnerAngle().valueRadians());
        each.cosOuter = std::cos(0.5f * light.getSpotlightOuterAngle().valueRadians());
        m_lights.push_back(each);
    }
    frame.lights = m_lights.data();
    frame.lightCount = static_cast<uint32_t>(m_lights.size());
    copyVector(m_scene.getAmbientLight().ptr(), frame.ambient);
    copyVector(background.ptr(), frame.background);
    frame.draw = onDraw;
    frame.drawUser = this;
    return frame;
}

void Adapter::record(Ogre::Camera& camera, const Ogre::TexturePtr& output, const Ogre::ColourValue& background) {
    synchroniseState();
    const AgaaFrame frame = describeFrame(camera, background);
    AgaaGlFrame glFrame = AGAA_GL_FRAME_INIT;
    output->getCustomAttribute("GLID", &glFrame.outputTexture);
    m_camera = &camera;
    m_message.clear();
    check(agaaGlRecordFrame(m_view, &frame, &glFrame), "agaaGlRecordFrame");
    glFinish(); // a host that lets frames overlap sets completedFrame from its fences instead
}

AgaaResult Adapter::onDraw(void* user, const AgaaDrawTarget* target) {
    auto& adapter = *static_cast<Adapter*>(user);
    AgaaResult result = AGAA_OK;
    try {
        adapter.draw(*target);
    } catch (const std::exception& e) { // exceptions must not leave a callback
        Ogre::LogManager::getSingleton().logMessage(e.what());
        result = AGAA_ERROR_CALLBACK;
    }
    adapter.m_drawTarget = nullptr;
    adapter.synchroniseState();
    return result;
}

void Adapter::draw(const AgaaDrawTarget& target) {
    m_target->setTarget(target);
    Ogre::Viewport viewport(nullptr, m_target.get(), 0.0f, 0.0f, 1.0f, 1.0f, 0);
    viewport.setMaterialScheme(schemeOf(target.pipelineKey));
    viewport.setClearEveryFrame(false); // the SDK has cleared the target
    viewport.setOverlaysEnabled(false);
    viewport.setSkiesEnabled(false); // pixels without geometry show AgaaFrame::background
    viewport.setShadowsEnabled(false);
    applyOpenGlState(target.state);
    m_renderSystem.setStencilBufferParams(Ogre::CMPF_EQUAL, 0, 0xFF, 0xFF, Ogre::SOP_KEEP, Ogre::SOP_KEEP,
                                          Ogre::SOP_INCREMENT);
    m_drawTarget = &target;
    m_scene._renderScene(m_camera, &viewport, false);
}

/* The stencil test may differ between the materials of a pass, and OGRE's materials have no stencil state. */
void Adapter::notifyRenderSingleObject(Ogre::Renderable*, const Ogre::Pass* pass, const Ogre::AutoParamDataSource*,
                                       const Ogre::LightList*, bool) {
    if (m_drawTarget)
        m_renderSystem.setStencilCheckEnabled(
            (isMasked(*pass) ? m_drawTarget->state.stencilTestMasked : m_drawTarget->state.stencilTest) != 0);
}

} // namespace agaaOgre
