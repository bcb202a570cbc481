#include "gl/state_guard.h"

#include "gl/state_table.h"

namespace agaa::gl {

StateGuard::StateGuard(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile)
    : context_(gl, scope, compatibilityProfile) {
    size_t count = 0;
    for (const StateRow& row : stateTable())
        if (context_.has(row))
            count += context_.elements(row.array).size();
    values_.resize(count);
}

void StateGuard::capture() {
    const StateReading reading(context_);
    auto value = values_.begin();
    for (const StateRow& row : stateTable())
        if (context_.has(row))
            for (const uint32_t element : context_.elements(row.array))
                row.read(reading, row, element, *value++);
}

void StateGuard::restore() noexcept {
    auto value = values_.begin();
    for (const StateRow& row : stateTable())
        if (context_.has(row))
            for (const uint32_t element : context_.elements(row.array))
                row.write(context_, row, element, *value++);
}

} // namespace agaa::gl
