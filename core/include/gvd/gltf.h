// SPDX-License-Identifier: MIT
/// \file
/// Reads the triangles of a glTF scene. A library of its own, `gvd_gltf`, because programs that
/// have triangles already do not need it.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gvd/sliced_work.h"

namespace gvd {

/// The triangles of a glTF scene in world space, in the form that `TriangleMesh` takes.
struct GltfScene {
  /// Where a run of triangles came from, in scene order.
  struct Part {
    int node = -1;
    int mesh = -1;
    int primitive = -1;
    int firstTriangle = 0;
    int triangleCount = 0;
    std::string name;  ///< the node's name, else the mesh's, else empty
  };
  std::vector<double> positions;  ///< x, y, z per vertex
  std::vector<int> triangles;     ///< three vertex indices each
  /// Unit normals (x, y, z) and texture coordinates (u, v: TEXCOORD_0) per vertex; zeros where a
  /// primitive has none, empty if none has.
  std::vector<double> normals, uvs;
  /// A density for samplings and tessellations per vertex, from an attribute defined by this
  /// library: _DENSITY, one number of type float. 1 where a primitive has none, empty if none has.
  std::vector<double> density;
  std::vector<Part> parts;
  std::vector<std::string> notes;  ///< a sentence for everything passed over (points, lines, …)
};

/// A file that a glTF names as a buffer: the name as the glTF writes it, percent-encoded or not.
struct GltfResource {
  std::string uri;
  std::span<const std::byte> bytes;
};

/// Limits on the demands of a file, so that a small file cannot take all memory or hours. All are
/// checked before the work is done; the message names the limit.
struct GltfLimits {
  std::size_t maxJsonBytes = std::size_t{1} << 29;
  /// Nodes, meshes, primitives, accessors, buffer views, … together; also the primitives and morph
  /// targets of all nodes together, instances of EXT_mesh_gpu_instancing included.
  std::size_t maxObjects = std::size_t{1} << 18;
  /// Vertices and triangles of all nodes and instances together; each active morph target counts
  /// its vertices again. The surface of more than these would not fit into the 4 GB of a
  /// WebAssembly memory.
  std::size_t maxVertices = std::size_t{1} << 24;
  std::size_t maxTriangles = std::size_t{1} << 24;
  /// Elements of accessors without a buffer view: these are zeros, take no bytes of a file, and so
  /// are not limited by its size. Counted as vertices are; also counts the vertices of instances
  /// whose attributes have no buffer view.
  std::size_t maxZeroElements = std::size_t{1} << 20;
};

/// Reads GLB or glTF JSON (buffers embedded, as data: URIs, or from `resources`; no file is
/// opened).
///
/// Takes every triangle primitive (lists, strips, fans; any index type or none) of the default
/// scene, else of all root nodes, else (there are no nodes) of all meshes: depth first, primitives
/// in order, each node's world transform applied; a mirroring one swaps the second and third corner
/// of the triangles. A node with EXT_mesh_gpu_instancing has its mesh once per instance. Morph
/// targets are applied with their default weights. A mesh with a skin is taken as it is bound,
/// without the transform of its node, as the specification says. Every primitive brings all of its
/// positions, every triangle counts: the faces of the scene are numbered the way an independent
/// reader of the file would number them. Normals and texture coordinates that cannot be read are
/// passed over, and no buffer is missed that no triangle needs.
/// Throws `Error(kInvalidGltf)` with a sentence that names the offending object and its index.
GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources = {},
                   const GltfLimits& limits = {});

/// The same in steps, which throw as it does; all bytes must outlive them. The JSON is parsed in
/// one step, whose length is that of the JSON.
std::unique_ptr<SlicedWork<GltfScene>> startGltf(std::span<const std::byte> bytes,
                                                 std::span<const GltfResource> resources = {},
                                                 const GltfLimits& limits = {});

}  // namespace gvd
