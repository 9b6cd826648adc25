#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>
#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// The swept keys of a case and their values as YAML text; nothing for a key that its scene does not have.
using CaseValues = std::vector<std::pair<std::string, std::optional<std::string>>>;

/// The result of one case.
struct CaseResult
{
  std::string run_hash;    ///< runHash() of its scene
  std::string scene_hash;  ///< sceneHash() of it
  std::uint64_t seed = 0;
  CaseValues values;
  std::string error;       ///< reason of a failure; empty on success
  double wall_time = 0.0;  ///< of the process that completed it [s]
  std::string host;
  nlohmann::ordered_json summary;  ///< summarize(); null on failure
};

/// One column for each scalar of a summary. Its name is the key; nested keys are joined, as in
/// `collisions.apex` or `base_impulse.x`; values of a species have its name, as in `mean_vx.A`, and of
/// a size class its number as well, as in `size_classes.1.left.A`. In addition
/// `counted`, the number of disks that left; `warnings`, their number, and `warning_text`; `steady_reason`.
/// Not included: columns that the table has for every case, other texts, and species columns if there are
/// more than MOST_COLUMN_SPECIES species. If names differ only in case, all but the first in byte order get a
/// number: `mean_vx.a (2)`.
using SummaryColumns = std::vector<std::pair<std::string, nlohmann::ordered_json>>;
SummaryColumns summaryColumns(const nlohmann::ordered_json& summary);

constexpr std::size_t MOST_COLUMN_SPECIES = 32;

/// One run of a sweep.
struct SweepCase
{
  std::uint64_t position = 0;  ///< in the sweep, from 0
  SceneDefinition scene;       ///< including its seed
  std::vector<std::string> warnings;
  CaseValues values;  ///< of Sweep::keys()
};

/// Builds the cases of a sweep one after the other. Cases that differ only in their seed share their scene.
/// One instance per thread.
class CaseBuilder
{
public:
  /// @throws SceneError if the scene is not valid YAML @pre `sweep` outlives this
  explicit CaseBuilder(const Sweep& sweep);

  /// The case at a position; valid until the next call. @throws SceneError if its scene is illegal; the
  /// message names the case
  const SweepCase& at(std::uint64_t position);

  /// `base.inclination=0.1 density=2 seed=3`: a case with its values as in the file.
  std::string name(std::uint64_t position) const;

  /// The same without the seed. @param point index for Sweep::point()
  std::string settingName(std::uint64_t point) const;

private:
  void build(std::uint64_t point);

  const Sweep& sweep_;
  std::vector<std::string> keys_;
  YAML::Node base_;
  std::optional<std::uint64_t> point_;
  std::uint64_t own_seed_ = 0;  ///< of the setting's scene
  SweepCase case_;
};

/// Takes the frames of one case from its beginning.
struct CaseRecord
{
  std::unique_ptr<FrameSink> sink;
  FrameRates rates;
  std::function<void(const nlohmann::ordered_json& summary)> keep;  ///< called once the case has ended
};

/// Opens the record of a case; called by the thread that runs it.
using OpenRecord = std::function<CaseRecord(const SweepCase&)>;

/// How a case is run. Each function may be empty.
struct CaseRunOptions
{
  std::string checkpoint;  ///< checkpoint file: resumed if it exists, written periodically; empty: none
  double checkpoint_period = 60.0;                      ///< of wall time [s]
  std::function<bool()> stop_wanted;                    ///< polled several times a second
  std::function<void(const std::string&)> warn;         ///< called for problems that do not end the case
  OpenRecord record;                                    ///< @pre there is no checkpoint
  std::function<void(const CaseResult&)> take_stopped;  ///< takes what a run that is stopped has until then
};

/// A simulation at its beginning; nothing if it was stopped while its disks were placed.
std::optional<Simulation> poured(const SceneDefinition& scene, const std::function<bool()>& stop_wanted);

/// The result of a case that has not been run.
CaseResult resultFor(const SweepCase& sweep_case);

/// Runs a case to its end in this thread. Errors become part of the result.
/// @return nothing if it was stopped; its checkpoint then has its state
std::optional<CaseResult> runCase(const SweepCase& sweep_case, const CaseRunOptions& options);

}  // namespace ratchet_sieve
