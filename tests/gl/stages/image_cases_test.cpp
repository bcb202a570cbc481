// Filters and accumulation of shaded images, by OpenGL.
#include "show.h"

#include "filter_cases.h"
#include "history_cases.h"
#include "visibility_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, FilterCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, HistoryCases, OpenGLHost);
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, VisibilityCases, OpenGLHost);

} // namespace
} // namespace agaa::test
