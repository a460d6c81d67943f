// SPDX-License-Identifier: MIT
//
// glTF files, right ones and wrong ones of every kind, with the verdict on each: the one table that
// the native reader and the JavaScript library are held to.
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
  int faces = 0;         ///< of the mesh that it opens as; 0: it is refused
  std::string sentence;  ///< of the error; of a file that opens, its notes, joined by "; "
  /// Where the JavaScript library, which undoes compression and reads other formats too, says
  /// something else: what begins so.
  std::string librarySentence;
  /// Files that it names, by their paths.
  std::vector<std::pair<std::string, ByteVector>> resources;
};

std::vector<GltfCase> gltfCorpus();

/// How the parts of the table are written: as changes of a right file, which has one triangle in
/// one mesh in one node.
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

/// The right file, and its positions.
GlbWriter triangleFile();
extern const std::vector<float> kTriangle;

void addContainerCases(GltfCases& cases);
void addBufferCases(GltfCases& cases);
void addNumberCases(GltfCases& cases);
void addAccessorCases(GltfCases& cases);
void addPrimitiveCases(GltfCases& cases);
void addSceneCases(GltfCases& cases);
void addSurfaceCases(GltfCases& cases);
void addLimitCases(GltfCases& cases);

}  // namespace gvd
