// An interposer between the SDK and OpenGL. Functions that create objects, allocate memory or compile fail, and the
// context reports changed properties.
#pragma once

#include "interposer.h"

namespace agaa::conformance {

// A call that fails does nothing, and glGetError returns the error. Functions that return a value return 0. If the
// error is 0, only functions whose failure shows in their results fail.
class OpenGlInterposer : public Interposer {
public:
    OpenGlInterposer();
    ~OpenGlInterposer() override;

    // The function of the description provides all other functions.
    void chainTo(ContextDescription& description) override;

    std::string version;         // GL_VERSION, "4.2 …"; empty: the context's
    std::string hiddenExtension; // extension that the context seems to lack
    std::string missing;         // function that is not found; "*": all functions
    bool isComplete = true;      // false: framebuffers are reported as unsupported

    bool notifiesReset = false; // the context seems to be created with GL_LOSE_CONTEXT_ON_RESET
    uint32_t resetStatus = 0;   // the next result of glGetGraphicsResetStatus

    // Called by the functions that replace OpenGL's.
    static OpenGlInterposer* current;
    bool fails(const char* function);
    bool failsVisibly(const char* function);
    bool countsAsLost();
    uint32_t takeError();

private:
    static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name);
    AgaaGlGetProcAddr next_ = nullptr;
    void* nextUser_ = nullptr;
    uint32_t pending_ = 0;
};

} // namespace agaa::conformance
