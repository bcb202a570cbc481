#include "show.h"

#include <cstring>

namespace agaa::test {

FunctionBuffer::FunctionBuffer(const std::vector<glm::vec4>& data)
    : arena_(sharedDevice()), set_(sharedDevice(), 1, VK_SHADER_STAGE_COMPUTE_BIT) {
    buffer_ = arena_.hostBuffer(data.size() * sizeof data[0], VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(buffer_.mapped, data.data(), data.size() * sizeof data[0]);
    set_.write({buffer_.buffer.get()});
}

} // namespace agaa::test
