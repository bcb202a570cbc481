#include "gl/host_bindings.h"

#include "gl/state_table.h"

namespace agaa::gl {

HostBindings::HostBindings(const GladGLContext& gl, const HostDialect& dialect, bool compatibilityProfile)
    : context_(gl, hostBindings(dialect), compatibilityProfile) {
    size_t count = 0;
    for (const StateRow& row : bindingRows())
        if (row.array != StateArray::Once && context_.has(row)) {
            rows_.push_back(row);
            count += context_.elements(row.array).size();
        }
    values_.resize(count);
}

void HostBindings::capture() {
    const StateReading reading(context_);
    auto value = values_.begin();
    for (const StateRow& row : rows_)
        for (const uint32_t element : context_.elements(row.array))
            row.read(reading, row, element, *value++);
}

// Binding to an index also binds to the target, and binding a texture changes the active unit. Both keep the values
// that the callback left.
void HostBindings::restore() noexcept {
    const GladGLContext& gl = context_.gl();
    GLint uniformBuffer = 0, storageBuffer = 0, activeTexture = 0;
    gl.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &uniformBuffer);
    gl.GetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &storageBuffer);
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &activeTexture);
    auto value = values_.begin();
    for (const StateRow& row : rows_)
        for (const uint32_t element : context_.elements(row.array))
            row.write(context_, row, element, *value++);
    gl.BindBuffer(GL_UNIFORM_BUFFER, GLuint(uniformBuffer));
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, GLuint(storageBuffer));
    gl.ActiveTexture(GLenum(activeTexture));
}

} // namespace agaa::gl
