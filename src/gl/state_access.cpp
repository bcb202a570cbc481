#include "gl/state_access.h"

#include <cstdint>

namespace agaa::gl {
namespace {

// Reads count components of one parameter from component first on.
void readParameter(const GladGLContext& gl, GLenum parameter, char type, const uint32_t* index, size_t first,
                   size_t count, StateValue& out) {
    const auto get = [&](auto plain, auto indexed, auto* data) {
        if (index != nullptr)
            indexed(parameter, *index, data);
        else
            plain(parameter, data);
    };
    // Larger than any answer: some drivers write two values for GL_POLYGON_MODE where one is specified.
    GLboolean booleans[8]{};
    GLint integers[8]{};
    GLint64 longs[8]{};
    GLdouble reals[8]{};
    switch (type) {
    case 'b':
        get(gl.GetBooleanv, gl.GetBooleani_v, booleans);
        break;
    case 'u': // not read as GLint: drivers may clamp it to 2^31 - 1
    case 'l':
        get(gl.GetInteger64v, gl.GetInteger64i_v, longs);
        break;
    case 'f':
        get(gl.GetDoublev, gl.GetDoublei_v, reals);
        break;
    default:
        get(gl.GetIntegerv, gl.GetIntegeri_v, integers);
        break;
    }
    for (size_t i = 0; i < count; ++i) {
        if (type == 'f')
            out.setReal(first + i, reals[i]);
        else if (type == 'b')
            out.setInteger(first + i, booleans[i] != GL_FALSE);
        else if (type == 'u')
            out.setInteger(first + i, static_cast<uint32_t>(longs[i]));
        else
            out.setInteger(first + i, type == 'l' ? longs[i] : integers[i]);
    }
}

} // namespace

void readValues(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    const uint32_t* index = row.array == StateArray::Once ? nullptr : &element;
    if (row.parameters[1] == 0) {
        readParameter(reading.gl(), row.parameters[0], row.layout[0], index, 0, row.layout.size(), out);
        return;
    }
    for (size_t i = 0; i < row.layout.size(); ++i)
        readParameter(reading.gl(), row.parameters[i], row.layout[i], index, i, 1, out);
}

void readCapability(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    out.setInteger(0, reading.gl().IsEnabled(row.parameters[0] + element) != GL_FALSE);
}

void writeCapability(const StateContext& context, const StateRow& row, uint32_t element, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    (value.integer(0) != 0 ? gl.Enable : gl.Disable)(row.parameters[0] + element);
}

void readCapabilityAt(const StateReading& reading, const StateRow& row, uint32_t element, StateValue& out) {
    out.setInteger(0, reading.gl().IsEnabledi(row.parameters[0], element) != GL_FALSE);
}

void writeCapabilityAt(const StateContext& context, const StateRow& row, uint32_t element, const StateValue& value) {
    const GladGLContext& gl = context.gl();
    (value.integer(0) != 0 ? gl.Enablei : gl.Disablei)(row.parameters[0], element);
}

} // namespace agaa::gl
