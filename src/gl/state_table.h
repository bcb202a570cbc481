// The states that come back to the host: one row each, in the order in which they are set. The
// guard, its test and docs/state.md are all made from it.
#pragma once

#include "gl/state_row.h"

#include <span>

namespace agaa::gl {

// A row that setting another one changes stands after that one.
std::span<const StateRow> stateTable();

// Its parts, by topic.
std::span<const StateRow> capabilityRows();
std::span<const StateRow> rasterRows();
std::span<const StateRow> fragmentRows();
std::span<const StateRow> pixelRows();
std::span<const StateRow> bindingRows();

} // namespace agaa::gl
