// Collects the messages of validation layers and drivers, except those on the allow-list.
#pragma once

#include "render/renderer.h"

#include <mutex>
#include <string>
#include <vector>

namespace harness {

// One line of allowed_messages.txt, and whether this process has received a message that it allows.
struct AllowedMessage {
    std::string id;
    std::string substring;
    std::string reason;
    bool isUsed = false;
};

// Returns the allow-list with its use by all renderers of this process. Tests fail on unused entries.
std::vector<AllowedMessage> allowedMessages();

// Returns messages of destroyed renderers, for example about leaked objects, and messages that nobody took before. They
// come from all renderers of this process since the last call.
std::vector<ApiMessage> takeLeftoverMessages();

// Parses the allow-list. Throws std::runtime_error that names an invalid line.
std::vector<AllowedMessage> parseAllowedMessages(const std::string& text);

// Collects the reports of an API's debug callback. The collector must not move while the callback may run.
class MessageCollector {
public:
    void add(ApiMessage message); // ignored if the allow-list has it
    std::vector<ApiMessage> take();
    // Hands the messages to takeLeftoverMessages() when no more can arrive.
    void handOver();

private:
    std::mutex mutex_; // drivers may report from any thread
    std::vector<ApiMessage> messages_;
};

} // namespace harness
