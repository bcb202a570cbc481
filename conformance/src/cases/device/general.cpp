// Basic tests, on which the other tests rely.
#include "cases.h"
#include "frame_rig.h"

namespace agaa::conformance {

void addGeneralCases(Suite& suite) {
    // The ambient light is 1, so each rectangle shows its diffuse colour.
    suite.both("general/a_frame_shows_the_scene", [](Test& test) {
        Rig rig(test);
        const Image image = rig.render();
        const uint32_t width = rig.description().desc.width, height = rig.description().desc.height;
        const float background[] = {0.5f, 0.5f, 0.5f}, second[] = {0.25f, 0.5f, 0.5f}, masked[] = {0.25f, 0.75f, 0.5f};
        expectColor(test, image, width, {0, 0, width / 4, height}, background, 0.01f, "the rectangle at the back");
        expectColor(test, image, width, {width / 4, height / 2, width, height}, second, 0.01f, "the second rectangle");
        expectColor(test, image, width, {width / 2, 0, width * 3 / 4, height / 2}, masked, 0.01f,
                    "the masked rectangle");
    });
}

} // namespace agaa::conformance
