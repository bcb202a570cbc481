// Checks of frames that are stronger than a bound of the error.
#pragma once

#include "hard/frames.h"

namespace harness::hard {

// The largest difference from the other frame, after tone mapping.
Finding differenceFromOther(const Rendered& frame, double bound);
// The number of channels that differ from the other frame in any bit.
Finding bitsOfOther(const Rendered& frame);
// The number of channels that differ from the background in any bit, or with a filter by more than a step of half
// floats.
Finding bitsOfBackground(const Rendered& frame);
// The largest distance of a pixel from a whole number of samples of emission 1 over black, in samples. 0 for
// filters, which blend pixels.
Finding wholeWeights(const Rendered& frame);
// The largest error of the bars of hard-dark-ramp, in codes of a sample whose sum has 16 bits. A black bar is infinite.
Finding rampError(const Rendered& frame);
// The largest change of a pixel after tone mapping, when the image moves by 1/16 of a pixel.
Finding largestJump(const Rendered& frame, double bound);

} // namespace harness::hard
