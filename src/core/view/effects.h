// Table of the effects that a scene or a host may use. The price of an effect is the difference between the plans with
// and without it (core/reports/prices.h).
#pragma once

#include "core/view/view_settings.h"

#include <span>

namespace agaa {

struct Effect {
    const char* name;
    const char* need; // says in one sentence which scenes need it
    // Returns whether the description has the effect, even if the technique ignores it.
    bool (*isOn)(const ViewSettings& view);
    // Switches the effect. If the view already matches `on`, its plan does not change, except that a shadow map removes
    // all higher ones.
    void (*set)(ViewSettings& view, bool on);
};

std::span<const Effect> effects();

} // namespace agaa
