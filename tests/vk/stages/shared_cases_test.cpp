// Frame validation on Vulkan.
#include "stage_host.h"

#include "validation_cases.h"

namespace agaa::test {
namespace {

struct VulkanHost {
    using Context = StageContext;
    using View = StageView;
};
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ValidationTest, VulkanHost);

} // namespace
} // namespace agaa::test
