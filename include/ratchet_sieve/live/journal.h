#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "ratchet_sieve/recording/run.h"

namespace ratchet_sieve
{

/// Receives the log lines of a run.
struct RunLog
{
  std::function<void(const std::string&)> inform = [](const std::string&) {};
  std::function<void(const std::string&)> warn = [](const std::string&) {};
};

/// What the log says of the runs of a node, one after the other, while they are under way.
class Journal
{
public:
  using Clock = std::chrono::steady_clock;

  explicit Journal(RunLog log) : log_(std::move(log)) {}

  /// Says what is new: progress at every tenth of the duration; a violent energy and a choked base, once in
  /// a run; the number of disks that have gone over the walls, of the first and at each doubling; and that
  /// the accuracy requested by the scene is reached. A batch run would end then, or where it is choked if the
  /// scene says so; of a node's run the user decides when it ends.
  void look(const Run& run);

  /// Progress of a slow pour. The first line comes when it has lasted for one period. To be called with the
  /// arguments of a PourObserver.
  void pouring(std::size_t poured, std::size_t of, Clock::time_point now);

  static constexpr std::chrono::seconds POUR_PERIOD{2};  ///< between lines [s of wall time]

private:
  bool warn(const std::string& text);  ///< @return whether there is something to warn of
  void lookAtProgress(const Run& run);
  void lookAtWalls(const Simulation& simulation);
  void lookAtCertainty(const Simulation& simulation);

  RunLog log_;

  /// What was said of the present run.
  struct Said
  {
    double start = 0.0;      ///< of the run [s]
    double last_time = 0.0;  ///< at which it was looked at [s]
    int tenths = 0;          ///< of the duration
    bool energy = false;
    bool choke = false;
    std::uint64_t over_walls = 0;  ///< disks
    bool certainty = false;
    std::optional<double> next_certainty;  ///< time of the next check [s]
  } said_;

  std::size_t poured_ = std::numeric_limits<std::size_t>::max();
  Clock::time_point next_pour_line_;
};

}  // namespace ratchet_sieve
