// AGAA SDK for C++17 and later: owners of handles, results with values, lists. Header-only, over the C functions.
// SPDX-License-Identifier: MIT
//
// Conventions
//   Names      agaaX is agaa::x, agaaVkX is agaa::vk::x (agaa_vk.hpp), agaaGlX is agaa::gl::x (agaa_gl.hpp). The
//              comments of the C functions hold: ranges, errors, threads, state of OpenGL.
//   Structs    Structs, enumerations and flags are those of C. agaa::init<T>() has the defaults of AGAA_…_INIT.
//   Handles    agaa::Context and agaa::View own a handle. Functions take the handle, as agaa::View::get() returns it.
//   Errors     Functions return AgaaResult or agaa::Result<T>, and throw nothing. Functions that return a vector or a
//              string allocate: std::bad_alloc leaves them, or ends the program if it has no exceptions. All others
//              are noexcept. The header needs neither exceptions nor RTTI.
//   Texts      std::string_view: static storage, with a zero behind the text. std::string: the caller's.
//              Texts in parameters are const char*, because C needs the zero.
//
// The graphics APIs have headers of their own, as in C, so that the order of includes does not matter.
#ifndef AGAA_HPP
#define AGAA_HPP

#include "agaa_sdk.h"

#include "agaa/cpp/array_view.hpp"
#include "agaa/cpp/callbacks.hpp"
#include "agaa/cpp/chain.hpp"
#include "agaa/cpp/init.hpp"
#include "agaa/cpp/owner.hpp"
#include "agaa/cpp/queries.hpp"
#include "agaa/cpp/result.hpp"
#include "agaa/cpp/views.hpp"

#endif // AGAA_HPP
