#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/live/sensors.h"
#include "ratchet_sieve/recording/stride.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// Asks Python whether a signal, such as Ctrl-C, wants the caller to stop. Python acts on signals in its main
/// thread alone. Used by the thread that made it.
class SignalWatch
{
public:
  /// At most fifty times a second, because it takes Python's lock. @pre that lock is not held
  bool stopWanted();

  /// Calls a function of Python. Where it raises, the caller is to stop; then it is not called again. @pre
  /// that lock is not held
  template <typename... Arguments>
  void call(const pybind11::object& function, const Arguments&... arguments)
  {
    if (stop_wanted_)
      return;
    const pybind11::gil_scoped_acquire held;
    try
    {
      function(arguments...);
    }
    catch (pybind11::error_already_set& error)
    {
      error.restore();
      stop_wanted_ = true;
    }
  }

  /// Raises the error of the signal's handler or of such a function, if there is one. @pre Python's lock is
  /// held
  void raise() const;

private:
  std::chrono::steady_clock::time_point next_;
  bool stop_wanted_ = false;
};

/// The sensors of rs.env. @param start_time [s] @throws SceneError
std::vector<Sensor> sensorsFromText(const std::string& yaml, const SceneDefinition& scene, double start_time);

/// A simulation that Python holds: one thread at a time uses it.
class RunningSimulation
{
public:
  /// Pours the disks, with Python's lock let go. @throws as Simulation
  RunningSimulation(std::shared_ptr<Scene> scene, double start_time);
  RunningSimulation(std::shared_ptr<Scene> scene, std::string_view saved_state);

  /// The exclusive use of a simulation while this exists.
  class Use
  {
  public:
    /// @throws std::runtime_error while another thread uses it
    explicit Use(RunningSimulation& of);
    ~Use() { of_.in_use_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    Simulation* operator->() { return of_.simulation_.get(); }
    Simulation& operator*() { return *of_.simulation_; }

  private:
    RunningSimulation& of_;
  };

  const std::shared_ptr<Scene>& scene() const { return scene_; }

  /// New setpoints by the names of their quantities, in SI units. All are checked before the first one is
  /// taken. @throws std::invalid_argument a name that is none, a value that is not legal
  void command(const std::map<std::string, double>& setpoints);

  /// @throws std::invalid_argument a rate that is not legal
  void setSlewRates(const SlewRates& rates);

  /// Pours more disks, with Python's lock let go; a signal cancels it. @throws as Simulation
  void pour(std::size_t species, std::size_t count, const std::optional<std::pair<double, double>>& between);

  /// Sensors that read from now on. Takes the observer of exits. @param sensors YAML @throws SceneError
  void sense(const std::string& sensors);

  /// What each sensor sent last, one after the other: kg, disks of each species, or disks; zeros before.
  std::vector<double> sensed() const;

  /// Advances until `stop_wanted`, which is asked every few hundredths of a second. The simulation then
  /// stands at an earlier time and may be used as before. @pre Python's lock is let go @throws StallError
  void advanceTo(double time, const std::function<bool()>& stop_wanted);

private:
  std::shared_ptr<Scene> scene_;
  std::unique_ptr<Simulation> simulation_;
  std::atomic<bool> in_use_{false};
  Stride stride_;
  std::vector<Sensor> sensors_;
};

}  // namespace ratchet_sieve
