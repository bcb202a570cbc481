#include "core/plan/surfaces.h"

#include "core/base/checked.h"

#include <cstring>

namespace agaa {

AgaaSurface describeSurface(const Plan& plan, ResourceId id) {
    const Resource& resource = plan.resources[id];
    AgaaSurface surface = AGAA_SURFACE_INIT;
    std::strncpy(surface.name, resource.name.c_str(), sizeof surface.name - 1);
    if (resource.format != Format::Buffer) {
        std::strncpy(surface.format, formatName(resource.format), sizeof surface.format - 1);
        surface.width = resource.width;
        surface.height = resource.height;
        surface.scaleX = resource.hasFixedSize ? 0 : resource.width / plan.view.width;
        surface.scaleY = resource.hasFixedSize ? 0 : resource.height / plan.view.height;
    }
    surface.samples = resource.samples;
    surface.layers = resource.layers;
    surface.bytes = checkedMultiply(resource.bytes, resource.copies);
    surface.isPerPixel = resource.isPerPixel();
    surface.firstPass = resource.firstPass;
    surface.lastPass = resource.lastPass;
    return surface;
}

} // namespace agaa
