/* VTK's own copy of the state of the OpenGL context. SPDX-License-Identifier: MIT */
#pragma once

#include <string>

class vtkOpenGLState;

/* Returns the names of the states of which VTK's copy differs from the context. */
std::string mistakenStates(vtkOpenGLState& copy);
