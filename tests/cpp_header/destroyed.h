// Counts the calls of agaaDestroyContext and agaaDestroyView in this program, which defines both in front of the
// library and calls the library's.
#pragma once

#include "agaa.hpp"

#include <vector>

namespace destroyed {

// Handles in the order of their destruction, since the last clear().
std::vector<void*>& handles();

// Handles that belong to no library: destroying them is only counted. Contexts in `refused` are not destroyed, as
// those that have views.
inline char fakes[64];
template <class Handle> Handle fake(size_t number) { return reinterpret_cast<Handle>(fakes + number); }
std::vector<AgaaContext>& refused();

} // namespace destroyed
