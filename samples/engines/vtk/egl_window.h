/* A render window of VTK on an OpenGL context without a window system. Debian's VTK has no vtkEGLRenderWindow.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

class EglWindow : public vtkGenericOpenGLRenderWindow {
public:
    static EglWindow* New();
    vtkTypeMacro(EglWindow, vtkGenericOpenGLRenderWindow);

    void MakeCurrent() override;
    bool IsCurrent() override;

protected:
    EglWindow();
    ~EglWindow() override;
    void OpenGLInitContext() override;

private:
    void* m_display = nullptr;
    void* m_context = nullptr;
};
