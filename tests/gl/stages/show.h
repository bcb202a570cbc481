// Shots by the OpenGL host.
#pragma once

#include "shown.h"
#include "stage_host.h"

namespace agaa::test {

Shown show(StageContext& context, ViewSettings settings, const Shot& shot);

struct OpenGLHost {
    using Context = StageContext;
    using View = StageView;
    static std::vector<float> rgba(const View& view) { return view.image(); }
};

} // namespace agaa::test
