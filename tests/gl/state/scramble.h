// Sets every state of the table to something else, by OpenGL calls of its own: what the table's
// rows read and write is checked against them.
#pragma once

#include "host_objects.h"
#include "state_text.h"

#include <string>
#include <vector>

namespace agaa::test {

// The values depend on the seed alone; those of seeds 2 n and 2 n + 1 differ in every row that may
// take two values or more.
void scrambleState(const gl::StateContext& context, const HostObjects& objects, uint32_t seed);
// One row's element. False if there is no scrambler for the row.
bool scrambleRow(const gl::StateContext& context, const HostObjects& objects, uint32_t seed, const gl::StateRow& row,
                 uint32_t element);

std::vector<StateText> readState(const GladGLContext& gl, const gl::StateScope& scope, bool compatibilityProfile);
// A line for each state that differs: its name, the first value and the second.
std::vector<std::string> differences(const std::vector<StateText>& first, const std::vector<StateText>& second);

} // namespace agaa::test
