#include "ratchet_sieve/sweep/case_claims.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <regex>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ratchet_sieve/core/physics_version.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* PREFIX = "owner-";

std::string newName()
{
  std::random_device device;
  char name[48];
  std::snprintf(name, sizeof name, "%s%ld-%08x%08x%s", PREFIX, static_cast<long>(getpid()), device(),
                device(), OwnerLock::EXTENSION);
  return name;
}

/// Whether newName() can have produced it: names are read from a results file and become paths.
bool isOwnerName(const std::string& name)
{
  static const std::regex FORM(std::string(PREFIX) + "[0-9]{1,20}-[0-9a-f]{16}" + OwnerLock::EXTENSION);
  return std::regex_match(name, FORM);
}

std::string processOf(const std::string& owner)
{
  const std::size_t first = std::strlen(PREFIX);
  return owner.substr(first, owner.find('-', first) - first);
}

/// Whether the descriptor still is the file at the path: another process may have removed a lock file before
/// it was locked.
bool isThere(const std::string& path, int descriptor)
{
  struct stat named;
  struct stat opened;
  return stat(path.c_str(), &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino;
}

/// Calls `act` while no other process can take the lock at that path. @return whether no process holds it, or
/// there is none
template <typename Act>
bool whereNobodyHolds(const std::string& path, Act&& act)
{
  // Opened for reading and with a shared lock: there may be no write permission, and others may check at the
  // same time.
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0)
    return errno == ENOENT;
  const bool is_free = flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  if (is_free)
    act(path);
  close(descriptor);
  return is_free;
}

const std::string IS_OPEN =
    "AND NOT EXISTS (SELECT 1 FROM cases c WHERE c.run_hash = p.run_hash AND c.physics = ?2) "
    "AND NOT EXISTS (SELECT 1 FROM claims k WHERE k.run_hash = p.run_hash AND k.physics = ?2) ";

std::vector<std::pair<std::string, std::uint64_t>> claimsByOwner(const Database& database,
                                                                 const SweepPlan& plan)
{
  Statement select(
      database,
      "SELECT owner, COUNT(*) FROM claims k JOIN plan p ON p.sweep = ?1 AND p.run_hash = k.run_hash "
      "WHERE physics = ?2 GROUP BY owner");
  select.bind(1, plan.id()).bind(2, PHYSICS_VERSION);
  std::vector<std::pair<std::string, std::uint64_t>> owners;
  while (select.step())
    owners.emplace_back(select.text(0), static_cast<std::uint64_t>(select.integer(1)));
  return owners;
}

}  // namespace

const std::string& checkpointEnding()
{
  static const std::string ENDING = ".physics" + std::to_string(PHYSICS_VERSION) + ".checkpoint";
  return ENDING;
}

std::string checkpointPath(const std::string& directory, const std::string& run_hash)
{
  return directory + '/' + run_hash + checkpointEnding();
}

OwnerLock::OwnerLock(const std::string& directory) : directory_(directory), name_(newName())
{
  const std::string path = directory_ + '/' + name_;
  do
  {
    if (descriptor_ >= 0)
      close(descriptor_);
    std::error_code ignored;  // another process, the last one, may have removed it
    std::filesystem::create_directories(directory_, ignored);
    descriptor_ = open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor_ < 0 || flock(descriptor_, LOCK_EX) != 0)
      throw DatabaseError(path + ": cannot be locked: " + std::strerror(errno));
  } while (!isThere(path, descriptor_));
}

OwnerLock::~OwnerLock()
{
  unlink((directory_ + '/' + name_).c_str());
  close(descriptor_);
}

bool OwnerLock::isGone(const std::string& directory, const std::string& name)
{
  return !isOwnerName(name) || whereNobodyHolds(directory + '/' + name, [](const std::string&) {});
}

void OwnerLock::removeGone(const std::string& directory)
{
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error))
    if (isOwnerName(entry->path().filename().string()))
      whereNobodyHolds(entry->path().string(), [](const std::string& path) { unlink(path.c_str()); });
}

CaseClaims::CaseClaims(Database& database, const SweepPlan& plan, const std::string& directory)
    : database_(database),
      directory_(directory),
      lock_(directory),
      plan_(plan),
      select_(database,
              "SELECT position, run_hash FROM plan p WHERE sweep = ?1 AND position >= ?3 " + IS_OPEN +
                  "AND NOT EXISTS (SELECT 1 FROM deaths d WHERE d.run_hash = p.run_hash AND d.physics = ?2) "
                  "ORDER BY position LIMIT ?4"),
      select_suspect_(
          database,
          "SELECT position, p.run_hash FROM deaths d CROSS JOIN plan p ON p.run_hash = d.run_hash "
          "WHERE sweep = ?1 AND d.physics = ?2 " +
              IS_OPEN + "ORDER BY position LIMIT 1"),
      claim_(database, "INSERT INTO claims (run_hash, physics, owner) VALUES (?, ?, ?)"),
      release_(database, "DELETE FROM claims WHERE run_hash = ? AND physics = ? AND owner = ?"),
      forgive_(database, "DELETE FROM deaths WHERE run_hash = ? AND physics = ?")
{
}

std::vector<std::uint64_t> CaseClaims::take(std::size_t most)
{
  std::vector<std::uint64_t> positions = search(most);
  if (positions.empty() && cursor_ > 0)
  {
    cursor_ = 0;
    positions = search(most);
  }
  return positions.empty() ? searchSuspect() : positions;
}

std::vector<std::uint64_t> CaseClaims::search(std::size_t most)
{
  select_.bind(1, plan_.id())
      .bind(2, PHYSICS_VERSION)
      .bind(3, cursor_)
      .bind(4, static_cast<std::int64_t>(most));
  std::vector<std::uint64_t> positions = claim(select_);
  if (!positions.empty())
    cursor_ = static_cast<std::int64_t>(positions.back()) + 1;
  return positions;
}

std::vector<std::uint64_t> CaseClaims::searchSuspect()
{
  if (runsSuspect())
    return {};
  return claim(select_suspect_.bind(1, plan_.id()).bind(2, PHYSICS_VERSION));
}

/// Claims the cases that a statement selects.
std::vector<std::uint64_t> CaseClaims::claim(Statement& select)
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
    claim_.bind(1, hash).bind(2, PHYSICS_VERSION).bind(3, lock_.name()).run();
  return positions;
}

/// Whether a case of this process is suspect. It is not any more if it has written a checkpoint since.
bool CaseClaims::runsSuspect()
{
  Statement select(database_,
                   "SELECT d.run_hash, place FROM deaths d JOIN claims k USING (run_hash, physics) "
                   "WHERE physics = ? AND owner = ?");
  select.bind(1, PHYSICS_VERSION).bind(2, lock_.name());
  std::string hash;
  std::string place;
  for (; select.step(); hash = select.text(0), place = select.text(1))
  {
  }
  if (hash.empty() || placeOf(hash) == place)
    return !hash.empty();
  forgive_.bind(1, hash).bind(2, PHYSICS_VERSION).run();
  return false;
}

/// How far a case has come: the time of its checkpoint's file, empty if there is none.
std::string CaseClaims::placeOf(const std::string& run_hash) const
{
  std::error_code error;
  const auto written = std::filesystem::last_write_time(checkpointPath(directory_, run_hash), error);
  return error ? "" : std::to_string(written.time_since_epoch().count());
}

std::vector<std::uint64_t> CaseClaims::countDeaths()
{
  Transaction transaction(database_);
  std::vector<std::uint64_t> deadly;
  for (const auto& [owner, cases] : claimsByOwner(database_, plan_))
    if (owner != lock_.name() && OwnerLock::isGone(directory_, owner))
      countDeaths(owner, deadly);
  transaction.commit();
  return deadly;
}

void CaseClaims::countDeaths(const std::string& owner, std::vector<std::uint64_t>& deadly)
{
  Statement select(database_,
                   "SELECT p.position, k.run_hash, d.place FROM claims k JOIN plan p ON p.sweep = ?1 AND "
                   "p.run_hash = k.run_hash LEFT JOIN deaths d ON d.run_hash = k.run_hash AND "
                   "d.physics = k.physics WHERE k.physics = ?2 AND owner = ?3");
  Statement insert(database_, "INSERT OR REPLACE INTO deaths (run_hash, physics, place) VALUES (?, ?, ?)");
  select.bind(1, plan_.id()).bind(2, PHYSICS_VERSION).bind(3, owner);
  while (select.step())
  {
    const std::string hash = select.text(1);
    const std::string place = placeOf(hash);
    if (!select.isNull(2) && select.text(2) == place)
      deadly.push_back(static_cast<std::uint64_t>(select.integer(0)));
    insert.bind(1, hash).bind(2, PHYSICS_VERSION).bind(3, place).run();
  }
  Statement(database_, "DELETE FROM claims WHERE owner = ?").bind(1, owner).run();
}

void CaseClaims::release(const std::string& run_hash)
{
  release_.bind(1, run_hash).bind(2, PHYSICS_VERSION).bind(3, lock_.name()).run();
  forgive_.bind(1, run_hash).bind(2, PHYSICS_VERSION).run();
}

void CaseClaims::releaseAll()
{
  Transaction transaction(database_);
  Statement(database_, "DELETE FROM claims WHERE owner = ?").bind(1, lock_.name()).run();
  transaction.commit();
}

std::uint64_t CaseClaims::freeAbandoned()
{
  Transaction transaction(database_);
  std::uint64_t held = 0;
  for (const auto& [owner, cases] : claimsByOwner(database_, plan_))
  {
    if (owner == lock_.name())
      continue;
    if (!OwnerLock::isGone(directory_, owner))
    {
      held += cases;
      continue;
    }
    Statement(database_, "DELETE FROM claims WHERE owner = ?").bind(1, owner).run();
  }
  transaction.commit();
  return held;
}

void CaseClaims::requireNone() const
{
  Statement select(database_, "SELECT 1 FROM claims WHERE owner = ?");
  if (select.bind(1, lock_.name()).step())
    throw DatabaseError(database_.path() +
                        ": lists other cases than the sweep has: remove it, or use another with --db");
}

void CaseClaims::sayOthers(const std::function<void(const std::string&)>& say)
{
  for (const auto& [owner, cases] : claimsByOwner(database_, plan_))
    if (owner != lock_.name() && !OwnerLock::isGone(directory_, owner) && said_.insert(owner).second && say)
      say("process " + processOf(owner) + " also runs this sweep (cases: " + std::to_string(cases) +
          "); waiting for it");
}

std::uint64_t casesUnderWay(const Database& database, const SweepPlan& plan, const std::string& directory)
{
  std::uint64_t cases = 0;
  for (const auto& [owner, claimed] : claimsByOwner(database, plan))
    if (!OwnerLock::isGone(directory, owner))
      cases += claimed;
  return cases;
}

}  // namespace ratchet_sieve
