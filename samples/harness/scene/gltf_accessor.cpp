#include "scene/gltf_accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace harness {

namespace {

constexpr size_t mostImplied = 1u << 22; // elements that take no space in a file

uint32_t indexAt(const unsigned char* data, size_t size) {
    uint32_t value = 0;
    std::memcpy(&value, data, size); // little-endian, as the format is
    return value;
}

bool isUnsigned(int componentType) {
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

} // namespace

AccessorView::AccessorView(const GltfReader& reader, int index) : reader_(reader) {
    accessor_ = &reader.at(reader.model.accessors, index, "accessors");
    const int components = tinygltf::GetNumComponentsInType(uint32_t(accessor_->type));
    const int size = tinygltf::GetComponentSizeInBytes(uint32_t(accessor_->componentType));
    if (components <= 0 || size <= 0)
        reader.fail("an accessor has an unknown type");
    components_ = size_t(components);
    size_ = size_t(size);
    if (accessor_->bufferView >= 0)
        readDense();
    else if (!accessor_->sparse.isSparse)
        reader.fail("an accessor has no data");
    if (accessor_->sparse.isSparse)
        readSparse();
}

AccessorView::Range AccessorView::viewOf(int bufferView, size_t byteOffset) const {
    const auto& view = reader_.at(reader_.model.bufferViews, bufferView, "bufferViews");
    const auto& buffer = reader_.at(reader_.model.buffers, view.buffer, "buffers").data;
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset ||
        byteOffset > view.byteLength)
        reader_.fail("an accessor reaches beyond its buffer");
    return {buffer.data() + view.byteOffset + byteOffset, view.byteLength - byteOffset};
}

void AccessorView::readDense() {
    const Range range = viewOf(accessor_->bufferView, accessor_->byteOffset);
    const int stride = accessor_->ByteStride(reader_.model.bufferViews[size_t(accessor_->bufferView)]);
    if (stride <= 0)
        reader_.fail("an accessor has no valid stride");
    stride_ = size_t(stride);
    // The first check bounds the product.
    if (count() > range.bytes || (count() > 0 && (count() - 1) * stride_ + components_ * size_ > range.bytes))
        reader_.fail("an accessor reaches beyond its buffer");
    data_ = range.data;
}

// Copies the elements, which are 0 without a buffer, and replaces some.
void AccessorView::readSparse() {
    const auto& sparse = accessor_->sparse;
    const size_t bytes = components_ * size_;
    if (!data_ && count() > mostImplied)
        reader_.fail("a sparse accessor without a buffer has more than " + std::to_string(mostImplied) + " elements");
    own_.resize(count() * bytes);
    for (size_t i = 0; data_ && i < count(); ++i)
        std::memcpy(&own_[i * bytes], data_ + i * stride_, bytes);
    data_ = own_.data();
    stride_ = bytes;
    if (!isUnsigned(sparse.indices.componentType) || sparse.count < 0 || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0)
        reader_.fail("a sparse accessor has invalid indices");
    const size_t indexSize = size_t(tinygltf::GetComponentSizeInBytes(uint32_t(sparse.indices.componentType)));
    const Range indices = viewOf(sparse.indices.bufferView, size_t(sparse.indices.byteOffset));
    const Range values = viewOf(sparse.values.bufferView, size_t(sparse.values.byteOffset));
    const auto replaced = size_t(sparse.count);
    if (replaced > indices.bytes / indexSize || replaced > values.bytes / bytes)
        reader_.fail("an accessor reaches beyond its buffer");
    for (size_t i = 0; i < replaced; ++i) {
        const uint32_t element = indexAt(indices.data + i * indexSize, indexSize);
        if (element >= count())
            reader_.fail("a sparse accessor has invalid indices");
        std::memcpy(&own_[element * bytes], values.data + i * bytes, bytes);
    }
}

float AccessorView::number(size_t element, size_t component) const {
    const unsigned char* p = data_ + element * stride_ + component * size_;
    const auto read = [&](auto value, float scale) {
        std::memcpy(&value, p, sizeof value);
        return accessor_->normalized ? std::max(float(value) / scale, -1.0f) : float(value);
    };
    switch (accessor_->componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT: {
        float value;
        std::memcpy(&value, p, sizeof value);
        if (std::isfinite(value))
            return finiteFloat(value);
        reader_.drop("numbers that are not finite are read as 0");
        return 0;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read(uint8_t(0), 255.0f);
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return read(int8_t(0), 127.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read(uint16_t(0), 65535.0f);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return read(int16_t(0), 32767.0f);
    default:
        reader_.fail("an accessor has a component type that vertices do not use");
    }
}

uint32_t AccessorView::index(size_t element, size_t component) const {
    if (!isUnsigned(accessor_->componentType))
        reader_.fail("indices have a component type that is not an unsigned integer");
    return indexAt(data_ + element * stride_ + component * size_, size_);
}

} // namespace harness
