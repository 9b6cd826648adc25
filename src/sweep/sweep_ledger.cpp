#include "ratchet_sieve/sweep/sweep_ledger.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/sweep/case.h"
#include "ratchet_sieve/sweep/database.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* LOCK = "/lock";

/// Of a whole file. Locks of open descriptions belong to no process: two in one process exclude each other as
/// well.
struct flock lockOf(short type)
{
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Whether the descriptor still is the file at the path: the last process may have removed it meanwhile.
bool isThere(const std::string& path, int descriptor)
{
  struct stat named;
  struct stat opened;
  return stat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino;
}

/// Interval between two scans of all results, at least ...
constexpr auto BETWEEN_LOOKS = std::chrono::seconds(1);
/// ... and at least this many times the duration of a scan.
constexpr int TIMES_A_LOOK = 50;

constexpr const char* DEADLY =
    "the process that ran it died twice: it crashed or was killed, as where memory is short";

const std::string WITHOUT_RESULT = "NOT EXISTS (SELECT 1 FROM results r WHERE r.run_hash = p.run_hash) ";

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

ResultsLock::ResultsLock(const std::string& results) : directory_(workDirectory(results))
{
  const std::string path = directory_ + LOCK;
  do
  {
    if (descriptor_ >= 0)
      close(descriptor_);
    std::error_code ignored;  // an open file says why
    std::filesystem::create_directories(directory_, ignored);
    descriptor_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    struct flock lock = lockOf(F_WRLCK);
    if (descriptor_ >= 0 && fcntl(descriptor_, F_OFD_SETLK, &lock) == 0)
      continue;
    const int reason = errno;
    if (descriptor_ >= 0)
      close(descriptor_);
    if (reason == EAGAIN)
      throw DatabaseError(results + ": another process runs a sweep into this file");
    throw DatabaseError(path + ": cannot be locked: " + std::strerror(reason));
  } while (!isThere(path, descriptor_));
}

ResultsLock::~ResultsLock()
{
  unlink((directory_ + LOCK).c_str());
  close(descriptor_);
  rmdir(directory_.c_str());
}

bool ResultsLock::isHeld(const std::string& results)
{
  const int descriptor = open((workDirectory(results) + LOCK).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  struct flock lock = lockOf(F_RDLCK);
  const bool is_held = fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
  close(descriptor);
  return is_held;
}

SweepLedger::SweepLedger(const Sweep& sweep, SweepResults& results)
    : sweep_(sweep),
      results_(results),
      open_(results.database(),
            "SELECT position, run_hash FROM plan p WHERE position >= ?1 AND " + WITHOUT_RESULT +
                "AND NOT EXISTS (SELECT 1 FROM deaths d WHERE d.run_hash = p.run_hash AND d.physics = ?2) "
                "ORDER BY position LIMIT ?3"),
      suspect_(results.database(),
               "SELECT position, p.run_hash FROM deaths d CROSS JOIN plan p ON p.run_hash = d.run_hash "
               "WHERE d.physics = ? AND " +
                   WITHOUT_RESULT + "ORDER BY position LIMIT 1"),
      begin_(results.database(), "INSERT INTO under_way (run_hash, physics) VALUES (?, ?)"),
      end_(results.database(), "DELETE FROM under_way WHERE run_hash = ? AND physics = ?"),
      forgive_(results.database(), "DELETE FROM deaths WHERE run_hash = ? AND physics = ?")
{
  static_cast<SweepCounts&>(progress_) = results.counts();
}

std::vector<std::uint64_t> SweepLedger::exchange(const std::vector<CaseResult>& results, std::size_t wanted)
{
  std::vector<std::uint64_t> positions;
  try
  {
    Transaction transaction(results_.database());
    for (const CaseResult& result : results)
    {
      results_.store().record(result);
      end_.run({result.run_hash, PHYSICS_VERSION});
      forgive_.run({result.run_hash, PHYSICS_VERSION});
    }
    if (wanted > 0)
      positions = begin(wanted);
    transaction.commit();
  }
  catch (const DatabaseError&)
  {
    results_.store().forgetColumns();
    throw;
  }
  progress_.finished_here += results.size();
  for (const CaseResult& result : results)
    ++(result.error.empty() ? progress_.done : progress_.failed);
  return positions;
}

std::vector<std::uint64_t> SweepLedger::begin(std::size_t most)
{
  open_.restart({cursor_, PHYSICS_VERSION, most});
  std::vector<std::uint64_t> positions = begin(open_);
  if (!positions.empty())
    cursor_ = static_cast<std::int64_t>(positions.back()) + 1;
  else if (!runsSuspect())
  {
    suspect_.restart({PHYSICS_VERSION});
    return begin(suspect_);
  }
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
  select.restart();
  for (const std::string& hash : hashes)
    begin_.run({hash, PHYSICS_VERSION});
  return positions;
}

/// Whether a suspect is under way. It is none any more if it has written a checkpoint since.
bool SweepLedger::runsSuspect()
{
  std::string hash;
  std::string place;
  Statement select(results_.database(),
                   "SELECT run_hash, place FROM deaths JOIN under_way USING (run_hash, physics) "
                   "WHERE physics = ?",
                   {PHYSICS_VERSION});
  if (select.step())
  {
    hash = select.text(0);
    place = select.text(1);
  }
  if (hash.empty() || placeOf(hash) == place)
    return !hash.empty();
  forgive_.run({hash, PHYSICS_VERSION});
  return false;
}

/// How far a case has come: the time of its checkpoint's file, empty if there is none.
std::string SweepLedger::placeOf(const std::string& run_hash) const
{
  std::error_code error;
  const auto written =
      std::filesystem::last_write_time(checkpointPath(results_.database().path(), run_hash), error);
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
  Transaction transaction(results_.database());
  Statement select(
      results_.database(),
      "SELECT p.position, u.run_hash, d.place FROM under_way u JOIN plan p USING (run_hash) "
      "LEFT JOIN deaths d ON d.run_hash = u.run_hash AND d.physics = u.physics WHERE u.physics = ?",
      {PHYSICS_VERSION});
  Statement insert(results_.database(),
                   "INSERT OR REPLACE INTO deaths (run_hash, physics, place) VALUES (?, ?, ?)");
  std::vector<std::uint64_t> deadly;
  while (select.step())
  {
    const std::string hash = select.text(1);
    const std::string place = placeOf(hash);
    if (select.value(2) == place)
      deadly.push_back(static_cast<std::uint64_t>(select.integer(0)));
    insert.run({hash, PHYSICS_VERSION, place});
  }
  results_.database().execute("DELETE FROM under_way");
  transaction.commit();
  return deadly;
}

void SweepLedger::forgetUnfinished()
{
  Transaction transaction(results_.database());
  results_.database().execute("DELETE FROM under_way");
  transaction.commit();
}

SweepProgress SweepLedger::progress(std::uint64_t running)
{
  progress_.running = running;
  progress_.wall = std::chrono::duration<double>(Clock::now() - start_).count();
  countWarnings();
  return progress_;
}

void SweepLedger::countWarnings()
{
  const Clock::time_point begin = Clock::now();
  if (begin < next_look_)
    return;
  progress_.warned = results_.warnings().warned();
  const Clock::time_point end = Clock::now();
  next_look_ = end + std::max<Clock::duration>(BETWEEN_LOOKS, TIMES_A_LOOK * (end - begin));
}

}  // namespace ratchet_sieve
