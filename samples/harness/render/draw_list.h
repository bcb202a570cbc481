// The draws of a frame in order: visible instances, opaque before alpha-masked, grouped by material.
#pragma once

#include "render/camera_matrices.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace harness {

// The output of the material shader for the motion of a surface since the previous frame.
enum class MotionOutput {
    None,
    Attribute, // the custom attribute motionAttribute
    Emission,  // motion and distance instead of the material; see motion_image.h
};

struct Draw {
    uint32_t mesh = 0;
    uint32_t instance = 0;
    bool isMasked = false;
    bool isMirrored = false;  // the transform mirrors triangles
    bool isFetched = true;    // the material is fetched by id, if the frame fetches
    uint32_t alphaPoints = 1; // alpha reads of cut-outs per texel
    glm::dmat4 toShading{1};
    MotionOutput motionOutput = MotionOutput::None;
    // From this frame's shading space to the previous frame's clip space, without jitter, if the material shader writes
    // the motion and the camera's motion is not all of it.
    std::optional<glm::dmat4> toPreviousClip = {};
};

struct DrawListOptions {
    bool useMasked = true;    // false: every material counts as opaque
    uint32_t alphaPoints = 1; // alpha reads of cut-outs per texel of the target: 1, 4 or 16
    double clipMargin = 0;    // margin of culling, as a share of the clip volume
    uint32_t shuffleSeed = 0; // != 0: seed that shuffles the order within opaque and within masked draws
};

// Lists the draws. `clip` maps shading space to clip space with z in [0, w]. Instances outside of the volume are
// dropped.
std::vector<Draw> makeDrawList(const Scene& scene, const glm::dvec3& worldOffset, const glm::dvec3& eye,
                               const glm::dmat4& clip, const DrawListOptions& options);

// Returns the material mode of a mesh. Meshes without a valid material are opaque.
bool isMasked(const Scene& scene, const Mesh& mesh);

// Returns whether a pass contains the draw. A G-buffer at equal depth contains only draws that cannot be fetched.
bool isDrawnIn(const AgaaDrawTarget& target, const Draw& draw);

// Returns a number of the instance that does not depend on the order of the draws.
uint32_t drawSeed(uint32_t instance);

} // namespace harness
