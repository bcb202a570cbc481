#include "core/base/spirv_code.h"

namespace agaa {

namespace {

class Reader {
public:
    explicit Reader(std::span<const uint8_t> bytes) : bytes_(bytes) {}

    uint64_t number() {
        uint64_t value = 0;
        for (uint32_t shift = 0; shift < 64; shift += 7) {
            if (at_ == bytes_.size())
                break;
            const uint64_t byte = bytes_[at_++];
            value |= (byte & 0x7F) << shift;
            if (byte < 0x80)
                return value;
        }
        isBroken_ = true;
        return 0;
    }
    bool isAtEnd() const { return at_ == bytes_.size(); }
    bool isBroken() const { return isBroken_; }

private:
    std::span<const uint8_t> bytes_;
    size_t at_ = 0;
    bool isBroken_ = false;
};

} // namespace

std::vector<uint32_t> decodedSpirv(std::span<const uint8_t> code) {
    constexpr size_t headerWords = 5, mostOperands = 0xFFFE;
    Reader reader(code);
    std::vector<uint32_t> words;
    words.reserve(code.size()); // an operand takes a byte at least
    for (size_t i = 0; i < headerWords; ++i)
        words.push_back(uint32_t(reader.number()));
    uint32_t next = spirvGlobalIds;
    while (!reader.isAtEnd() && !reader.isBroken()) {
        const uint64_t opcode = reader.number(), count = reader.number();
        if (opcode > 0xFFFF || count > mostOperands)
            return {};
        words.push_back(uint32_t((count + 1) << 16 | opcode));
        for (uint64_t i = 0; i < count && !reader.isBroken(); ++i) {
            const uint64_t number = reader.number(), value = number >> 2;
            switch (SpirvOperand(number & 3)) {
            case SpirvOperand::Literal:
            case SpirvOperand::Global:
                words.push_back(uint32_t(value));
                break;
            case SpirvOperand::Local:
                words.push_back(next + uint32_t(value & 1 ? (value + 1) >> 1 : -(value >> 1)));
                break;
            case SpirvOperand::Result:
                words.push_back(next++);
                break;
            }
        }
    }
    return reader.isBroken() ? std::vector<uint32_t>() : words;
}

} // namespace agaa
