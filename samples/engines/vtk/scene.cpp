/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkConeSource.h>
#include <vtkCubeSource.h>
#include <vtkElevationFilter.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkOutlineFilter.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkSphereSource.h>
#include <vtkTrivialProducer.h>
#include <vtkTubeFilter.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace {

struct Texel {
    float red, green, blue, alpha = 1.0f;
};

float encodeSrgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

/* Creates a texture with mip levels from a colour per texel; x and y are in [0, 1). */
vtkSmartPointer<vtkTexture> createTexture(int size, const std::function<Texel(float x, float y)>& texelAt) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(size, size, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Texel t = texelAt((float(x) + 0.5f) / float(size), (float(y) + 0.5f) / float(size));
            for (const float channel : {encodeSrgb(t.red), encodeSrgb(t.green), encodeSrgb(t.blue), t.alpha})
                *bytes++ = static_cast<unsigned char>(std::lround(channel * 255.0f));
        }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    texture->SetColorModeToDirectScalars();
    texture->UseSRGBColorSpaceOn(); // VTK's PBR shader requires it
    texture->MipmapOn();
    texture->InterpolateOn();
    return texture;
}

/* Alpha of a lobed leaf with a stem: 0.5 at its outline, which is some texels wide. */
Texel leafTexel(float x, float y) {
    const float u = 2.0f * x - 1.0f, v = 2.0f * y - 1.0f;
    const float angle = std::atan2(u, v), radius = std::sqrt(u * u + v * v);
    const float outline = 0.52f + 0.3f * std::cos(5.0f * angle) + 0.06f * std::cos(15.0f * angle);
    const float leaf = (outline - radius) * 12.0f;
    const float stem = v < 0.0f ? (0.04f - std::abs(u)) * 40.0f : -1.0f;
    const float vein = std::abs(u) < 0.03f ? 0.7f : 1.0f;
    return {0.20f * vein, 0.42f * vein, 0.08f * vein, std::clamp(0.5f + std::max(leaf, stem), 0.0f, 1.0f)};
}

/* The same numbers in every run. */
struct Random {
    uint32_t state = 12345;
    double operator()(double low, double high) {
        state = state * 1664525u + 1013904223u;
        return low + (high - low) * double(state >> 8) / 16777216.0;
    }
};

/* Adds a line to a set of lines. */
void addLine(vtkPoints& points, vtkCellArray& lines, int count,
             const std::function<std::array<double, 3>(double)>& at) {
    lines.InsertNextCell(count);
    for (int i = 0; i < count; ++i)
        lines.InsertCellPoint(points.InsertNextPoint(at(double(i) / (count - 1)).data()));
}

vtkSmartPointer<vtkTubeFilter> tubesAlong(vtkPoints* points, vtkCellArray* lines, double radius) {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(lines);
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(data);
    tubes->SetRadius(radius);
    tubes->SetNumberOfSides(6);
    tubes->CappingOn();
    return tubes;
}

} // namespace

Scene::Scene() {
    m_tiles = createTexture(256, [](float x, float y) {
        const bool isDark = (int(x * 8.0f) + int(y * 8.0f)) % 2 == 0;
        return isDark ? Texel{0.10f, 0.09f, 0.08f} : Texel{0.55f, 0.52f, 0.46f};
    });
    m_leaf = createTexture(128, leafTexel);
    m_renderer->SetBackground(0.30, 0.42, 0.62); // linear
    m_renderer->AutomaticLightCreationOff();
    m_renderer->GetActiveCamera()->SetViewAngle(50.0);
    m_renderer->GetActiveCamera()->SetClippingRange(0.1, 100.0);
    createGround();
    createSolids();
    createTubes();
    createGlyphs();
    createLeaves();
    createLights();
}

/* Adds an actor with VTK's PBR shader. The shader's end is changed: it writes linear colours, and leaves are cut out.
 */
vtkActor* Scene::add(vtkAlgorithmOutput* geometry, const Material& material) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(geometry);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->ForceOpaqueOn(); // the textures have alpha
    vtkProperty& property = *actor->GetProperty();
    property.SetInterpolationToPBR();
    property.SetColor(material.color[0], material.color[1], material.color[2]);
    property.SetMetallic(material.metallic);
    property.SetRoughness(material.roughness);
    if (material.texture)
        property.SetTexture("albedoTex", material.texture);
    vtkShaderProperty& shader = *actor->GetShaderProperty();
    shader.AddFragmentShaderReplacement("color = pow(color, vec3(1.0/2.2));", false,
                                        material.isLeaf ? "if (opacity < alphaCutoff) discard;\n  opacity = 1.0;" : "",
                                        true);
    if (material.isLeaf)
        shader.GetFragmentCustomUniforms()->SetUniformf("alphaCutoff", 0.5f);
    m_renderer->AddActor(actor);
    return actor;
}

void Scene::createGround() {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-20.0, 0.0, 20.0);
    plane->SetPoint1(20.0, 0.0, 20.0);
    plane->SetPoint2(-20.0, 0.0, -20.0);
    plane->SetResolution(20, 20);
    plane->Update();
    auto* coordinates = vtkFloatArray::SafeDownCast(plane->GetOutput()->GetPointData()->GetTCoords());
    for (vtkIdType i = 0; i < coordinates->GetNumberOfValues(); ++i)
        coordinates->SetValue(i, 5.0f * coordinates->GetValue(i));
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(plane->GetOutput());
    add(producer->GetOutputPort(), {{1.0, 1.0, 1.0}, 0.0, 0.7, m_tiles});
}

void Scene::createSolids() {
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.6);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(32);
    vtkNew<vtkElevationFilter> elevation; // its scalars are shown as colours of the vertices
    elevation->SetInputConnection(sphere->GetOutputPort());
    elevation->SetLowPoint(0.0, 0.0, -0.6);
    elevation->SetHighPoint(0.0, 0.0, 0.6);
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(32);
    cone->SetHeight(1.2);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(cone->GetOutputPort());
    m_moving.push_back(add(cube->GetOutputPort(), {{0.60, 0.08, 0.05}, 0.0, 0.6}));
    m_moving.push_back(add(sphere->GetOutputPort(), {{0.85, 0.75, 0.60}, 1.0, 0.5}));
    m_moving.push_back(add(cube->GetOutputPort(), {{1.0, 0.9, 0.7}, 0.0, 0.75, m_tiles}));
    m_moving.push_back(add(elevation->GetOutputPort(), {{1.0, 1.0, 1.0}, 0.0, 0.5}));
    m_moving.push_back(add(normals->GetOutputPort(), {{0.06, 0.12, 0.55}, 0.0, 0.5}));
    m_moving.push_back(add(sphere->GetOutputPort(), {{0.10, 0.35, 0.15}, 0.0, 0.55}));
    for (size_t i = 0; i < m_moving.size(); ++i) {
        const double angle = double(i) * 2.0 * 3.14159265358979 / 6.0;
        m_moving[i]->SetPosition(3.0 * std::cos(angle), 0.9, 3.0 * std::sin(angle));
    }
}

/* A fence of straight tubes, and wires. */
void Scene::createTubes() {
    vtkNew<vtkPoints> barPoints, wirePoints;
    vtkNew<vtkCellArray> bars, wires;
    for (int i = 0; i <= 64; ++i)
        addLine(*barPoints, *bars, 2, [i](double t) { return std::array{-6.4 + 0.2 * i, 1.9 * t, -3.6}; });
    for (int i = 0; i < 4; ++i)
        addLine(*barPoints, *bars, 2, [i](double t) { return std::array{-6.4 + 12.8 * t, 0.3 + 0.53 * i, -3.6}; });
    for (int wire = 0; wire < 6; ++wire)
        addLine(*wirePoints, *wires, 25, [wire](double t) {
            const double x = 2.0 * t - 1.0;
            return std::array{9.0 * x, 2.4 + 0.28 * wire + 0.6 * x * x, -5.0 + 1.5 * (wire % 2) * x};
        });
    add(tubesAlong(barPoints, bars, 0.016)->GetOutputPort(), {{0.60, 0.60, 0.60}, 1.0, 0.55});
    add(tubesAlong(wirePoints, wires, 0.008)->GetOutputPort(), {{0.02, 0.02, 0.02}, 0.0, 0.7});
}

/* Wire frames of cubes as glyphs at the points of a helix. */
void Scene::createGlyphs() {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 14; ++i) {
        const double angle = 0.7 * i;
        points->InsertNextPoint(2.0 * std::cos(angle), 0.25 + 0.19 * i, 2.0 * std::sin(angle));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    vtkNew<vtkCubeSource> cube;
    vtkNew<vtkOutlineFilter> outline;
    outline->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputConnection(outline->GetOutputPort());
    tubes->SetRadius(0.03);
    tubes->SetNumberOfSides(5);
    vtkNew<vtkGlyph3D> glyphs;
    glyphs->SetInputData(data);
    glyphs->SetSourceConnection(tubes->GetOutputPort());
    glyphs->SetScaleFactor(0.28);
    m_moving.push_back(add(glyphs->GetOutputPort(), {{0.55, 0.30, 0.05}, 0.0, 0.6}));
}

void Scene::createLeaves() {
    Random random;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkFloatArray> normals, coordinates;
    normals->SetNumberOfComponents(3);
    coordinates->SetNumberOfComponents(2);
    for (vtkIdType leaf = 0; leaf < 260; ++leaf) {
        const double centre[] = {random(-1.3, 1.3), random(0.2, 2.6), random(-1.3, 1.3)};
        const double turn = random(0.0, 6.0), tilt = random(0.0, 3.0), size = random(0.10, 0.22);
        const double across[] = {std::cos(turn), 0.0, std::sin(turn)};
        const double along[] = {-std::sin(turn) * std::cos(tilt), std::sin(tilt), std::cos(turn) * std::cos(tilt)};
        const double normal[] = {across[1] * along[2] - across[2] * along[1],
                                 across[2] * along[0] - across[0] * along[2],
                                 across[0] * along[1] - across[1] * along[0]};
        quads->InsertNextCell(4);
        for (int k = 0; k < 4; ++k) {
            const double u = k == 1 || k == 2 ? 1.0 : 0.0, v = k >= 2 ? 1.0 : 0.0;
            double place[3];
            for (int i = 0; i < 3; ++i)
                place[i] = centre[i] + size * ((2.0 * u - 1.0) * across[i] + (2.0 * v - 1.0) * along[i]);
            quads->InsertCellPoint(points->InsertNextPoint(place));
            normals->InsertNextTuple(normal);
            coordinates->InsertNextTuple2(u, v);
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(quads);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetTCoords(coordinates);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    m_moving.push_back(add(producer->GetOutputPort(), {{1.0, 1.0, 1.0}, 0.0, 0.8, m_leaf, true}));
}

void Scene::createLights() {
    const auto addLight = [this](bool isPositional, std::array<double, 3> position, std::array<double, 3> color,
                                 double intensity) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPositional(isPositional);
        light->SetConeAngle(180.0);
        light->SetPosition(position.data());
        light->SetFocalPoint(0.0, 0.0, 0.0);
        light->SetDiffuseColor(color.data());
        light->SetIntensity(intensity);
        light->SetAttenuationValues(0.0, 0.0, 1.0);
        m_renderer->AddLight(light);
    };
    // Beside positional lights, VTK's PBR shader lets directional lights shine from their position, so it is far away.
    addLight(false, {3000.0, 5000.0, 4000.0}, {1.0, 0.95, 0.85}, 2.6);
    addLight(false, {-2000.0, 4000.0, 5000.0}, {0.45, 0.55, 0.75}, 1.0);
    addLight(true, {-4.0, 2.2, -2.5}, {1.0, 0.55, 0.25}, 14.0);
    addLight(true, {4.0, 1.8, 1.5}, {0.3, 0.6, 1.0}, 12.0);
}

void Scene::setTime(float seconds) {
    for (size_t i = 0; i < m_moving.size(); ++i) {
        const double phase = double(seconds) + double(i);
        m_moving[i]->SetOrientation(0.0, 0.0, 0.0);
        m_moving[i]->RotateWXYZ(40.0 * phase, 0.2, 1.0, 0.1);
        if (i < 6) { // glyphs and leaves only turn
            double* place = m_moving[i]->GetPosition();
            m_moving[i]->SetPosition(place[0], 0.95 + 0.25 * std::sin(1.3 * phase), place[2]);
        }
    }
    const double angle = 0.15 + 0.12 * double(seconds);
    vtkCamera& camera = *m_renderer->GetActiveCamera();
    camera.SetPosition(6.6 * std::sin(angle), 2.1 + 0.1 * std::sin(double(seconds)), 6.6 * std::cos(angle));
    camera.SetFocalPoint(0.0, 1.3, -0.5);
    camera.SetViewUp(0.0, 1.0, 0.0);
}
