#include "structs.h"

#include <stdexcept>

namespace agaa::conformance {

namespace {

std::vector<StructRow> makeRows() {
    std::vector<StructRow> rows;
#define AGAA_STRUCT(Name, TYPE, bytes)                                                                                 \
    {                                                                                                                  \
        static const Agaa##Name value = AGAA_##TYPE##_INIT;                                                            \
        const auto* from = reinterpret_cast<const unsigned char*>(&value);                                             \
        rows.push_back({"Agaa" #Name,                                                                                  \
                        AGAA_STRUCTURE_TYPE_##TYPE,                                                                    \
                        sizeof value,                                                                                  \
                        bytes,                                                                                         \
                        {from, from + sizeof value},                                                                   \
                        [](const Functions& sdk, void* structure, size_t structSize) {                                 \
                            sdk.agaaInit##Name(static_cast<Agaa##Name*>(structure), structSize);                       \
                        }});                                                                                           \
    }
#define AGAA_VK_STRUCT AGAA_STRUCT
#define AGAA_GL_STRUCT AGAA_STRUCT
#include "structs.inc"
    return rows;
}

} // namespace

const std::vector<StructRow>& versionedStructs() {
    static const std::vector<StructRow> rows = makeRows();
    return rows;
}

const StructRow& versionedStruct(const std::string& name) {
    for (const StructRow& row : versionedStructs())
        if (row.name == name)
            return row;
    throw std::logic_error(name + " is not in structs.inc");
}

size_t Bytes::findDifference(size_t from, size_t to, unsigned char value) const {
    for (size_t i = from; i < to; ++i)
        if (data()[i] != value)
            return i;
    return size_;
}

} // namespace agaa::conformance
