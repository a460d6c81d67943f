// SPDX-License-Identifier: MIT
//
// Valid and invalid glTF files of every kind, with the expected result of each: one table for both
// the native reader and the JavaScript library.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "glb_writer.h"

namespace gvd {

struct GltfCase {
  std::string name;
  ByteVector bytes;
  int faces = 0;         ///< of the mesh read; 0: the file is refused
  std::string sentence;  ///< the error, or the notes of a file that opens, joined by "; "
  /// How the library's sentence begins, if it differs: the JavaScript library undoes compression
  /// and reads other formats, too.
  std::string librarySentence;
  /// The files that the glTF refers to, by their paths.
  std::vector<std::pair<std::string, ByteVector>> resources;
};

std::vector<GltfCase> gltfCorpus();

/// Builds a part of the table, from changes of a valid file with one triangle in one mesh in one
/// node.
class GltfCases {
 public:
  using Change = std::function<void(GlbWriter&)>;

  GltfCase& opens(const std::string& name, int faces, const Change& change);
  GltfCase& opens(const std::string& name, int faces, ByteVector bytes);
  GltfCase& refused(const std::string& name, const std::string& sentence, const Change& change);
  GltfCase& refused(const std::string& name, const std::string& sentence, ByteVector bytes);

  std::vector<GltfCase> take() { return std::move(cases_); }

 private:
  std::vector<GltfCase> cases_;
};

/// The valid file, and its positions.
GlbWriter triangleFile();
extern const std::vector<float> kTriangle;
/// Corners of a zigzag strip: 0 2 4 above, 1 3 5 below.
extern const std::vector<float> kZigzag;

/// Every way of writing a buffer as a data URI, by name.
std::vector<std::pair<std::string, std::string>> dataUris(const ByteVector& buffer);

/// Changes of the valid file: the primitives of its mesh, the members of its node or its accessor.
GltfCases::Change primitives(const std::string& list);
GltfCases::Change node(const std::string& members);
GltfCases::Change accessor(const std::string& members);

/// A JSON array of `count` + 1 equal elements.
std::string repeated(const std::string& text, int count);

void addContainerCases(GltfCases& cases);
void addBufferCases(GltfCases& cases);
void addNumberCases(GltfCases& cases);
void addAccessorCases(GltfCases& cases);
void addPrimitiveCases(GltfCases& cases);
void addSceneCases(GltfCases& cases);
void addSurfaceCases(GltfCases& cases);
void addLimitCases(GltfCases& cases);

}  // namespace gvd
