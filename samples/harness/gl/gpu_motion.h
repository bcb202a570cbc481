// The motion of a frame's draws as texels of a buffer, for material.frag.
#pragma once

#include "gl/objects.h"
#include "render/draw_list.h"

namespace harness::gl {

class GpuMotion {
public:
    explicit GpuMotion(const GladGLContext& gl);

    // Replaces the rows.
    void update(const std::vector<Draw>& draws);
    void bind() const;

private:
    const GladGLContext* gl_;
    Buffer rows_;
    Texture texels_;
    bool hasRows_ = false;
};

} // namespace harness::gl
