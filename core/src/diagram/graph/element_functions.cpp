// SPDX-License-Identifier: MIT
#include "diagram/graph/element_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace gvd {
namespace {

[[noreturn]] void rejectDistances() {
  throw std::logic_error("the nearest label at a corner of a face is not known at all its corners");
}

}  // namespace

ElementFunctions::ElementFunctions(const FaceComplex& complex)
    : complex_(complex), unit_(std::ldexp(1.0, -std::ilogb(complex.mesh().boundingDiagonal()))) {}

std::span<const LabelFunction> ElementFunctions::of(int element) {
  const int* const node = complex_.nodesOf(element);
  const int soleOwner = complex_.soleOwner(element);
  const auto atA = complex_.nodes().labels(node[0]), atB = complex_.nodes().labels(node[1]),
             atC = complex_.nodes().labels(node[2]);
  // The labels known at all three nodes, without branches for a processor to guess wrong: each
  // round writes a function, and the next one writes over it if it was not of all three nodes.
  const size_t most = std::min({atA.size(), atB.size(), atC.size()}) + 1;
  if (functions_.size() < most) functions_.resize(most);
  LabelFunction* next = functions_.data();
  for (auto a = atA.begin(), b = atB.begin(), c = atC.begin();
       a != atA.end() && b != atB.end() && c != atC.end();) {
    const int ofA = a->label, ofB = b->label, ofC = c->label, label = std::max({ofA, ofB, ofC});
    const bool isCommon = (ofA == label) & (ofB == label) & (ofC == label);
    next->label = label;
    const double inA = unit_ * a->distance, inB = unit_ * b->distance, inC = unit_ * c->distance;
    next->value[0] = inA * inA;
    next->value[1] = inB * inB;
    next->value[2] = inC * inC;
    next += isCommon & ((soleOwner < 0) | (label == soleOwner));
    a += isCommon | (ofA < label);
    b += isCommon | (ofB < label);
    c += isCommon | (ofC < label);
  }
  const std::span<LabelFunction> common(functions_.data(), next);
  if (common.empty()) rejectDistances();
  return common.size() > 3 ? withoutDominated(common, node) : common;
}

/// Moves the functions that are kept to the front, and returns these.
std::span<LabelFunction> ElementFunctions::withoutDominated(std::span<LabelFunction> functions,
                                                            const int* nodes) const {
  std::array<LabelFunction, 3> owners;
  for (int i = 0; i < 3; ++i) {
    const auto owner = std::find_if(
        functions.begin(), functions.end(),
        [&](const LabelFunction& f) { return f.label == complex_.nodes().owner(nodes[i]); });
    if (owner == functions.end()) rejectDistances();
    owners[i] = *owner;
  }
  LabelFunction* kept = functions.data();
  for (const LabelFunction& f : functions) {
    bool isDominated = false;  // by one owner at all nodes; without branches as above
    for (const LabelFunction& owner : owners) {
      const int isLower = owner.label < f.label;
      bool isBehind = owner.label != f.label;
      for (int i = 0; i < 3; ++i)
        isBehind &= (owner.value[i] < f.value[i]) | ((owner.value[i] == f.value[i]) & isLower);
      isDominated |= isBehind;
    }
    *kept = f;
    kept += !isDominated;
  }
  return {functions.data(), kept};
}

}  // namespace gvd
