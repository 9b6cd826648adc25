#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/sweep/result_store.h"
#include "ratchet_sieve/sweep/sweep.h"

namespace ratchet_sieve
{

/// How far a sweep is, and what else the results file knows of its cases.
struct SweepCounts
{
  std::uint64_t cases = 0;  ///< different ones
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t other_physics = 0;  ///< results of these cases of other versions of the physics

  std::uint64_t open() const { return cases - done - failed; }
};

struct BestCase
{
  std::uint64_t position = 0;
  double quality = 0.0;
};

/// The cases of one sweep, as a results file lists them: position and runHash(), each case once.
class SweepPlan
{
public:
  /// The plan that the file has, if it is complete.
  static std::optional<SweepPlan> find(Database& database, const Sweep& sweep);

  /// Writes down the list of all cases. Nothing where `stop_wanted`. @pre requireLegal() @throws
  /// DatabaseError
  static std::optional<SweepPlan> make(Database& database, const Sweep& sweep,
                                       const std::function<bool()>& stop_wanted);

  std::int64_t id() const { return id_; }

  SweepCounts counts(Database& database) const;

  /// The case of the highest Q so far, if there is a Q.
  std::optional<BestCase> best(const ResultStore& store) const;

  /// Cases that another sweep has run lack the values of keys that only this one sweeps: they get them.
  void fillValues(ResultStore& store, const Sweep& sweep) const;

  /// Takes out the rows of cases that failed, so that they are run again. @return how many
  std::int64_t removeFailed(Database& database) const;

private:
  explicit SweepPlan(std::int64_t id) : id_(id) {}
  std::int64_t id_;
};

/// Sees that each case is legal. @throws SceneError that names the first that is not
void requireLegal(const Sweep& sweep);

}  // namespace ratchet_sieve
