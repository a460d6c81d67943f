// SPDX-License-Identifier: MIT
//
// Every property of `diagram_checks.h` and of `partition_checks.h` on random degenerate cases, with
// both metrics, and of the diagram after its sites have changed:
//
//     diagram_property_test [--seed S] [--cases N] [--wild 1]
//
// checks the cases of seeds S … S+N-1, or the wild ones of these seeds: for those, all of
// `pipeline_checks.h`. A failure names the command that repeats its case alone, and
// shows what is left of the case after shrinking.

#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "brute_force.h"
#include "diagram_checks.h"
#include "gvd/dynamic_diagram.h"
#include "gvd/partition.h"
#include "partition_checks.h"
#include "pipeline_checks.h"
#include "random_case.h"

namespace gvd {
namespace {

// Three times what a case may take, for machines that are slower or watched by sanitizers.
constexpr int kSecondsPerCase = 120, kSecondsPerWildCase = 30;
constexpr int kMostFailures = 5;

struct Options {
  std::uint64_t seed = 0;
  std::uint64_t cases = 1000;
  std::uint64_t wild = 0;  ///< or 1
};

std::string_view nameOf(Metric metric) { return metric == Metric::kDgpc ? "dgpc" : "exact"; }

/// What is wrong with a diagram whose sites have changed: one has moved to the middle of a face,
/// one has gone, and one has come to where another one is.
std::string complaintAfterChanges(const TriangleMesh& mesh, std::span<const SurfacePoint> sites,
                                  Metric metric) {
  DynamicDiagram dynamic(mesh, sites, metric);
  const int count = static_cast<int>(sites.size());
  dynamic.moveSite(0, shapes::centroid(mesh.faceCount() / 2));
  if (count > 2) dynamic.removeSite(count / 2);
  dynamic.insertSite(sites[count - 1]);
  const auto result = checks::isConsistent(mesh, dynamic.diagram());
  return result ? "" : std::string("after changes: ") + result.message();
}

/// What is wrong with the diagram of a case; empty if nothing is.
std::string complaint(const RandomCase& c, Metric metric) {
  try {
    const TriangleMesh mesh = c.mesh();
    const auto sites = c.sitesOn(mesh);
    const checks::Traced traced = checks::trace(mesh, sites, metric);
    if (const auto result = checks::isConsistent(mesh, traced.diagram); !result)
      return result.message();
    if (const auto result = checks::isSound(mesh, partition(mesh, traced.diagram)); !result)
      return "partition: " + std::string(result.message());
    if (const auto result = checks::agreesWithField(mesh, traced, sites, metric); !result)
      return result.message();
    if (const std::string result = complaintAfterChanges(mesh, sites, metric); !result.empty())
      return result;
    if (metric == Metric::kDgpc) return {};
    const checks::BruteForce everywhere(mesh, sites, metric);
    if (const auto result = checks::spreadsFarEnough(mesh, traced, everywhere); !result)
      return result.message();
  } catch (const std::exception& error) {
    return std::string("an exception: ") + error.what();
  }
  return {};
}

/// The same of a wild case, of which less is promised.
std::string complaintAboutWild(const RandomCase& c, Metric metric) {
  try {
    const TriangleMesh mesh = c.mesh();
    shapes::Random random(c.sites.size());
    return checks::complaintAboutPipeline(mesh, c.sitesOn(mesh), random, {.metric = metric});
  } catch (const std::exception& error) {
    return std::string("an exception: ") + error.what();
  }
}

using Complaint = std::string (*)(const RandomCase&, Metric);

/// Whether a smaller case fails as well. One that is no mesh or has no site on it does not count.
bool alsoFails(const RandomCase& c, Metric metric, Complaint complaint) {
  try {
    c.sitesOn(c.mesh());
  } catch (const std::exception&) {
    return false;
  }
  return !complaint(c, metric).empty();
}

// --- Which case it was, where a test ends without coming back ------------------------------------

std::array<char, 256> commandNow;

void nameCase(const char* program, std::uint64_t seed, bool isWild) {
  std::snprintf(commandNow.data(), commandNow.size(), "\nRepeat with: %s --seed %llu --cases 1%s\n",
                program, static_cast<unsigned long long>(seed), isWild ? " --wild 1" : "");
}

/// Only what a signal handler may do.
void onSignal(int signal) {
  const std::string_view what = signal == SIGPROF ? "\nA case takes too long." : "\nA crash.";
  [[maybe_unused]] auto written = write(STDERR_FILENO, what.data(), what.size());
  written = write(STDERR_FILENO, commandNow.data(), std::string_view(commandNow.data()).size());
  _exit(1);
}

/// Of the processor: a busy machine is no fault. 0: none.
void limitTime(int seconds) {
  const itimerval limit{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

void handleSignals() {
  std::signal(SIGPROF, onSignal);
  std::signal(SIGABRT, onSignal);
  std::signal(SIGFPE, onSignal);
#ifndef GVD_SANITIZED
  std::signal(SIGSEGV, onSignal);  // of which the sanitizer tells more
#endif
}

void report(const RandomCase& failing, Metric metric, const std::string& what,
            Complaint complaint) {
  std::cout << "FAILED: " << failing.kind << ", " << nameOf(metric) << ": " << what
            << commandNow.data() << std::flush;
  limitTime(0);
  const RandomCase small =
      shrunk(failing, [&](const RandomCase& c) { return alsoFails(c, metric, complaint); });
  std::cout << "Shrunk to " << small.shape.faceCount() << " triangles and " << small.sites.size()
            << " sites: " << complaint(small, metric) << '\n'
            << sourceOf(small) << std::endl;
}

/// Returns the number of failures.
int run(const Options& options, const char* program) {
  int failures = 0;
  handleSignals();
  for (std::uint64_t i = 0; i < options.cases && failures < kMostFailures; ++i) {
    nameCase(program, options.seed + i, options.wild);
    limitTime(options.wild ? kSecondsPerWildCase : kSecondsPerCase);
    const RandomCase c = options.wild ? wildCase(options.seed + i) : randomCase(options.seed + i);
    const Complaint complaintNow = options.wild ? complaintAboutWild : complaint;
    for (const Metric metric : {Metric::kDgpc, Metric::kExact}) {
      const std::string what = complaintNow(c, metric);
      if (what.empty()) continue;
      ++failures;
      report(c, metric, what, complaintNow);
    }
  }
  limitTime(0);
  return failures;
}

/// False if the arguments make no sense.
bool parse(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; i += 2) {
    const std::string_view name = arguments[i];
    std::uint64_t* const value = name == "--seed"    ? &options.seed
                                 : name == "--cases" ? &options.cases
                                 : name == "--wild"  ? &options.wild
                                                     : nullptr;
    if (!value || i + 1 == count) return false;
    const std::string_view text = arguments[i + 1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *value);
    if (error != std::errc() || end != text.data() + text.size()) return false;
  }
  return true;
}

}  // namespace
}  // namespace gvd

int main(int count, char** arguments) {
  gvd::Options options;
  if (!gvd::parse(count, arguments, options)) {
    std::cerr << "usage: " << arguments[0] << " [--seed S] [--cases N] [--wild 1]\n";
    return 2;
  }
  const int failures = gvd::run(options, arguments[0]);
  if (failures > 0) return 1;
  std::cout << options.cases << " cases passed\n";
}
