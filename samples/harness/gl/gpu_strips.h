// Resources of draws that pull vertices: the scene's vertices and indices as texels, and an index buffer.
#pragma once

#include "gl/gpu_scene.h"

namespace harness::gl {

class GpuStrips {
public:
    GpuStrips(const GladGLContext& gl, const Scene& scene, const GpuScene& gpuScene);

    void bind() const;
    void draw(const Mesh& mesh) const;

private:
    const GladGLContext* gl_;
    VertexArray vertexArray_; // a vertex array without attributes
    Buffer indices_;
    Texture texels_[2]; // vertices, indices
};

} // namespace harness::gl
