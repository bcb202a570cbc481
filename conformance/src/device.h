// A device of the suite: the host that the tests on Vulkan and OpenGL use.
#pragma once

#include "log.h"
#include "scene.h"

namespace agaa::conformance {

// AgaaContextDesc with its native part, to be changed by a test before link().
struct ContextDescription {
    AgaaContextDesc desc;
    AgaaVkDeviceDesc vk;
    AgaaGlDeviceDesc gl;
};

// What a wrong host does, so that the tests of the checks in integration/ can show that each mistake is found. All off: a right
// host.
struct Mistakes {
    // The scene that a pass draws, from the scene that was passed to record().
    std::function<Scene(const AgaaDrawTarget&, const Scene&)> changeScene;
    // The matrix that the vertices are drawn with, from AgaaFrame::projection.
    std::function<void(float* projection)> changeProjection;
    // The state that pipelines have, from that of the pass (AgaaDrawPassId).
    std::function<void(uint32_t pass, AgaaDrawState&)> changeState;
    bool blends = false;          // alpha blending (SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ADD) is on in all passes
    bool keysByPass = false;      // pipelines are kept by AgaaDrawPassId and not by pipelineKey, also across views
    bool keepsFirstSet = false;   // Vulkan: binds the descriptor set of the first frame of the first view for ever
    bool forgetsBarrier = false;  // Vulkan: copies the vertices in the same command buffer, and no barrier follows
};

class Device {
public:
    virtual ~Device() = default;
    Mistakes mistakes;
    // What a test changes in the structs that record() passes. Null: nothing.
    std::function<void(AgaaVkFrame&)> changeVkFrame;
    std::function<void(AgaaGlFrame&)> changeGlFrame;

    virtual Backend backend() const = 0;
    virtual std::string deviceName() const = 0;
    virtual std::string driverName() const = 0;

    // What a right host passes; the native part is not chained yet. framesInFlight is 2.
    virtual ContextDescription description() = 0;
    // Chains the native part behind what description.desc.pNext already holds, and calls agaaVk… or agaaGlCreateContext.
    virtual AgaaResult createContext(const Functions& sdk, uint32_t headerVersion, ContextDescription& description,
                                     AgaaContext* outContext) = 0;
    virtual AgaaResult createView(const Functions& sdk, AgaaContext context, const AgaaViewDesc* desc,
                                  AgaaView* outView) = 0;
    // Of a view that createView() did not create. Before prepare().
    virtual void adopt(AgaaContext context, AgaaView view) = 0;
    virtual AgaaResult getContextCaps(const Functions& sdk, AgaaContext context, AgaaDeviceCaps* outCaps) = 0;
    // Of the device, before a context exists.
    virtual AgaaResult getDeviceCaps(const Functions& sdk, const AgaaLog* log, AgaaDeviceCaps* outCaps) = 0;

    // Creates pipelines or programs for all draw passes of a view that are not there yet, by key. Throws
    // std::runtime_error with the compiler's message.
    virtual void prepare(const Functions& sdk, AgaaView view) = 0;
    // Destroys them. The device is idle.
    virtual void forget(AgaaView view) = 0;

    // An output of this size is there from now on. Its pixels are 0.
    virtual void setOutput(uint32_t width, uint32_t height) = 0;
    // Records one frame with the output and the scene, which sets frame.draw and frame.drawUser unless draw is already set;
    // submits and waits if the call succeeds or returns AGAA_NOT_READY. If the call fails, what was recorded is submitted too
    // where the API allows it (not after AGAA_ERROR_PARTIAL), so that a test sees whether anything was recorded.
    virtual AgaaResult record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) = 0;
    // Draws the scene of record(), for tests that set frame.draw: their callbacks call it.
    virtual AgaaResult draw(const AgaaDrawTarget& target) = 0;
    // AgaaFrame::draw, with the device as drawUser.
    static AgaaResult AGAA_CALL drawCallback(void* device, const AgaaDrawTarget* target) {
        return static_cast<Device*>(device)->draw(*target);
    }
    // Fetches the triangles of the scene of record(), for views of this device.
    virtual AgaaFetchFunction sceneFetch() const = 0;
    // Binds again what sceneFetch() reads during record(), after a test that changed OpenGL's bindings.
    virtual void bindScene() const {}
    // All shadow maps of all frames have this depth from now on, at first 1.
    virtual void setShadowDepth(float depth) = 0;
    // Linear RGBA, row 0 first.
    virtual std::vector<float> readOutput() = 0;
    virtual void fillOutput(float value) = 0;

    // Messages of the validation layers, or of OpenGL's debug output, since the last call.
    virtual std::vector<std::string> takeMessages() = 0;
    // False: the validation layer is not installed, and there are no messages.
    virtual bool testsMessages() const = 0;

    // AGAA_VIEW_… that this device's clip space needs.
    virtual uint64_t viewFlags() const = 0;
};

// Of the first device of the API, or the one whose name contains `name`. Throws Skipped with the reason if there is none.
// The Vulkan device has the features that agaaVkGetRequirements requires, and geometryShader where there is one; with options,
// also the other optional ones.
std::unique_ptr<Device> makeVulkanDevice(const Functions& sdk, const std::string& name, bool withOptions = false);
std::unique_ptr<Device> makeOpenGlDevice(const std::string& name);

// ---- what most tests need ------------------------------------------------------------------------

// A context that is destroyed at the end of the test; its log is recorded.
class OwnContext {
public:
    OwnContext(Test& test, const std::function<void(ContextDescription&)>& change = {});
    ~OwnContext();
    OwnContext(const OwnContext&) = delete;
    OwnContext& operator=(const OwnContext&) = delete;
    AgaaContext get() const { return context_; }
    LogRecorder log;

private:
    Test& test_;
    AgaaContext context_ = nullptr;
};

// A fetch function of no scene.
AgaaFetchFunction emptyFetch();

// n of a technique where "ssaa" has `samples`: 1 for "single" and "fxaa"; 16 times as many coverage samples for "dcaa".
uint32_t samplesOf(const std::string& technique, uint32_t samples);
bool needsOneSample(const std::string& technique);       // "single" and "fxaa"
bool countsCoverage(const AgaaConfig& config); // whether n counts coverage samples: targets have one
bool hasCoverageSamples(const std::string& technique);   // "dcaa", which needs an AgaaFetchFunction

// Config, facts and description of a view of 32 x 24 pixels, "agaa" with n = 4, counters, no shadows, ambient light; tests
// change it before they create the view.
struct ViewDescription {
    ViewDescription(const Device* device); // null: of no device
    ViewDescription(const ViewDescription&) = delete;
    ViewDescription& operator=(const ViewDescription&) = delete;
    // Selects a technique with n = samplesOf(name, samples), and chains sceneFetch if the technique needs it. Call it once.
    void setTechnique(const std::string& name, uint32_t samples);
    std::string technique; // that setTechnique() names
    AgaaLayout layout; // "precise"
    AgaaConfig config;
    AgaaAggregation aggregation;    // chained to config
    AgaaDecoupledCoverage coverage; // chained to aggregation
    AgaaAdaptiveSampling adaptive;  // chained to coverage
    AgaaMeasurement measurement;    // chained to adaptive
    AgaaFetchFunction sceneFetch;   // chained to desc by setTechnique() where the technique needs it
    AgaaSceneFacts facts;
    AgaaViewDesc desc;
};

// A view that is destroyed at the end of the test. Nothing is drawn of it: it has no pipelines.
class BareView {
public:
    BareView(Test& test, AgaaContext context, const ViewDescription& description);
    ~BareView();
    BareView(const BareView&) = delete;
    BareView& operator=(const BareView&) = delete;
    AgaaView get() const { return view_; }

private:
    Test& test_;
    AgaaView view_ = nullptr;
};

// With its pipelines, and an output of its size.
class OwnView : public BareView {
public:
    OwnView(Test& test, AgaaContext context, const ViewDescription& description);
};

// The frame of index i (completed: i - 1) with the camera of setPixelCamera for the description, ambient light 1 and a black
// background; lights none.
AgaaFrame pixelFrame(const Device& device, const ViewDescription& description, uint64_t i);
// Three rectangles on whole pixels, from back to front, the last one alpha-masked with alpha 1.
Scene smallScene(uint32_t width, uint32_t height);

} // namespace agaa::conformance
