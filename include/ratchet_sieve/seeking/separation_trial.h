#pragma once

#include <cstdint>
#include <optional>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{

/// How long an inclination is tried. All times are simulated.
struct TrialOptions
{
  double dwell = 4.0;               ///< from when theta is reached until the window begins [s]
  double window = 4.0;              ///< at least [s]
  double longest_window = 60.0;     ///< a window ends by then though a species is kept back [s]
  std::uint64_t least_disks = 100;  ///< of each species, that have to leave within the window
};

/// Waits until a sieve stands at an inclination, lets what was on its base leave, and then counts what leaves
/// within a window. Goes by the times in the frames, whenever they come: frames of the base and of the
/// bins may overtake each other, and some may be lost. A sieve whose time or counts go back, or whose base
/// is moved by somebody else, is awaited again.
class SeparationTrial
{
public:
  explicit SeparationTrial(const TrialOptions& options) : options_(options) {}

  /// Tries an inclination [rad]; where the sieve was tried at it just before, from the end of that
  /// window on.
  void begin(double inclination);

  void take(const BaseFrame& frame);
  void take(const BinFrame& frame);
  void take(const StatisticsFrame& frame);

  /// What left, once the window is over; nothing before, and after begin().
  const std::optional<Separation>& result() const { return result_; }

  /// Forgets the frames so far: the sieve is another one, or was away.
  void interrupt();

  /// How often that was so, or time or counts went back.
  unsigned interruptions() const { return interruptions_; }

  /// Whether the base, as last received, is commanded to the inclination.
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
  std::optional<double> base_time_;           ///< of the last frame of the base
  std::optional<double> standing_since_;      ///< of the base's frames
  std::optional<BinFrame> last_;              ///< the bins as last received
  std::optional<BinFrame> waiting_;           ///< bins for which the base is not known yet
  std::optional<BinFrame> first_;             ///< the bins at the window's begin
  std::optional<BinFrame> end_;               ///< the bins at the end of the window before
  std::vector<TemperatureSum> temperatures_;  ///< per species, over frames
  double paces_ = 0.0;                        ///< sum of wall over simulated time, as ~statistics has it
  unsigned paced_ = 0;
  std::optional<Separation> result_;
};

}  // namespace ratchet_sieve
