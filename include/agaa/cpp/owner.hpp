// Owners of handles. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_OWNER_HPP
#define AGAA_CPP_OWNER_HPP

#include "agaa/base.h"

#include <cassert>
#include <utility>

namespace agaa {
namespace detail {

inline AgaaResult destroy(AgaaContext context) noexcept { return agaaDestroyContext(context); }
inline AgaaResult destroy(AgaaView view) noexcept {
    agaaDestroyView(view);
    return AGAA_OK;
}

} // namespace detail

// Owns a handle or none, and destroys it once. Destroy views before their context: an object declares its context
// first, and resets its views before it assigns a context. The device must have finished the frames of a view, and on
// OpenGL the context must be current, when the owner destroys the handle. One call at a time per context.
template <class Handle> class Owner {
public:
    Owner() noexcept = default;
    explicit Owner(Handle handle) noexcept : handle_(handle) {}
    Owner(Owner&& other) noexcept : handle_(other.release()) {}
    // Destroys the earlier handle. Assigning an owner to itself changes nothing.
    Owner& operator=(Owner&& other) noexcept {
        Owner(std::move(other)).swap(*this);
        return *this;
    }
    // A context that still has views is kept by the library: an assertion fails, and the log reports it.
    ~Owner() {
        [[maybe_unused]] const AgaaResult result = reset();
        assert(result == AGAA_OK && "A context is destroyed before its views.");
    }

    [[nodiscard]] Handle get() const noexcept { return handle_; }
    [[nodiscard]] explicit operator bool() const noexcept { return handle_ != nullptr; }
    // Gives the handle up: the caller destroys it.
    [[nodiscard]] Handle release() noexcept { return std::exchange(handle_, nullptr); }
    // Destroys the handle, if there is one. Always AGAA_OK for views. AGAA_ERROR_WRONG_ORDER if a context still has
    // views: the owner keeps the handle.
    AgaaResult reset() noexcept {
        const AgaaResult result = handle_ == nullptr ? AgaaResult(AGAA_OK) : detail::destroy(handle_);
        if (result == AGAA_OK)
            handle_ = nullptr;
        return result;
    }
    void swap(Owner& other) noexcept { std::swap(handle_, other.handle_); }
    friend void swap(Owner& left, Owner& right) noexcept { left.swap(right); }

private:
    Handle handle_ = nullptr;
};

using Context = Owner<AgaaContext>;
using View = Owner<AgaaView>;

} // namespace agaa

#endif // AGAA_CPP_OWNER_HPP
