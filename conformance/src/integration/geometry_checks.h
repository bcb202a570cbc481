// The checks of camera, geometry and state of the draw passes.
#pragma once

#include "engine_view.h"

namespace agaa::conformance {

void checkCamera(Test& test, HostTest& hostTest);
void checkDepthTest(Test& test, HostTest& hostTest);
void checkSameGeometry(Test& test, HostTest& hostTest);
void checkAlphaMasks(Test& test, HostTest& hostTest);
void checkBlending(Test& test, HostTest& hostTest);
void checkDrawnOnce(Test& test, HostTest& hostTest);

} // namespace agaa::conformance
