// Inputs of the C ABI with members that may have any value, and the check of results.
#pragma once

#include "target.h"

#include "agaa_sdk.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace fuzz {

// Owns copies of structs that are exactly as long as their structSize, so that AddressSanitizer sees reads beyond.
class Memory {
public:
    explicit Memory(Choices& choices) : choices_(choices) {}

    // Returns a copy whose words in [begin, end) may be changed. A larger `calm` changes fewer. Pointers must be
    // outside.
    template <typename T> T* copy(const T& value, size_t begin, size_t end, uint64_t calm) {
        size_t size = sizeof(T);
        if (choices_.oneIn(200))
            size = choices_.below(sizeof(T) + 65);
        // Hosts own the header at least, and the whole struct if structSize is less.
        const size_t bytes = std::max(size, sizeof(AgaaStructHeader));
        std::byte* block = keep(bytes);
        std::memcpy(block, &value, std::min(bytes, sizeof(T)));
        while (begin < end && choices_.oneIn(calm)) {
            const size_t at = begin + choices_.below((end - begin) / 4) * 4;
            const uint32_t word = choices_.word();
            if (at + 4 <= bytes)
                std::memcpy(block + at, &word, 4);
        }
        auto* header = reinterpret_cast<AgaaStructHeader*>(block);
        header->structSize = uint32_t(size);
        if (choices_.oneIn(250))
            header->sType = choices_.word();
        return reinterpret_cast<T*>(block);
    }
    // Returns a copy of a text or of an array that AddressSanitizer knows the end of.
    const char* text(const std::string& value);
    const float* numbers(size_t count, bool areValid);

private:
    std::byte* keep(size_t bytes) {
        blocks_.push_back(std::make_unique<std::byte[]>(bytes));
        return blocks_.back().get();
    }

    Choices& choices_;
    std::vector<std::unique_ptr<std::byte[]>> blocks_;
};

// A view and all that it points to. Most members have usual values, so that many views are accepted.
struct ViewInput {
    Memory memory;
    AgaaViewDesc* view = nullptr;
    AgaaConfig* config = nullptr;
    AgaaAggregation* aggregation = nullptr;
    AgaaMeasurement* measurement = nullptr;
    AgaaDeviceCaps* caps = nullptr; // may be null

    explicit ViewInput(Choices& choices);
};

struct Messages {
    unsigned errors = 0;
    AgaaResult code = AGAA_OK;
    std::string text;
    AgaaLog log = AGAA_LOG_INIT;

    Messages();
    Messages(const Messages&) = delete;
};

// Checks the result of a call: an error has one message, with its code, of one line that begins with the name of the
// function and ends with a full stop. It leaves the outputs as they were.
void checkResult(const char* function, AgaaResult result, const Messages& messages, bool isOutputChanged);

// Returns a name: one of the list, or text that no list has.
const char* anyName(Choices& choices, Memory& memory, std::initializer_list<const char*> names);

} // namespace fuzz
