/* SPDX-License-Identifier: MIT */
#pragma once

#include <RenderSystems/GL3Plus/OgreGL3PlusPrerequisites.h>

#define ENGINE_GL_CALL APIENTRY
