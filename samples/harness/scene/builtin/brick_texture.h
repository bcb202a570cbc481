// A brick wall as a pair of repeating textures: base colour and normal map.
#pragma once

#include "scene/scene.h"

namespace harness::builtin {

struct BrickTextures {
    Texture color;
    Texture normal;
};

// Creates eight rows of four bricks on 256 x 256 texels.
BrickTextures brickTextures();

} // namespace harness::builtin
