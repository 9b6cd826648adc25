#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/sweep/case_result.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

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

}  // namespace ratchet_sieve
