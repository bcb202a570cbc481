// OpenGL objects of a plan's resources.
#pragma once

#include "core/plan/plan.h"
#include "gl/context.h"

#include <cstddef>
#include <vector>

namespace agaa::gl {

struct GpuResource {
    GLuint texture = 0;
    std::vector<GLuint> buffers;       // one per copy
    std::vector<GLuint> bufferImages;  // buffer textures of `buffers`, if host draws access them as texels
    const std::byte* mapped = nullptr; // of Plan::breadcrumbs, for reading while the device writes
};

class ViewResources {
public:
    ViewResources(const Context& context, const Plan& plan);
    ~ViewResources();
    ViewResources(const ViewResources&) = delete;
    ViewResources& operator=(const ViewResources&) = delete;

    const GpuResource& operator[](ResourceId id) const { return resources_[id]; }
    GLuint buffer(ResourceId id, uint32_t slot) const;
    GLuint bufferImage(ResourceId id, uint32_t slot) const;
    void clearPersistent(const Plan& plan);
    uint64_t payloadBytes() const { return payloadBytes_; } // per-pixel surfaces as created

private:
    void createTexture(const Resource& resource, GpuResource& out);
    void createMappedBuffer(const Resource& resource, GpuResource& out);
    void createBuffers(const Resource& resource, GLenum texels, GpuResource& out);
    void destroy();

    const Context& context_;
    std::vector<GpuResource> resources_;
    uint64_t payloadBytes_ = 0;
};

} // namespace agaa::gl
