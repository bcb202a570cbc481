// Chains of structs. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_CHAIN_HPP
#define AGAA_CPP_CHAIN_HPP

#include "agaa_sdk.h"

#include <type_traits>

namespace agaa {

// True if a struct of type Next may be chained to one of type Root. A host that chains a struct of its own, with
// AGAA_STRUCTURE_TYPE_OPTIONAL_BIT, may add a specialisation.
template <class Root, class Next> inline constexpr bool isChainable = false;
template <> inline constexpr bool isChainable<AgaaConfig, AgaaAggregation> = true;
template <> inline constexpr bool isChainable<AgaaConfig, AgaaDecoupledCoverage> = true;
template <> inline constexpr bool isChainable<AgaaConfig, AgaaAdaptiveSampling> = true;
template <> inline constexpr bool isChainable<AgaaConfig, AgaaTemporal> = true;
template <> inline constexpr bool isChainable<AgaaConfig, AgaaMeasurement> = true;
template <> inline constexpr bool isChainable<AgaaViewDesc, AgaaGBufferFunction> = true;
template <> inline constexpr bool isChainable<AgaaViewDesc, AgaaFetchFunction> = true;
template <> inline constexpr bool isChainable<AgaaViewDesc, AgaaShadowFunction> = true;
template <> inline constexpr bool isChainable<AgaaViewDesc, AgaaShadingFunction> = true;
template <> inline constexpr bool isChainable<AgaaViewDesc, AgaaResolvedOutputs> = true;
template <> inline constexpr bool isChainable<AgaaFrame, AgaaTemporalFrame> = true;

namespace detail {

template <class T, class... Others>
constexpr bool areDistinct = (!std::is_same_v<T, Others> && ...) && areDistinct<Others...>;
template <class T> constexpr bool areDistinct<T> = true;

template <class Last> void link(Last& last) noexcept { last.pNext = nullptr; }
template <class First, class Second, class... Rest> void link(First& first, Second& second, Rest&... rest) noexcept {
    first.pNext = &second;
    link(second, rest...);
}

} // namespace detail

// Chains the structs to root, in their order, in place of an earlier chain. The structs must exist as long as the
// chain is read. Returns root. Structs that the library does not accept in this chain, and a type twice, do not
// compile.
template <class Root, class... Next> Root& chain(Root& root, Next&... next) noexcept {
    static_assert((isChainable<Root, Next> && ...), "A struct may not be chained to the first one.");
    static_assert(detail::areDistinct<Root, Next...>, "A chain holds a struct twice.");
    detail::link(root, next...);
    return root;
}

} // namespace agaa

#endif // AGAA_CPP_CHAIN_HPP
