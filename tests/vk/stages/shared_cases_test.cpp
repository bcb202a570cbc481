// What tests of all graphics APIs share, by Vulkan.
#include "batch_cases.h"
#include "show.h"

#include "accumulation_cases.h"
#include "adaptive_cases.h"
#include "carried_cases.h"
#include "compute_triangles_cases.h"
#include "coverage_cases.h"
#include "culling_cases.h"
#include "expanded_ids_cases.h"
#include "facts_cases.h"
#include "dcaa_cases.h"
#include "depth_prepass_cases.h"
#include "definition_cases.h"
#include "fragments_cases.h"
#include "frame_place_cases.h"
#include "debug_view_cases.h"
#include "hair_cases.h"
#include "hard_geometry_cases.h"
#include "hdr_resolve_cases.h"
#include "resolved_output_cases.h"
#include "hard_material_cases.h"
#include "ids_cases.h"
#include "interlock_cases.h"
#include "lanes_cases.h"
#include "left_handed_cases.h"
#include "mask_cases.h"
#include "material_class_cases.h"
#include "pattern_cases.h"
#include "plan_cases.h"
#include "pulling_cases.h"
#include "raster_order_cases.h"
#include "shading_function_cases.h"
#include "shadow_function_cases.h"
#include "validation_cases.h"
#include "variant_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ValidationTest, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, PlanCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(VulkanRenderPass, PlanCases, VulkanRenderPassHost);
INSTANTIATE_TYPED_TEST_SUITE_P(VulkanUnconditional, PlanCases, VulkanUnconditionalHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, DcaaCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, FragmentsCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, BatchCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, DepthPrepassCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, CarriedCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, PatternCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, InterlockCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, RasterOrderCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ComputeTrianglesCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ExpandedIdsCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, PullingCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, AccumulationCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, DefinitionCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HairCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HardGeometryCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HardMaterialCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, MaskCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, FramePlaceCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, HdrResolveCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, MaterialClassCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ResolvedOutputCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, AdaptiveCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, CullingCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, FactsCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, CoverageCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, IdsCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, LaneCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, LeftHandedCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, DebugViewCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ShadingFunctionCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, ShadowFunctionCases, VulkanHost);
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, VariantCases, VulkanHost);

} // namespace
} // namespace agaa::test
