#include "state_text.h"

#include "core/base/error.h"
#include "gl/state_table.h"

namespace agaa::test {
namespace {

std::string text(char type, const gl::StateValue& value, size_t i) {
    switch (type) {
    case 'b':
        return value.integer(i) != 0 ? "true" : "false";
    case 'e':
    case 'u':
        return format("0x%llX", static_cast<unsigned long long>(value.integer(i)));
    case 'f':
        return format("%.9g", value.real(i));
    default:
        return format("%lld", static_cast<long long>(value.integer(i)));
    }
}

} // namespace

std::vector<StateText> describe(const gl::StateGuard& guard) {
    std::vector<StateText> texts;
    texts.reserve(guard.captured().size());
    for (const gl::StateRow& row : gl::stateTable()) {
        if (!guard.context().has(row))
            continue;
        for (const uint32_t element : guard.context().elements(row.array)) {
            const gl::StateValue& value = guard.captured()[texts.size()];
            StateText& out = texts.emplace_back(StateText{row.name, {}});
            if (row.array != gl::StateArray::Once)
                out.name += format(" [%u]", element);
            for (size_t i = 0; i < row.layout.size(); ++i) {
                if (i != 0)
                    out.value += ' ';
                out.value += text(row.layout[i], value, i);
            }
        }
    }
    return texts;
}

} // namespace agaa::test
