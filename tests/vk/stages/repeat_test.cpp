// Repeatability of frames, by Vulkan.
#include "show.h"

#include "repeat_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, RepeatCases, VulkanHost);

} // namespace
} // namespace agaa::test
