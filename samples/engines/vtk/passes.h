/* Render passes of the host: one renders into a texture of floats, one checks what a frame of the SDK leaves behind.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "adapter.h"

#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>
#include <vtkTextureObject.h>

#include <string>
#include <vector>

/* Renders another pass into a texture, in place of VTK's framebuffer with 8 bits per channel. */
class FloatTargetPass : public vtkRenderPass {
public:
    static FloatTargetPass* New();
    vtkTypeMacro(FloatTargetPass, vtkRenderPass);

    void setDelegate(vtkRenderPass* pass) { m_delegate = pass; }
    void Render(const vtkRenderState* state) override;
    void ReleaseGraphicsResources(vtkWindow* window) override;
    std::vector<float> read() const; // linear RGBA, row 0 at the bottom

private:
    vtkSmartPointer<vtkRenderPass> m_delegate;
    vtkNew<vtkOpenGLFramebufferObject> m_framebuffer;
    vtkNew<vtkTextureObject> m_color;
};

/* Renders with the SDK, and compares the state of the context and VTK's copy of it before and after the frame. */
class CheckedPass : public vtkRenderPass {
public:
    static CheckedPass* New();
    vtkTypeMacro(CheckedPass, vtkRenderPass);

    void setAdapter(agaaVtk::Adapter* adapter) { m_adapter = adapter; }
    void Render(const vtkRenderState* state) override;
    /* Names of states that the frame changed, and of states that VTK believes to be different; empty: none. */
    const std::string& changed() const { return m_changed; }
    const std::string& mistaken() const { return m_mistaken; }

private:
    vtkSmartPointer<agaaVtk::Adapter> m_adapter;
    std::string m_changed, m_mistaken;
};
