// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "gvd/sliced_work.h"

namespace gvd {

/// A loop over the indices 0 … count - 1 that stops when a budget is used up, and continues there
/// when called again.
///
/// A budget limits the work of one step. Its unit is a microsecond or less: dividing one mixed
/// face, or `perUnit` rounds of a cheap loop. These numbers of rounds are rough: they decide how
/// long a step takes, but no result.
class SlicedLoop {
 public:
  /// Calls `body` with the indices. Returns true when it has been called with all of them; the next
  /// loop then starts from 0. Where indices differ in cost, `body` returns how many of `perUnit`
  /// rounds it took, as a long.
  template <class Body>
  bool run(std::size_t count, long& budget, long perUnit, Body body) {
    if constexpr (std::is_same_v<std::invoke_result_t<Body&, int>, long>) {
      return runWeighted(count, budget, perUnit, body);
    } else {
      const std::size_t begin = next_, end = advance(count, budget, perUnit);
      for (std::size_t i = begin; i < end; ++i) body(static_cast<int>(i));
      return end == count;
    }
  }

 private:
  template <class Body>
  bool runWeighted(std::size_t count, long& budget, long perUnit, Body& body) {
    while (next_ < count) {
      if (budget <= 0) return false;
      long rounds = 0;
      while (next_ < count && rounds < perUnit) rounds += body(static_cast<int>(next_++));
      budget -= std::max(rounds / perUnit, 1L);
    }
    next_ = 0;
    return true;
  }
  std::size_t advance(std::size_t count, long& budget, long perUnit);

  std::size_t next_ = 0;
};

/// Rounds per unit for loops that read or write a few numbers per round.
inline constexpr long kQuickRounds = 32;

/// A budget for all work at one go.
inline constexpr long kUnlimited = std::numeric_limits<long>::max();

/// A loop as a part of a `SlicedSequence`: over the indices 0 … count - 1 if `items` is a count,
/// else over those of a list. Parts before it may fill the list, whose size is read when the loop
/// has its turn; a count is that at the call of the sequence.
template <class Items, class Body>
auto forEach(const Items& items, long& budget, long perUnit, Body body) {
  if constexpr (std::is_integral_v<Items>)
    return [count = items, &budget, perUnit, body](SlicedLoop& loop) {
      return loop.run(count, budget, perUnit, body);
    };
  else
    return [&items, &budget, perUnit, body](SlicedLoop& loop) {
      return loop.run(items.size(), budget, perUnit, body);
    };
}

/// The same over the items of a list: calls `body` with each.
template <class Items, class Body>
auto forItems(Items& items, long& budget, long perUnit, Body body) {
  return forEach(items, budget, perUnit, [&items, body](int i) { return body(items[i]); });
}

/// A sequence of parts, done one after the other: functions, which may take a `SlicedLoop` of their
/// own, or loops made by `forEach`. A part returns false if it has used up its budget, and is then
/// called again; a part that returns void is always done after one call.
class SlicedSequence {
 public:
  /// Goes on with the first of `parts` that is not done; true when all are.
  template <class... Parts>
  bool run(Parts... parts) {
    count_ = sizeof...(parts);
    int i = 0;
    return ((i++ < done_ || (isDone(parts) && ++done_ > 0)) && ...);
  }
  /// The same for parts that are repeated: once all are done, the next call begins anew.
  template <class... Parts>
  bool runRound(Parts... parts) {
    if (!run(parts...)) return false;
    done_ = 0;
    return true;
  }
  /// The share of the parts that is done; 0 before the first call.
  double progress() const { return count_ > 0 ? static_cast<double>(done_) / count_ : 0; }

 private:
  template <class Part>
  bool isDone(Part& part) {
    if constexpr (std::is_invocable_v<Part&, SlicedLoop&>) {
      return part(loop_);
    } else if constexpr (std::is_void_v<decltype(part())>) {
      part();
      return true;
    } else {
      return part();
    }
  }

  int done_ = 0, count_ = 0;
  SlicedLoop loop_;  ///< of the current part, if that is a loop
};

/// Work that is one sequence of parts, which fill in the result. Its progress is the share of them
/// that is done, unless `share` is overridden.
template <class Result>
class SequentialWork : public SlicedWork<Result> {
 protected:
  double share() const override { return sequence_.progress(); }
  Result result() override { return std::move(out_); }

  SlicedSequence sequence_;
  Result out_;
};

/// Work that consists in one part, with `step` and `progress`: `finish` makes the result of it.
template <class Part, class Finish>
auto workOn(std::unique_ptr<Part> part, Finish finish) {
  using Result = std::invoke_result_t<Finish&, std::unique_ptr<Part>>;
  class WorkOnPart final : public SlicedWork<Result> {
   public:
    WorkOnPart(std::unique_ptr<Part> part, Finish finish)
        : finish_(std::move(finish)), part_(std::move(part)) {}
    bool advance(long budget) override { return part_->step(budget); }
    double share() const override { return part_->progress(); }
    Result result() override { return finish_(std::move(part_)); }

   private:
    Finish finish_;  // keeps what the part refers to, so it has to outlive the part
    std::unique_ptr<Part> part_;
  };
  return std::unique_ptr<SlicedWork<Result>>(new WorkOnPart(std::move(part), std::move(finish)));
}

/// Works on a part, which is constructed from `arguments` in the first call; true when it is done.
template <class Part, class... Arguments>
bool runPart(std::optional<Part>& part, long& budget, Arguments&&... arguments) {
  if (!part) part.emplace(std::forward<Arguments>(arguments)...);
  return part->step(budget);
}

/// Takes the result of a part and destroys the part.
template <class Part>
auto taken(std::optional<Part>& part) {
  auto result = part->take();
  part.reset();
  return result;
}

/// The end of the slice of a list of `count` items, begun at `begin`, that a budget suffices for;
/// lowers the budget by its cost. The slice is empty if the budget is negative because indivisible
/// work has overdrawn it.
std::size_t endOfSlice(std::size_t begin, std::size_t count, long& budget, long perUnit);

/// Lengthens a list to `count` items; true when it is that long. Not inlined, as the WebAssembly
/// module would be larger.
template <class Item>
[[gnu::noinline]] bool fillInSlices(std::vector<Item>& list, std::size_t count, const Item& value,
                                    long& budget) {
  constexpr long kItemsPerUnit = 256;
  if (list.size() >= count) return true;
  list.reserve(count);
  list.resize(endOfSlice(list.size(), count, budget, kItemsPerUnit), value);
  return list.size() == count;
}

/// Frees the memory of a list that is not needed any more.
template <class Item>
void release(std::vector<Item>& list) {
  std::vector<Item>().swap(list);
}

}  // namespace gvd
