#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/seeking/outflow.h"

namespace ratchet_sieve
{

enum class Measure
{
  QUALITY,    ///< Q, eq. (2) of the paper, of the pair of species with the highest
  PURITY,     ///< the species' share of its bin
  RECOVERY,   ///< the bin's share of what leaves of the species
  FLOW,       ///< of the species into the bin [1/s or kg/s]
  THROUGHPUT  ///< of all species into both bins [1/s or kg/s]
};

/// What a search maximises.
struct Goal
{
  Measure measure = Measure::QUALITY;
  std::string species;   ///< name; of purity, recovery and flow
  bool right = false;    ///< its bin; false: the left one
  bool by_mass = false;  ///< instead of by number

  /// Whether it is a share, in [0, 1], rather than a flow.
  bool isShare() const { return measure != Measure::FLOW && measure != Measure::THROUGHPUT; }
};

/// What goalFromText() reads.
constexpr const char* GOAL_FORMS =
    "quality, purity:SPECIES:BIN, recovery:SPECIES:BIN, flow:SPECIES:BIN or throughput, BIN left or right; "
    "all but "
    "quality may end in :mass";

/// Nothing for any other text.
std::optional<Goal> goalFromText(const std::string& text);

std::string goalText(const Goal& goal);

/// A number with its standard error from the number of disks; both 0 if it is undefined.
struct Measured
{
  double value = 0.0;
  double error = 0.0;
  bool defined = false;
};

/// Undefined where nothing is counted that it is a share of, or the sieve has no such species.
Measured measured(const Goal& goal, const Outflow& outflow);

}  // namespace ratchet_sieve
