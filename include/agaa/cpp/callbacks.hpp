// Function objects as callbacks of the SDK. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_CALLBACKS_HPP
#define AGAA_CPP_CALLBACKS_HPP

#include "agaa/base.h"
#include "agaa/cpp/init.hpp"

#include <memory>
#include <string_view>
#include <type_traits>
#include <utility>

namespace agaa {

// Sets a callback and its user pointer so that they call a function object, which takes the callback's parameters
// without `user` and must be noexcept: agaa::bind(frame.draw, frame.drawUser, draw). The object must exist and stay in
// its place as long as the SDK may call it. Callbacks that share a user pointer need one object with several operators.
template <class Return, class... Arguments, class Function>
void bind(Return(AGAA_CALL*& callback)(void*, Arguments...), void*& user, Function& function) noexcept {
    static_assert(std::is_object_v<Function>, "Assign functions to the callback itself.");
    static_assert(std::is_nothrow_invocable_r_v<Return, Function&, Arguments...>,
                  "The function object must take the callback's parameters and be noexcept.");
    callback = [](void* object, Arguments... arguments) noexcept -> Return {
        return static_cast<Return>((*static_cast<Function*>(object))(arguments...));
    };
    user = const_cast<void*>(static_cast<const volatile void*>(std::addressof(function)));
}
template <class Callback, class Function> void bind(Callback&, void*&, const Function&&) = delete; // it would dangle

// A function object that receives the SDK's messages: void(AgaaSeverity, AgaaResult, std::string_view) noexcept. The
// text is valid during the call only, and has a zero behind it. The sink must outlive the contexts whose description
// has its log, because they keep its address. It runs in the thread that called the SDK and must not call the SDK.
template <class Function> class LogSink {
    static_assert(std::is_nothrow_invocable_v<Function&, AgaaSeverity, AgaaResult, std::string_view>,
                  "The function object must take (AgaaSeverity, AgaaResult, std::string_view) and be noexcept.");

public:
    explicit LogSink(Function function) noexcept(std::is_nothrow_move_constructible_v<Function>)
        : function_(std::move(function)) {
        log_.callback = [](void* user, uint32_t severity, AgaaResult code, const char* message) noexcept {
            static_cast<LogSink*>(user)->function_(static_cast<AgaaSeverity>(severity), code, message);
        };
        log_.user = this;
    }
    LogSink(const LogSink&) = delete;
    LogSink& operator=(const LogSink&) = delete;

    // Returns the log for AgaaContextDesc::log and for functions that take one.
    [[nodiscard]] const AgaaLog* get() const noexcept { return &log_; }

private:
    Function function_;
    AgaaLog log_ = init<AgaaLog>();
};

} // namespace agaa

#endif // AGAA_CPP_CALLBACKS_HPP
