// One camera's frame on OpenGL: a plan with everything it needs to be run again and again.
#pragma once

#include "core/plan/sample_patterns.h"
#include "gl/context.h"
#include "gl/pass_clock.h"
#include "gl/resources.h"
#include "gl/store_barriers.h"

#include <optional>
#include <string>
#include <vector>

namespace agaa::gl {

// Objects of a pass that live as long as the view.
struct PassObjects {
    // Host draws
    GLuint framebuffer = 0;
    uint64_t key = 0;
    std::string extensions;   // GLSL
    std::string declarations; // GLSL
    std::string geometry;     // GLSL, or empty
    std::string vertex;       // GLSL, or empty
};

class View : public ViewState {
public:
    View(Context& owner, const ViewSettings& settings);
    View(Context& owner, Plan plan);
    ~View() override;

    ViewState* recreate(const ViewSettings& settings) const override;
    void prepare(const ViewSettings& settings, const AgaaSceneFacts& facts) override;
    AgaaResult record(AgaaFrame frame, const AgaaGlFrame& glFrame);

    MemoryUse memoryUse() const override;
    const StructRow& drawPassRow() const override;
    const StructRow& surfaceRow() const override;
    void describePass(size_t index, AgaaDrawPass& out, void* native) const override;
    void describeSurface(ResourceId id, void* native) const override;
    CounterBuffer readCounters(uint32_t slot) const override;
    std::vector<double> readPassTimes(uint32_t slot) const override;
    AgaaTimeSource timeSource() const override { return context.timeSource; }

    Context& context;
    std::optional<ViewResources> resources;
    const std::vector<Step> steps;
    std::vector<PassObjects> passes;
    std::optional<PassClock> clock;
    StoreBarriers barriers;
    SamplePositions positions;

private:
    class HostState;

    Compiled compile(const Pass& pass, size_t index) override;
    void createPasses();
    void createFramebuffer(const Pass& pass, PassObjects& objects);
    SamplePositions readPositions() const;
    void destroy();

    void checkContextState() const;
    // Returns the output's format where the frame shades.
    GLenum checkTarget(const AgaaFrame& frame, const AgaaGlFrame& glFrame) const;
    void writeFrameData(const AgaaFrame& frame, uint32_t slot);
    bool endsBefore(const Step& step, uint32_t slot) const;
    void runPasses(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, uint32_t slot,
                   HostState& state);
    void runStep(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, const Step& step, uint32_t slot,
                 HostState& state);
    void runHostDraw(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Step& step, uint32_t slot,
                     HostState& state);
    void dispatch(const Dispatch& dispatch, uint32_t slot);
    void clearColor(const Pass& pass, GLuint framebuffer) const;
    void clearTargets(const Pass& pass, GLuint framebuffer);
    void bindConstants(GLuint place, ResourceId resource, uint32_t slot);
    void bindForHost(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame, uint32_t slot);
    void bindForCompute(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame,
                        uint32_t slot);
    GLuint shadowTexture(const Resource& map, const AgaaFrame& frame, const AgaaGlFrame& glFrame) const;
    void runTransfer(const Pass& pass, uint32_t slot);

    std::vector<std::byte> upload_; // of the largest upload buffer
    GLenum outputFormat_ = GL_NONE;
};

} // namespace agaa::gl
