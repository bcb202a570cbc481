// Collects what validation layers and drivers report, less what the allow-list excuses.
#pragma once

#include "render/renderer.h"

#include <mutex>
#include <string>
#include <vector>

namespace harness {

// One line of allowed_messages.txt, and whether this process has met a message that it excuses.
struct AllowedMessage {
    std::string id;
    std::string substring;
    std::string reason;
    bool isUsed = false;
};

// The allow-list as used so far by all renderers of this process: tests fail on unused entries.
std::vector<AllowedMessage> allowedMessages();

// Messages that came when a renderer was destroyed, such as of leaked objects, or that nobody took
// before. Since the last call, of all renderers of this process.
std::vector<ApiMessage> takeLeftoverMessages();

// Parses the allow-list. Throws std::runtime_error naming the line that is not of its form.
std::vector<AllowedMessage> parseAllowedMessages(const std::string& text);

// What an API's debug callback reports; the collector must stay where it is as long as that may call.
class MessageCollector {
public:
    void add(ApiMessage message); // unless the allow-list excuses it
    std::vector<ApiMessage> take();
    // For takeLeftoverMessages(), when no more can come.
    void giveUp();

private:
    std::mutex mutex_; // drivers may report from threads of their own
    std::vector<ApiMessage> messages_;
};

} // namespace harness
