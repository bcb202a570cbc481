// What hosts are told of a view's draw passes and surfaces.
#include "core/base/structs.h"
#include "gl/formats.h"
#include "gl/view.h"

namespace agaa::gl {

const StructRow& View::drawPassRow() const { return StructOf<AgaaGlDrawPass>::row; }
const StructRow& View::surfaceRow() const { return StructOf<AgaaGlSurface>::row; }

void View::describePass(size_t index, AgaaDrawPass& out, void* native) const {
    const Pass& pass = plan.passes[index];
    const PassObjects& objects = passes[index];
    out.pipelineKey = objects.key;
    out.glslExtensions = objects.extensions.c_str();
    out.glslDeclarations = objects.declarations.c_str();
    out.glslGeometry = objects.geometry.empty() ? nullptr : objects.geometry.c_str();
    out.glslVertex = objects.vertex.empty() ? nullptr : objects.vertex.c_str();
    if (!native)
        return;
    AgaaGlDrawPass own = AGAA_GL_DRAW_PASS_INIT;
    uint32_t attachments = 0;
    for (ResourceId target : pass.draw.colorTargets)
        for (uint32_t layer = 0; layer < plan.resources[target].layers; ++layer)
            own.colorFormats[attachments++] = internalFormat(plan.resources[target].format);
    own.depthStencilFormat =
        pass.draw.depthTarget != noResource ? internalFormat(plan.resources[pass.draw.depthTarget].format) : GL_NONE;
    own.framebuffer = objects.framebuffer;
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
