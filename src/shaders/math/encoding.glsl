// Fixed-point encodings of normals, colours and means.
// Sources: AGAA (Crassin et al., TVCG 2016) section 3.2 and figure 7; Cigolle et al. 2014, "A
// Survey of Efficient Representations for Independent Unit Vectors" (octahedral and hemi-octahedral
// maps); Duff et al. 2017, "Building an Orthonormal Basis, Revisited"; hard cases 10, 11, 18,
// 32, 33.
#ifndef AGAA_MATH_ENCODING_GLSL
#define AGAA_MATH_ENCODING_GLSL
#include "real.glsl"
#include "sanitise.glsl"

// ---- frame of a view ray ---------------------------------------------------------------------

// Computes orthonormal t, b with cross(t, b) == v for unit v (Duff et al. 2017). The sign of v.z moves the singularity
// away, so v.z == -1 needs no branch and is as exact as v.z == 1.
void agaa_viewBasis(rvec3 v, OUT(rvec3) t, OUT(rvec3) b) {
    const real s = v.z < real(0.0) ? real(-1.0) : real(1.0);
    const real a = real(-1.0) / (s + v.z);
    const real m = v.x * v.y * a;
    t = rvec3(real(1.0) + s * v.x * v.x * a, s * m, -s * v.x);
    b = rvec3(m, s + v.y * v.y * a, -v.y);
}

// ---- codes with an exact centre --------------------------------------------------------------

// Returns the largest code of a UNORM channel. Channels have 1 to 24 bits, because a float holds no more.
uint agaa_maxCode(uint bits) {
    return (1u << min(bits, 24u)) - 1u;
}

// Returns the value to write to a UNORM channel of `bits` bits, [2, 16], so that it stores this code. The value is a
// quarter of a step above the code, for drivers that round and for drivers that truncate, such as Mesa 22.3 with 10
// bits.
rvec2 agaa_unormOfCode(rvec2 code, uint bits) {
    return (code + rvec2(real(0.25))) / real(agaa_maxCode(bits));
}

// Returns the value to write for the code nearest to x.
real agaa_unormOf(real x, uint bits) {
    const real code = floor(agaa_saturate(x) * real(agaa_maxCode(bits)) + real(0.5));
    return agaa_unormOfCode(rvec2(code), bits).x;
}

// Signed codes are in [1, 2^bits-1] around the centre 2^(bits-1). Their number is odd, so that 0 is exact, and code 0
// means "no geometry".
uint agaa_signedCode(real v, uint bits) {
    const uint centre = 1u << (clamp(bits, 2u, 24u) - 1u);
    const real span = real(centre - 1u);
    const real c = clamp(v, real(-1.0), real(1.0)) * span + real(0.5);
    // floor() returns a value in [-span, span], which becomes non-negative before the conversion to unsigned.
    return uint(floor(c) + real(centre));
}

real agaa_fromSignedCode(uint code, uint bits) {
    const uint centre = 1u << (clamp(bits, 2u, 24u) - 1u);
    const real span = real(centre - 1u);
    return clamp((real(code) - real(centre)) / span, real(-1.0), real(1.0));
}

// Returns whether a vector is finite and has a length.
bool agaa_hasDirection(rvec3 n) {
    return agaa_isFinite3(n) && max(abs(n.x), max(abs(n.y), abs(n.z))) > real(1e-30);
}

// Returns the vector scaled so that its largest component is 1, or +z if it has no direction. The scale prevents
// overflow and underflow of sums of components.
rvec3 agaa_directionOrZ(rvec3 n) {
    rvec3 result = rvec3(real(0.0), real(0.0), real(1.0));
    if (agaa_hasDirection(n)) {
        const real m = max(abs(n.x), max(abs(n.y), abs(n.z)));
        result = agaa_quotient3(n, m);
    }
    return result;
}

// Returns a host's normal as a unit vector, +z if it has no direction. Sets bad to 1 if it is not finite.
rvec3 agaa_sanitiseNormal(rvec3 n, INOUT(uint) bad) {
    if (!agaa_isFinite3(n)) {
        bad = 1u;
    }
    return normalize(agaa_directionOrZ(n));
}

// ---- hemi-octahedral, two times 8 bits -------------------------------------------------------

// Encodes n in the frame whose +z points to the viewer. Below the horizon z is set to 0, which keeps the azimuth and
// does not mirror the normal. If no direction remains, the code is that of +z.
uvec2 agaa_encodeHemiOct8(rvec3 n) {
    const rvec3 d = agaa_directionOrZ(n);
    const real z = max(d.z, real(0.0));
    const real s = abs(d.x) + abs(d.y) + z;
    uvec2 code = uvec2(128u, 128u);
    if (s > real(1e-30)) {
        const real px = d.x / s;
        const real py = d.y / s;
        code = uvec2(agaa_signedCode(px + py, 8u), agaa_signedCode(px - py, 8u));
    }
    return code;
}

rvec3 agaa_decodeHemiOct8(uvec2 code) {
    const real u = agaa_fromSignedCode(code.x, 8u);
    const real v = agaa_fromSignedCode(code.y, 8u);
    const real x = (u + v) * real(0.5);
    const real y = (u - v) * real(0.5);
    // |x| + |y| == max(|u|, |v|), so z never comes out negative by rounding.
    const real z = real(1.0) - max(abs(u), abs(v));
    return normalize(rvec3(x, y, z));
}

// Returns the bound of 1 - length for the mean of equal normals that rounding put in neighbouring codes.
real agaa_hemiOct8LengthBound() { return real(4.7e-5); }

// ---- octahedral, full sphere -----------------------------------------------------------------

// Returns the values to store in two UNORM channels of `bits` bits each, [2, 16]. Neither is code 0.
rvec2 agaa_encodeOct(rvec3 n, uint bits) {
    const rvec3 d = agaa_directionOrZ(n);
    const real s = abs(d.x) + abs(d.y) + abs(d.z);
    const real px = d.x / s;
    const real py = d.y / s;
    real x = px;
    real y = py;
    if (d.z < real(0.0)) {
        // The lower half folds outwards over the diagonals; a component of 0 counts as positive.
        x = (real(1.0) - abs(py)) * (px < real(0.0) ? real(-1.0) : real(1.0));
        y = (real(1.0) - abs(px)) * (py < real(0.0) ? real(-1.0) : real(1.0));
    }
    const real top = real(agaa_maxCode(bits));
    return rvec2(real(agaa_signedCode(x, bits)) / top, real(agaa_signedCode(y, bits)) / top);
}

rvec3 agaa_decodeOct(rvec2 u, uint bits) {
    const real top = real(agaa_maxCode(bits));
    // The channel returns code/top with rounding of its own; going back to the code removes it.
    const real cx = agaa_saturate(u.x) * top + real(0.5);
    const real cy = agaa_saturate(u.y) * top + real(0.5);
    const real x = agaa_fromSignedCode(uint(cx), bits);
    const real y = agaa_fromSignedCode(uint(cy), bits);
    const real z = real(1.0) - abs(x) - abs(y);
    rvec3 n = rvec3(x, y, z);
    if (z < real(0.0)) {
        n.x = (real(1.0) - abs(y)) * (x < real(0.0) ? real(-1.0) : real(1.0));
        n.y = (real(1.0) - abs(x)) * (y < real(0.0) ? real(-1.0) : real(1.0));
    }
    return normalize(n);
}

// ---- unsigned fixed point --------------------------------------------------------------------

// Clamps to [0, 1] and rounds to the nearest code. Non-finite values become 0. The result is exact for up to 16 bits;
// between 17 and 24 bits the float sum rounds by at most one code.
uint agaa_quantise(real v, uint bits) {
    const uint top = agaa_maxCode(bits);
    uint code = 0u;
    if (agaa_isFinite(v)) {
        code = min(uint(agaa_saturate(v) * real(top) + real(0.5)), top);
    }
    return code;
}

// Returns the mean, in [0, 1], of `count` codes whose integer sum is `sum`; 0 without codes. Sums up to 2^24 (32
// samples of 16 bits are 2^21) and the divisor are exact in a float. Larger ones, as those of moments, round by a
// relative 6e-8 each.
real agaa_meanOfSum(uint sum, uint count, uint bits) {
    real mean = real(0.0);
    if (count > 0u) {
        mean = min(real(sum) / (real(count) * real(agaa_maxCode(bits))), real(1.0));
    }
    return mean;
}

// Returns the mean, in [-1, 1], of `count` signed codes whose integer sum is `sum`; 0 without codes. The centres are
// subtracted as integers, so that a mean of zeros is exactly 0.
real agaa_signedMeanOfSum(uint sum, uint count, uint bits) {
    real mean = real(0.0);
    if (count > 0u) {
        const uint centre = 1u << (clamp(bits, 2u, 24u) - 1u);
        const int above = int(sum) - int(count * centre);
        mean = clamp(real(above) / (real(count) * real(centre - 1u)), real(-1.0), real(1.0));
    }
    return mean;
}

// ---- colour ----------------------------------------------------------------------------------

// Full-range YCbCr with the weights of ITU-R BT.601 (those of JFIF). The map is linear, so means of
// YCbCr are means of RGB; Cb and Cr are biased by 1/2 to fit a UNORM channel.
rvec3 agaa_rgbToYCbCr(rvec3 c) {
    const real y = real(0.299) * c.x + real(0.587) * c.y + real(0.114) * c.z;
    return rvec3(y, (c.z - y) / real(1.772) + real(0.5), (c.x - y) / real(1.402) + real(0.5));
}

rvec3 agaa_yCbCrToRgb(rvec3 c) {
    const real cb = c.y - real(0.5);
    const real cr = c.z - real(0.5);
    const real r = c.x + real(1.402) * cr;
    const real b = c.x + real(1.772) * cb;
    // Y = .299 R + .587 G + .114 B, solved for G, with R and B replaced by their differences to Y.
    const real g = c.x - (real(0.299) * real(1.402) / real(0.587)) * cr -
                   (real(0.114) * real(1.772) / real(0.587)) * cb;
    return rvec3(r, g, b);
}

// Returns emission, divided by a layout's range, as a factor of the diffuse albedo, [0, 1].
real agaa_emissiveFactor(rvec3 diffuse, rvec3 emissive) {
    const rvec3 luma = rvec3(real(0.2126), real(0.7152), real(0.0722));
    return clamp(dot(emissive, luma) / max(dot(diffuse, luma), real(1e-3)), real(0.0), real(1.0));
}

#endif
