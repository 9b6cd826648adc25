#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// One event time per disk, the earliest at the top: a complete binary tournament
/// (Marin & Cordero, Comput. Phys. Commun. 92, 214 (1995)). Ties go to the smaller id, so that the
/// order of events is total.
class EventQueue
{
public:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  /// Makes room for ids below `count`; new ones are due never.
  void resize(std::size_t count)
  {
    std::size_t leaves = 1;
    while (leaves < count)
      leaves *= 2;
    times_.resize(leaves, NEVER);
    winners_.resize(leaves);
    rebuild();
  }

  void update(std::uint32_t id, double time)
  {
    times_[id] = time;
    for (std::size_t node = (times_.size() + id) / 2; node > 0; node /= 2)
    {
      const std::uint32_t winner = play(node);
      const std::uint32_t previous = winners_[node];
      winners_[node] = winner;
      if (winner == previous && winner != id)
        return;
    }
  }

  /// The id whose event is next. @pre resize() was called
  std::uint32_t top() const { return times_.size() == 1 ? 0 : winners_[1]; }
  double topTime() const { return times_.empty() ? NEVER : times_[top()]; }

  /// Moves every time back by `length`.
  void rebase(double length)
  {
    for (double& time : times_)
      time -= length;
    rebuild();
  }

  void archive(StateArchive& state) { state(times_, winners_); }

private:
  std::uint32_t entrant(std::size_t node) const
  {
    return node >= times_.size() ? static_cast<std::uint32_t>(node - times_.size()) : winners_[node];
  }

  std::uint32_t play(std::size_t node) const
  {
    const std::uint32_t left = entrant(2 * node);
    const std::uint32_t right = entrant(2 * node + 1);
    return times_[right] < times_[left] ? right : left;
  }

  void rebuild()
  {
    for (std::size_t node = times_.size(); node-- > 1;)
      winners_[node] = play(node);
  }

  std::vector<double> times_;           ///< per id; the tournament's leaves
  std::vector<std::uint32_t> winners_;  ///< per inner node, 1 the root
};

}  // namespace ratchet_sieve
