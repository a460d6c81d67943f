// SPDX-License-Identifier: MIT
#include "options.h"

#include <charconv>
#include <functional>
#include <map>
#include <stdexcept>

namespace gvd::bench {
namespace {

template <class Number>
Number toNumber(const std::string& text, Number least) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end || number < least)
    throw std::invalid_argument(text + " is not a number of at least " + std::to_string(least));
  return number;
}

}  // namespace

const char* const kUsage =
    "Usage: gvd_bench [--name value]...\n"
    "  --sites N           sites per mesh (300)\n"
    "  --seed N            of the sites (1)\n"
    "  --runs N            the fastest counts (5)\n"
    "  --detail N          of the diagrams (0)\n"
    "  --part NAME         only speed, accuracy, convergence or cvt; all\n"
    "  --only TEXT         only meshes with this in their name\n"
    "  --model FILE        one more mesh, a GLB; may be repeated\n"
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
      {"--sites", number(options.sites, 1)},
      {"--seed", number(options.seed, 0)},
      {"--runs", number(options.runs, 1)},
      {"--detail", number(options.detail, 0)},
      {"--part",
       [&](const std::string& text) {
         if (!options.parts.contains(text)) throw std::invalid_argument("there is no part " + text);
         options.parts = {text};
       }},
      {"--only", [&](const std::string& text) { options.only = text; }},
      {"--model", [&](const std::string& text) { options.models.emplace_back(text); }},
      {"--case", [&](const std::string& text) { options.cases.emplace_back(text); }},
      {"--tessellation", [&](const std::string& text) { options.tessellations.push_back(text); }},
      {"--meshes", [&](const std::string& text) { options.meshFolder = text; }},
      {"--oracle-sites", number(options.oracleSites, 1)},
      {"--oracle-points", number(options.oraclePoints, 1)},
      {"--oracle-faces", number(options.oracleFaces, 0)},
  };
  for (size_t i = 0; i < arguments.size(); i += 2) {
    const auto option = known.find(arguments[i]);
    if (option == known.end()) throw std::invalid_argument("there is no option " + arguments[i]);
    if (i + 1 == arguments.size()) throw std::invalid_argument(arguments[i] + " needs a value");
    option->second(arguments[i + 1]);
  }
  return options;
}

}  // namespace gvd::bench
