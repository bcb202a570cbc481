// A device of the suite: the host that the tests on Vulkan and OpenGL use.
#pragma once

#include "log.h"
#include "scene.h"

namespace agaa::conformance {

// AgaaContextDesc with the struct of the graphics API. A test may change both before createContext().
struct ContextDescription {
    AgaaContextDesc desc;
    AgaaVkDeviceDesc vk;
    AgaaGlDeviceDesc gl;
};

// Mistakes of a host, with which tests show that the checks of integration/ find each mistake. All are off by default.
struct Mistakes {
    // Returns the scene that a pass draws, from the scene of record().
    std::function<Scene(const AgaaDrawTarget&, const Scene&)> changeScene;
    // Changes AgaaFrame::projection to the matrix with which the vertices are drawn.
    std::function<void(float* projection)> changeProjection;
    // Changes the state of the pass (AgaaDrawPassId) to the state of the pipelines.
    std::function<void(uint32_t pass, AgaaDrawState&)> changeState;
    // Vulkan: changes the text of each fragment shader.
    std::function<void(std::string& text)> changeFragmentShader;
    bool blends = false;         // alpha blending (SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ADD) is on in all passes
    bool keysByPass = false;     // the keys of pipelines are AgaaDrawPassId instead of pipelineKey; all views share
                                 // them
    bool keepsFirstSet = false;  // Vulkan: always binds the descriptor set of the first frame of the first view
    bool forgetsBarrier = false; // Vulkan: copies the vertices in the same command buffer without a barrier
};

class Device {
public:
    virtual ~Device() = default;
    Mistakes mistakes;
    // Change the structs that record() passes. Null changes nothing.
    std::function<void(AgaaVkFrame&)> changeVkFrame;
    std::function<void(AgaaGlFrame&)> changeGlFrame;
    bool discardsCommands = false; // Vulkan: record() discards the commands instead of submitting them

    virtual Backend backend() const = 0;
    virtual std::string deviceName() const = 0;
    virtual std::string driverName() const = 0;

    // Returns the description of a correct host with framesInFlight 2. The struct of the graphics API is not chained
    // yet.
    virtual ContextDescription description() = 0;
    // Appends the struct of the graphics API to the chain of description.desc, and calls agaaVkCreateContext or
    // agaaGlCreateContext.
    virtual AgaaResult createContext(const Functions& sdk, uint32_t headerVersion, ContextDescription& description,
                                     AgaaContext* outContext) = 0;
    virtual AgaaResult createView(const Functions& sdk, AgaaContext context, const AgaaViewDesc* desc,
                                  AgaaView* outView) = 0;
    // Registers a view that createView() did not create. Must be called before prepare().
    virtual void adopt(AgaaContext context, AgaaView view) = 0;
    virtual AgaaResult getContextCaps(const Functions& sdk, AgaaContext context, AgaaDeviceCaps* outCaps) = 0;
    // Gets the capabilities of the device. No context needs to exist.
    virtual AgaaResult getDeviceCaps(const Functions& sdk, const AgaaLog* log, AgaaDeviceCaps* outCaps) = 0;

    // Creates the missing pipelines or programs for all draw passes of a view, by key. Throws std::runtime_error with
    // the compiler's message.
    virtual void prepare(const Functions& sdk, AgaaView view) = 0;
    // Destroys them. The device must be idle.
    virtual void forget(AgaaView view) = 0;

    // Creates an output of this size with pixels of 0.
    virtual void setOutput(uint32_t width, uint32_t height) = 0;
    // Records one frame with the output and the scene. Sets frame.draw and frame.drawUser unless draw is already set.
    // Submits and waits if the call succeeds or returns AGAA_NOT_READY. If the call fails, the recorded commands are
    // submitted too, so that a test sees them, except after AGAA_ERROR_PARTIAL.
    virtual AgaaResult record(const Functions& sdk, AgaaView view, AgaaFrame& frame, const Scene& scene) = 0;
    // Draws the scene of record(). The callbacks of tests that set frame.draw call it.
    virtual AgaaResult draw(const AgaaDrawTarget& target) = 0;
    // The callback for AgaaFrame::draw, with the device as drawUser.
    static AgaaResult AGAA_CALL drawCallback(void* device, const AgaaDrawTarget* target) {
        return static_cast<Device*>(device)->draw(*target);
    }
    // Returns the function that fetches the triangles of the scene of record(), for views of this device.
    virtual AgaaFetchFunction sceneFetch() const = 0;
    // Restores the bindings of sceneFetch() during record(), after a test has changed OpenGL's bindings.
    virtual void bindScene() const {}
    // Sets the depth of all shadow maps of later frames; initially 1.
    virtual void setShadowDepth(float depth) = 0;
    // Returns linear RGBA, row 0 first.
    virtual std::vector<float> readOutput() = 0;
    virtual void fillOutput(float value) = 0;
    // Creates images of the size of the output for AgaaResolvedOutputs, which later frames chain. 0: they chain none.
    virtual void setResolvedOutputs(uint32_t count) = 0;
    // Returns RGBA of image i, row 0 first.
    virtual std::vector<float> readResolvedOutput(uint32_t i) = 0;

    // Returns the messages of the validation layers, or of OpenGL's debug output, since the last call.
    virtual std::vector<std::string> takeMessages() = 0;
    // Returns false if the validation layer is not installed, so that there are no messages.
    virtual bool testsMessages() const = 0;

    // Returns the AGAA_VIEW_… that the clip space of the device needs.
    virtual uint64_t viewFlags() const = 0;
};

// Create a host on the first device of the API, or on the device whose name contains `name`. Throw Skipped with the
// reason if there is none. The Vulkan device enables the features that agaaVkGetRequirements requires, and
// geometryShader if available; withOptions also enables the other optional ones.
std::unique_ptr<Device> makeVulkanDevice(const Functions& sdk, const std::string& name, bool withOptions = false);
struct OpenGlVersion {
    int major = 4, minor = 5;
    bool isCompatibility = false; // the profile
};
std::unique_ptr<Device> makeOpenGlDevice(const std::string& name, const OpenGlVersion& version);
// Takes a core context of OpenGL 4.5, or one of 4.3.
std::unique_ptr<Device> makeOpenGlDevice(const std::string& name);

// ---- what most tests need ------------------------------------------------------------------------

// A context that is destroyed at the end of the test; its log is recorded.
class ScopedContext {
public:
    ScopedContext(Test& test, const std::function<void(ContextDescription&)>& change = {});
    ~ScopedContext();
    ScopedContext(const ScopedContext&) = delete;
    ScopedContext& operator=(const ScopedContext&) = delete;
    AgaaContext get() const { return context_; }
    LogRecorder log;

private:
    Test& test_;
    AgaaContext context_ = nullptr;
};

// Returns a fetch function without a scene.
AgaaFetchFunction emptyFetch();

// Returns n of a technique that corresponds to `samples` of "ssaa": 1 for techniques of one sample, 16 times as
// many coverage samples for "dcaa" and "sgbc".
uint32_t samplesOf(const std::string& technique, uint32_t samples);
bool needsOneSample(const std::string& technique);     // true for "single", "fxaa", "smaa" and "taa"
bool countsCoverage(const AgaaConfig& config);         // n counts coverage samples, and targets have one sample
bool hasCoverageSamples(const std::string& technique); // true for "dcaa" and "sgbc", which need an AgaaFetchFunction

// Config, facts and description of a view of 32 x 24 pixels: "agaa" with n = 4, counters, no shadows, ambient light.
// Tests change it before they create the view.
struct ViewDescription {
    ViewDescription(const Device* device); // null: no device
    ViewDescription(const ViewDescription&) = delete;
    ViewDescription& operator=(const ViewDescription&) = delete;
    // Selects a technique with n = samplesOf(name, samples), and chains sceneFetch if the technique needs it. Call it
    // once.
    void setTechnique(const std::string& name, uint32_t samples);
    std::string technique; // set by setTechnique()
    AgaaLayout layout;     // "precise"
    AgaaConfig config;
    AgaaAggregation aggregation;    // chained to config
    AgaaDecoupledCoverage coverage; // chained to aggregation
    AgaaAdaptiveSampling adaptive;  // chained to coverage
    AgaaTemporal temporal;          // chained to adaptive
    AgaaMeasurement measurement;    // chained to temporal
    AgaaFetchFunction sceneFetch;   // setTechnique() chains it to desc if the technique needs it
    AgaaSceneFacts facts;
    AgaaViewDesc desc;
};

// A view that is destroyed at the end of the test. It has no pipelines, so it cannot draw.
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

// A view with pipelines, and an output of its size.
class ScopedView : public BareView {
public:
    ScopedView(Test& test, AgaaContext context, const ViewDescription& description);
};

// Returns the frame i, after the completed frame i - 1. It has the camera of setPixelCamera for the description,
// ambient light 1, a black background and no lights.
AgaaFrame pixelFrame(const Device& device, const ViewDescription& description, uint64_t i);
// Returns three rectangles on whole pixels, from back to front. The last one is alpha-masked with alpha 1.
Scene smallScene(uint32_t width, uint32_t height);

} // namespace agaa::conformance
