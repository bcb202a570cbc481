// The motion of a frame's draws as texels of a buffer, for material.frag.
#pragma once

#include "render/draw_list.h"
#include "vk/arena.h"

namespace harness::vk {

class GpuMotion {
public:
    GpuMotion(const Device& device, size_t maxDraws);

    // Writes the texel buffer's descriptor. No command that uses the set may be pending.
    void write(VkDescriptorSet set, uint32_t binding) const;
    // Replaces the rows. No command that reads them may be pending.
    void update(const std::vector<Draw>& draws);

private:
    const Device* device_;
    Arena arena_;
    BufferResource rows_;
    BufferView texels_;
};

} // namespace harness::vk
