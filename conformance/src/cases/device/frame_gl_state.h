// A broad part of the state of an OpenGL context.
#pragma once

#include "suite.h"

#include "hosts/gl_device.h"

namespace agaa::conformance {

struct StateValue {
    std::string name; // GL_VIEWPORT, GL_UNIFORM_BUFFER_BINDING[3]
    std::vector<double> values;
    bool isBindingOfSdk = false; // the SDK binds here during draw callbacks, as AGAA_GL_DEVICE_DESC_INIT says
};
using State = std::vector<StateValue>;
State readState();
// inCallback: without the bindings of the SDK.
void expectSameState(Test& test, const State& got, const State& expected, bool inCallback, const std::string& when);

// State that differs from the initial one in as much as possible, with objects of its own. At the
// end it is initial again, except for what the suite's host sets itself.
class UnusualState {
public:
    UnusualState();
    ~UnusualState();
    UnusualState(const UnusualState&) = delete;
    UnusualState& operator=(const UnusualState&) = delete;

private:
    GLuint buffer_ = 0, texture_ = 0, array_ = 0, multisampled_ = 0, sampler_ = 0, framebuffer_ = 0, vertexArray_ = 0;
};
// Sets what changes fragments to what the suite's host relies on.
void setHarmlessState();

} // namespace agaa::conformance
