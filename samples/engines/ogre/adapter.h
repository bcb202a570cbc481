/* Connects OGRE 1.12 (GL3Plus) to the AGAA SDK. docs/integration/engines.md describes the order of calls.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "agaa_gl.h"

#include <Ogre.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace Ogre {
class GL3PlusRenderSystem;
}

namespace agaaOgre {

class SdkTarget; // the SDK's framebuffers as an OGRE render target

/* A view of the SDK that draws the scene of an OGRE camera. All functions need OGRE's OpenGL context to be current.
 *
 * Materials    The first pass of a material's first technique is drawn. Its fragment program needs a surface text, and
 *              its vertex program must declare `invariant gl_Position`. A pass with an alpha rejection is a cut-out.
 *              Transparent passes, and passes without a surface text, are not drawn.
 * Lights       An OGRE light is an inverse-square light with OGRE's attenuation range. */
class Adapter : Ogre::MaterialManager::Listener, Ogre::RenderObjectListener {
public:
    Adapter(Ogre::GL3PlusRenderSystem& renderSystem, Ogre::SceneManager& scene);
    ~Adapter() override;
    Adapter(const Adapter&) = delete;

    /* Sets the GLSL from which the fragment programs of draw passes are made: a #version line, and code that fills an
     * AgaaSurfaceInput. OGRE's programs do not keep their text: it is replaced by what OGRE's preprocessor leaves. */
    void setSurfaceText(const Ogre::String& fragmentProgram, const Ogre::String& text) {
        m_surfaceTexts[fragmentProgram] = text;
    }

    /* Creates the view, in place of an earlier one, and the materials for its draw passes. It throws an Ogre::Exception
     * with the SDK's sentence if the SDK refuses the view. */
    void createView(const AgaaConfig& config, const AgaaSceneFacts& facts, uint32_t width, uint32_t height);
    void destroyView();

    /* Brings the states of which OGRE keeps copies to fixed values, in OGRE and in the context. record() begins with
     * it; a host that compares the context's state before and after record() calls it, too. */
    void synchroniseState();
    /* Runs a frame. `output` has the size of the view; row 0 is the top of the image, as in OGRE's render textures. */
    void record(Ogre::Camera& camera, const Ogre::TexturePtr& output, const Ogre::ColourValue& background);

    AgaaView view() const { return m_view; }
    uint64_t frameIndex() const { return m_frameIndex; } // of the newest frame
    const std::vector<AgaaDrawPass>& passes() const { return m_passes; }

private:
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    static void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message);
    Ogre::Technique* handleSchemeNotFound(unsigned short, const Ogre::String& scheme, Ogre::Material* material,
                                          unsigned short, const Ogre::Renderable*) override;
    void notifyRenderSingleObject(Ogre::Renderable*, const Ogre::Pass* pass, const Ogre::AutoParamDataSource*,
                                  const Ogre::LightList*, bool) override;
    void check(AgaaResult result, const char* call) const;
    Ogre::Technique* techniqueFor(const Ogre::Material& material, const AgaaDrawPass& pass);
    void convert(Ogre::Pass& material, const AgaaDrawPass& pass);
    void setBindings(Ogre::GpuProgramParameters& parameters, const AgaaDrawPass& pass);
    AgaaFrame describeFrame(Ogre::Camera& camera, const Ogre::ColourValue& background);
    void draw(const AgaaDrawTarget& target);

    Ogre::GL3PlusRenderSystem& m_renderSystem;
    Ogre::SceneManager& m_scene;
    AgaaContext m_context = nullptr;
    AgaaView m_view = nullptr;
    std::map<Ogre::String, Ogre::String> m_surfaceTexts; // by fragment program
    std::vector<AgaaDrawPass> m_passes;
    std::vector<AgaaLight> m_lights;
    std::unique_ptr<SdkTarget> m_target;
    Ogre::Camera* m_camera = nullptr;             // of the frame that is recorded
    const AgaaDrawTarget* m_drawTarget = nullptr; // during a draw callback
    uint64_t m_frameIndex = 0;
    std::string m_message; // the SDK's last error
};

} // namespace agaaOgre
