#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/sweep/best_setting.h"
#include "ratchet_sieve/sweep/sweep_run.h"

// Checks whether results depend on contact.min_rebound_speed: repeats the run with a half and a quarter of
// it.
namespace ratchet_sieve
{

/// A result of a run and the half-width of its interval, if they are known.
struct FloorResult
{
  std::string name;  ///< quality, processed, mean_vx.A
  std::optional<double> value;
  std::optional<double> half_width;
};

/// The results of a scene at one minimum rebound speed.
struct FloorRun
{
  double floor = 0.0;  ///< [m/s]
  std::string error;   ///< reason of a failure; empty on success
  std::vector<std::string> warnings;
  std::vector<FloorResult> results;
};

/// Repeats a scene at lower minimum rebound speeds, in this thread. @param summary of the run at the scene's
/// own value, which comes first in the result @return nothing if stopped @pre the scene has a minimum rebound
/// speed
std::optional<std::vector<FloorRun>> runAtLowerFloors(const SceneDefinition& scene,
                                                      const nlohmann::ordered_json& summary,
                                                      const std::function<bool()>& stop_wanted);

/// For the summary: the results at each minimum rebound speed, and their differences from the scene's own.
nlohmann::ordered_json floorCheckJson(const std::vector<FloorRun>& runs);

/// The same as a table in lines, with the list of results that depend on it.
std::vector<std::string> floorCheckLines(const std::vector<FloorRun>& runs);

/// The best setting of a sweep at one minimum rebound speed.
struct FloorMean
{
  double floor = 0.0;               ///< [m/s]
  std::optional<SettingMean> mean;  ///< nothing if no seed has a Q
};

/// Repeats all seeds of a setting at lower minimum rebound speeds, and stores them in the sweep's results
/// file. Cases with a result are not repeated.
/// @return the sweep's own value first; nothing if stopped @throws as runSweep()
/// @pre the setting has a minimum rebound speed
std::optional<std::vector<FloorMean>> runSettingAtLowerFloors(const Sweep& sweep, std::uint64_t point,
                                                              const std::string& results,
                                                              const SweepRunOptions& options);

nlohmann::ordered_json floorCheckJson(const std::vector<FloorMean>& means);
std::vector<std::string> floorCheckLines(const std::vector<FloorMean>& means);

}  // namespace ratchet_sieve
