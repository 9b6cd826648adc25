#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/live/plant.h"

namespace ratchet_sieve
{

/// The drives of a base. They depend on setpoints and simulated times alone, not on how often they are
/// advanced.
class Drives
{
public:
  /// At rest at the scene's values. @param time [s]
  Drives(const DriveParameters& settings, const BaseDefinition& base, double time);

  /// A new setpoint. @param time [s], not before an earlier one
  void ask(Quantity quantity, double setpoint, double time);

  double asked(Quantity quantity) const { return drives_[indexOf(quantity)].asked; }  ///< the newest setpoint

  /// When a drive moves next [s]; infinity: not before another setpoint.
  double nextTime() const;

  /// @param time at most nextTime() [s]
  void advanceTo(double time);

  /// What the base is given now, within the legal values.
  double output(Quantity quantity) const;

  /// What a drive can suffer: none; stuck (it stays where it is); off, but for the inclination.
  static std::vector<std::string> faults(Quantity quantity);

  /// @param applied where the base is
  void setFault(Quantity quantity, const std::string& fault, double applied);

private:
  struct Drive
  {
    DriveSettings settings;
    double asked;
    Lag lag;
    double settled_at = 0.0;                               ///< when the lag is over [s]
    std::deque<std::pair<double, double>> under_way = {};  ///< arrivals [s] and setpoints, in the dead time
    std::optional<double> held = {};                       ///< what a fault gives the base
  };

  std::vector<Drive> drives_;  ///< in the order of Quantity
};

}  // namespace ratchet_sieve
