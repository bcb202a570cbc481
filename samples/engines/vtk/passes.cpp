/* SPDX-License-Identifier: MIT */
#include "passes.h"

#include "common/gl_state.h"
#include "vtk_state.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtk_glew.h>

vtkStandardNewMacro(FloatTargetPass);
vtkStandardNewMacro(CheckedPass);

void FloatTargetPass::Render(const vtkRenderState* state) {
    vtkRenderer* renderer = state->GetRenderer();
    auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
    const int width = renderer->GetSize()[0], height = renderer->GetSize()[1];
    if (!m_color->GetHandle()) {
        m_color->SetContext(window);
        m_color->Create2D(unsigned(width), unsigned(height), 4, VTK_FLOAT, false);
        m_framebuffer->SetContext(window);
    }
    vtkOpenGLState* openGl = window->GetState();
    openGl->PushFramebufferBindings();
    m_framebuffer->Bind();
    m_framebuffer->AddColorAttachment(0, m_color);
    m_framebuffer->ActivateBuffer(0);
    m_framebuffer->AddDepthAttachment();
    m_framebuffer->StartNonOrtho(width, height);
    openGl->vtkglEnable(GL_DEPTH_TEST);
    vtkRenderState inner(renderer);
    inner.SetPropArrayAndCount(state->GetPropArray(), state->GetPropArrayCount());
    inner.SetFrameBuffer(m_framebuffer);
    m_delegate->Render(&inner);
    openGl->PopFramebufferBindings();
}

void FloatTargetPass::ReleaseGraphicsResources(vtkWindow* window) {
    m_framebuffer->ReleaseGraphicsResources(window);
    m_color->ReleaseGraphicsResources(window);
    m_delegate->ReleaseGraphicsResources(window);
}

std::vector<float> FloatTargetPass::read() const {
    std::vector<float> pixels(4 * size_t(m_color->GetWidth()) * m_color->GetHeight());
    glGetTextureImage(m_color->GetHandle(), 0, GL_RGBA, GL_FLOAT, GLsizei(pixels.size() * sizeof(float)),
                      pixels.data());
    return pixels;
}

void CheckedPass::Render(const vtkRenderState* state) {
    vtkOpenGLState& openGl = *static_cast<vtkOpenGLRenderer*>(state->GetRenderer())->GetState();
    const GlState before = readGlState();
    m_adapter->record(state);
    m_changed = differingStates(before, readGlState());
    m_mistaken = mistakenStates(openGl);
    m_adapter->copyOutput(state);
}
