/* Connects VTK 9.1 to the AGAA SDK. docs/integration/engines.md describes the order of calls.
 * SPDX-License-Identifier: MIT */
#pragma once

#include "agaa_gl.h"

#include <vtkNew.h>
#include <vtkOpenGLRenderPass.h>
#include <vtkTextureObject.h>
#include <vtkTimeStamp.h>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace agaaVtk {

/* A render pass that draws the opaque geometry with a view of the SDK, in place of vtkOpaquePass. All functions need
 * VTK's OpenGL context to be current.
 *
 * Actors     Visible actors with the interpolation PBR, triangles and point normals are drawn, with the texture
 *            "albedoTex". An actor whose fragment uniforms have `alphaCutoff` is a cut-out. Translucent actors, lines
 *            and points are not drawn.
 * Lights     Positional lights need the attenuation (0, 0, q). Cones of spot lights are hard.
 * Output     Render() draws the frame into the framebuffer that is bound, without its depth. */
class Adapter : public vtkOpenGLRenderPass {
public:
    static Adapter* New();
    vtkTypeMacro(Adapter, vtkOpenGLRenderPass);

    void createContext(); // of the SDK, in that of VTK
    /* Creates the view, in place of an earlier one. createContext() and createView() throw a std::runtime_error with
     * the SDK's sentence if the SDK refuses. */
    void createView(vtkOpenGLRenderWindow& window, const AgaaConfig& config, const AgaaSceneFacts& facts,
                    uint32_t width, uint32_t height);
    void destroyView();

    void Render(const vtkRenderState* state) override; // runs record() and copyOutput()
    void record(const vtkRenderState* state);          // runs a frame, into a texture of the adapter
    void copyOutput(const vtkRenderState* state);      // draws the texture into the framebuffer that is bound
    void ReleaseGraphicsResources(vtkWindow* window) override;

    AgaaView view() const { return m_view; }
    uint64_t frameIndex() const { return m_frameIndex; } // of the newest frame
    const std::vector<AgaaDrawPass>& passes() const { return m_passes; }
    const std::string& message() const { return m_message; } // of the newest frame's error; empty if it has none
    uint64_t shadersWritten() const { return m_shadersWritten; }

protected:
    Adapter() = default;
    ~Adapter() override;

    bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                vtkAbstractMapper* mapper, vtkProp* prop) override;
    bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
                                 vtkAbstractMapper* mapper, vtkProp* prop) override;
    vtkMTimeType GetShaderStageMTime() override { return m_stageTime.GetMTime(); }

private:
    static AgaaResult AGAA_CALL onDraw(void* user, const AgaaDrawTarget* target);
    static void AGAA_CALL onLog(void* user, uint32_t severity, AgaaResult code, const char* message);
    void check(AgaaResult result, const char* call) const;
    AgaaFrame describeFrame(vtkRenderer& renderer);
    void addLights(vtkRenderer& renderer);
    void draw(const AgaaDrawTarget& target);

    AgaaContext m_context = nullptr;
    AgaaView m_view = nullptr;
    std::vector<AgaaDrawPass> m_passes;
    std::vector<AgaaLight> m_lights;
    vtkNew<vtkTextureObject> m_output;
    const vtkRenderState* m_state = nullptr; // of the frame that is recorded
    const AgaaDrawPass* m_pass = nullptr;    // for which shaders were made last
    vtkTimeStamp m_stageTime;                // of the change of m_pass
    uint64_t m_frameIndex = 0, m_shadersWritten = 0;
    std::string m_message; // the SDK's last error
};

} // namespace agaaVtk
