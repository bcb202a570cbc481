// The programs of the suite's host on OpenGL.
#pragma once

#include "gl_device.h"

#include <map>
#include <set>

namespace agaa::conformance {

struct OpenGlProgram {
    GLuint opaque = 0, masked = 0;
};

// The members of AgaaGlDeviceDesc on which programs depend.
struct ShaderDialect {
    uint32_t glslVersion = 450;
    bool declaresOutputs = false; // AGAA_GL_OUTPUTS_HOST
};

class OpenGlPrograms {
public:
    explicit OpenGlPrograms(const Mistakes& mistakes) : mistakes_(mistakes) {}
    ~OpenGlPrograms();
    OpenGlPrograms(const OpenGlPrograms&) = delete;
    OpenGlPrograms& operator=(const OpenGlPrograms&) = delete;

    void prepare(const Functions& sdk, AgaaView view, const ShaderDialect& dialect);
    void forget(AgaaView view);
    // Returns null if the pass was not prepared.
    const OpenGlProgram* find(AgaaView view, uint64_t pipelineKey, uint32_t pass) const;

private:
    using Key = std::pair<AgaaView, uint64_t>; // null and the pass with Mistakes::keysByPass
    Key keyOf(AgaaView view, uint64_t pipelineKey, uint32_t pass) const;
    static void destroy(const OpenGlProgram& program);

    const Mistakes& mistakes_;
    std::map<Key, OpenGlProgram> programs_;
    std::set<AgaaView> views_;
};

} // namespace agaa::conformance
