#include "ratchet_sieve/sweep/sweep_ledger.h"

#include <algorithm>

#include <fmt/format.h>

#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_run.h"

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

}  // namespace

SweepLedger::SweepLedger(const Sweep& sweep, ResultStore& store, const SweepPlan& plan,
                         const std::string& directory)
    : sweep_(sweep), store_(store), plan_(plan), claims_(store.database(), plan, directory)
{
  countOpen();
}

std::uint64_t SweepLedger::countOpen()
{
  const SweepCounts counts = plan_.counts(store_.database());
  progress_.cases = counts.cases;
  progress_.done = counts.done;
  progress_.failed = counts.failed;
  return counts.open();
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
      claims_.release(result.run_hash);
    }
    if (wanted > 0)
      positions = claims_.take(wanted);
    transaction.commit();
  }
  catch (const DatabaseError&)
  {
    store_.forgetColumns();
    throw;
  }
  count(results);
  return positions;
}

std::string SweepLedger::recordDeaths()
{
  const std::vector<std::uint64_t> deadly = claims_.countDeaths();
  if (deadly.empty())
    return "";
  std::vector<CaseResult> results;
  std::string text;
  CaseBuilder builder(sweep_);
  for (const std::uint64_t position : deadly)
  {
    results.push_back(resultFor(builder.at(position)));
    results.back().error = DEADLY;
    text += fmt::format("{}case {} ({})", text.empty() ? "" : ", ", position + 1, builder.name(position));
  }
  exchange(results, 0);
  return text + " failed: " + DEADLY;
}

void SweepLedger::count(const std::vector<CaseResult>& results)
{
  progress_.finished_here += results.size();
  for (const CaseResult& result : results)
    ++(result.error.empty() ? progress_.done : progress_.failed);
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
