// Names of objects, by which tools show them.
#include "cases.h"
#include "frame_rig.h"
#include "vk_interposer.h"

namespace agaa::conformance {

namespace {

// Every object that the SDK creates on the device has a name that begins with "agaa".
void testObjectNames(Test& test) {
    for (const std::string& technique : techniques(test)) {
        VulkanInterposer vulkan;
        Rig rig(
            test,
            [&](ViewDescription& description) {
                setTechnique(description, technique, 4);
                description.config.flags |= AGAA_CONFIG_COUNTERS | AGAA_CONFIG_TIMESTAMPS | AGAA_CONFIG_BREADCRUMBS;
            },
            [&](ContextDescription& description) { vulkan.chainTo(description); });
        rig.render();
        test.check(!vulkan.kinds.empty(), "\"" + technique + "\" creates no objects.");
        for (const auto& [handle, kind] : vulkan.kinds)
            test.check(vulkan.names[handle].starts_with("agaa"),
                       "a Vk" + kind + " of \"" + technique + "\" has the name \"" + vulkan.names[handle] + "\".");
    }
}

} // namespace

void addObjectNameCases(Suite& suite) { suite.add("agaaVkCreateView/names", {Backend::Vulkan}, testObjectNames); }

} // namespace agaa::conformance
