// Procedural textures of leaves with transparent surroundings.
#pragma once

#include "scene/scene.h"

namespace harness::builtin {

struct LeafPicture {
    uint32_t seed = 1;
    int leaves = 9;            // leaves along a twig that runs up the texture
    float length = 0.42f;      // length of a leaf, in widths of the texture
    float slenderness = 0.36f; // width to length
    uint32_t color = 0x5a8a36; // sRGB
    uint32_t youngColor = 0x93b352;
};

// Creates a texture of 256 x 256 texels. Alpha falls off over a few texels. The colour continues beyond the edge, so
// that filtering creates no dark seam.
Texture leafTexture(const LeafPicture& picture);

} // namespace harness::builtin
