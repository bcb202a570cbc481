// Effects that a scene or a host may have or not: rows of a table. A price (core/reports/prices.h) is the difference of the plans with
// and without one.
#pragma once

#include "core/view/view_settings.h"

#include <span>

namespace agaa {

struct Effect {
    const char* name;
    const char* need; // when a scene needs it, one sentence
    // Whether the description has it, used or not.
    bool (*isOn)(const ViewSettings& view);
    // Plans of a view that is as `on` says already stay the same, except that a shadow map drops the maps after it.
    void (*set)(ViewSettings& view, bool on);
};

std::span<const Effect> effects();

} // namespace agaa
