/* The state of the OpenGL context, to check that the SDK leaves it as it was. Each engine has its own OpenGL header:
 * engine_gl.h in its folder, which defines ENGINE_GL_CALL, too.
 * SPDX-License-Identifier: MIT */
#pragma once

#include <map>
#include <string>
#include <vector>

using GlState = std::map<std::string, std::vector<long long>>;

GlState readGlState();
/* Returns the names of the states that differ, separated by spaces. */
std::string differingStates(const GlState& before, const GlState& after);
/* Returns the number of pending OpenGL errors, and removes them. */
unsigned takeGlErrors();
/* Counts debug messages of high severity from now on. */
void countSevereMessages();
unsigned severeMessages();
