// A view on OpenGL: a plan with the objects that run it.
#pragma once

#include "gl/context.h"
#include "gl/pass_clock.h"
#include "gl/resources.h"
#include "gl/store_barriers.h"

#include <array>
#include <optional>
#include <vector>

namespace agaa::gl {

// A texture of the host that a frame writes.
struct OutputTexture {
    GLuint texture = 0;
    GLenum format = GL_NONE;
};

class View : public ViewState {
public:
    View(Context& owner, const ViewSettings& settings);
    View(Context& owner, Plan plan);
    ~View() override;

    ViewState* recreate(const ViewSettings& settings) const override;
    void prepare(const ViewSettings& settings, const AgaaSceneFacts& facts) override;
    AgaaResult record(AgaaFrame frame, const AgaaGlFrame& glFrame);

    void requireDevice() const override { context.requireAlive(); }
    MemoryUse memoryUse() const override;
    const StructRow& drawPassRow() const override;
    const StructRow& surfaceRow() const override;
    void describePass(size_t index, void* native) const override;
    void describeSurface(ResourceId id, void* native) const override;
    std::vector<double> readPassTimes(uint32_t slot) const override;
    AgaaTimeSource timeSource() const override { return context.timeSource; }

    Context& context;
    std::optional<ViewResources> resources;
    std::vector<GLuint> framebuffers; // by pass; 0 unless the host draws the pass
    std::optional<PassClock> clock;
    StoreBarriers barriers;

private:
    class HostState;

    Compiled compile(const Pass& pass, size_t index) override;
    HostDialect viewDialect() const; // of the host's shaders
    void createFramebuffers();
    void createFramebuffer(size_t index);
    SamplePositions readPositions() const;
    void destroy();

    void checkContextState() const;
    // Sets outputs_ if the frame shades.
    void checkTarget(const AgaaFrame& frame, const AgaaGlFrame& glFrame, bool isPlaced);
    void checkResolved(const AgaaGlFrame& glFrame, uint64_t right, uint64_t top);
    std::byte* beginUpload(ResourceId buffer, uint32_t slot) override;
    void endUpload(ResourceId buffer, uint32_t slot, uint64_t bytes) override;
    const std::byte* mappedBreadcrumbs() const override { return (*resources)[plan.breadcrumbs].mapped; }
    void readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const override;
    bool isFinished(const Step& step, uint32_t slot) const;
    void runPasses(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, uint32_t slot,
                   HostState& state);
    // Writes a member of BreadcrumbBuffer.
    void writeBreadcrumb(uint64_t offset, const Breadcrumb& crumb) const;
    void runStep(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, size_t number,
                 uint32_t slot, HostState& state);
    void runHostDraw(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Step& step, uint32_t slot,
                     HostState& state);
    void dispatch(const Dispatch& dispatch, FrameExtent extent, uint32_t slot);
    void clearColor(size_t pass) const;
    void clearTargets(size_t pass);
    void evaluateDepth(size_t pass); // that sets sample locations
    void bindConstants(GLuint point, ResourceId resource, uint32_t slot);
    void bindForHost(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame, uint32_t slot);
    void bindForCompute(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame, uint32_t slot);
    GLuint shadowTexture(const Resource& map, const AgaaFrame& frame, const AgaaGlFrame& glFrame) const;
    void runTransfer(const Pass& pass, uint64_t frameIndex, uint32_t slot);

    std::array<OutputTexture, 1 + AGAA_MAX_RESOLVED_OUTPUTS> outputs_{}; // of the frame, by Resource::hostSlot
    std::vector<std::byte> upload_;                                      // as large as the largest upload buffer
};

} // namespace agaa::gl
