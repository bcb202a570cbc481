/* SPDX-License-Identifier: MIT */
#pragma once

#include <vtk_glew.h>

#define ENGINE_GL_CALL GLAPIENTRY
