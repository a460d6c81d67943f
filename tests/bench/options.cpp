// SPDX-License-Identifier: MIT
#include "options.h"

#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>
#include <string_view>

namespace gvd::bench {
namespace {

template <class Number>
Number toNumber(std::string_view text, Number least) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || number < least)
    throw std::invalid_argument("'" + std::string(text) + "' is not a number of at least " +
                                std::to_string(least));
  return number;
}

/// Of numbers with commas between them.
std::vector<int> toNumbers(std::string_view text, int least) {
  std::vector<int> numbers;
  for (;;) {
    const size_t comma = text.find(',');
    numbers.push_back(toNumber(text.substr(0, comma), least));
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

NamedMetric toMetric(std::string_view text) {
  for (const NamedMetric& metric : kMetrics)
    if (metric.name == text) return metric;
  throw std::invalid_argument("there is no metric '" + std::string(text) + "'");
}

}  // namespace

const char* const kUsage =
    "Usage: gvd_bench [--name value]...\n"
    "  --mesh FILE         a mesh instead of the generated ones, a GLB or a glTF that needs no "
    "other\n"
    "                      file; may be repeated\n"
    "  --generated         the generated meshes besides\n"
    "  --subdivide N       every face in four, N times, the new vertices a little displaced (0)\n"
    "  --sites N,N,...     sites per mesh that speed is measured with (1,10,100,300,1000,5000)\n"
    "  --seed N            of the sites (1)\n"
    "  --runs N            the fastest counts (5)\n"
    "  --detail N          of the diagrams (0)\n"
    "  --metric NAME       only dgpc or exact; both\n"
    "  --part NAME         only speed, size, accuracy, convergence or cvt; all\n"
    "  --only TEXT         only meshes and cases with this in their name\n"
    "  --case FILE         exact answers to compare with, as truth_cases.mjs writes them; may be\n"
    "                      repeated\n"
    "  --tessellation FILE sites to start from, and points to measure the energy at, likewise\n"
    "  --meshes FOLDER     where the meshes that speed was measured on are left, as GLBs\n"
    "  --oracle-sites N    sites per mesh where distances are compared with CGAL's (30)\n"
    "  --oracle-points N   points there (1000)\n"
    "  --oracle-faces N    faces of the largest mesh there (6000); 0: none\n";

Options parseOptions(const std::vector<std::string>& arguments) {
  Options options;
  using Take = std::function<void(const std::string&)>;
  const auto number = [](auto& target, auto least) -> Take {
    return [&target, least](const std::string& text) {
      target = toNumber<std::remove_reference_t<decltype(target)>>(text, least);
    };
  };
  const std::map<std::string, Take> known = {
      {"--mesh", [&](const std::string& text) { options.meshes.emplace_back(text); }},
      {"--subdivide", number(options.subdivisions, 0)},
      {"--sites", [&](const std::string& text) { options.sites = toNumbers(text, 1); }},
      {"--seed", number(options.seed, 0)},
      {"--runs", number(options.runs, 1)},
      {"--detail", number(options.detail, 0)},
      {"--metric", [&](const std::string& text) { options.metrics = {toMetric(text)}; }},
      {"--part",
       [&](const std::string& text) {
         if (!options.parts.contains(text))
           throw std::invalid_argument("there is no part '" + text + "'");
         options.parts = {text};
       }},
      {"--only", [&](const std::string& text) { options.only = text; }},
      {"--case", [&](const std::string& text) { options.cases.emplace_back(text); }},
      {"--tessellation", [&](const std::string& text) { options.tessellations.push_back(text); }},
      {"--meshes", [&](const std::string& text) { options.meshFolder = text; }},
      {"--oracle-sites", number(options.oracleSites, 1)},
      {"--oracle-points", number(options.oraclePoints, 1)},
      {"--oracle-faces", number(options.oracleFaces, 0)},
  };
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (name == "--generated") {
      options.generated = true;
      continue;
    }
    const auto option = known.find(name);
    if (option == known.end()) throw std::invalid_argument("there is no option " + name);
    if (++i == arguments.size()) throw std::invalid_argument(name + " needs a value");
    option->second(arguments[i]);
  }
  return options;
}

}  // namespace gvd::bench
