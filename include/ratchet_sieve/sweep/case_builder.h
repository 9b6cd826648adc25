#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// One run of a sweep.
struct SweepCase
{
  std::uint64_t position = 0;  ///< in the sweep, from 0
  SceneDefinition scene;       ///< its seed included
  std::vector<std::string> warnings;
  std::vector<std::optional<std::string>>
      values;  ///< of Sweep::keys(), YAML text; nothing where a scene has none
};

/// Works out the cases of a sweep, one after the other; those that differ in their seed alone at no cost. One
/// to a thread.
class CaseBuilder
{
public:
  /// @throws SceneError where the scene is no YAML @pre `sweep` lives as long
  explicit CaseBuilder(const Sweep& sweep);

  /// The one at a position, until at() is called again. @throws SceneError that names it, where its scene is
  /// illegal
  const SweepCase& at(std::uint64_t position);

  /// `base.inclination=0.1 density=2 seed=3`, of a case as it stands in the file.
  std::string name(std::uint64_t position) const;

private:
  void build(std::uint64_t point);

  const Sweep& sweep_;
  std::vector<std::string> keys_;
  YAML::Node base_;
  std::optional<std::uint64_t> point_;
  std::uint64_t own_seed_ = 0;  ///< of the point's scene
  SweepCase case_;
};

}  // namespace ratchet_sieve
