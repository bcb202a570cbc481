// Frame validation on OpenGL.
#include "stage_host.h"

#include "validation_cases.h"

namespace agaa::test {
namespace {

struct OpenGLHost {
    using Context = StageContext;
    using View = StageView;
};
INSTANTIATE_TYPED_TEST_SUITE_P(OpenGL, ValidationTest, OpenGLHost);

} // namespace
} // namespace agaa::test
