// One row of the state table: the name of a state, and how it is read and written.
#pragma once

#include <glad/gl.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace agaa::gl {

class StateContext;
class StateReading;
struct StateRow;

// Holds up to six components; StateRow::layout gives their types.
class StateValue {
public:
    int64_t integer(size_t i) const { return words_[i]; }
    double real(size_t i) const { return std::bit_cast<double>(words_[i]); }
    GLuint name(size_t i = 0) const { return static_cast<GLuint>(words_[i]); }
    void setInteger(size_t i, int64_t value) { words_[i] = value; }
    void setReal(size_t i, double value) { words_[i] = std::bit_cast<int64_t>(value); }
    bool operator==(const StateValue&) const = default;

private:
    std::array<int64_t, 6> words_{};
};

enum class StateProfile : uint8_t { Any, Core, Compatibility };

// Elements for which a row is repeated.
enum class StateArray : uint8_t {
    Once,
    TextureUnits,
    UniformBindings,
    StorageBindings,
    ImageUnits,
    DrawBuffers,
    Viewports,
    ClipDistances,
    SampleMaskWords,
};
inline constexpr size_t kStateArrays = 9;

using StateRead = void (*)(const StateReading&, const StateRow&, uint32_t element, StateValue&);
using StateWrite = void (*)(const StateContext&, const StateRow&, uint32_t element, const StateValue&);

struct StateNeed {
    const char* name = nullptr; // for the documentation
    bool (*met)(const GladGLContext&) = nullptr;
};

// element: the texture unit, binding point, draw buffer or viewport; 0 with StateArray::Once.
struct StateRow {
    const char* name; // as in the OpenGL specification; multiple names if one call sets them
    const char* description;
    std::array<GLenum, 6> parameters; // read by glGet: one for all components, or one for each
    // A letter for each component: b boolean, e enum, i integer, u 32-bit mask or index, l 64-bit
    // integer, f number, o name of an object.
    std::string_view layout;
    StateRead read;
    StateWrite write;
    StateArray array = StateArray::Once;
    StateProfile profile = StateProfile::Any;
    StateNeed need{};
};

} // namespace agaa::gl
