// A scene whose textures are of many sizes, so that hosts who keep them in arrays need several.
#pragma once

#include "render/renderer.h"

namespace harness::test {

// By id, where textures come from arrays by size and fetch.glsl wraps and filters, as from a G-buffer, where each is
// bound by itself with a sampler.
void expectTextureSizesAgree(Renderer& renderer);

} // namespace harness::test
