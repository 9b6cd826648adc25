#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "ratchet_sieve/core/observable.h"
#include "state/observer.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Something of each species in each of the two bins.
template <typename Value>
class PerBin
{
public:
  explicit PerBin(std::size_t species) { bins_.fill(std::vector<Value>(species)); }

  /// @pre the disk left into a bin
  Value& of(const Departure& departure)
  {
    return bins_[departure.exit == Exit::RIGHT_BIN ? 1 : 0][departure.species];
  }

  void reset() { bins_.fill(std::vector<Value>(bins_[0].size())); }

  template <typename Visit>
  void forEach(Visit&& visit)
  {
    for (std::vector<Value>& bin : bins_)
      for (Value& value : bin)
        visit(value);
  }

  /// A row of each: the left bin first. row(value) -> ObservedRow
  template <typename Row>
  Observed observed(const char* name, const SystemState& system, Row&& row) const
  {
    Observed result{name, {}};
    for (std::size_t bin = 0; bin < bins_.size(); ++bin)
      for (std::size_t s = 0; s < bins_[bin].size(); ++s)
      {
        result.rows.push_back(row(bins_[bin][s]));
        result.rows.back().place = bin == 0 ? "left" : "right";
        result.rows.back().species = system.scene().species[s].name;
      }
    return result;
  }

  void archive(StateArchive& state) { state(bins_); }

private:
  std::array<std::vector<Value>, 2> bins_;  ///< left, right; per species
};

}  // namespace ratchet_sieve
