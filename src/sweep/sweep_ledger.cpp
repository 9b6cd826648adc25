#include "ratchet_sieve/sweep/sweep_ledger.h"

#include <chrono>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* DEADLY =
    "the process that ran it died twice: it crashed or was killed, as where memory is short";

constexpr std::int64_t NO_MORE = std::numeric_limits<std::int64_t>::max();

/// The first case from ?2 on that is no suspect of the physics ?1, and has no result.
constexpr const char* NEXT =
    "SELECT CAST(position AS INTEGER) FROM plan WHERE position >= ?2 AND run_hash NOT IN "
    "(SELECT run_hash FROM deaths WHERE physics = ?1) "
    "AND NOT EXISTS (SELECT 1 FROM cases c WHERE c.run_hash = plan.run_hash AND physics = ?1) "
    "ORDER BY position LIMIT 1";

/// The first suspect without a result.
constexpr const char* NEXT_SUSPECT =
    "SELECT CAST(MIN(position) AS INTEGER) FROM deaths JOIN plan USING (run_hash) WHERE physics = ?1 "
    "AND NOT EXISTS (SELECT 1 FROM cases c WHERE c.run_hash = plan.run_hash AND physics = ?1)";

}  // namespace

std::string workDirectory(const std::string& results)
{
  return linkTarget(results) + ".d";
}

const std::string& checkpointEnding()
{
  static const std::string ENDING = ".physics" + std::to_string(PHYSICS_VERSION) + ".checkpoint";
  return ENDING;
}

std::string checkpointPath(const std::string& results, const std::string& run_hash)
{
  return workDirectory(results) + '/' + run_hash + checkpointEnding();
}

SweepLedger::SweepLedger(const Sweep& sweep, SweepResults& results) : results_(results)
{
  static_cast<SweepCounts&>(progress_) = results.counts();
  progress_.warned = results.warnings().warned();
  CaseBuilder builder(sweep);
  for (const std::uint64_t position : countDeaths())
  {
    CaseResult result = resultFor(builder.at(position));
    result.error = DEADLY;
    exchange(result, false);
    deaths_ +=
        fmt::format("{}case {} ({})", deaths_.empty() ? "" : ", ", position + 1, builder.name(position));
  }
  if (!deaths_.empty())
    deaths_ += std::string(" failed: ") + DEADLY;
}

std::optional<std::uint64_t> SweepLedger::exchange(const std::optional<CaseResult>& finished, bool begin_next)
{
  std::optional<std::uint64_t> position;
  Transaction transaction(results_.database());
  if (finished)
  {
    results_.record(*finished);
    results_.database().execute("DELETE FROM under_way WHERE run_hash = ? AND physics = ?",
                                {finished->run_hash, PHYSICS_VERSION});
    forgive(finished->run_hash);
  }
  if (begin_next)
    position = begin();
  transaction.commit();
  if (finished)
  {
    ++progress_.finished_here;
    ++(finished->error.empty() ? progress_.done : progress_.failed);
    progress_.warned += finished->error.empty() && !finished->summary.at("warnings").empty() ? 1 : 0;
  }
  return position;
}

std::optional<std::uint64_t> SweepLedger::begin()
{
  Database& database = results_.database();
  nlohmann::ordered_json position = database.value(NEXT, {PHYSICS_VERSION, cursor_});
  cursor_ = position.is_null() ? NO_MORE : position.get<std::int64_t>() + 1;
  waits_ = position.is_null() && runsSuspect();
  if (position.is_null() && !waits_)
    position = database.value(NEXT_SUSPECT, {PHYSICS_VERSION});
  if (position.is_null())
    return std::nullopt;
  database.execute("INSERT INTO under_way SELECT run_hash, ? FROM plan WHERE position = ?",
                   {PHYSICS_VERSION, position});
  return position.get<std::uint64_t>();
}

/// Whether a suspect is under way. It is none any more if it has written a checkpoint since.
bool SweepLedger::runsSuspect()
{
  Statement select(results_.database(),
                   "SELECT run_hash, place FROM deaths JOIN under_way USING (run_hash, physics) "
                   "WHERE physics = ?",
                   {PHYSICS_VERSION});
  if (!select.step())
    return false;
  const std::string run_hash = select.text(0);
  if (placeOf(run_hash) == select.text(1))
    return true;
  forgive(run_hash);
  return false;
}

void SweepLedger::forgive(const std::string& run_hash)
{
  results_.database().execute("DELETE FROM deaths WHERE run_hash = ? AND physics = ?",
                              {run_hash, PHYSICS_VERSION});
}

/// How far a case has come: the time of its checkpoint's file, empty if there is none.
std::string SweepLedger::placeOf(const std::string& run_hash) const
{
  std::error_code error;
  const auto written =
      std::filesystem::last_write_time(checkpointPath(results_.database().path(), run_hash), error);
  return error ? "" : std::to_string(written.time_since_epoch().count());
}

/// @return the positions of those cases that were suspect before
std::vector<std::uint64_t> SweepLedger::countDeaths()
{
  Database& database = results_.database();
  Transaction transaction(database);
  Statement select(database,
                   "SELECT position, run_hash, place FROM under_way JOIN plan USING (run_hash) "
                   "LEFT JOIN deaths USING (run_hash, physics) WHERE physics = ?",
                   {PHYSICS_VERSION});
  std::vector<std::uint64_t> deadly;
  while (select.step())
  {
    const std::string place = placeOf(select.text(1));
    if (select.value(2) == place)
      deadly.push_back(static_cast<std::uint64_t>(select.integer(0)));
    database.execute("INSERT OR REPLACE INTO deaths (run_hash, physics, place) VALUES (?, ?, ?)",
                     {select.text(1), PHYSICS_VERSION, place});
  }
  database.execute("DELETE FROM under_way");
  transaction.commit();
  return deadly;
}

SweepProgress SweepLedger::progress() const
{
  SweepProgress progress = progress_;
  progress.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  progress.running = results_.database().value("SELECT COUNT(*) FROM under_way").get<std::uint64_t>();
  return progress;
}

}  // namespace ratchet_sieve
