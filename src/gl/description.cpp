// What hosts are told of a view's draw passes and surfaces.
#include "core/base/structs.h"
#include "gl/formats.h"
#include "gl/view.h"

namespace agaa::gl {

const StructRow& View::drawPassRow() const { return StructOf<AgaaGlDrawPass>::row; }
const StructRow& View::surfaceRow() const { return StructOf<AgaaGlSurface>::row; }

void View::describePass(size_t index, void* native) const {
    const HostPass& hostPass = hostPasses[index];
    AgaaGlDrawPass own = AGAA_GL_DRAW_PASS_INIT;
    for (size_t i = 0; i < hostPass.colors.size(); ++i)
        own.colorFormats[i] = internalFormat(hostPass.colors[i].format);
    own.depthStencilFormat = internalFormat(hostPass.depthFormat);
    own.framebuffer = framebuffers[index];
    writeStruct(static_cast<AgaaGlDrawPass*>(native), own);
}

void View::describeSurface(ResourceId id, void* native) const {
    const GpuResource& objects = (*resources)[id];
    AgaaGlSurface own = AGAA_GL_SURFACE_INIT;
    own.texture = objects.texture;
    own.buffer = objects.buffers.empty() ? 0 : objects.buffers[0];
    own.format = internalFormat(plan.resources[id].format);
    writeStruct(static_cast<AgaaGlSurface*>(native), own);
}

} // namespace agaa::gl
