// Elements of a glTF accessor.
#pragma once

#include "scene/gltf_reader.h"

#include <vector>

namespace harness {

// Reads elements as numbers or indices. The constructor checks every range, so that element < count() and
// component < components() are the only preconditions.
class AccessorView {
public:
    AccessorView(const GltfReader& reader, int index);
    AccessorView(const AccessorView&) = delete;
    AccessorView& operator=(const AccessorView&) = delete;

    size_t count() const { return accessor_->count; }
    size_t components() const { return components_; }

    // Returns a finite number; other numbers are 0.
    float number(size_t element, size_t component) const;
    // Returns an unsigned integer of 8, 16 or 32 bits.
    uint32_t index(size_t element, size_t component = 0) const;

private:
    struct Range {
        const unsigned char* data;
        size_t bytes;
    };
    Range viewOf(int bufferView, size_t byteOffset) const;
    void readDense();
    void readSparse();

    const GltfReader& reader_;
    const tinygltf::Accessor* accessor_;
    size_t components_ = 0;
    size_t size_ = 0; // bytes of a component
    size_t stride_ = 0;
    const unsigned char* data_ = nullptr;
    std::vector<unsigned char> own_; // elements of a sparse accessor
};

} // namespace harness
