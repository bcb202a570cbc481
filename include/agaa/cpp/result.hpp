// Results: a value, or the code that says why there is none. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_RESULT_HPP
#define AGAA_CPP_RESULT_HPP

#include "agaa/base.h"

#include <cassert>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace agaa {

[[nodiscard]] constexpr bool isError(AgaaResult result) noexcept { return result < 0; }
[[nodiscard]] inline std::string_view resultString(AgaaResult result) noexcept { return agaaResultString(result); }
[[nodiscard]] inline std::string_view resultName(AgaaResult result) noexcept { return agaaResultName(result); }
[[nodiscard]] inline uint32_t getVersion() noexcept { return agaaGetVersion(); }

// The code of a call without a value: an error, or AGAA_NOT_READY.
struct Failure {
    AgaaResult code;
};

// Holds a value and AGAA_OK, or another code and no value. Access to a value that does not exist is a mistake of the
// program: an assertion fails, and without assertions the behaviour is undefined.
template <class T> class [[nodiscard]] Result {
    static_assert(std::is_object_v<T> && !std::is_same_v<std::remove_cv_t<T>, Failure>);

public:
    using Value = T;

    Result(T value) noexcept(std::is_nothrow_move_constructible_v<T>) : value_(std::move(value)) {}
    Result(Failure failure) noexcept : code_(failure.code) { assert(failure.code != AGAA_OK); }

    [[nodiscard]] bool hasValue() const noexcept { return value_.has_value(); }
    [[nodiscard]] explicit operator bool() const noexcept { return hasValue(); }
    // AGAA_OK if there is a value.
    [[nodiscard]] AgaaResult code() const noexcept { return code_; }
    // False for AGAA_NOT_READY, which has no value either.
    [[nodiscard]] bool isError() const noexcept { return agaa::isError(code_); }

    [[nodiscard]] T& value() & noexcept { return checked(*this); }
    [[nodiscard]] const T& value() const& noexcept { return checked(*this); }
    // Moves the value out, so that a loop may run over a list that a function has just returned.
    [[nodiscard]] T value() && { return std::move(checked(*this)); }
    [[nodiscard]] T& operator*() & noexcept { return checked(*this); }
    [[nodiscard]] const T& operator*() const& noexcept { return checked(*this); }
    [[nodiscard]] T operator*() && { return std::move(checked(*this)); }
    [[nodiscard]] T* operator->() noexcept { return std::addressof(checked(*this)); }
    [[nodiscard]] const T* operator->() const noexcept { return std::addressof(checked(*this)); }

    [[nodiscard]] T valueOr(T other) const& { return hasValue() ? *value_ : std::move(other); }
    [[nodiscard]] T valueOr(T other) && { return hasValue() ? std::move(*value_) : std::move(other); }

private:
    template <class Self> static auto& checked(Self& self) noexcept {
        assert(self.hasValue());
        return *self.value_;
    }

    std::optional<T> value_;
    AgaaResult code_ = AGAA_OK;
};

} // namespace agaa

#endif // AGAA_CPP_RESULT_HPP
