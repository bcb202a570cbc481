#include "gl/host_state.h"

#include "core/base/callbacks.h"
#include "core/base/error.h"

namespace agaa::gl {

// Runs after a failure only; the first error is the one that is reported.
View::HostState::~HostState() {
    if (finished_)
        return;
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE && captured_)
        context_.guard->restore(); // undoes the changes of a callback, too
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS && isPushed_)
        contained([&] { return context_.popState(context_.stateUser); });
}

void View::HostState::restore() {
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE)
        context_.guard->restore();
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS) {
        isPushed_ = false;
        require(contained([&] { return context_.popState(context_.stateUser); }) == AGAA_OK, AGAA_ERROR_CALLBACK,
                "AgaaGlDeviceDesc::popState reported failure.");
    }
}

void View::HostState::finish() {
    restore();
    finished_ = true;
}

void View::HostState::save() {
    // Captured once per frame: changes of a callback are not part of the state on entry.
    if (context_.statePolicy == AGAA_GL_STATE_RESTORE && !captured_) {
        context_.guard->capture();
        captured_ = true;
    }
    if (context_.statePolicy == AGAA_GL_STATE_CALLBACKS) {
        require(contained([&] { return context_.pushState(context_.stateUser); }) == AGAA_OK, AGAA_ERROR_CALLBACK,
                "AgaaGlDeviceDesc::pushState reported failure.");
        isPushed_ = true;
    }
}

} // namespace agaa::gl
