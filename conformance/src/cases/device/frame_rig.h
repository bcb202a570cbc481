// A view and its frames, for tests that record.
#pragma once

#include "device.h"
#include "cases/core/structs.h"

namespace agaa::conformance {

using Image = std::vector<float>; // linear RGBA, row 0 first

// agaaVkRecordFrame or agaaGlRecordFrame; native: AgaaVkFrame or AgaaGlFrame.
using RecordCall = std::function<AgaaResult(AgaaView, const AgaaFrame*, const void* native)>;
// Stands in place of the record function of a host's frame. May call it with other arguments, several times or not at all.
using RecordHook = std::function<AgaaResult(const RecordCall& call, AgaaView, const AgaaFrame*, const void* native)>;

class Rig {
public:
    using ChangeView = std::function<void(ViewDescription&)>;
    using ChangeContext = std::function<void(ContextDescription&)>;
    using ChangeFrame = std::function<void(AgaaFrame&)>;

    // Skips the test if the device cannot run the technique.
    explicit Rig(Test& test, const ChangeView& changeView = {}, const ChangeContext& changeContext = {});

    Test& test;
    OwnContext context;

private: // before the view, which is created from it
    ViewDescription description_;
    const ViewDescription& changed(const ChangeView& changeView);

public:
    OwnView view;
    Scene scene; // smallScene
    uint64_t recorded = 0; // index of the newest frame that was recorded without an error

    const ViewDescription& description() const { return description_; }
    Device& device() const { return test.device(); }
    std::string function() const; // that records
    // The next right frame.
    AgaaFrame nextFrame() const;
    AgaaResult record(AgaaFrame& frame, const RecordHook& hook = {});
    // Records the next frame, which must succeed without a message, and returns its output.
    Image render(const ChangeFrame& change = {});
    AgaaFrameStatistics statistics();
    AgaaCounters counters() { return statistics().counters; }
    // Messages of the graphics API, which must not be there.
    void expectNoMessages(const std::string& what);
    // Warnings and errors in the log, which must not be there. Clears the log.
    void expectNoErrors(const std::string& what);
};

struct Refusal {
    AgaaResult code;
    std::string what;  // as a reader of the failure would write it
    std::string words = ""; // in the log's sentence; may be empty
    bool mayReport = false; // the graphics API may report a message, too
};
// A frame that must fail: one sentence, nothing drawn, and the next right frame shows `expected`.
void expectFrameRefused(Rig& rig, AgaaFrame& frame, const Refusal& refusal, const Image& expected,
                        const RecordHook& hook = {});
// The same without the output, which a frame in part may have written.
void expectNextFrame(Rig& rig, const Image& expected, const std::string& after);

// A test of both record functions: agaaVk… on Vulkan, agaaGl… on OpenGL.
void addRecordCase(Suite& suite, const std::string& promise, const std::function<void(Test&)>& run);

// ---- images ---------------------------------------------------------------------------------------

const float* pixel(const Image& image, uint32_t width, uint32_t x, uint32_t y);
// Compares bit by bit, and names the first pixel that differs.
void expectSame(Test& test, const Image& got, const Image& expected, uint32_t width, const std::string& what);
// Passes if |got - expected| <= rounding (1 + |expected|) for each value.
void expectAlike(Test& test, const Image& got, const Image& expected, float rounding, const std::string& what);
// All pixels of [x0, x1) x [y0, y1) have the colour within the tolerance.
struct Area {
    uint32_t x0, y0, x1, y1;
};
void expectColor(Test& test, const Image& got, uint32_t width, const Area& area, const float* rgb, float tolerance,
                 const std::string& what);

// Returns why the device cannot run a technique, or an empty text.
std::string obstacleOf(Test& test, const std::string& technique);
// The names that the library lists, without those that the device cannot run. The tests of a single technique skip instead.
std::vector<std::string> techniques(Test& test);
void setTechnique(ViewDescription& description, const std::string& technique, uint32_t samples);

} // namespace agaa::conformance
