// SPDX-License-Identifier: MIT
#include "gvd/dynamic_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <vector>

#include "base/tolerances.h"
#include "diagram_checks.h"
#include "equality.h"
#include "gvd/error.h"
#include "gvd/sampling.h"
#include "mechanical_shapes.h"
#include "mesh/given_points.h"
#include "mesh/incidence.h"
#include "shapes.h"

namespace gvd {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/// The present sites, and the label of each.
struct Present {
  std::vector<SurfacePoint> sites;
  std::vector<int> labels;
};

Present presentOf(const DynamicDiagram& dynamic) {
  Present present;
  for (int label = 0; label < dynamic.labelCount(); ++label) {
    if (!dynamic.hasSite(label)) continue;
    present.sites.push_back(dynamic.site(label));
    present.labels.push_back(label);
  }
  return present;
}

/// The corners of all outlines and Voronoi points of a diagram, by label, sorted.
std::vector<std::array<double, 4>> corners(const TriangleMesh& mesh, const Diagram& d,
                                           std::span<const int> labelOf) {
  std::vector<std::array<double, 4>> list;
  const auto add = [&](int label, int point) {
    const Eigen::Vector3d p = mesh.position(d.points[point]);
    list.push_back({static_cast<double>(label), p.x(), p.y(), p.z()});
  };
  for (int i = 0; i < d.loops.size(); ++i)
    for (const int p : d.loops[i]) add(labelOf[d.loopLabel[i]], p);
  for (const Diagram::VoronoiPoint& v : d.voronoiPoints)
    for (const int label : v.labels) add(labelOf[label], v.point);
  return list;
}

/// Whether two lists hold the same corners to a tolerance, in any order.
AssertionResult areSameCorners(std::vector<std::array<double, 4>> a,
                               std::vector<std::array<double, 4>> b, double tolerance) {
  if (a.size() != b.size()) return AssertionFailure() << a.size() << " corners and " << b.size();
  // Along a line that no two corners of a mesh should share.
  const auto key = [](const std::array<double, 4>& c) {
    return c[0] * 1e3 + 0.7236 * c[1] + 0.5393 * c[2] + 0.4309 * c[3];
  };
  const auto isBefore = [&](const auto& x, const auto& y) { return key(x) < key(y); };
  std::sort(a.begin(), a.end(), isBefore);
  std::sort(b.begin(), b.end(), isBefore);
  for (size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(key(a[i]) - key(b[i])) <= tolerance * std::max(1.0, std::abs(key(a[i])))))
      return AssertionFailure() << "a corner of " << a[i][0] << " at " << a[i][1] << ' ' << a[i][2]
                                << ' ' << a[i][3] << ", or " << b[i][0] << " at " << b[i][1] << ' '
                                << b[i][2] << ' ' << b[i][3];
  return AssertionSuccess();
}

std::string written(std::span<const LabelledDistance> known, std::span<const int> labelOf) {
  std::ostringstream text;
  text.precision(17);
  for (const LabelledDistance& d : known) text << ' ' << labelOf[d.label] << ": " << d.distance;
  return text.str();
}

/// Whether a diagram that has followed its sites is the one of the sites it has now.
AssertionResult isUpToDate(const TriangleMesh& mesh, const DynamicDiagram& dynamic, Metric metric,
                           int detail = 0) {
  const auto [sites, labels] = presentOf(dynamic);
  const Diagram followed = dynamic.diagram();
  if (sites.empty()) {
    const bool isEmpty = followed.loops.size() == 0 && followed.cells.size() == 0 &&
                         std::ranges::all_of(followed.faceLabel, [](int l) { return l == -1; });
    return isEmpty ? AssertionSuccess() : AssertionFailure() << "something is left";
  }
  const checks::Traced anew = checks::trace(mesh, sites, metric, detail);
  if (const auto same = checks::areSame(mesh, anew.diagram, followed, labels, 1e-12); !same)
    return same;
  if (anew.diagram.indifferentFaces != followed.indifferentFaces)
    return AssertionFailure() << "other indifferent faces";
  const std::vector<int> own = checks::identity(dynamic.labelCount());
  if (const auto same =
          areSameCorners(corners(mesh, anew.diagram, labels), corners(mesh, followed, own), 1e-11);
      !same)
    return same;
  if (anew.diagram.points.size() != followed.points.size())
    return AssertionFailure() << anew.diagram.points.size() << " points and "
                              << followed.points.size();
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const auto expected = anew.field->at(v), known = dynamic.distances().at(v);
    const bool same =
        std::equal(expected.begin(), expected.end(), known.begin(), known.end(),
                   [&labels = labels](auto& a, auto& b) {
                     return labels[a.label] == b.label &&
                            std::abs(a.distance - b.distance) <= 1e-12 * std::abs(a.distance);
                   });
    if (!same)
      return AssertionFailure() << "at vertex " << v << " known are" << written(known, own)
                                << " and not" << written(expected, labels);
  }
  return checks::isConsistent(mesh, followed, detail);
}

/// Sites that come, go and move by a random sequence.
class RandomEdits {
 public:
  RandomEdits(const TriangleMesh& mesh, std::uint64_t seed) : mesh_(mesh), random_(seed) {}

  SurfacePoint point() {
    const int face = random_.below(mesh_.faceCount());
    switch (random_.below(6)) {
      case 0:
        return {face, Eigen::Vector3d::Unit(random_.below(3))};
      case 1: {
        const double t = random_.uniform();
        return {face, {t, 1 - t, 0}};
      }
      default: {
        const double a = std::sqrt(random_.uniform()), b = random_.uniform();
        return {face, {1 - a, a * (1 - b), a * b}};
      }
    }
  }

  std::vector<SurfacePoint> points(int count) {
    std::vector<SurfacePoint> list;
    for (int i = 0; i < count; ++i) list.push_back(point());
    return list;
  }

  /// About as many sites come, one to three at once, as go.
  void edit(DynamicDiagram& dynamic, int usual) {
    const Present present = presentOf(dynamic);
    const int count = static_cast<int>(present.labels.size());
    const int kind = random_.below(4);
    if (count == 0 || (kind == 0 && count < 2 * usual))
      finished(dynamic.startInsert(points(1 + random_.below(3))));
    else if (kind == 1)
      dynamic.removeSite(present.labels[random_.below(count)]);
    else
      dynamic.moveSite(present.labels[random_.below(count)], point());
  }

 private:
  const TriangleMesh& mesh_;
  shapes::Random random_;
};

struct EditCase {
  const char* name;
  shapes::Shape shape;
  int sites, edits, detail;
};

void PrintTo(const EditCase& c, std::ostream* out) { *out << c.name; }

/// Each runs the same code on other numbers, six times slower where a sanitizer watches it.
#ifdef GVD_SANITIZED
constexpr int kSequences = 1, kMostEdits = 10;
#else
constexpr int kSequences = 4, kMostEdits = 60;
#endif

class EditSequences : public ::testing::TestWithParam<EditCase> {
 protected:
  void endInTheDiagramOfTheSites(Metric metric) {
    const auto& [name, shape, count, edits, detail] = GetParam();
    const TriangleMesh mesh = shape.mesh();
    for (int seed = 1; seed <= kSequences; ++seed) {
      RandomEdits random(mesh, seed);
      DynamicDiagram dynamic(mesh, random.points(count), metric, {.detail = detail});
      for (int i = 0; i < std::min(edits, kMostEdits); ++i) {
        random.edit(dynamic, count);
        ASSERT_TRUE(isUpToDate(mesh, dynamic, metric, detail)) << "seed " << seed << ", edit " << i;
      }
    }
  }
};

TEST_P(EditSequences, EndInTheExactDiagramOfTheSites) { endInTheDiagramOfTheSites(Metric::kExact); }

TEST_P(EditSequences, EndInTheApproximateDiagramOfTheSites) {
  endInTheDiagramOfTheSites(Metric::kDgpc);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, EditSequences,
    ::testing::Values(
        EditCase{"grid", shapes::grid(12, 9, 0.4, 1), 8, 40, 0},
        EditCase{"gridCrowded", shapes::grid(6, 5, 0.4, 1), 60, 60, 0},
        EditCase{"gridFew", shapes::grid(12, 9, 0.4, 1), 1, 40, 0},
        EditCase{"bumpySphere", shapes::bumpySurface(0, 6, 0.3, 2), 12, 40, 0},
        EditCase{"bumpyTorus", shapes::bumpySurface(1, 6, 0.3, 3), 12, 40, 0},
        EditCase{"bumpyGenus3Crowded", shapes::bumpySurface(3, 4, 0.5, 4), 200, 60, 0},
        EditCase{"annulus", shapes::annulus(12, 4), 6, 40, 0},
        // Most labels own no vertex of it, only parts of edges.
        EditCase{"tubeOfLongFaces", shapes::cylinder(80, 1, 1, 1), 30, 40, 0},
        EditCase{"plate", shapes::perforatedPlate(2, 2), 9, 40, 0},
        EditCase{"skinny", shapes::randomTriangulation(80, 400, 7), 10, 40, 0},
        EditCase{"graded", shapes::gradedDisk(6, 9, 2.0), 8, 40, 0},
        EditCase{"components",
                 shapes::joined(shapes::icosphere(1),
                                shapes::moved(shapes::grid(4, 4, 0.3, 5), {5, 0, 0})),
                 5, 40, 0},
        // On each side of a plane of symmetry, as much is known, and in any order.
        EditCase{"icosphere", shapes::icosphere(3), 12, 40, 0},
        // Where paths of two labels bend at one vertex, they tie ever after.
        EditCase{"needles", shapes::torus(60, 6), 8, 40, 0},
        EditCase{"moebius", shapes::moebiusStrip(14, 3), 7, 40, 0},
        EditCase{"bumpyTorusDetail", shapes::bumpySurface(1, 5, 0.3, 3), 9, 25, 2},
        EditCase{"gridDetail", shapes::grid(8, 6, 0.4, 1), 6, 25, 1},
        // Its long faces have sides where labels are added, which may own something
        // beyond the faces that an edit has changed.
        EditCase{"partDetail", shapes::mechanicalShape("plate with nine round holes"), 40, 25, 1}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(DynamicDiagram, FollowsTiesFarBehindASaddle) {
  // All around the middle, and at the same distance: what ties behind it, and where, changes with
  // every site.
  const auto mesh =
      shapes::subdivided(shapes::subdivided(shapes::vertexFan(12, 4 * std::numbers::pi))).mesh();
  const auto middleOf = [](int face) { return shapes::centroid(16 * face + 15); };
  DynamicDiagram dynamic(mesh, std::vector{middleOf(0), middleOf(1)});
  const auto expectTies = [&](int least, int most) {
    const int count = static_cast<int>(dynamic.diagram().indifferentFaces.size());
    EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
    EXPECT_TRUE(least <= count && count <= most) << count;
  };
  expectTies(64, 96);
  dynamic.insertSite(middleOf(2));
  expectTies(48, 80);
  dynamic.moveSite(0, middleOf(6));
  expectTies(8, 32);
  dynamic.removeSite(0);
  expectTies(64, 96);
  dynamic.moveSite(1, shapes::centroid(7));
  expectTies(0, 0);
  dynamic.moveSite(1, middleOf(3));
  expectTies(64, 96);
}

/// Two pairs of sites 1e-13 apart: in their face the region of site 3 is a sliver, two corners of
/// which rounding puts in one place, though no segment joins them.
TEST(DynamicDiagram, TellsPointsInOnePlaceApart) {
  const shapes::Shape shape{
      {0.6, 0, 4.8985871965894131e-17, -0.49999999999999972, 0.8660254037844386, -0.4,
       0.99999999999999989, 0, -0.4, -0.69999999999999962, 1.2124355652982142, 0},
      {0, 1, 2, 2, 1, 3}};
  const auto mesh = shape.mesh();
  const std::vector<SurfacePoint> sites = {
      {1, {0.11291687275999007, 0.79157418935549884, 0.095508937884511091}},
      {1, {0.11291687275992461, 0.79157418935556434, 0.095508937884511091}},
      {0, {0.46231701912957457, 0.33547486435464635, 0.20220811651577908}},
      {1, {0.10271863432590278, 0.75410095133907584, 0.14318041433502138}},
      {1, {0.10271863432580941, 0.75410095133916921, 0.14318041433502138}}};
  std::vector<SurfacePoint> own;
  for (const SurfacePoint& site : sites) own.push_back(mesh.fromInput(site));
  EXPECT_TRUE(checks::isConsistent(mesh, DynamicDiagram(mesh, own).diagram()));
}

/// Faces with a side of 1e-11: the way from a corner, measured across them, came out shorter than
/// the edge, by more than rounding. The bound that it made kept all labels from the vertex.
TEST(DynamicDiagram, FollowsSitesAtTheCornersOfNeedles) {
  const shapes::Shape shape{
      {-4.4408920985006262e-16, 0.1, 0, 0.89999999999999947, 0.69999999999999951, 0.9,
       0.89999999999999991, 0.7, 0.9, 0.29999999999999954, 0.69999999999999951, 0, 0.6, 0.1, 0.9,
       0.30000000000000021, 0.70000000000000018, 0},
      {0, 1, 2, 1, 0, 3, 1, 3, 2, 2, 4, 1, 2, 3, 5, 2, 5, 4}};
  const TriangleMesh mesh = shape.mesh();
  ASSERT_GT(mesh.repairs().mollifiedTriangles, 0);
  const SurfacePoint atOther = {0, {0, 0, 1}}, atNeedle = {5, {1, 0, 0}};
  for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
    const std::vector<SurfacePoint> sites = {
        {0, {0.9156646728515625, 0.015625, 0.0687103271484375}},
        atNeedle,
        atOther,
        {3, {0.484039306640625, 0.3421630859375, 0.173797607421875}},
        {1, {0.7776336669921875, 0.056304931640625, 0.1660614013671875}},
        {1, {0.5220184326171875, 0.01617431640625, 0.4618072509765625}}};
    DynamicDiagram dynamic(mesh, sites, metric);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
    dynamic.moveSite(1, atOther);
    dynamic.moveSite(1, atNeedle);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
    dynamic.insertSite(atNeedle);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
  }
}

/// All sites but the first tie at a vertex 1e11 edges away. While the first site is there, most of
/// them are no neighbours of it.
TEST(DynamicDiagram, LetsTiesFarAwayGoOnAfterARemoval) {
  // Against the last vertex, all others are at one place: their edges get one length.
  const shapes::Shape shape{
      {0, 0, 0, 1, 0, 0, 2, 1, 0, 3, 1, 0, 4, 2, 0, 5, 2, 0, 0, 0, 1e30, 6, 3, 0},
      {0, 1, 4, 0, 4, 3, 2, 3, 6, 2, 6, 5, 3, 4, 7, 3, 7, 6}};
  const TriangleMesh mesh = shape.mesh();
  DynamicDiagram dynamic(
      mesh, std::vector<SurfacePoint>{{3, {1, 0, 0}},
                                      {0, {0.4226837158203125, 0.1953125, 0.3820037841796875}},
                                      {0, {0, 0.015625, 0.984375}},
                                      {0, {0.0030059814453125, 0.01171875, 0.9852752685546875}},
                                      {0, {6.103515625e-05, 0, 0.99993896484375}}});
  dynamic.removeSite(0);
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// The boundary turns by 1e-12 at vertex 1, so the shortest path along it is straight. Rounding
/// turns the lines from vertex 6 by more, past the face behind: only a virtual source leads on.
TEST(DynamicDiagram, KnowsPathsAlongABoundaryThatIsStraightWithinRounding) {
  const TriangleMesh mesh = shapes::Shape{
      {1e30, 0,    0,      0,       0.1, 0, 0.1135, 0.227,    -0.3405, 0.00728, 0.01456,
       1e30, 1e30, 0.0388, -0.0582, 0,   0, 0,      -4.4e-16, 0.1,     0},
      {0, 1, 4, 0, 4, 3, 2, 3, 6, 2, 6, 5, 3, 4, 1, 3, 1,
       6}}.mesh();
  DynamicDiagram dynamic(mesh, std::vector<SurfacePoint>{{2, {0.0234375, 0, 0.9765625}}});
  for (const SurfacePoint& site : {SurfacePoint{0, {0, 1, 0}}, SurfacePoint{0, {1, 0, 0}}}) {
    dynamic.insertSite(site);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
  }
}

/// Paths to vertices 4 and 8 from either side of the cone at vertex 7 are equally long within
/// rounding. Only one of them is kept, and only behind the other one lies the strip to vertex 2.
TEST(DynamicDiagram, KnowsPathsBehindSaddlesWhicheverOfTwoPathsToThemIsKept) {
  const TriangleMesh mesh =
      shapes::Shape{
          {1,     1,     1,     0.142, 0.285, -0.427, 1e30,  0.0117, 0.004,  0.143, 0.286, -0.429,
           0,     0.016, 0.012, 1e30,  0.004, 1,      0.142, 0.285,  -0.427, 0.004, 1,     1e30,
           0.008, 0,     0.074, 0.001, 0.748, 0.703,  0.793, 0.808,  0.249,  0.114, 0.227, -0.341},
          {0, 1, 4, 0, 4, 3, 1, 2, 5,  1, 5,  4, 3, 4, 7,  3, 7,  6,
           4, 5, 8, 4, 8, 7, 6, 7, 10, 6, 10, 9, 7, 8, 11, 7, 11, 10}}
          .mesh();
  const std::vector<SurfacePoint> sites = {
      {11, {0.2039337158203125, 0.2039337158203125, 0.592132568359375}},
      {9, {0.3839874267578125, 0.602783203125, 0.0132293701171875}},
      {3, {0.0038909912109375, 0.59765625, 0.3984527587890625}},
      {3, {0.0077972412109375, 0.4994964599609375, 0.492706298828125}},
      {11, {1.52587890625e-05, 0.2508087158203125, 0.749176025390625}}};
  DynamicDiagram dynamic(mesh, sites);
  dynamic.moveSite(3, {2, {0.427459716796875, 0.427459716796875, 0.14508056640625}});
  dynamic.moveSite(1, {2, {0.427459716796875, 0.4265899658203125, 0.1459503173828125}});
  dynamic.moveSite(3, {11, {0.1889495849609375, 0.3748931884765625, 0.4361572265625}});
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// Through faces 1e11 times as long as wide, straight paths along the strip come out longer than
/// the path along its edges, by more than rounding of the path's length alone.
TEST(DynamicDiagram, KnowsTiesOfPathsThroughLongFaces) {
  const TriangleMesh mesh = shapes::Shape{{0,    0, 0, 1,    0, 0, 2, 1, 0, 3, 1, 0, 4, 2, 0, 0, 0,
                                           1e30, 0, 1, 1e30, 5, 3, 0, 6, 3, 0, 7, 4, 0, 8, 4, 0},
                                          {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4, 4, 5,
                                           7, 4, 7, 6, 6, 7, 9, 6, 9, 8, 8, 9, 10}}
                                .mesh();
  DynamicDiagram dynamic(mesh, std::vector<SurfacePoint>{{0, {0, 0, 1}}});
  dynamic.insertSite({0, {1, 0, 0}});
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// Sites that are equally far from a point, but much nearer to it than to the corners of the face:
/// rounding there is a share of the face, not of the distance.
TEST(DynamicDiagram, GivesTheLowestOfNearTiesWhateverTheOrderOfTheSites) {
  const TriangleMesh mesh = shapes::triangle().mesh();
  shapes::Random random(7);
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector3d middle(0.3 + 0.1 * random.uniform(), 0.3 + 0.1 * random.uniform(), 0);
    const Eigen::Vector3d step(1e-6 * random.uniform(), 1e-6 * random.uniform(), 0);
    const auto at = [](Eigen::Vector3d p) {
      p.z() = 1 - p.x() - p.y();
      return SurfacePoint{0, p};
    };
    const std::vector<SurfacePoint> sites = {at(middle + step), at(middle - step)};
    const auto fresh = finished(propagate(mesh, sites, Metric::kExact));
    DynamicDiagram dynamic(mesh, sites);
    dynamic.moveSite(0, at({0.1, 0.1, 0}));
    dynamic.moveSite(0, sites[0]);
    EXPECT_EQ(dynamic.distances().nearest(at(middle)).label, fresh->nearest(at(middle)).label);
    EXPECT_EQ(fresh->nearest(at(middle)).label, 0);
  }
}

/// At vertex 1, site 2 ties with site 0 and with site 1, but these two do not tie with each other.
/// Which distance the label of site 1 is listed with must not depend on which label came last.
TEST(DynamicDiagram, TellsChainsOfTiesApartInAnyOrder) {
  const TriangleMesh mesh = shapes::Shape{
      {0.000135, 0.00027, -0.000405, 0.000545, 0.00109, 1e30, 0.00223, 0.00446, -0.0067, 1.53e-05,
       3.05e-05, -4.58e-05, 0, 0, 0, 0.00168, 0.00336, -0.00504},
      {1, 0, 3, 1, 3, 2, 0, 4, 3, 2, 3, 5, 2, 5, 4, 3, 4,
       5}}.mesh();
  DynamicDiagram dynamic(mesh, std::vector<SurfacePoint>{
                                   {2, {0.5000152587890625, 0.1289215087890625, 0.371063232421875}},
                                   {2, {0.0008544921875, 0.2156982421875, 0.783447265625}},
                                   {3, {0.2249908447265625, 0.5981292724609375, 0.1768798828125}},
                                   {4, {0.2236175537109375, 0.5993804931640625, 0.177001953125}},
                                   {1, {0.001953125, 0.0008392333984375, 0.9972076416015625}},
                                   {2, {0.0117645263671875, 0, 0.9882354736328125}}});
  dynamic.insertSite({0, {0.9962158203125, 0, 0.0037841796875}});
  dynamic.moveSite(3, {2, {1, 0, 0}});
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// A regular grid but for 1e-14, about which shares of edges round: whether a label owns part of an
/// edge must not depend on which labels were found first to tie with others at its ends.
TEST(DynamicDiagram, KnowsTheSameLabelsOnANearlyRegularGrid) {
  for (const std::uint64_t seed : {2445, 3391, 3504}) {
    shapes::Random offset(seed), random(seed);
    shapes::Shape shape = shapes::grid(4, 4);
    const auto any = [&] { return 1e-14 * offset.uniform(-1, 1); };
    for (int v = 0; v < shape.vertexCount(); ++v)
      shape.setPosition(v, shape.position(v) + Eigen::Vector3d{any(), any(), any()});
    const TriangleMesh mesh = shape.mesh();
    const auto vertexOrMidpoint = [&] {
      SurfacePoint p{random.below(mesh.faceCount()), Eigen::Vector3d::Zero()};
      for (int i = 0; i < 2; ++i) p.bary[random.below(3)] += 0.5;
      return p;
    };
    std::vector<SurfacePoint> sites;
    for (int i = 0; i < 9; ++i) sites.push_back(vertexOrMidpoint());
    DynamicDiagram dynamic(mesh, sites);
    for (int i = 0; i < 3; ++i) {
      const int label = random.below(9);
      dynamic.moveSite(label, vertexOrMidpoint());
      EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact)) << "seed " << seed << ", move " << i;
    }
  }
}

/// At the last vertex, site 1 ties with no other, but the first path found to it from site 2 is
/// longer and ties with that of site 1.
TEST(DynamicDiagram, GivesVerticesByFinalDistances) {
  const shapes::Shape shape{{0, 0, 0, -0.9, 0.3, 0, -0.4, 0.1, 0, -1.7, 1.7, 0, 5e10, 0, 0},
                            {0, 4, 1, 1, 4, 2, 1, 2, 3}};
  const TriangleMesh mesh = shape.mesh();
  DynamicDiagram dynamic(mesh, std::vector<SurfacePoint>{{0, {1, 0, 0}},
                                                         {2, {0.005, 0.002, 0.993}},
                                                         {2, {0.008, 0.009, 0.983}},
                                                         {2, {0.007, 0, 0.993}}});
  dynamic.removeSite(0);
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

TEST(DynamicDiagram, TakesOverDistances) {
  const auto mesh = shapes::bumpySurface(1, 5, 0.3, 3).mesh();
  for (const Metric metric : {Metric::kExact, Metric::kDgpc}) {
    const auto sites = sampleUniform(mesh, 20, 3);
    auto dynamic = DynamicDiagram::fromDistances(mesh, finished(propagate(mesh, sites, metric)));
    EXPECT_EQ(dynamic.labelCount(), 20);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
    dynamic.removeSite(7);
    dynamic.moveSite(3, sites[7]);
    EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
  }
}

TEST(DynamicDiagram, RefusesForeignDistances) {
  using Foreign = checks::NoDistances;
  const auto mesh = shapes::bumpySurface(1, 5, 0.3, 3).mesh();
  EXPECT_THROW(DynamicDiagram::fromDistances(mesh, std::make_unique<Foreign>()), Error);
  EXPECT_THROW(DynamicDiagram::fromDistances(mesh, nullptr), Error);
  const std::shared_ptr<DistanceField> kept = std::make_shared<Foreign>();
  EXPECT_THROW(DynamicDiagram::fromDistances(mesh, kept), Error);
  EXPECT_EQ(kept.use_count(), 1);
}

/// Each edit of one diagram would make the other one wrong.
TEST(DynamicDiagram, RefusesDistancesThatChangeWithAnotherDiagram) {
  const auto mesh = shapes::icosphere(1).mesh(), other = shapes::icosphere(1).mesh();
  const std::shared_ptr<DistanceField> field =
      finished(propagate(mesh, sampleUniform(mesh, 5, 1), Metric::kExact));
  EXPECT_THROW(DynamicDiagram::fromDistances(other, field), Error);
  auto late = DynamicDiagram::startFromDistances(mesh, field);
  DynamicDiagram::startFromDistances(mesh, field);  // given up, so the distances stay free
  const DynamicDiagram first = DynamicDiagram::fromDistances(mesh, field);
  EXPECT_THROW(DynamicDiagram::fromDistances(mesh, field), Error);
  EXPECT_THROW(finished(std::move(late)), Error);
}

TEST(DynamicDiagram, GivesTheLowestFreeLabel) {
  const TriangleMesh mesh = shapes::grid(6, 6, 0.3, 1).mesh();
  RandomEdits random(mesh, 1);
  DynamicDiagram dynamic(mesh, random.points(4));
  dynamic.removeSite(2);
  dynamic.removeSite(1);
  EXPECT_FALSE(dynamic.hasSite(1));
  EXPECT_EQ(dynamic.lowestFreeLabel(), 1);
  dynamic.insertSite(random.point());
  EXPECT_TRUE(dynamic.hasSite(1));
  finished(dynamic.startInsert(random.points(2)));
  EXPECT_TRUE(dynamic.hasSite(2) && dynamic.hasSite(4));
  EXPECT_EQ(dynamic.lowestFreeLabel(), 5);
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// Scaled to the sum 1, a coordinate may fall below what counts as rounding in points given.
TEST(DynamicDiagram, MeasuresDistancesFromWhereASiteIs) {
  const TriangleMesh mesh = shapes::grid(6, 6, 0.3, 1).mesh();
  const SurfacePoint site = {0, {kCoordinateRounding, 0.5, 0.5 + kBarycentricTolerance / 2}};
  const DynamicDiagram dynamic(mesh, {&site, 1});
  EXPECT_EQ(dynamic.distances().path(0, {40, {0.2, 0.3, 0.5}}).back(), dynamic.site(0));
}

/// Of sites at one place, the one with the lowest label has the region, whichever came first.
TEST(DynamicDiagram, GivesThePlaceOfSeveralSitesToTheLowestLabel) {
  const TriangleMesh mesh = shapes::icosphere(3).mesh();
  const int h = 0, vertex = mesh.tail(100);
  SurfacePoint onEdge{0, {0.25, 0.75, 0}};
  const SurfacePoint places[] = {shapes::centroid(7), onEdge, pointAtVertex(mesh, vertex)};
  // The same places as they are in other faces.
  const SurfacePoint again[] = {shapes::centroid(7), acrossEdge(mesh, onEdge, h),
                                pointInFace(mesh, places[2], mesh.fan(vertex)[2] / 3).value()};
  for (const Metric metric : {Metric::kExact, Metric::kDgpc})
    for (int i = 0; i < 3; ++i) {
      const std::vector<SurfacePoint> sites = {places[i], shapes::centroid(500), again[i],
                                               again[i]};
      DynamicDiagram dynamic(mesh, sites, metric);
      const auto expectOnly = [&](int label) {
        EXPECT_TRUE(isUpToDate(mesh, dynamic, metric));
        const Diagram d = dynamic.diagram();
        for (const int l : {0, 2, 3}) EXPECT_EQ(d.regionArea[l] > 0, l == label) << l;
      };
      expectOnly(0);
      const DiagramChange out = dynamic.removeSite(0);
      EXPECT_TRUE(std::ranges::binary_search(out.labels, 2));
      expectOnly(2);
      dynamic.removeSite(3);
      expectOnly(2);
      dynamic.insertSite(places[i]);  // as site 0
      expectOnly(0);
      dynamic.insertSite(places[i]);  // as site 3
      const DiagramChange moved = dynamic.moveSite(0, shapes::centroid(900));
      EXPECT_TRUE(std::ranges::binary_search(moved.labels, 0));
      EXPECT_GT(dynamic.diagram().regionArea[0], 0);
      EXPECT_GT(dynamic.diagram().regionArea[2], 0);
      dynamic.moveSite(0, again[i]);
      expectOnly(0);
      EXPECT_TRUE(dynamic.hasSite(2));
      EXPECT_EQ(dynamic.site(2).bary, again[i].bary);
    }
}

/// The diagram is inconsistent meanwhile: using it read memory that was not its own.
TEST(DynamicDiagram, RefusesEverythingUntilAChangeIsDone) {
  const TriangleMesh mesh = shapes::cube().mesh();
  DynamicDiagram dynamic(mesh, {{mesh.fromInputVertex(0)}});
  auto change = dynamic.startInsert(mesh.fromInputVertex(7));
  const auto expectRefusal = [&] {
    EXPECT_THROW(dynamic.insertSite(mesh.fromInputVertex(1)), Error);
    EXPECT_THROW(dynamic.diagram(), Error);
    EXPECT_THROW(dynamic.distances(), Error);
    EXPECT_THROW(dynamic.sites(), Error);
  };
  expectRefusal();
  while (!change->step(1)) expectRefusal();
  EXPECT_EQ(dynamic.insertSite(mesh.fromInputVertex(1)).part.siteCount, 3);
  change = dynamic.startRemove(1);
  change.reset();
  expectRefusal();
}

TEST(DynamicDiagram, RefusesLabelsWithoutSite) {
  const TriangleMesh mesh = shapes::triangle().mesh();
  DynamicDiagram dynamic(mesh, {});
  EXPECT_THROW(dynamic.removeSite(0), Error);
  EXPECT_THROW(dynamic.moveSite(-1, {0, Eigen::Vector3d::Unit(0)}), Error);
}

/// A refused site changes nothing; above all, it does not remove the one that was to be moved.
TEST(DynamicDiagram, RefusesSitesThatAreNotOnTheMesh) {
  const TriangleMesh mesh = shapes::grid(6, 6, 0.3, 1).mesh();
  RandomEdits random(mesh, 1);
  DynamicDiagram dynamic(mesh, random.points(4));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SurfacePoint& nowhere : {SurfacePoint(), SurfacePoint{mesh.faceCount(), {1, 0, 0}},
                                      SurfacePoint{0, {5, -4, 0}}, SurfacePoint{0, {nan, 0, 1}}}) {
    EXPECT_THROW(dynamic.insertSite(nowhere), Error);
    EXPECT_THROW(dynamic.moveSite(2, nowhere), Error);
    if (nowhere.face != -1) {
      EXPECT_THROW(DynamicDiagram(mesh, {{nowhere}}), Error);
    }
    EXPECT_THROW(dynamic.distances().nearest(nowhere), Error);
    EXPECT_THROW(dynamic.distances().distance(0, nowhere), Error);
    EXPECT_THROW(dynamic.distances().path(0, nowhere), Error);
    const LabelledPoint labelled = {0, nowhere};
    EXPECT_THROW(dynamic.distances().distancesAt({labelled}), Error);
  }
  EXPECT_EQ(dynamic.labelCount(), 4);
  EXPECT_TRUE(dynamic.hasSite(2));
  EXPECT_TRUE(isUpToDate(mesh, dynamic, Metric::kExact));
}

/// What a change names is all that is different.
TEST(DynamicDiagram, NamesWhatHasChanged) {
  const TriangleMesh mesh = shapes::bumpySurface(1, 8, 0.3, 2).mesh();
  RandomEdits random(mesh, 3);
  DynamicDiagram dynamic(mesh, random.points(200));
  for (int i = 0; i < 20; ++i) {
    const Diagram before = dynamic.diagram();
    const int label = 10 * i;
    const DiagramChange change = dynamic.moveSite(label, random.point());
    const Diagram after = dynamic.diagram();
    EXPECT_TRUE(std::ranges::binary_search(change.labels, label));
    for (int f = 0; f < mesh.faceCount(); ++f) {
      if (std::ranges::binary_search(change.faces, f)) continue;
      EXPECT_EQ(before.faceLabel[f], after.faceLabel[f]) << f;
    }
    for (int l = 0; l < 200; ++l) {
      if (std::ranges::binary_search(change.labels, l)) continue;
      EXPECT_EQ(before.regionArea[l], after.regionArea[l]) << l;
    }
    EXPECT_LT(change.labels.size(), 100u);
  }
}

}  // namespace
}  // namespace gvd
