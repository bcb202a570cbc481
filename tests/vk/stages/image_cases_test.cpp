// Filters and accumulation of shaded images, by Vulkan.
#include "show.h"

#include "filter_cases.h"
#include "history_cases.h"
#include "visibility_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, FilterCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HistoryCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, VisibilityCases, VulkanHost);

} // namespace
} // namespace agaa::test
