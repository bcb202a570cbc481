// The table of the states that the SDK restores, in the order in which they are written. The guard, its test and
// docs/state.md use it.
#pragma once

#include "gl/state_row.h"

#include <span>

namespace agaa::gl {

// If writing one row changes the state of another row, the other row follows it.
std::span<const StateRow> stateTable();

// Parts of the table, by topic.
std::span<const StateRow> capabilityRows();
std::span<const StateRow> rasterRows();
std::span<const StateRow> fragmentRows();
std::span<const StateRow> pixelRows();
std::span<const StateRow> bindingRows();

} // namespace agaa::gl
