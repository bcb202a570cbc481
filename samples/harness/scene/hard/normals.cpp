// Many normals, planes or primitives in a pixel.
#include "scene/hard/parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace harness::hard {

using builtin::MeshBuilder;

namespace {

// Adds a rectangle of irregular cells in one plane. The border is straight.
void addCells(MeshBuilder& mesh, const glm::vec2& low, const glm::vec2& high, int columns, int rows) {
    Random random(31);
    const uint32_t first = uint32_t(mesh.vertices.size());
    const glm::vec2 cell = (high - low) / glm::vec2(columns, rows);
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const glm::vec2 shift{random.in(-0.35f, 0.35f), random.in(-0.35f, 0.35f)};
            const glm::vec2 free(i > 0 && i<columns, j> 0 && j < rows);
            Vertex vertex;
            vertex.position = glm::vec3(low + cell * (glm::vec2(i, j) + shift * free), 0);
            vertex.normal = {0, 0, 1};
            mesh.vertices.push_back(vertex);
        }
    const uint32_t row = uint32_t(columns) + 1;
    for (uint32_t j = 0; j < uint32_t(rows); ++j)
        for (uint32_t i = 0; i < uint32_t(columns); ++i) {
            const uint32_t a = first + j * row + i, b = a + row;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
        }
}

// cells  of a side of 1 unit; 0: each half is one rectangle
Scene mirror(int cells) {
    Scene scene;
    for (int half = 0; half < 2; ++half) {
        const glm::vec2 low(half ? 0 : -36, -21), high(half ? 36 : 0, 21);
        MeshBuilder mesh;
        addCells(mesh, low, high, cells ? 36 * cells : 1, cells ? 42 * cells : 1);
        placeMesh(scene, mesh,
                  addLinear(scene, half ? "polished" : "mirror", {0.9f, 0.85f, 0.7f}, half ? 0.25f : 0, 1));
    }
    // Each half reflects one sun into the camera, at x = -12 and x = 12.
    addSun(scene, {0.24, -0.06, -1}, glm::vec3(0.02f));
    addSun(scene, {-0.24, 0.05, -1}, {0.1f, 0.08f, 0.06f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

// Returns the rotation that turns the z axis to the direction.
glm::dmat4 turnZ(const glm::dvec3& direction) {
    const glm::dvec3 z = glm::normalize(direction);
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.1, 1, 0.2), z));
    glm::dmat4 m(1);
    m[0] = glm::dvec4(x, 0);
    m[1] = glm::dvec4(glm::cross(z, x), 0);
    m[2] = glm::dvec4(z, 0);
    return m;
}

Scene overlapping(int copies) {
    Scene scene;
    MeshBuilder card, blades;
    addRectangle(card, {-9, -6}, {9, 6}, 0);
    for (int i = 0; i < 12; ++i)
        addRectangle(blades, {-9 + 1.5f * float(i), -9}, {-8.7f + 1.5f * float(i), 9}, 0);
    std::vector<Instance> instances;
    const std::array colors = {glm::vec3(0.7f, 0.2f, 0.1f), glm::vec3(0.1f, 0.5f, 0.2f), glm::vec3(0.2f, 0.25f, 0.7f)};
    for (int i = 0; i < 6; ++i) {
        const uint32_t material = addLinear(scene, "card", colors[size_t(i) % colors.size()], 0.4f);
        const uint32_t mesh = builtin::addMesh(scene, i % 2 ? blades : card, material);
        const glm::dvec3 position(-18 + 7.3 * i, 3 * std::sin(2.0 * i), -2.0 * i);
        const glm::dmat4 turned =
            glm::rotate(glm::translate(glm::dmat4(1), position), 0.5 - 0.2 * i, glm::dvec3(0.3, 1, 0.2));
        instances.push_back({mesh, glm::rotate(turned, 0.3 * i, glm::dvec3(0, 0, 1))});
    }
    for (int copy = 0; copy < copies; ++copy)
        scene.instances.insert(scene.instances.end(), instances.begin(), instances.end());
    addSun(scene, {0.3, -0.4, -1}, {2.5f, 2.4f, 2.2f});
    addLamp(scene, {4, 6, 12}, {60, 80, 120}, 0.1f);
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace

Scene makeMirror() { return mirror(3); }
Scene makeWholeMirror() { return mirror(0); }

Scene makeOppositeNormals() {
    Scene scene;
    MeshBuilder mesh;
    constexpr std::array deltas = {0.0f, 1e-7f, 1e-3f, 0.1f}; // z of the normals, in bands of the image
    for (int band = 0; band < 4; ++band)
        for (int column = 0; column < 256; ++column) {
            const float x = -32 + 0.25f * float(column), y = -18 + 9 * float(band);
            const float side = column % 2 ? 1.0f : -1.0f;
            mesh.color = column % 2 ? glm::u8vec4(200, 50, 40, 255) : glm::u8vec4(40, 60, 210, 255);
            const size_t first = mesh.vertices.size();
            addRectangle(mesh, {x, y}, {x + 0.25f, y + 9}, 0);
            for (size_t i = first; i < mesh.vertices.size(); ++i)
                mesh.vertices[i].normal = glm::normalize(glm::vec3(side, 0, deltas[size_t(band)]));
        }
    placeMesh(scene, mesh, addLinear(scene, "columns", glm::vec3(1), 0.4f));
    addSun(scene, {-1, 0.1, -0.6}, {2, 2, 1.5f});
    addSun(scene, {1, -0.2, -0.5}, {1, 1.5f, 2.5f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeNeedles() {
    Scene scene;
    MeshBuilder sphere;
    sphere.sphere(glm::vec3(0), 1, 24, 32);
    const uint32_t mesh = builtin::addMesh(scene, sphere, addLinear(scene, "needle", {0.9f, 0.7f, 0.5f}, 0.25f, 1));
    const glm::dvec3 eye = frontCamera().eye;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 centre(-28 + 8 * i + 0.3 * j, -13.5 + 9 * j + 0.13 * i, 0);
            const double radius = 0.1 * std::pow(1.13, 8 * j + i); // 0.1 to 4.4 pixels
            builtin::place(scene, mesh,
                           glm::translate(glm::dmat4(1), centre) * turnZ(eye - centre) *
                               glm::scale(glm::dmat4(1), glm::dvec3(radius, radius, 20)));
        }
    addBackdrop(scene, -30, {0.3f, 0.32f, 0.35f});
    addSun(scene, {0.4, -0.5, -1}, {2.5f, 2.4f, 2.2f});
    addSun(scene, {-0.8, 0.1, -0.6}, {0.5f, 0.8f, 1.2f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeDuplicates() { return overlapping(2); }
Scene makeSingles() { return overlapping(1); }

Scene makePrimitivePerSample() {
    Scene scene;
    MeshBuilder mesh;
    Random random(6);
    constexpr float cell = 1.0f / 6;
    for (int j = -48; j < 48; ++j)
        for (int i = -72; i < 72; ++i) {
            const size_t first = mesh.vertices.size();
            mesh.color = glm::u8vec4(random.below(256), random.below(256), random.below(256), 255);
            const glm::vec3 tilt = builtin::unitVector(random);
            addRectangle(mesh, glm::vec2(i, j) * cell, glm::vec2(i + 1, j + 1) * cell, 0);
            for (size_t k = first; k < mesh.vertices.size(); ++k)
                mesh.vertices[k].normal = glm::normalize(glm::vec3(0, 0, 1.2f) + tilt);
        }
    placeMesh(scene, mesh, addLinear(scene, "cells", glm::vec3(1), 0.35f));
    addSun(scene, {0.3, -0.4, -1}, {2.5f, 2.4f, 2.2f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeSpecks() {
    Scene scene;
    MeshBuilder mesh;
    Random random(12);
    for (int j = -18; j < 18; ++j)
        for (int i = -32; i < 32; ++i) {
            const glm::vec2 low = glm::vec2(i, j) + glm::vec2{random.in(0.05f, 0.75f), random.in(0.05f, 0.75f)};
            addRectangle(mesh, low, low + 0.17f, 0);
        }
    placeMesh(scene, mesh, addEmitter(scene, "speck", glm::vec3(1)));
    addSun(scene, {0, 0, -1}, glm::vec3(0));
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeSweep() {
    Scene scene;
    constexpr std::array roughness = {0.15f, 0.35f, 0.6f, 1.0f};
    for (int band = 0; band < 4; ++band) {
        MeshBuilder mesh;
        const float bottom = -18 + 9 * float(band);
        for (int column = 0; column < 16; ++column) {
            const float left = -32 + 4 * float(column);
            // The upper part of a band is a ridge of 0 to 75 degrees, the lower part a step of 0.001 to 10 pixels.
            const float slope = std::tan(glm::radians(2.5f * float(column)));
            const glm::vec3 ridge(left + 2.3f, bottom + 4.5f, 1.7f * slope), up(0, 4.5f, 0);
            const glm::vec3 start(left, bottom + 4.5f, 0), end(left + 4, bottom + 4.5f, 0);
            mesh.quad(start, ridge - start, up);
            mesh.quad(ridge, end - ridge, up);
            const float step = 0.001f * std::pow(10.0f, float(column) / 3.75f);
            addRectangle(mesh, {left, bottom}, {left + 2.3f, bottom + 4.5f}, 0);
            addRectangle(mesh, {left - 0.5f, bottom}, {left + 4.5f, bottom + 4.5f}, -step);
        }
        placeMesh(scene, mesh, addLinear(scene, "band", {0.6f, 0.55f, 0.5f}, roughness[size_t(band)]));
    }
    addBackdrop(scene, -12, {0.6f, 0.55f, 0.5f});
    addSun(scene, {0.5, -0.2, -1}, {2.2f, 2.2f, 2});
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace harness::hard
