// The state of an OpenGL context: made unusual, and read, to see whether the SDK changes it.
#pragma once

#include "device.h"

namespace agaa::conformance {

struct StateValue {
    std::string name;
    std::vector<double> values;
    // The SDK sets it during draw callbacks, as AGAA_GL_DEVICE_DESC_INIT says.
    bool isBindingOfSdk = false;
};
using State = std::vector<StateValue>; // in the order of reading

State readState();
// inCallback: without the bindings of the SDK.
void expectSameState(Test& test, const State& got, const State& expected, bool inCallback, const std::string& when);

// Sets everything that can be set to other values than the initial ones, with objects that remain until the context is
// destroyed.
void makeStateUnusual();
// Sets what the suite's host relies on and does not set itself.
void setHarmlessState();

// A test in an OpenGL context of its own, whose state the other tests do not see. What fails there fails in the outer test.
class OwnOpenGl {
public:
    explicit OwnOpenGl(Test& outer);
    ~OwnOpenGl();
    OwnOpenGl(const OwnOpenGl&) = delete;
    OwnOpenGl& operator=(const OwnOpenGl&) = delete;
    const std::unique_ptr<Device> device;
    Test test;

private:
    Test& outer_;
};

} // namespace agaa::conformance
