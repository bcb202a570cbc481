#include "broken_hosts.h"

#include <limits>

namespace agaa::conformance {

std::vector<Broken> brokenHosts() {
    const auto material = [](uint32_t pass) {
        return pass == AGAA_DRAW_PASS_AGGREGATE || pass == AGAA_DRAW_PASS_FORWARD;
    };
    return {
        {"none", {}, "", [](Mistakes&) {}},
        {"other depth convention",
         {"frames"},
         "Nothing is visible",
         [](Mistakes& m) {
             m.changeState = [](uint32_t, AgaaDrawState& state) { state.depthCompare = AGAA_COMPARE_GREATER; };
         }},
        {"moving scene",
         {"repeated_frames"},
         "the scene moves",
         [](Mistakes& m) {
             m.changeScene = [frames = 0](const AgaaDrawTarget& target, const Scene& scene) mutable {
                 frames += target.pass == AGAA_DRAW_PASS_VISIBILITY || target.pass == AGAA_DRAW_PASS_GBUFFER;
                 Scene moved = scene;
                 for (Vertex& vertex : moved)
                     vertex.position[0] += 0.1f * float(frames % 2);
                 return moved;
             };
         }},
        {"division by 0",
         {"finite_attributes"},
         "not finite",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget&, const Scene& scene) {
                 Scene divided = scene;
                 for (Vertex& vertex : divided)
                     vertex.roughness = std::numeric_limits<float>::quiet_NaN();
                 return divided;
             };
         }},
        {"inverted normals",
         {"normals"},
         "points away from the eye",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget&, const Scene& scene) {
                 Scene inverted = scene;
                 for (Vertex& vertex : inverted)
                     for (float& component : vertex.normal)
                         component = -component;
                 return inverted;
             };
         }},
        {"other projection",
         {"camera"},
         "AgaaFrame's camera",
         [](Mistakes& m) { m.changeProjection = [](float* p) { p[0] *= 0.8f, p[5] *= 0.8f; }; }},
        {"wrong y",
         {"camera"},
         "direction of y",
         [](Mistakes& m) { m.changeProjection = [](float* p) { p[5] = -p[5]; }; }},
        {"forgotten discard",
         {"alpha_masks"},
         "one pass discards and the other does not",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget& target, const Scene& scene) {
                 Scene solid = scene;
                 if (target.pass == AGAA_DRAW_PASS_VISIBILITY)
                     for (Vertex& vertex : solid)
                         vertex.isMasked = 0;
                 return solid;
             };
         }},
        {"wrong depth function: hidden surfaces",
         {"depth_test"},
         "hidden surfaces show",
         [material](Mistakes& m) {
             m.changeState = [material](uint32_t pass, AgaaDrawState& state) {
                 if (material(pass))
                     state.depthCompare = AGAA_COMPARE_ALWAYS;
             };
         }},
        {"wrong depth function: hidden surfaces in the forward pass",
         {"depth_test"},
         "\"msaa\"",
         [](Mistakes& m) {
             m.changeState = [](uint32_t pass, AgaaDrawState& state) {
                 if (pass == AGAA_DRAW_PASS_FORWARD)
                     state.depthCompare = AGAA_COMPARE_ALWAYS;
             };
         }},
        {"wrong depth function: nothing",
         {"depth_test"},
         "depthCompare, which is EQUAL",
         [material](Mistakes& m) {
             m.changeState = [material](uint32_t pass, AgaaDrawState& state) {
                 if (material(pass))
                     state.depthCompare = AGAA_COMPARE_LESS;
             };
         }},
        {"blending left on", {"blending"}, "disable blending", [](Mistakes& m) { m.blends = true; }},
        {"stale key", {"pipeline_keys"}, "AgaaDrawPass::pipelineKey", [](Mistakes& m) { m.keysByPass = true; }},
        {"wrong set",
         {"descriptor_sets"},
         "AgaaDrawTarget::descriptorSet",
         [](Mistakes& m) { m.keepsFirstSet = true; },
         true},
        {"missing barrier",
         {"messages"},
         "A barrier of the host is missing",
         [](Mistakes& m) { m.forgetsBarrier = true; },
         true},
        {"added blending",
         {"blending"},
         "disable blending",
         [](Mistakes& m) {
             m.changeState = [](uint32_t pass, AgaaDrawState& state) {
                 state.keepFirst |= pass == AGAA_DRAW_PASS_GBUFFER;
             };
         }},
        {"omitted object",
         {"same_geometry"},
         "left out of the material pass",
         [material](Mistakes& m) {
             m.changeScene = [material](const AgaaDrawTarget& target, const Scene& scene) {
                 Scene less = scene;
                 if (material(target.pass))
                     less.erase(less.begin() + 6, less.begin() + 12);
                 return less;
             };
         }},
        // What docs/conformance.md says does not show.
        {"wrong depth function: first pass",
         {},
         "",
         [](Mistakes& m) {
             m.changeState = [](uint32_t pass, AgaaDrawState& state) {
                 if (pass == AGAA_DRAW_PASS_VISIBILITY || pass == AGAA_DRAW_PASS_GBUFFER)
                     state.depthCompare = AGAA_COMPARE_ALWAYS;
             };
         }},
        {"forgotten discard: material pass",
         {},
         "",
         [material](Mistakes& m) {
             m.changeScene = [material](const AgaaDrawTarget& target, const Scene& scene) {
                 Scene solid = scene;
                 if (material(target.pass))
                     for (Vertex& vertex : solid)
                         vertex.isMasked = 0;
                 return solid;
             };
         }},
        {"two draws",
         {"drawn_once"},
         "more than once",
         [](Mistakes& m) {
             m.changeScene = [](const AgaaDrawTarget&, const Scene& scene) {
                 Scene twice = scene;
                 twice.insert(twice.end(), scene.begin(), scene.end());
                 return twice;
             };
         }},
    };
}

} // namespace agaa::conformance
