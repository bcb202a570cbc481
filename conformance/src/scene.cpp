#include "scene.h"

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

void addRectangle(Scene& scene, uint32_t width, uint32_t height, float x0, float y0, float x1, float y1, float distance,
                  const Surface& surface) {
    const auto vertex = [&](float x, float y) {
        Vertex v{};
        v.position[0] = x - float(width) / 2;
        v.position[1] = float(height) / 2 - y;
        v.position[2] = -distance;
        std::memcpy(v.normal, surface.normal, sizeof v.normal);
        std::memcpy(v.diffuse, surface.diffuse, sizeof v.diffuse);
        std::memcpy(v.specular, surface.specular, sizeof v.specular);
        std::memcpy(v.emissive, surface.emissive, sizeof v.emissive);
        v.roughness = surface.roughness;
        v.isMasked = surface.isMasked ? 1 : 0;
        return v;
    };
    for (const Vertex& v :
         {vertex(x0, y0), vertex(x1, y0), vertex(x1, y1), vertex(x0, y0), vertex(x1, y1), vertex(x0, y1)})
        scene.push_back(v);
}

void setPixelCamera(AgaaFrame& frame, uint32_t width, uint32_t height, float farthest, bool isReversed,
                    bool fromMinusOne) {
    float* p = frame.projection;
    std::fill(p, p + 16, 0.0f);
    p[0] = 2.0f / float(width);
    p[5] = -2.0f / float(height); // y down
    p[10] = -1.0f / farthest;
    p[15] = 1.0f;
    if (isReversed) {
        p[10] = 1.0f / farthest;
        p[14] = 1.0f;
    }
    if (fromMinusOne) {
        p[10] *= 2.0f;
        p[14] = 2.0f * p[14] - 1.0f;
    }
}

} // namespace agaa::conformance
