// What to draw in which order: visible instances, opaque before alpha-masked, grouped by material.
#pragma once

#include "render/camera_matrices.h"

#include <cstdint>
#include <vector>

namespace harness {

struct Draw {
    uint32_t mesh = 0;
    uint32_t instance = 0;
    bool isMasked = false;
    bool isMirrored = false; // the transform turns triangles inside out
    bool isFetched = true;   // by id, where the frame fetches
    uint32_t alphaPoints = 1; // of cut-outs, in each texel
    glm::dmat4 toShading{1};
};

struct DrawListOptions {
    bool useMasked = true; // false: every material counts as opaque
    uint32_t alphaPoints = 1; // where cut-outs read alpha in each texel of the target: 1, 4 or 16
    double clipMargin = 0; // culling keeps what is this far outside, as a part of the clip volume
    uint32_t shuffleSeed = 0; // != 0: the order within opaque and within masked is shuffled by it
};

// clip: shading space to clip space with z in [0,w]. Instances wholly outside are dropped.
std::vector<Draw> makeDrawList(const Scene& scene, const glm::dvec3& worldOffset,
                               const glm::dvec3& eye, const glm::dmat4& clip,
                               const DrawListOptions& options);

// The material mode by which a mesh is drawn; meshes without a valid material are opaque.
bool isMasked(const Scene& scene, const Mesh& mesh);

// Whether a pass draws it: a G-buffer at equal depth is for what cannot be fetched.
bool isDrawnIn(const AgaaDrawTarget& target, const Draw& draw);

// A number of the instance's own that does not depend on the order of drawing.
uint32_t drawSeed(uint32_t instance);

} // namespace harness
