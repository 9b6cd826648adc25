#pragma once

#include <array>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/commanded_quantity.h"

namespace ratchet_sieve
{

/// What stands between a setpoint and the base. By default nothing: the base gets the setpoint at once, and
/// follows it at its slew rate. A setpoint passes the members in their order. Units are those of the
/// quantity.
struct DriveSettings
{
  double dead_time = 0.0;      ///< [s]
  double time_constant = 0.0;  ///< of a first-order lag [s]
  double resolution = 0.0;     ///< of the smallest step that the drive can make; 0: any
  std::vector<std::pair<double, double>> over_frequency;  ///< [Hz] and a factor, by rising frequency
  double offset = 0.0;                                    ///< that the controller does not know
};

using DriveParameters = std::array<DriveSettings, QUANTITIES>;  ///< in the order of Quantity

/// One drive. It depends on setpoints and simulated times alone, not on how often it is advanced.
class Actuator
{
public:
  /// At rest at a setpoint. @param time [s]
  Actuator(const DriveSettings& settings, double setpoint, double time)
      : settings_(settings), asked_(setpoint), goal_(setpoint), position_(setpoint), position_time_(time)
  {
  }

  /// A new setpoint. @param time [s], not before an earlier one
  void ask(double setpoint, double time);
  double asked() const { return asked_; }  ///< the newest setpoint

  /// When the drive moves next [s]; infinity: not before another setpoint.
  double nextTime() const;

  /// @param time nextTime() [s]
  void advanceTo(double time);

  /// What the base is given now, within `legal`. @param frequency that the base is given [Hz]
  double output(double frequency, const Interval& legal) const;

  /// The drive stays at a value of the base whatever it is asked; nothing: it works again.
  void hold(std::optional<double> value) { held_ = value; }

private:
  void lagTo(double time);
  double step() const;

  DriveSettings settings_;
  double asked_;
  std::deque<std::pair<double, double>> under_way_;  ///< arrivals [s] and setpoints, within the dead time
  double goal_;                                      ///< of the lag
  double position_;                                  ///< of the lag at position_time_
  double position_time_;                             ///< [s]
  double near_ = 0.0;                                ///< distance at which the goal counts as reached
  std::optional<double> held_;
};

/// The drives of a base.
class Drives
{
public:
  /// At rest at the scene's values. @param time [s]
  Drives(const DriveParameters& settings, const BaseDefinition& base, double time);

  void ask(Quantity quantity, double setpoint, double time) { of(quantity).ask(setpoint, time); }
  double asked(Quantity quantity) const { return drives_[indexOf(quantity)].asked(); }
  double nextTime() const;
  void advanceTo(double time);

  /// What the base is given now.
  double output(Quantity quantity) const;

  /// What a drive can suffer: none; stuck (it stays where it is); off, but for the inclination.
  static std::vector<std::string> faults(Quantity quantity);

  /// @param applied where the base is
  void setFault(Quantity quantity, const std::string& fault, double applied);

private:
  Actuator& of(Quantity quantity) { return drives_[indexOf(quantity)]; }

  std::vector<Actuator> drives_;  ///< in the order of Quantity
};

}  // namespace ratchet_sieve
