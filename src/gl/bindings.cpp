#include "gl/bindings.h"

#include "core/base/error.h"

namespace agaa::gl {

std::optional<BindingKind> hostKind(const BindingRow& row, const HostDialect& dialect) {
    if (row.slot == host_slot::Frame && dialect.constants == AGAA_GL_CONSTANTS_UNIFORMS)
        return std::nullopt;
    if (row.slot == host_slot::Frame && dialect.constants == AGAA_GL_CONSTANTS_TEXELS)
        return BindingKind::Texture;
    if (!dialect.storageImages || row.kind == BindingKind::Uniform || row.kind == BindingKind::Texture)
        return row.kind;
    return row.kind == BindingKind::WrittenStorage ? BindingKind::Image : BindingKind::Uniform;
}

static std::vector<uint32_t>& bindingPointsOf(StateScope& scope, BindingKind kind) {
    switch (kind) {
    case BindingKind::Uniform:
        return scope.uniformBindings;
    case BindingKind::Texture:
        return scope.textureUnits;
    case BindingKind::Image:
        return scope.imageUnits;
    case BindingKind::Storage:
    case BindingKind::WrittenStorage:
        break;
    }
    return scope.storageBindings;
}

StateScope hostBindings(const HostDialect& dialect) {
    StateScope scope;
    for (const BindingRow& row : hostBindingTable)
        if (const auto kind = hostKind(row, dialect))
            bindingPointsOf(scope, *kind).push_back(dialect.bindings[row.slot]);
    return scope;
}

StateScope passBindings() {
    StateScope scope;
    for (const BindingRow& row : bindingTable)
        bindingPointsOf(scope, row.kind).push_back(row.openGl);
    return scope;
}

} // namespace agaa::gl
