// Stands between the SDK and OpenGL: functions fail, the context says other things of itself, and objects are counted.
#pragma once

#include "creation.h"

#include <map>

namespace agaa::conformance {

// One at a time. It outlives the contexts that are created with it.
class OpenGlInterposer {
public:
    OpenGlInterposer();
    ~OpenGlInterposer();
    OpenGlInterposer(const OpenGlInterposer&) = delete;
    OpenGlInterposer& operator=(const OpenGlInterposer&) = delete;

    // Makes the SDK load its functions here; what the description had is called for the others.
    void chainTo(ContextDescription& description);

    // The nth call from now on that allocates memory does nothing, and glGetError returns the error. 0: none.
    void failAt(uint32_t nth, uint32_t error);
    const std::string& failed() const { return failed_; } // the function that failed; empty if none did

    std::string version;          // GL_VERSION, "4.2 …"; empty: the context's
    std::string hiddenExtension;  // that the context seems to lack
    std::string missing;          // the function that is not found; "*": all functions
    bool isComplete = true;       // false: framebuffers are unsupported

    // Objects that were created and not deleted, by kind; kinds without such objects are not listed.
    std::map<std::string, int64_t> objects;

    // For the functions in place of OpenGL's.
    static OpenGlInterposer* current;
    bool fails(const char* function);
    uint32_t takeError();
    void count(const char* kind, int64_t difference);

private:
    static AgaaGlFunction AGAA_CALL getProcAddr(void* user, const char* name);
    AgaaGlGetProcAddr next_ = nullptr;
    void* nextUser_ = nullptr;
    uint32_t remaining_ = 0, error_ = 0, pending_ = 0;
    std::string failed_;
};

} // namespace agaa::conformance
