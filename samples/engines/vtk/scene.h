/* A small animated scene of VTK's sources and filters: a textured ground, solids, tubes, wire glyphs and leaves.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <vector>

class vtkAlgorithmOutput;

class Scene {
public:
    Scene();
    void setTime(float seconds); // moves the objects and the camera

    vtkRenderer& renderer() { return *m_renderer; }
    static constexpr uint32_t lightCount = 4;

private:
    struct Material {
        double color[3];
        double metallic, roughness;
        vtkTexture* texture = nullptr;
        bool isLeaf = false;
    };
    vtkActor* add(vtkAlgorithmOutput* geometry, const Material& material);
    void createGround();
    void createSolids();
    void createTubes();
    void createGlyphs();
    void createLeaves();
    void createLights();

    vtkNew<vtkRenderer> m_renderer;
    vtkSmartPointer<vtkTexture> m_tiles, m_leaf;
    std::vector<vtkActor*> m_moving; // the renderer owns them
};
