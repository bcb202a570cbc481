// The bench of this host.
#pragma once

#include "host_bench.h"
#include "show.h"

namespace agaa::test {

struct Bench : BenchOf<OpenGLHost> {
    using BenchOf::BenchOf;
    AgaaGlFrame glFrame() const {
        AgaaGlFrame f = view.glFrame();
        f.shadowTextures[0] = map.get();
        return f;
    }
};

} // namespace agaa::test
