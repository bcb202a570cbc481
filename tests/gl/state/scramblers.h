// A scrambler for each row of the state table.
#pragma once

#include "gl/state_context.h"
#include "host_objects.h"

#include <initializer_list>
#include <span>

namespace agaa::test {

// Values of one row's element, from a seed.
class Values {
public:
    Values(uint32_t seed, uint32_t row, uint32_t element)
        : state_((seed / 2) * 0x9E3779B9u ^ row * 0x85EBCA6Bu ^ element * 0xC2B2AE35u), odd_(seed % 2) {}

    uint32_t below(uint32_t count) {
        state_ = state_ * 747796405u + 2891336453u;
        const uint32_t mixed = ((state_ >> ((state_ >> 28) + 4u)) ^ state_) * 277803737u;
        return (((mixed >> 22) ^ mixed) % count + odd_) % count;
    }
    bool flag() { return below(2) != 0; }
    GLboolean boolean() { return flag() ? GL_TRUE : GL_FALSE; }
    // Multiples of a sixteenth of the span, which every number type holds.
    float number(float least, float most) { return least + (most - least) * static_cast<float>(below(17)) / 16.0f; }
    template <typename T> T oneOf(std::initializer_list<T> list) {
        return list.begin()[below(static_cast<uint32_t>(list.size()))];
    }
    GLuint name(const HostObjects::Names& names) { return names[below(HostObjects::kCount)]; }
    // Seldom 0, which is a value like others.
    GLuint nameOrNone(const HostObjects::Names& names) {
        const uint32_t i = below(2 * HostObjects::kCount + 1);
        return i == 0 ? 0 : names[(i - 1) % HostObjects::kCount];
    }

private:
    uint32_t state_;
    uint32_t odd_;
};

struct Scrambling {
    const GladGLContext& gl;
    const HostObjects& objects;
    bool compatibilityProfile;
    const gl::StateRow& row;
    uint32_t element;
    Values values;
};

struct Scrambler {
    const char* name; // of the row; those that glEnable switches need none
    void (*run)(Scrambling&);
};
std::span<const Scrambler> fixedFunctionScramblers();
std::span<const Scrambler> bindingScramblers();
// Null if there is none.
void (*scramblerOf(const gl::StateRow& row))(Scrambling&);

} // namespace agaa::test
