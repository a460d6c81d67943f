// SPDX-License-Identifier: MIT
// This work is based on:
// Yang Liu, Wenping Wang, Bruno Lévy, Feng Sun, Dong-Ming Yan, Lin Lu, Chenglei Yang. On Centroidal
// Voronoi Tessellation: Energy Smoothness and Fast Computation. 2009
#include "gvd/cvt.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "base/plane.h"
#include "base/random.h"
#include "base/rejection.h"
#include "base/sliced_loop.h"
#include "gvd/straightest.h"
#include "mesh/given_points.h"
#include "mesh/random_points.h"
#include "tessellation/cvt_energy.h"
#include "tessellation/density.h"
#include "tessellation/lbfgs.h"

namespace gvd {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

void require(bool condition, const std::string& what) {
  if (!condition) rejectArgument(what);
}

void validate(const TriangleMesh& mesh, size_t siteCount, const CvtOptions& options) {
  require(siteCount > 0, "there is no site");
  require(options.iterations >= 0,
          "there cannot be " + std::to_string(options.iterations) + " iterations");
  require(options.energyTolerance >= 0 && options.moveTolerance >= 0,
          "a tolerance is negative or not a number");
  if (!options.density.empty()) requireDensity(mesh, options.density);
  for (const int label : options.fixedSites)
    require(label >= 0 && label < static_cast<int>(siteCount),
            "there is no site " + std::to_string(label) + " to be fixed");
}

/// Moves a point off a vertex: there, angles do not add up to 2π and paths have no unique
/// direction. Beside the vertex, the logarithmic map, and so the gradient, is as good as anywhere.
SurfacePoint offVertex(SurfacePoint p) {
  constexpr double kLeast = 1e-7;
  int corner;
  if (p.bary.maxCoeff(&corner) <= 1 - 2 * kLeast) return p;
  p.bary = Eigen::Vector3d::Constant(kLeast);
  p.bary[corner] = 1 - 2 * kLeast;
  return p;
}

/// Sites, and what follows from them: distances, diagram, and the energy with its moments.
struct State {
  std::vector<SurfacePoint> sites;
  std::vector<Vector2d> frames;  ///< x axis of each site's frame, in the frame of its face
  double largestMove = 0;        ///< of its sites, from their places before
  std::shared_ptr<const DistanceField> distances;
  std::shared_ptr<const Diagram> diagram;
  CvtEnergy energy;
  VectorXd gradient;  ///< of the energy, in the frames; zero for fixed sites
};

/// Finds what follows from the sites of a state, but for the gradient, in slices.
class Evaluation {
 public:
  /// All must outlive this.
  Evaluation(const TriangleMesh& mesh, const CvtOptions& options, State& state)
      : mesh_(mesh),
        options_(options),
        state_(state),
        propagation_(propagate(mesh, state.sites, options.metric)) {}

  bool step(long budget) {
    return sequence_.run(
        [&] { return propagation_->step(budget); },
        [&] {
          state_.distances = propagation_->take();
          tracing_ = startDiagram(mesh_, *state_.distances, static_cast<int>(state_.sites.size()));
        },
        [&] { return tracing_->step(budget); },
        [&] {
          state_.diagram = std::make_shared<const Diagram>(tracing_->take());
          tracing_.reset();
          integration_ =
              startCvtEnergy(mesh_, *state_.distances, *state_.diagram, options_.density);
        },
        [&] { return integration_->step(budget); }, [&] { state_.energy = integration_->take(); });
  }

 private:
  const TriangleMesh& mesh_;
  const CvtOptions& options_;
  State& state_;
  SlicedSequence sequence_;
  std::unique_ptr<Propagation> propagation_;
  std::unique_ptr<SlicedWork<Diagram>> tracing_;
  std::unique_ptr<SlicedWork<CvtEnergy>> integration_;
};

}  // namespace

/// Evaluates trial sites, a step away from the accepted sites. If the energy has fallen enough, the
/// trial is accepted and a new direction chosen. Otherwise the step is shortened and, after a few
/// attempts, Lloyd's direction is taken instead.
///
/// Every site has its own frame, transported in parallel along its moves. Gradients and steps are
/// given in these frames, two components per site, so that those of earlier iterations can be
/// combined with the current ones (an isometric vector transport: Huang, Gallivan, Absil 2015).
class Cvt::Solver {
 public:
  Solver(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, CvtOptions options)
      : mesh_(mesh), options_(std::move(options)), isFixed_(sites.size(), false) {
    validate(mesh, sites.size(), options_);
    for (const int label : options_.fixedSites) isFixed_[label] = true;
    trial_.sites.assign(sites.begin(), sites.end());
    trial_.frames.assign(sites.size(), Vector2d(1, 0));
    for (size_t l = 0; l < sites.size(); ++l) {
      if (sites[l].face < 0) isFixed_[l] = true;  // a label without a site keeps none
      if (!isFixed_[l]) trial_.sites[l] = offVertex(onMesh(mesh_, sites[l], "site", l));
    }
    evaluation_.emplace(mesh_, options_, trial_);
  }

  bool step(long budget) {
    if (isDone_ || !moveSites(budget) || !evaluation_->step(budget)) return false;
    takeGradient();
    if (!accepted_.distances) {
      accept();
    } else if (isLowEnough()) {
      if (options_.method == CvtMethod::kLbfgs && !hasNewPlaces())
        memory_.learn(search_.step * search_.direction, trial_.gradient - accepted_.gradient);
      ++iteration_.number;
      accept();
    } else {
      retreat();
      return false;
    }
    return true;
  }

  bool isDone() const { return isDone_; }
  const CvtIteration& iteration() const { return iteration_; }
  std::span<const SurfacePoint> sites() const { return accepted_.sites; }
  std::shared_ptr<const DistanceField> distances() const { return accepted_.distances; }
  std::shared_ptr<const Diagram> diagram() const { return accepted_.diagram; }

 private:
  /// A direction in which the energy falls, and the step along it that is tried.
  struct LineSearch {
    VectorXd direction;
    double slope = 0;  ///< of the energy along the direction
    double step = 1;   ///< in lengths of the direction
    int attempts = 0;  ///< that did not lower the energy enough
  };

  int siteCount() const { return static_cast<int>(isFixed_.size()); }
  /// Whether the region of an accepted site has a mass that can be divided by.
  bool hasMass(int label) const { return std::isnormal(accepted_.energy.regions[label].mass); }

  // --- The trial ---

  void takeGradient() {
    trial_.gradient = VectorXd::Zero(2 * siteCount());
    for (int l = 0; l < siteCount(); ++l)
      if (!isFixed_[l])
        trial_.gradient.segment<2>(2 * l) =
            -2 * turnedBackBy(trial_.energy.regions[l].moment, trial_.frames[l]);
  }

  /// Armijo's condition, where an increase by rounding counts as none.
  bool isLowEnough() const {
    constexpr double kDecrease = 1e-4, kRounding = 1e-14;
    const double before = accepted_.energy.energy;
    return trial_.energy.energy <=
           before * (1 + kRounding) + kDecrease * search_.step * search_.slope;
  }

  void accept() {
    const double before = accepted_.energy.energy;
    const double fall = before - trial_.energy.energy;
    const bool isFirst = !accepted_.distances;
    std::swap(accepted_, trial_);
    iteration_.energy = accepted_.energy.energy;
    iteration_.largestMove = accepted_.largestMove;
    if (!isFirst && !hasNewPlaces())
      isDone_ = fall <= options_.energyTolerance * before ||
                iteration_.largestMove <= options_.moveTolerance;
    isDone_ |= iteration_.number >= options_.iterations;
    if (isDone_) return;
    findNewPlaces();
    if (hasNewPlaces()) memory_.clear();
    startSearch();
  }

  // --- Where to ---

  /// The inverse Hessian that Lloyd's step assumes: 1 / 2m per region of mass m takes the gradient
  /// -2 ∫ ρ u to minus the mean of u.
  VectorXd inverseDiagonal() const {
    VectorXd result = VectorXd::Zero(2 * siteCount());
    for (int l = 0; l < siteCount(); ++l)
      if (hasMass(l))
        result.segment<2>(2 * l).setConstant(1 / (2 * accepted_.energy.regions[l].mass));
    return result;
  }

  /// Takes the quasi-Newton direction, or Lloyd's, which is that of an empty memory, if the energy
  /// does not fall along it.
  void startSearch() {
    const VectorXd inverse = inverseDiagonal();
    for (;;) {
      search_ = {limited(memory_.direction(accepted_.gradient, inverse), inverse)};
      search_.slope = search_.direction.dot(accepted_.gradient);
      if (search_.slope < 0 || memory_.empty()) break;
      memory_.clear();
    }
    tryStep(1);
  }

  /// No site moves farther than the radius of a disk of its region's area, or twice as far as by
  /// Lloyd's step, whichever is more: the gradient says little about the energy beyond.
  VectorXd limited(VectorXd direction, const VectorXd& inverse) const {
    for (int l = 0; l < siteCount(); ++l) {
      const double lloyd =
          accepted_.gradient.segment<2>(2 * l).cwiseProduct(inverse.segment<2>(2 * l)).norm();
      const double radius = std::sqrt(accepted_.diagram->regionArea[l] / std::numbers::pi);
      const double most = std::max(2 * lloyd, radius), length = direction.segment<2>(2 * l).norm();
      if (length > most) direction.segment<2>(2 * l) *= most / length;
    }
    return direction;
  }

  void tryStep(double step) {
    search_.step = step;
    trial_.sites = accepted_.sites;
    trial_.frames = accepted_.frames;
    trial_.largestMove = 0;
    evaluation_.reset();
  }

  /// Moves the sites of the trial, in slices; true when its evaluation has begun.
  bool moveSites(long& budget) {
    if (evaluation_) return true;
    if (!moving_.run(siteCount(), budget, 1, [&](int l) { move(l); })) return false;
    evaluation_.emplace(mesh_, options_, trial_);
    return true;
  }

  void move(int label) {
    if (hasNewPlaces() && newPlaces_[label].face >= 0) {
      trial_.sites[label] = newPlaces_[label];
      return;
    }
    if (isFixed_[label]) return;
    const Vector2d step = search_.step * search_.direction.segment<2>(2 * label);
    const StraightestGeodesic way = walkStraight(
        mesh_, accepted_.sites[label], turnedBy(step, accepted_.frames[label]), AtBoundary::kSlide);
    trial_.sites[label] = offVertex(way.end);
    trial_.frames[label] = turnedBy(accepted_.frames[label], way.frame).normalized();
    trial_.largestMove = std::max(trial_.largestMove, way.length);
  }

  /// Shortens a step that did not lower the energy enough, to the minimum of a parabola, within
  /// limits. After three attempts, Lloyd's direction replaces the quasi-Newton one. Its first step
  /// lowers the energy, up to the errors of energy and gradient: after three attempts, sites that
  /// overshoot are held, and without any, no gain above these errors is left, and the tessellation
  /// is done. If the gradient promises no more than rounding, one attempt each is enough.
  void retreat() {
    constexpr int kAttempts = 3;
    constexpr double kRounding = 1e-13;  // of the energy
    const bool isWorthwhile = -search_.slope / 2 > kRounding * accepted_.energy.energy;
    if (++search_.attempts >= kAttempts || !isWorthwhile) {
      if (memory_.empty() && !(isWorthwhile && holdOvershooting())) {
        isDone_ = true;
        return;
      }
      memory_.clear();
      return startSearch();
    }
    const double expected = search_.step * search_.slope;
    const double rise = trial_.energy.energy - accepted_.energy.energy - expected;
    const double share = rise > 0 ? -expected / (2 * rise) : 0.5;
    tryStep(search_.step * std::clamp(share, 0.1, 0.5));
  }

  /// Holds the sites that even the shortest trial has taken beyond their minimum; whether there are
  /// any. Such a minimum is at a saddle vertex, where the energy has a kink: the gradient beside it
  /// does not vanish, and steps as long as it calls for raise the energy by more than the other
  /// sites can lower it.
  bool holdOvershooting() {
    bool isAny = false;
    for (int l = 0; l < siteCount(); ++l) {
      const double slope =
          trial_.gradient.segment<2>(2 * l).dot(search_.direction.segment<2>(2 * l));
      if (slope <= 0) continue;
      isFixed_[l] = true;
      isAny = true;
      accepted_.gradient.segment<2>(2 * l).setZero();
    }
    return isAny;
  }

  // --- Sites without region ---

  bool hasNewPlaces() const { return !newPlaces_.empty(); }

  /// Draws new places for the sites whose regions have no mass, from the faces in proportion to
  /// their energy: a further site lowers it most where it is large.
  void findNewPlaces() {
    newPlaces_.clear();
    std::vector<double> sums;
    for (int l = 0; l < siteCount(); ++l) {
      if (isFixed_[l] || hasMass(l)) continue;
      if (sums.empty()) sums = cumulative(accepted_.energy.faceEnergy);
      if (!(sums.back() > 0)) return;
      newPlaces_.resize(siteCount());
      newPlaces_[l] = drawPoint(random_, sums);
    }
  }

  const TriangleMesh& mesh_;
  const CvtOptions options_;
  std::vector<char> isFixed_;  ///< by the options, for want of a site, or held
  State accepted_, trial_;
  SlicedLoop moving_;
  std::optional<Evaluation> evaluation_;  ///< of the trial, once its sites are there
  LineSearch search_;
  LbfgsMemory memory_;
  std::vector<SurfacePoint> newPlaces_;  ///< by label, face -1: none; empty if there are none
  std::mt19937_64 random_{1};
  CvtIteration iteration_;
  bool isDone_ = false;
};

Cvt::Cvt(const TriangleMesh& mesh, std::span<const SurfacePoint> sites, CvtOptions options)
    : solver_(std::make_unique<Solver>(mesh, sites, std::move(options))) {}
Cvt::~Cvt() = default;
Cvt::Cvt(Cvt&&) noexcept = default;
Cvt& Cvt::operator=(Cvt&&) noexcept = default;

bool Cvt::step(long budget) { return solver_->step(std::max(budget, 1L)); }
bool Cvt::isDone() const { return solver_->isDone(); }
const CvtIteration& Cvt::iteration() const { return solver_->iteration(); }
std::span<const SurfacePoint> Cvt::sites() const { return solver_->sites(); }
std::shared_ptr<const DistanceField> Cvt::distances() const { return solver_->distances(); }
std::shared_ptr<const Diagram> Cvt::diagram() const { return solver_->diagram(); }

}  // namespace gvd
