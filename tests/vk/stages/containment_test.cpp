// Containment of bad values, by Vulkan.
#include "show.h"

#include "containment_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ContainmentCases, VulkanHost);

} // namespace
} // namespace agaa::test
