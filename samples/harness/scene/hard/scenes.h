// The scenes of hard cases behind builtin.h: each stresses a formula or a limit at which usual implementations fail
// (docs/numerics.md). Most have frontCamera(), so that a unit at z = 0 is a pixel of a frame of 64 by 36.
#pragma once

#include "scene/scene.h"

namespace harness::hard {

// Returns a camera on the z axis that shows 36 units vertically at z = 0.
Camera frontCamera();

Scene makeMirror();      // the plane in many triangles
Scene makeWholeMirror(); // the same plane in two triangles
Scene makeOppositeNormals();
Scene makeNeedles();
Scene makeDuplicates(); // every instance twice
Scene makeSingles();    // the same instances once
Scene makePrimitivePerSample();
Scene makeSpecks();
Scene makeSweep();

Scene makeFarWall();
Scene makeRailings();
Scene makeHair();
Scene makeCutouts();

Scene makeLightOnSurface();
Scene makeLightInSurface();
Scene makeLightInside();
Scene makeLightWithoutRadius();
Scene makeSpots();
Scene makeChecker();

Scene makeDarkRamp();
Scene makeEmission();
Scene makeHdrEdges();
Scene makeStripes();
Scene makeEmpty();

} // namespace harness::hard
