// Descriptions of draw passes and surfaces for hosts.
#include "gl/formats.h"
#include "gl/structs.h"
#include "gl/view.h"

namespace agaa::gl {

const StructRow& View::drawPassRow() const { return StructOf<AgaaGlDrawPass>::row; }
const StructRow& View::surfaceRow() const { return StructOf<AgaaGlSurface>::row; }

void View::describePass(size_t index, void* native) const {
    const HostPass& hostPass = hostPasses[index];
    AgaaGlDrawPass description = AGAA_GL_DRAW_PASS_INIT;
    for (size_t i = 0; i < hostPass.colors.size(); ++i)
        description.colorFormats[i] = internalFormat(hostPass.colors[i].format);
    description.depthStencilFormat = internalFormat(hostPass.depthFormat);
    description.framebuffer = framebuffers[index];
    writeStruct(static_cast<AgaaGlDrawPass*>(native), description);
}

void View::describeSurface(ResourceId id, void* native) const {
    const GpuResource& objects = (*resources)[id];
    AgaaGlSurface description = AGAA_GL_SURFACE_INIT;
    description.texture = objects.texture;
    description.buffer = objects.buffers.empty() ? 0 : objects.buffers[0];
    description.format = internalFormat(plan.resources[id].format);
    writeStruct(static_cast<AgaaGlSurface*>(native), description);
}

} // namespace agaa::gl
