// SPDX-License-Identifier: MIT
#include "diagram/final/arc_chaining.h"

namespace gvd {

bool ArcChaining::step(long& budget) {
  const size_t count = out_.segments.size();
  const auto forSegments = [&](auto body) { return forEach(count, budget, kQuickRounds, body); };
  const auto followFromEnd = [&](int s) {
    if (!passes(out_.segments[s].points[0])) follow(s);
  };
  const auto followClosed = [&](int s) {
    if (out_.segments[s].arc < 0) follow(s);
  };
  return sequence_.run([&] { out_.arcs.points.reserve(count + count / 2); },
                       [&] { return fillInSlices(ends_, out_.points.size(), Ends(), budget); },
                       forSegments([&](int s) { noteEnds(s); }), forSegments(followFromEnd),
                       forSegments(followClosed));
}

void ArcChaining::noteEnds(int segment) {
  const auto [tail, tip] = out_.segments[segment].points;
  int &outgoing = ends_[tail].outgoing, &incoming = ends_[tip].incoming;
  outgoing = outgoing == kNone ? segment : kSeveral;
  incoming = incoming == kNone ? segment : kSeveral;
}

/// Whether an arc goes on through a point.
bool ArcChaining::passes(int point) const {
  const auto& [incoming, outgoing] = ends_[point];
  if (incoming < 0 || outgoing < 0) return false;
  const auto &before = out_.segments[incoming].labels, &after = out_.segments[outgoing].labels;
  return before[0] == after[0] && before[1] == after[1];
}

void ArcChaining::follow(int segment) {
  const int arc = out_.arcs.size();
  std::vector<int>& points = out_.arcs.points;
  out_.arcLabels.push_back(out_.segments[segment].labels);
  points.push_back(out_.segments[segment].points[0]);
  for (;;) {
    Diagram::Segment& s = out_.segments[segment];
    s.arc = arc;
    points.push_back(s.points[1]);
    if (!passes(s.points[1])) break;
    segment = ends_[s.points[1]].outgoing;
    if (out_.segments[segment].arc >= 0) break;
  }
  out_.arcs.close();
}

}  // namespace gvd
