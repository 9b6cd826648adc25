#pragma once

#include <cstdint>
#include <optional>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{

/// Durations and counts of a trial. All times are simulated.
struct TrialOptions
{
  double dwell = 4.0;               ///< wait after theta is reached, before the window begins [s]
  double window = 4.0;              ///< shortest window [s]
  double longest_window = 60.0;     ///< the window ends then even if a species has too few disks [s]
  std::uint64_t least_disks = 100;  ///< of each species that must leave within the window
};

/// One trial of an inclination. Waits until the sieve has reached it, lets the disks on the base leave during
/// `dwell`, and then counts those that leave within a window. Uses the times in the frames only: frames of
/// base and bins may arrive in any order, and some may be lost. The trial restarts if the sieve's time or
/// counts go back, or if its base is moved by another node.
class SeparationTrial
{
public:
  explicit SeparationTrial(const TrialOptions& options) : options_(options) {}

  /// Begins a trial at an inclination [rad]. If the previous trial had the same inclination, the new window
  /// begins at the end of the previous one.
  void begin(double inclination);

  void take(const BaseFrame& frame);
  void take(const BinFrame& frame);
  void take(const StatisticsFrame& frame);

  /// The result once the window is over; nothing before, and after begin().
  const std::optional<Separation>& result() const { return result_; }

  /// Forgets the frames so far: the sieve was restarted or replaced.
  void interrupt();

  /// Number of interruptions, including jumps back of time or counts.
  unsigned interruptions() const { return interruptions_; }

  /// Whether the last frame of the base shows this inclination as commanded.
  bool followed() const { return followed_; }

private:
  bool stands(const DriveState& base) const;
  void forgetStatistics();
  void count(const BinFrame& frame);
  Separation since(const BinFrame& first, const BinFrame& last) const;
  bool isOver(const Separation& separation) const;

  TrialOptions options_;
  double inclination_ = 0.0;
  bool followed_ = false;
  unsigned interruptions_ = 0;
  std::optional<double> base_time_;           ///< time of the base's last frame
  std::optional<double> standing_since_;      ///< time since which the base is at the inclination
  std::optional<BinFrame> last_;              ///< the last frame of the bins
  std::optional<BinFrame> waiting_;           ///< bins that wait for a frame of the base
  std::optional<BinFrame> first_;             ///< the bins at the begin of the window
  std::optional<BinFrame> end_;               ///< the bins at the end of the previous window
  std::vector<TemperatureSum> temperatures_;  ///< per species, over frames
  double paces_ = 0.0;                        ///< sum of wall over simulated time, from ~statistics
  unsigned paced_ = 0;
  std::optional<Separation> result_;
};

}  // namespace ratchet_sieve
