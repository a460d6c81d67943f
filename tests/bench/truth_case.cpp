// SPDX-License-Identifier: MIT
#include "truth_case.h"

#include <fstream>
#include <stdexcept>

namespace gvd::bench {
namespace {

SurfacePoint readPoint(std::istream& in) {
  SurfacePoint p;
  in >> p.face >> p.bary[0] >> p.bary[1] >> p.bary[2];
  return p;
}

double readDistance(std::istream& in) {
  double distance = -1;
  in >> distance;
  return distance < 0 ? kInfinity : distance;
}

}  // namespace

TruthCase readTruthCase(const std::filesystem::path& path) {
  std::ifstream in(path);
  TruthCase result;
  std::string mesh;
  std::getline(in, result.name);
  std::getline(in, mesh);
  result.mesh = mesh;
  int siteCount = 0, pointCount = 0;
  in >> siteCount >> pointCount;
  for (int i = 0; i < siteCount && in; ++i) result.sites.push_back(readPoint(in));
  for (int i = 0; i < pointCount && in; ++i) {
    result.points.push_back(readPoint(in));
    TrueNearest nearest;
    in >> nearest.label;
    nearest.distance = readDistance(in);
    nearest.second = readDistance(in);
    result.nearest.push_back(nearest);
  }
  if (!in) throw std::runtime_error("cannot read " + path.string());
  return result;
}

}  // namespace gvd::bench
