#include "render/messages.h"

#include "embedded.h"

#include <sstream>
#include <stdexcept>
#include <utility>

namespace harness {

namespace {

std::string trim(const std::string& text) {
    const size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

struct AllowList {
    std::mutex mutex;
    std::vector<AllowedMessage> entries = parseAllowedMessages(embedded::allowed_messages_txt);
};

AllowList& allowList() {
    static AllowList list;
    return list;
}

struct Leftovers {
    std::mutex mutex;
    std::vector<ApiMessage> messages;
};

Leftovers& leftovers() {
    static Leftovers list;
    return list;
}

bool isAllowed(const ApiMessage& message) {
    AllowList& list = allowList();
    const std::lock_guard lock(list.mutex);
    for (AllowedMessage& entry : list.entries) {
        if (entry.id == message.id && message.text.find(entry.substring) != std::string::npos) {
            entry.isUsed = true;
            return true;
        }
    }
    return false;
}

} // namespace

std::vector<AllowedMessage> allowedMessages() {
    AllowList& list = allowList();
    const std::lock_guard lock(list.mutex);
    return list.entries;
}

std::vector<ApiMessage> takeLeftoverMessages() {
    const std::lock_guard lock(leftovers().mutex);
    return std::exchange(leftovers().messages, {});
}

std::vector<AllowedMessage> parseAllowedMessages(const std::string& text) {
    std::vector<AllowedMessage> entries;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        line = trim(line);
        if (line.empty() || line[0] == '#')
            continue;
        const size_t first = line.find('|');
        const size_t second = first == std::string::npos ? first : line.find('|', first + 1);
        AllowedMessage entry;
        if (second != std::string::npos) {
            entry.id = trim(line.substr(0, first));
            entry.substring = trim(line.substr(first + 1, second - first - 1));
            entry.reason = trim(line.substr(second + 1));
        }
        if (entry.id.empty() || entry.substring.empty() || entry.reason.empty())
            throw std::runtime_error("Line " + std::to_string(number) +
                                     " of the list of allowed messages is not of the form "
                                     "\"id | substring | reason\".");
        entries.push_back(entry);
    }
    return entries;
}

std::vector<ApiMessage> MessageCollector::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(messages_, {});
}

void MessageCollector::handOver() {
    const std::vector<ApiMessage> rest = take();
    const std::lock_guard lock(leftovers().mutex);
    leftovers().messages.insert(leftovers().messages.end(), rest.begin(), rest.end());
}

void MessageCollector::add(ApiMessage message) {
    if (isAllowed(message))
        return;
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
}

} // namespace harness
