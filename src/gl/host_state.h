// The host's state around a frame, by the policy that the host chose: away while the SDK works, back while the
// host draws and when it ends, however it ends.
#pragma once

#include "gl/view.h"

namespace agaa::gl {

class View::HostState {
public:
    explicit HostState(Context& context) : context_(context) { save(); }
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

    void restore(); // the host's, before a draw callback
    void save();    // after it
    void finish();  // restores for good, and tells if that fails

private:
    Context& context_;
    bool captured_ = false;
    bool away_ = false;
    bool finished_ = false;
};

} // namespace agaa::gl
