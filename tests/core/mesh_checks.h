// SPDX-License-Identifier: MIT
//
// Invariants of every triangle mesh, whatever it was made of.
#pragma once

#include "gvd/triangle_mesh.h"
#include "shapes.h"

namespace gvd::checks {

/// Fails the test unless connectivity, measures and the counts of repairs agree with each other.
void expectInvariants(const TriangleMesh& mesh);

/// Fails the test unless every corner of every input triangle is found where the input has it, and
/// faces lead back.
void expectTrueToInput(const shapes::Shape& shape, const TriangleMesh& mesh);

int repairCount(const MeshRepairs& repairs);

/// The mesh of a shape that needs no repair; fails the test if it got one, or breaks an invariant.
TriangleMesh cleanMesh(const shapes::Shape& shape);

/// The mesh of a shape that needs repairs; fails the test if it got none, or breaks an invariant.
TriangleMesh repairedMesh(const shapes::Shape& shape, const MeshOptions& options = {});

}  // namespace gvd::checks
