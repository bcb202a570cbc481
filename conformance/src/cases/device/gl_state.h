// The state of an OpenGL context: functions that make it unusual and read it, to test whether the SDK changes it.
#pragma once

#include "device.h"

namespace agaa::conformance {

struct StateValue {
    std::string name;
    std::vector<double> values;
    // The SDK sets this binding during draw callbacks, as AGAA_GL_DEVICE_DESC_INIT defines.
    bool isBindingOfSdk = false;
};
using State = std::vector<StateValue>; // values in the order of reading

State readState();
// Reads the state. inCallback excludes the bindings of the SDK.
void expectSameState(Test& test, const State& got, const State& expected, bool inCallback, const std::string& when);

// Sets all state to values that differ from the initial ones. Its objects remain until the context is destroyed.
void makeStateUnusual();
// Sets the state on which the suite's host relies and which it does not set.
void setHarmlessState();

// A test in a separate OpenGL context, whose state the other tests do not see. Its failures become failures of the
// outer test.
class SeparateOpenGl {
public:
    explicit SeparateOpenGl(Test& outer);
    ~SeparateOpenGl();
    SeparateOpenGl(const SeparateOpenGl&) = delete;
    SeparateOpenGl& operator=(const SeparateOpenGl&) = delete;
    const std::unique_ptr<Device> device;
    Test test;

private:
    Test& outer_;
};

} // namespace agaa::conformance
