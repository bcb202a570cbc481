// A view and its frames, for tests that record.
#pragma once

#include "device.h"
#include "cases/core/structs.h"

namespace agaa::conformance {

using Image = std::vector<float>; // linear RGBA, row 0 first

// agaaVkRecordFrame or agaaGlRecordFrame. `native` is an AgaaVkFrame or an AgaaGlFrame.
using RecordCall = std::function<AgaaResult(AgaaView, const AgaaFrame*, const void* native)>;
// Replaces the record function of a host's frame. It may call the function with other arguments, more than once or not
// at all.
using RecordHook = std::function<AgaaResult(const RecordCall& call, AgaaView, const AgaaFrame*, const void* native)>;

class Rig {
public:
    using ChangeView = std::function<void(ViewDescription&)>;
    using ChangeContext = std::function<void(ContextDescription&)>;
    using ChangeFrame = std::function<void(AgaaFrame&)>;

    // Skips the test if the device cannot run the technique.
    explicit Rig(Test& test, const ChangeView& changeView = {}, const ChangeContext& changeContext = {});

    Test& test;
    ScopedContext context;

private: // declared before the view, which is created from it
    ViewDescription description_;
    const ViewDescription& changed(const ChangeView& changeView);

public:
    ScopedView view;
    Scene scene;           // smallScene() at first
    uint64_t recorded = 0; // index of the newest frame that was recorded without an error

    const ViewDescription& description() const { return description_; }
    Device& device() const { return test.device(); }
    std::string function() const; // name of the recording function
    // Returns the next valid frame.
    AgaaFrame nextFrame() const;
    AgaaResult record(AgaaFrame& frame, const RecordHook& hook = {});
    // Records the next frame, which must succeed without a message, and returns its output.
    Image render(const ChangeFrame& change = {});
    AgaaFrameStatistics statistics();
    AgaaCounters counters() { return statistics().counters; }
    // Checks that the graphics API reported no messages.
    void expectNoMessages(const std::string& what);
    // Checks that the log has no warnings and errors, and clears it.
    void expectNoErrors(const std::string& what);
};

struct Refusal {
    AgaaResult code;
    std::string what;       // name of the call in failures
    std::string words = ""; // part of the log's sentence; may be empty
    bool mayReport = false; // the graphics API may also report a message
};
// Records a frame that must fail with one sentence and draw nothing. The next valid frame must show `expected`.
void expectFrameRefused(Rig& rig, AgaaFrame& frame, const Refusal& refusal, const Image& expected,
                        const RecordHook& hook = {});
// Checks the next frame only, because a partial frame may have written the output.
void expectNextFrame(Rig& rig, const Image& expected, const std::string& after);

// Runs a part of a test on another device.
void runOn(Test& test, Device& device, const std::function<void(Test&)>& run);

// Adds a test of agaaVk… on Vulkan and of agaaGl… on OpenGL.
void addRecordCase(Suite& suite, const std::string& promise, const std::function<void(Test&)>& run);

// ---- images ---------------------------------------------------------------------------------------

const float* pixel(const Image& image, uint32_t width, uint32_t x, uint32_t y);
// Compares bit by bit, and names the first pixel that differs.
void expectSame(Test& test, const Image& got, const Image& expected, uint32_t width, const std::string& what);
// Passes if |got - expected| <= rounding (1 + |expected|) for each value.
void expectAlike(Test& test, const Image& got, const Image& expected, float rounding, const std::string& what);
// The pixels [x0, x1) x [y0, y1). expectColor checks that they have the colour within the tolerance.
struct Area {
    uint32_t x0, y0, x1, y1;
};
void expectColor(Test& test, const Image& got, uint32_t width, const Area& area, const float* rgb, float tolerance,
                 const std::string& what);

// Returns why the device cannot run a technique, or an empty text.
std::string unsupportedReason(Test& test, const std::string& technique);
// Returns the techniques that the library lists and the device can run. The tests of a single technique skip instead.
std::vector<std::string> techniques(Test& test);
void setTechnique(ViewDescription& description, const std::string& technique, uint32_t samples);

} // namespace agaa::conformance
