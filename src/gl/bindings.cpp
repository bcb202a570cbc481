#include "gl/bindings.h"

#include "core/error.h"

namespace agaa::gl {

BindingKind hostKind(const BindingRow& row, bool storageImages) {
    if (!storageImages || row.kind == BindingKind::Uniform || row.kind == BindingKind::Texture)
        return row.kind;
    return row.kind == BindingKind::WrittenStorage ? BindingKind::Image : BindingKind::Uniform;
}

static std::vector<uint32_t>& placesOf(StateScope& scope, BindingKind kind) {
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
        placesOf(scope, hostKind(row, dialect.storageImages)).push_back(dialect.bindings[row.slot]);
    return scope;
}

StateScope passBindings() {
    StateScope scope;
    for (const BindingRow& row : bindingTable)
        placesOf(scope, row.kind).push_back(row.openGl);
    return scope;
}

} // namespace agaa::gl
