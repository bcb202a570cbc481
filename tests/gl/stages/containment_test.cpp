// Containment of bad values, by OpenGL.
#include "show.h"

#include "containment_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ContainmentCases, OpenGLHost);

} // namespace
} // namespace agaa::test
