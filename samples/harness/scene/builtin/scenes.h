// The scenes behind builtin.h, each in its own file.
#pragma once

#include "scene/scene.h"

namespace harness::builtin {

Scene makeBamboo();
Scene makeFoliage();
Scene makeFurball();
Scene makeMetal();
Scene makeCity();
Scene makeBlades(uint32_t count);

} // namespace harness::builtin
