// Pictures of leaves with transparent surroundings, drawn by formula.
#pragma once

#include "scene/scene.h"

namespace harness::builtin {

struct LeafPicture {
    uint32_t seed = 1;
    int leaves = 9;            // along a twig that runs up the picture
    float length = 0.42f;      // of a leaf, in widths of the picture
    float slenderness = 0.36f; // width to length
    uint32_t color = 0x5a8a36; // sRGB
    uint32_t youngColor = 0x93b352;
};

// 256 x 256; alpha falls off over a few texels, colour continues beyond the edge, so that filtering
// brings no dark seam.
Texture leafTexture(const LeafPicture& picture);

} // namespace harness::builtin
