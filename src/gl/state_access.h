// Functions that read and write rows of the state table. They follow the component types of the row and the signature
// of the OpenGL function that sets the state.
#pragma once

#include "gl/state_context.h"

#include <type_traits>
#include <utility>

namespace agaa::gl {

// Reads the row's parameters by glGet, indexed by element unless the row is StateArray::Once.
void readValues(const StateReading&, const StateRow&, uint32_t element, StateValue&);

// Read and write by glIsEnabled, glEnable and glDisable.
void readCapability(const StateReading&, const StateRow&, uint32_t element, StateValue&);
void writeCapability(const StateContext&, const StateRow&, uint32_t element, const StateValue&);
// Read and write by glIsEnabledi, glEnablei and glDisablei.
void readCapabilityAt(const StateReading&, const StateRow&, uint32_t element, StateValue&);
void writeCapabilityAt(const StateContext&, const StateRow&, uint32_t element, const StateValue&);

inline constexpr StateNeed kMixedSamples{"GL_NV_framebuffer_mixed_samples",
                                         [](const GladGLContext& gl) { return gl.NV_framebuffer_mixed_samples != 0; }};

template <typename T> T component(const StateValue& value, size_t i) {
    if constexpr (std::is_floating_point_v<T>)
        return static_cast<T>(value.real(i));
    else
        return static_cast<T>(value.integer(i));
}

// Calls an OpenGL function with the leading arguments, followed by the components.
template <typename... Parameters, typename... Leading>
void callWith(void(GLAD_API_PTR* function)(Parameters...), const StateValue& value, Leading... leading) {
    constexpr size_t count = sizeof...(Leading);
    const std::array<GLuint, count + 1> first{static_cast<GLuint>(leading)...};
    [&]<size_t... I>(std::index_sequence<I...>) {
        function((I < count ? static_cast<Parameters>(first[I < count ? I : 0])
                            : component<Parameters>(value, I < count ? 0 : I - count))...);
    }
    (std::index_sequence_for<Parameters...>{});
}

// Calls Function(constants…, components…).
template <auto Function, GLenum... Constants>
void set(const StateContext& context, const StateRow&, uint32_t, const StateValue& value) {
    callWith(context.gl().*Function, value, Constants...);
}

// Calls Function(element, components…).
template <auto Function>
void setAt(const StateContext& context, const StateRow&, uint32_t element, const StateValue& value) {
    callWith(context.gl().*Function, value, element);
}

// Calls Function(parameter, components…).
template <auto Function>
void setParameter(const StateContext& context, const StateRow& row, uint32_t, const StateValue& value) {
    callWith(context.gl().*Function, value, row.parameters[0]);
}

// Returns the object's name, or 0 if the host has deleted the object since it was read.
template <auto IsObject> GLuint existingName(const StateContext& context, GLuint name) {
    return name != 0 && (context.gl().*IsObject)(name) == GL_TRUE ? name : 0;
}

} // namespace agaa::gl
