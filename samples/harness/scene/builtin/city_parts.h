// Objects of the city scene. Each faces +z and rests on y = 0 unless its comment says otherwise.
#pragma once

#include "scene/builtin/mesh_builder.h"

namespace harness::builtin {

// A frame with glazing bars around [-width/2, width/2] x [0, height], and a sill.
MeshBuilder windowFrame(float width, float height);
// A slab and a railing of thin bars in front of a window.
MeshBuilder balcony(float width);
// A column with 20 flutes, a base and a capital.
MeshBuilder flutedColumn(float radius, float height);
// Thin upright bars between two rails along x, with spikes on request.
MeshBuilder fencePanel(float width, float height, int bars, bool spikes);
// A pole with two cross-arms, insulators and an arm with a lamp holder.
MeshBuilder wirePole();
// A rake antenna on a mast.
MeshBuilder roofAntenna();
// A hanging cable.
void addWire(MeshBuilder& mesh, const glm::vec3& from, const glm::vec3& to, float sag);

struct CafeChair {
    MeshBuilder tubes, slats;
};
CafeChair cafeChair();

struct CafeTable {
    MeshBuilder tubes, top;
};
CafeTable cafeTable();

} // namespace harness::builtin
