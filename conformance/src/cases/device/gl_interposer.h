// Stands between the SDK and OpenGL: functions that allocate memory fail, and the context says other things of itself.
#pragma once

#include "interposer.h"

namespace agaa::conformance {

// A call that fails does nothing, and glGetError returns the error.
class OpenGlInterposer : public Interposer {
public:
    OpenGlInterposer();
    ~OpenGlInterposer() override;

    // What the description had is called for the other functions.
    void chainTo(ContextDescription& description) override;

    std::string version;          // GL_VERSION, "4.2 …"; empty: the context's
    std::string hiddenExtension;  // that the context seems to lack
    std::string missing;          // the function that is not found; "*": all functions
    bool isComplete = true;       // false: framebuffers are unsupported

    // For the functions in place of OpenGL's.
    static OpenGlInterposer* current;
    bool fails(const char* function);
    uint32_t takeError();

private:
    static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name);
    AgaaGlGetProcAddr next_ = nullptr;
    void* nextUser_ = nullptr;
    uint32_t pending_ = 0;
};

} // namespace agaa::conformance
