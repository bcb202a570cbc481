// agaaValidateFrame and hosts with mistakes.
#include "cases.h"
#include "frame_rig.h"

namespace agaa::conformance {

namespace {

AgaaFrameValidation validate(Rig& rig) {
    AgaaFrameValidation validation = AGAA_FRAME_VALIDATION_INIT;
    rig.test.requireOk(rig.test.sdk.agaaValidateFrame(rig.view.get(), rig.recorded, &validation), "agaaValidateFrame");
    return validation;
}

void testEmpty(Test& test) {
    Rig rig(test);
    rig.scene.clear();
    rig.render();
    const AgaaFrameValidation v = validate(rig);
    test.check(v.isValid == 0 && v.visible == 0 && v.explanation[0], "a frame without geometry is valid.");
}

// The material pass leaves out a rectangle of 12 pixels with nothing behind it.
AgaaFrameValidation validateMissing(Test& test) {
    Rig rig(test);
    uint32_t passes = 0;
    test.requireOk(test.sdk.agaaGetDrawPasses(rig.view.get(), &passes, nullptr), "agaaGetDrawPasses");
    if (passes < 2)
        test.skip("the device has one geometry pass, with which no other can disagree.");
    rig.scene.clear();
    Surface surface;
    addRectangle(rig.scene, 32, 24, 4, 4, 12, 10, 8, surface);
    const size_t kept = rig.scene.size();
    addRectangle(rig.scene, 32, 24, 20, 10, 24, 13, 8, surface);
    rig.device().mistakes.changeScene = [kept](const AgaaDrawTarget& target, const Scene& scene) {
        return target.pass == AGAA_DRAW_PASS_AGGREGATE ? Scene(scene.begin(), scene.begin() + long(kept)) : scene;
    };
    rig.render();
    rig.device().mistakes = {};
    return validate(rig);
}

bool isMask(const uint32_t* mask, uint32_t first) { return mask[0] == first && !mask[1] && !mask[2] && !mask[3]; }

void testInvalid(Test& test) {
    const AgaaFrameValidation v = validateMissing(test);
    test.check(v.isValid == 0 && v.explanation[0], "a frame with an object that a pass omits is valid.");
    test.check(v.uncovered == 12 * 4,
               "AgaaFrameValidation::uncovered is " + std::to_string(v.uncovered) + " in place of 48.");
    test.check(v.invalidPixels == 12, "invalidPixels is " + std::to_string(v.invalidPixels) + " in place of 12.");
    test.require(v.pixelCount == AGAA_MAX_INVALID_PIXELS, "pixelCount is " + std::to_string(v.pixelCount) + ".");
    for (const AgaaInvalidPixel& pixel : v.pixels) {
        test.check(pixel.x >= 20 && pixel.x < 24 && pixel.y >= 10 && pixel.y < 13, "an invalid pixel lies elsewhere.");
        test.check(isMask(pixel.visible, 0xF) && isMask(pixel.uncovered, 0xF) && isMask(pixel.overlapping, 0),
                   "the masks of an invalid pixel are wrong.");
    }
}

void testReservedOfPixels(Test& test) {
    for (const AgaaInvalidPixel& pixel : validateMissing(test).pixels)
        test.check(!pixel.reserved[0] && !pixel.reserved[1], "AgaaInvalidPixel::reserved is not 0.");
}

// The host draws with a projection that differs from AgaaFrame.
void testMisplaced(Test& test) {
    Rig rig(test);
    rig.device().mistakes.changeProjection = [](float* projection) { projection[5] = -projection[5]; };
    rig.scene.clear();
    Surface surface;
    addRectangle(rig.scene, 32, 24, 4, 2, 12, 8, 8, surface);
    for (size_t i = 0; i < rig.scene.size(); i += 3) // the other projection turns it around
        std::swap(rig.scene[i], rig.scene[i + 1]);
    AgaaFrame frame = rig.nextFrame();
    test.requireOk(rig.record(frame), rig.function());
    rig.device().mistakes = {};
    const AgaaFrameValidation v = validate(rig);
    test.check(v.misplaced >= 48, "AgaaFrameValidation::misplaced is " + std::to_string(v.misplaced) +
                                      " for 48 pixels that are drawn elsewhere.");
    test.check(v.isValid == 0, "a frame with another projection than the host's is valid.");
}

} // namespace

void addValidationCases(Suite& suite) {
    suite.both("general/validation_of_an_empty_frame", testEmpty);
    suite.both("general/validation_of_an_omitted_object", testInvalid);
    suite.both("general/validation_of_another_projection", testMisplaced);
    suite.both("AgaaInvalidPixel.reserved/zero", testReservedOfPixels);
}

} // namespace agaa::conformance
