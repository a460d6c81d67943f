// SPDX-License-Identifier: MIT
/// \file
/// Reads the triangles of a glTF scene. A library of its own, `gvd::gltf` in CMake, because
/// programs that have triangles already do not need it.
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
    int node = -1;       ///< index in the glTF, -1 if it has no nodes
    int mesh = -1;       ///< index in the glTF
    int primitive = -1;  ///< index in the mesh
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
  /// One sentence for each kind of content that was ignored or simplified (points, lines, normals
  /// that cannot be read, skins, …), with its count.
  std::vector<std::string> notes;
};

/// A file that a glTF names as a buffer: the name as the glTF writes it, percent-encoded or not.
struct GltfResource {
  std::string uri;
  std::span<const std::byte> bytes;
};

/// Limits on what a file may ask for, so that a small malicious file cannot use up all memory or
/// run for hours. Each limit is checked before the work that it limits; the message names it.
struct GltfLimits {
  std::size_t maxJsonBytes = std::size_t{1} << 29;
  /// Nodes, meshes, primitives, accessors, buffer views, … together; also the primitives and morph
  /// targets of all nodes together, instances of EXT_mesh_gpu_instancing included.
  std::size_t maxObjects = std::size_t{1} << 18;
  /// Vertices and triangles of all nodes and instances together; each active morph target counts
  /// its vertices again. A `TriangleMesh` of more than these would not fit into the 4 GB of a
  /// WebAssembly memory.
  std::size_t maxVertices = std::size_t{1} << 24;
  std::size_t maxTriangles = std::size_t{1} << 24;
  /// Elements of accessors without a buffer view. By the specification these are zeros, so the size
  /// of the file does not limit their number. Counted once per node and instance, as vertices are,
  /// together with the vertices of instances whose attributes have no buffer view.
  std::size_t maxZeroElements = std::size_t{1} << 20;
};

/// Reads GLB or glTF JSON (buffers embedded, as data: URIs, or from `resources`; no file is
/// opened).
///
/// Takes every triangle primitive (lists, strips, fans; any index type or none) of the default
/// scene; if there is none, of all root nodes; if there are no nodes, of all meshes. Nodes are
/// visited depth first, primitives in order. Each node's world transform is applied; one that
/// mirrors swaps the second and third corner of the triangles. A node with EXT_mesh_gpu_instancing
/// has its mesh once per instance. Morph targets are applied with their default weights. A mesh
/// with a skin is taken in its bind pose, without the transform of its node, as the specification
/// says.
///
/// Nothing is merged or dropped: each primitive adds all of its positions, used or not, and all of
/// its triangles, degenerate ones included. So vertex and triangle indices are those that any other
/// reader gets that visits nodes in this order. Normals and texture coordinates that cannot be read
/// are left out, with a note. A buffer that no triangle needs may be missing.
/// Throws `Error(kInvalidGltf)` with a sentence that names the offending object and its index. O(n)
/// for n bytes, vertices and triangles, morph targets counted as `GltfLimits` does.
GltfScene readGltf(std::span<const std::byte> bytes, std::span<const GltfResource> resources = {},
                   const GltfLimits& limits = {});

/// The same in steps, which throw as it does; all bytes must outlive them. The JSON is parsed in
/// one step, whose length is that of the JSON.
std::unique_ptr<SlicedWork<GltfScene>> startGltf(std::span<const std::byte> bytes,
                                                 std::span<const GltfResource> resources = {},
                                                 const GltfLimits& limits = {});

}  // namespace gvd
