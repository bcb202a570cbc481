// Colours of the forward pass. Blending keeps the first fragment by its alpha of 1, so alpha has no room for a mark. A
// negative red marks fragments that may have the far plane's depth.
const float agaa_leastMarkedRed = 6.103515625e-5; // the smallest normal half, which replaces all values below it

vec3 agaa_markFarPlane(vec3 color) { return vec3(-max(color.r, agaa_leastMarkedRed), color.gb); }
bool agaa_isMarkedFarPlane(vec3 color) { return color.r < 0.0; }
vec3 agaa_unmarkFarPlane(vec3 color) {
    float red = abs(color.r);
    return vec3(color.r < 0.0 && red <= agaa_leastMarkedRed ? 0.0 : red, color.gb);
}
