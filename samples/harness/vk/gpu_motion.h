// The motion of a frame's draws as texels of a buffer, for material.frag.
#pragma once

#include "render/draw_list.h"
#include "vk/arena.h"

namespace harness::vk {

class GpuMotion {
public:
    // set and binding: the descriptor of the texel buffer, which the object writes.
    GpuMotion(const Device& device, VkDescriptorSet set, uint32_t binding);

    // Replaces the rows. No command that reads them, or uses the set, may be pending.
    void update(const std::vector<Draw>& draws);

private:
    void reserve(size_t draws);

    const Device* device_;
    VkDescriptorSet set_;
    uint32_t binding_;
    Arena arena_;
    BufferResource rows_;
    BufferView texels_;
    size_t capacity_ = 0; // draws
};

} // namespace harness::vk
