/* The state of the OpenGL context, to check that the SDK leaves it as it was.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <map>
#include <string>
#include <vector>

class vtkOpenGLState;

using GlState = std::map<std::string, std::vector<long long>>;

GlState readGlState();
/* Returns the names of the states that differ, separated by spaces. */
std::string differingStates(const GlState& before, const GlState& after);
/* Returns the names of the states of which VTK's copy differs from the context. */
std::string mistakenStates(vtkOpenGLState& copy);
/* Returns the number of pending OpenGL errors, and removes them. */
unsigned takeGlErrors();
/* Counts debug messages of high severity from now on. */
void countSevereMessages();
unsigned severeMessages();
