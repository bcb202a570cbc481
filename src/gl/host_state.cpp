#include "gl/host_state.h"

#include "core/base/callbacks.h"
#include "core/base/error.h"

namespace agaa::gl {

// Of a frame that fails, which has a failure to tell of already.
View::HostState::~HostState() {
    if (finished_)
        return;
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE && captured_)
        context_.guard->restore(); // whatever a callback left behind
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS && away_)
        contained([&] { return context_.popState(context_.stateUser); });
}

void View::HostState::restore() {
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE)
        context_.guard->restore();
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS) {
        away_ = false;
        require(contained([&] { return context_.popState(context_.stateUser); }) == AGAA_OK, AGAA_ERROR_CALLBACK,
                "AgaaGlDeviceDesc::popState reported failure.");
    }
}

void View::HostState::finish() {
    restore();
    finished_ = true;
}

void View::HostState::save() {
    // What a callback changes is not what the host had on entry.
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE && !captured_) {
        context_.guard->capture();
        captured_ = true;
    }
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS) {
        require(contained([&] { return context_.pushState(context_.stateUser); }) == AGAA_OK, AGAA_ERROR_CALLBACK,
                "AgaaGlDeviceDesc::pushState reported failure.");
        away_ = true;
    }
}

} // namespace agaa::gl
