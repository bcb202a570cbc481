// The guards of sanitise.glsl compiled with -ffast-math.
#ifndef AGAA_TESTS_MATH_GUARDS_FAST_MATH_H
#define AGAA_TESTS_MATH_GUARDS_FAST_MATH_H

bool fastMathIsFinite(float x);
// Returns the sanitised value; bad is set to 1 for a non-finite x.
float fastMathSanitise(float x, float lo, float hi, unsigned& bad);
// What a comparison makes of x under -ffast-math, for contrast.
bool fastMathComparesEqualToItself(float x);

#endif
