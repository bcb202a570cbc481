// What tests of all graphics APIs share, by OpenGL.
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

INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ValidationTest, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, PlanCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, DcaaCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, FragmentsCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, BatchCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, DepthPrepassCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, CarriedCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, PatternCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, InterlockCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, RasterOrderCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ComputeTrianglesCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ExpandedIdsCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, PullingCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, AccumulationCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, DefinitionCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HairCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HardGeometryCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HardMaterialCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, MaskCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, FramePlaceCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HdrResolveCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, MaterialClassCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ResolvedOutputCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, AdaptiveCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, CullingCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, FactsCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, CoverageCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, IdsCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, LaneCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, LeftHandedCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, DebugViewCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ShadingFunctionCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ShadowFunctionCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, VariantCases, OpenGLHost);

} // namespace
} // namespace agaa::test
