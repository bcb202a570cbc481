#include "render/camera_matrices.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace harness {

namespace {

// Returns any direction perpendicular to v.
glm::dvec3 perpendicular(const glm::dvec3& v) {
    const glm::dvec3 a = glm::abs(v);
    const glm::dvec3 axis = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                            : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                     : glm::dvec3(0, 0, 1);
    return glm::normalize(glm::cross(v, axis));
}

double farthestCorner(const Scene& scene, const glm::dvec3& point) {
    const glm::dvec3 reach = glm::max(glm::abs(scene.boundsMin - point), glm::abs(scene.boundsMax - point));
    return glm::length(reach);
}

glm::dmat4 rotationToView(const glm::dvec3& forward, const glm::dvec3& up) {
    glm::dvec3 right = glm::cross(forward, up);
    const double sine = glm::length(right);
    right = sine > 1e-6 * glm::length(up) && sine > 0 ? right / sine : perpendicular(forward);
    const glm::dvec3 trueUp = glm::cross(right, forward);
    glm::dmat4 view(1);
    for (int i = 0; i < 3; ++i) {
        view[i][0] = right[i];
        view[i][1] = trueUp[i];
        view[i][2] = -forward[i];
    }
    return view;
}

// Clip space moves by 2 jitter / size.
glm::dvec2 clipJitter(const RenderSettings& settings, ClipY clipY) {
    const double yDown = clipY == ClipY::Down ? 1 : -1;
    return {2 * settings.jitter.x / settings.width, 2 * settings.jitter.y / settings.height * yDown};
}

void projectPerspective(CameraMatrices& m, const RenderSettings& settings, ClipY clipY) {
    const double focal = 1.0 / std::tan(glm::radians(settings.camera.fovDegrees) / 2);
    const double aspect = double(settings.width) / settings.height;
    glm::dmat4& p = m.projection;
    p = glm::dmat4(0);
    p[0][0] = focal / aspect;
    p[1][1] = clipY == ClipY::Down ? -focal : focal;
    p[2][3] = -1;
    p[2][0] = -m.jitter.x; // w is -z
    p[2][1] = -m.jitter.y;
    if (settings.reversedZ) {
        p[3][2] = m.nearPlane;
    } else {
        p[2][2] = m.farPlane / (m.nearPlane - m.farPlane);
        p[3][2] = m.nearPlane * m.farPlane / (m.nearPlane - m.farPlane);
    }
}

void projectOrthographic(CameraMatrices& m, const RenderSettings& settings, ClipY clipY) {
    const double scale = 2 / settings.camera.height;
    const double aspect = double(settings.width) / settings.height;
    m.viewer = glm::dvec4(-m.forward, 0);
    m.nearPlane = 0;
    m.targetDistance = std::max(m.targetDistance, settings.camera.height); // for shadows; the eye is arbitrary
    glm::dmat4& p = m.projection;
    p = glm::dmat4(1);
    p[0][0] = scale / aspect;
    p[1][1] = clipY == ClipY::Down ? -scale : scale;
    p[2][2] = (settings.reversedZ ? 1 : -1) / m.farPlane;
    p[3] = {m.jitter, settings.reversedZ ? 1 : 0, 1};
}

} // namespace

CameraMatrices cameraMatrices(const Scene& scene, const RenderSettings& settings, ClipY clipY) {
    const Camera& camera = settings.camera;
    const glm::dvec3 gaze = camera.target - camera.eye;
    CameraMatrices m;
    m.targetDistance = glm::length(gaze);
    if (!(m.targetDistance > 0) || !std::isfinite(m.targetDistance))
        throw std::runtime_error("The camera's eye and target are the same point or not finite.");
    const bool isOrthographic = camera.height > 0;
    if (!isOrthographic && (!(camera.fovDegrees > 0) || !(camera.fovDegrees < 180)))
        throw std::runtime_error("The camera's field of view must be between 0 and 180 degrees.");

    m.eye = camera.eye + settings.worldOffset;
    m.forward = gaze / m.targetDistance;
    m.view = rotationToView(m.forward, camera.up);

    // The near plane is close enough for objects around a camera that looks at a distant target. This costs precision
    // at the far end of the standard depth range, as in any engine.
    const double reach = std::max(farthestCorner(scene, camera.eye), m.targetDistance);
    m.nearPlane = std::max(0.001 * m.targetDistance, 1e-6 * reach);
    m.farPlane = 1.01 * reach + m.nearPlane;

    m.jitter = clipJitter(settings, clipY);
    if (isOrthographic)
        projectOrthographic(m, settings, clipY);
    else
        projectPerspective(m, settings, clipY);
    m.viewProjection = m.projection * m.view;
    return m;
}

glm::dmat4 toShadingSpace(const glm::dmat4& objectToWorld, const glm::dvec3& worldOffset, const glm::dvec3& eye) {
    glm::dmat4 result = objectToWorld;
    result[3] = glm::dvec4(glm::dvec3(objectToWorld[3]) + worldOffset - eye, 1);
    return result;
}

} // namespace harness
