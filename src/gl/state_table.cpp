#include "gl/state_table.h"

#include <vector>

namespace agaa::gl {

std::span<const StateRow> stateTable() {
    static const std::vector<StateRow> table = [] {
        std::vector<StateRow> rows;
        for (const auto& part : {capabilityRows(), rasterRows(), fragmentRows(), pixelRows(), bindingRows()})
            rows.insert(rows.end(), part.begin(), part.end());
        return rows;
    }();
    return table;
}

} // namespace agaa::gl
