#include "core/view/resolved_outputs.h"

#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/base/names.h"
#include "core/base/structs.h"

#include <string_view>

namespace agaa {

static void findAttribute(ResolvedOutput& output, const char* name, const Layout& layout) {
    for (const CustomAttribute& custom : layout.customs) {
        if (custom.name == name) {
            output.attribute = custom.attribute;
            return;
        }
        output.firstChannel += custom.attribute.channels;
    }
    fail(AGAA_ERROR_LAYOUT,
         format("AgaaResolvedOutput::attribute is \"%s\", and no custom attribute of the layout has this name.",
                printable(name).c_str()));
}

std::vector<ResolvedOutput> readResolvedOutputs(const AgaaViewDesc& desc, const Layout& layout) {
    const std::optional<AgaaResolvedOutputs> chained = readChained<AgaaResolvedOutputs>(&desc);
    if (!chained)
        return {};
    checkReserved(chained->reserved, "AgaaResolvedOutputs::reserved");
    checkRange(uint64_t(chained->count), 1, AGAA_MAX_RESOLVED_OUTPUTS, "AgaaResolvedOutputs::count");
    std::vector<ResolvedOutput> outputs(chained->count);
    for (uint32_t i = 0; i < chained->count; ++i) {
        const AgaaResolvedOutput& source = chained->outputs[i];
        checkReserved(source.reserved, "AgaaResolvedOutput::reserved");
        checkRange(uint64_t(source.value), AGAA_RESOLVED_NEAREST_DEPTH, AGAA_RESOLVED_CUSTOM,
                   "AgaaResolvedOutput::value");
        require((source.value == AGAA_RESOLVED_CUSTOM) == (source.attribute != nullptr), AGAA_ERROR_INVALID_ARGUMENT,
                "AgaaResolvedOutput::attribute is null for CUSTOM, or not null for another value.");
        outputs[i].value = AgaaResolvedValue(source.value);
        if (source.attribute)
            findAttribute(outputs[i], source.attribute, layout);
    }
    return outputs;
}

} // namespace agaa
