#include "ratchet_sieve/sweep/sweep_ledger.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_run.h"
#include "ratchet_sieve/sweep/work_directory.h"

namespace ratchet_sieve
{
namespace
{

/// Interval between two scans of all results, at least ...
constexpr auto BETWEEN_LOOKS = std::chrono::seconds(1);
/// ... and at least this many times the duration of a scan.
constexpr int TIMES_A_LOOK = 50;

constexpr const char* DEADLY =
    "the process that ran it died twice: it crashed or was killed, as where memory is short";

const std::string WITHOUT_RESULT =
    "AND NOT EXISTS (SELECT 1 FROM cases c WHERE c.run_hash = p.run_hash AND c.physics = ?2) ";

}  // namespace

SweepLedger::SweepLedger(const Sweep& sweep, ResultStore& store, const SweepPlan& plan)
    : sweep_(sweep),
      store_(store),
      plan_(plan),
      open_(store.database(),
            "SELECT position, run_hash FROM plan p WHERE sweep = ?1 AND position >= ?3 " + WITHOUT_RESULT +
                "AND NOT EXISTS (SELECT 1 FROM deaths d WHERE d.run_hash = p.run_hash AND d.physics = ?2) "
                "ORDER BY position LIMIT ?4"),
      suspect_(store.database(),
               "SELECT position, p.run_hash FROM deaths d CROSS JOIN plan p ON p.run_hash = d.run_hash "
               "WHERE sweep = ?1 AND d.physics = ?2 " +
                   WITHOUT_RESULT + "ORDER BY position LIMIT 1"),
      begin_(store.database(), "INSERT INTO under_way (run_hash, physics) VALUES (?, ?)"),
      end_(store.database(), "DELETE FROM under_way WHERE run_hash = ? AND physics = ?"),
      forgive_(store.database(), "DELETE FROM deaths WHERE run_hash = ? AND physics = ?")
{
  const SweepCounts counts = plan_.counts(store_.database());
  progress_.cases = counts.cases;
  progress_.done = counts.done;
  progress_.failed = counts.failed;
}

std::vector<std::uint64_t> SweepLedger::exchange(const std::vector<CaseResult>& results, std::size_t wanted)
{
  std::vector<std::uint64_t> positions;
  try
  {
    Transaction transaction(store_.database());
    for (const CaseResult& result : results)
    {
      store_.record(result);
      end_.bind(1, result.run_hash).bind(2, PHYSICS_VERSION).run();
      forgive_.bind(1, result.run_hash).bind(2, PHYSICS_VERSION).run();
    }
    if (wanted > 0)
      positions = begin(wanted);
    transaction.commit();
  }
  catch (const DatabaseError&)
  {
    store_.forgetColumns();
    throw;
  }
  progress_.finished_here += results.size();
  for (const CaseResult& result : results)
    ++(result.error.empty() ? progress_.done : progress_.failed);
  return positions;
}

std::vector<std::uint64_t> SweepLedger::begin(std::size_t most)
{
  open_.bind(1, plan_.id()).bind(2, PHYSICS_VERSION).bind(3, cursor_);
  std::vector<std::uint64_t> positions = begin(open_.bind(4, static_cast<std::int64_t>(most)));
  if (!positions.empty())
    cursor_ = static_cast<std::int64_t>(positions.back()) + 1;
  else if (!runsSuspect())
    return begin(suspect_.bind(1, plan_.id()).bind(2, PHYSICS_VERSION));
  return positions;
}

/// Begins the cases that a statement selects.
std::vector<std::uint64_t> SweepLedger::begin(Statement& select)
{
  std::vector<std::uint64_t> positions;
  std::vector<std::string> hashes;
  while (select.step())
  {
    positions.push_back(static_cast<std::uint64_t>(select.integer(0)));
    hashes.push_back(select.text(1));
  }
  select.reset();
  for (const std::string& hash : hashes)
    begin_.bind(1, hash).bind(2, PHYSICS_VERSION).run();
  return positions;
}

/// Whether a suspect is under way. It is none any more if it has written a checkpoint since.
bool SweepLedger::runsSuspect()
{
  std::string hash;
  std::string place;
  Statement select(store_.database(),
                   "SELECT run_hash, place FROM deaths JOIN under_way USING (run_hash, physics) "
                   "WHERE physics = ?");
  if (select.bind(1, PHYSICS_VERSION).step())
  {
    hash = select.text(0);
    place = select.text(1);
  }
  select.reset();
  if (hash.empty() || placeOf(hash) == place)
    return !hash.empty();
  forgive_.bind(1, hash).bind(2, PHYSICS_VERSION).run();
  return false;
}

/// How far a case has come: the time of its checkpoint's file, empty if there is none.
std::string SweepLedger::placeOf(const std::string& run_hash) const
{
  std::error_code error;
  const auto written =
      std::filesystem::last_write_time(checkpointPath(store_.database().path(), run_hash), error);
  return error ? "" : std::to_string(written.time_since_epoch().count());
}

std::string SweepLedger::recordDeaths()
{
  std::vector<CaseResult> results;
  std::string text;
  CaseBuilder builder(sweep_);
  for (const std::uint64_t position : countDeaths())
  {
    results.push_back(resultFor(builder.at(position)));
    results.back().error = DEADLY;
    text += fmt::format("{}case {} ({})", text.empty() ? "" : ", ", position + 1, builder.name(position));
  }
  if (results.empty())
    return "";
  exchange(results, 0);
  return text + " failed: " + DEADLY;
}

/// @return the positions of those cases that were suspect before
std::vector<std::uint64_t> SweepLedger::countDeaths()
{
  Transaction transaction(store_.database());
  Statement select(store_.database(),
                   "SELECT p.position, u.run_hash, d.place FROM under_way u JOIN plan p ON p.sweep = ?1 AND "
                   "p.run_hash = u.run_hash LEFT JOIN deaths d ON d.run_hash = u.run_hash AND "
                   "d.physics = u.physics WHERE u.physics = ?2");
  Statement insert(store_.database(),
                   "INSERT OR REPLACE INTO deaths (run_hash, physics, place) VALUES (?, ?, ?)");
  std::vector<std::uint64_t> deadly;
  select.bind(1, plan_.id()).bind(2, PHYSICS_VERSION);
  while (select.step())
  {
    const std::string hash = select.text(1);
    const std::string place = placeOf(hash);
    if (!select.isNull(2) && select.text(2) == place)
      deadly.push_back(static_cast<std::uint64_t>(select.integer(0)));
    insert.bind(1, hash).bind(2, PHYSICS_VERSION).bind(3, place).run();
  }
  store_.database().execute("DELETE FROM under_way");
  transaction.commit();
  return deadly;
}

void SweepLedger::forgetUnfinished()
{
  Transaction transaction(store_.database());
  store_.database().execute("DELETE FROM under_way");
  transaction.commit();
}

SweepProgress SweepLedger::progress(std::uint64_t running, const BestCriteria& criteria)
{
  progress_.running = running;
  progress_.wall = std::chrono::duration<double>(Clock::now() - start_).count();
  lookAtResults(criteria);
  return progress_;
}

void SweepLedger::lookAtResults(const BestCriteria& criteria)
{
  const Clock::time_point begin = Clock::now();
  if (begin < next_look_)
    return;
  progress_.warned = plan_.warnings(store_).warned();
  progress_.best = bestSetting(store_, plan_, sweep_, criteria);
  const Clock::time_point end = Clock::now();
  next_look_ = end + std::max<Clock::duration>(BETWEEN_LOOKS, TIMES_A_LOOK * (end - begin));
}

}  // namespace ratchet_sieve
