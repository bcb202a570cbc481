// The host's state around a frame, according to the context's state policy. It is saved while the SDK works. It is
// restored for draw callbacks and at the end of the frame, even if the frame fails.
#pragma once

#include "gl/view.h"

namespace agaa::gl {

class View::HostState {
public:
    explicit HostState(Context& context) : context_(context) { save(); }
    ~HostState();
    HostState(const HostState&) = delete;
    HostState& operator=(const HostState&) = delete;

    void restore(); // before a draw callback
    void save();    // after a draw callback
    void finish();  // at the end of the frame; throws if popState fails

private:
    Context& context_;
    bool captured_ = false;
    bool isPushed_ = false;
    bool finished_ = false;
};

} // namespace agaa::gl
