// A scene whose textures are of many sizes, so that hosts who keep them in arrays need several.
#pragma once

#include "render/renderer.h"

namespace harness::test {

// A row of squares, each with colours and values of its own; the first has large textures, the others small ones.
Scene sceneOfTextureSizes();

// By id, where textures come from arrays by size, as from a G-buffer, where each is bound by itself.
void expectTextureSizesAgree(Renderer& renderer);

} // namespace harness::test
