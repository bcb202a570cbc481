// Views of arrays in parameters. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_ARRAY_VIEW_HPP
#define AGAA_CPP_ARRAY_VIEW_HPP

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace agaa {

// A view of constant elements: made of an array, a std::vector, a std::array, a std::span, or a pointer and a length.
// std::span itself is not in C++17, and functions of this header are the same in all versions of C++. The elements
// must exist as long as the view is used.
template <class T> class ArrayView {
    template <class Range>
    static constexpr bool isRange = std::is_same_v<std::remove_cv_t<std::remove_pointer_t<Range>>, T>;

public:
    constexpr ArrayView() noexcept = default;
    constexpr ArrayView(const T* data, size_t size) noexcept : data_(data), size_(size) {}
    template <class Range, class = std::enable_if_t<isRange<decltype(std::data(std::declval<const Range&>()))>>>
    constexpr ArrayView(const Range& range) noexcept : data_(std::data(range)), size_(std::size(range)) {}

    [[nodiscard]] constexpr const T* data() const noexcept { return data_; }
    [[nodiscard]] constexpr size_t size() const noexcept { return size_; }
    // The size as the C functions and structs have it.
    [[nodiscard]] constexpr uint32_t count() const noexcept {
        assert(size_ <= UINT32_MAX);
        return static_cast<uint32_t>(size_);
    }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr const T* begin() const noexcept { return data_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] constexpr const T& operator[](size_t index) const noexcept {
        assert(index < size_);
        return data_[index];
    }

private:
    const T* data_ = nullptr;
    size_t size_ = 0;
};

// Returns the text of a member such as AgaaSurface::name, up to its zero. The struct owns the text.
template <size_t size> [[nodiscard]] constexpr std::string_view text(const char (&array)[size]) noexcept {
    const std::string_view whole(array, size);
    return whole.substr(0, whole.find('\0'));
}

} // namespace agaa

#endif // AGAA_CPP_ARRAY_VIEW_HPP
