// A brick wall as a pair of pictures that repeat: base colour and normal map.
#pragma once

#include "scene/scene.h"

namespace harness::builtin {

struct BrickTextures {
    Texture color;
    Texture normal;
};

// Eight rows of four bricks on 256 x 256.
BrickTextures brickTextures();

} // namespace harness::builtin
