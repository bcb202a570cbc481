#include "core/view/custom_glsl.h"

#include "core/base/error.h"
#include "core/base/glsl_number.h"

namespace agaa {

// Parameters of the macros begin with agaa_. Names of attributes never do.
std::string customGlsl(const Layout& layout) {
    if (layout.customs.empty())
        return {};
    std::string members, clear, sanitise, store, load;
    uint32_t channel = 0;
    for (const auto& [name, a] : layout.customs) {
        const std::string type = a.channels == 1 ? "float" : format("vec%u", a.channels);
        const std::string member = "(agaa_s)." + name, range = glslNumber(a.range);
        const bool isNormal = a.filter == AGAA_FILTER_NORMAL;
        members += type + " " + name + "; ";
        clear += member + " = " + (isNormal ? "vec3(0.0, 0.0, 1.0)" : type + "(0.0)") + "; ";
        if (isNormal)
            sanitise += format("%s = agaa_sanitiseNormal(%s, agaa_bad); ", member.c_str(), member.c_str());
        std::string components;
        for (uint32_t i = 0; i < a.channels; ++i, ++channel) {
            const std::string value = a.channels == 1 ? member : member + "." + "xyzw"[i];
            if (!isNormal)
                sanitise +=
                    format("%s = agaa_sanitise(%s, 0.0, %s, agaa_bad); ", value.c_str(), value.c_str(), range.c_str());
            store += format("(agaa_v).custom[%u] = %s / %s; ", channel, value.c_str(), range.c_str());
            components += format("%s(agaa_v).custom[%u]", i ? ", " : "", channel);
        }
        const std::string value = format("%s(%s) * %s", type.c_str(), components.c_str(), range.c_str());
        load += member + " = " + (a.filter == AGAA_FILTER_CLASS ? "floor(" + value + " + 0.5)" : value) + "; ";
    }
    return "#define AGAA_CUSTOM_MEMBERS " + members + "\n#define AGAA_CLEAR_CUSTOM(agaa_s) " + clear +
           "\n#define AGAA_SANITISE_CUSTOM(agaa_s, agaa_bad) " + sanitise +
           "\n#define AGAA_STORE_CUSTOM(agaa_s, agaa_v) " + store + "\n#define AGAA_LOAD_CUSTOM(agaa_v, agaa_s) " +
           load + "\n";
}

} // namespace agaa
