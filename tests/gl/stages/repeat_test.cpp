// Repeatability of frames, by OpenGL.
#include "show.h"

#include "repeat_cases.h"

namespace agaa::test {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, RepeatCases, OpenGLHost);

} // namespace
} // namespace agaa::test
