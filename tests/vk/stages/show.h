// Shots by the Vulkan host.
#pragma once

#include "shown.h"
#include "stage_host.h"

namespace agaa::test {

Shown show(StageContext& context, ViewSettings settings, const Shot& shot);

struct VulkanHost {
    using Context = StageContext;
    using View = StageView;
};

} // namespace agaa::test
