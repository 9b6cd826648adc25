#include "ratchet_sieve/sweep/best_setting.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/estimates.h"
#include "ratchet_sieve/scene/parsed.h"
#include "ratchet_sieve/sweep/case_builder.h"

namespace ratchet_sieve
{
namespace
{

/// The column of the number of disks that left. Older rows lack it; their number comes from the summary.
std::string countedColumn(const ResultStore& store)
{
  const std::string from_summary =
      "(SELECT SUM(json_extract(value, '$.left') + json_extract(value, '$.right')) FROM json_each(c.summary, "
      "'$.species'))";
  return store.hasColumn("counted") ? "COALESCE(c.counted, " + from_summary + ")" : from_summary;
}

bool areEqual(const std::string& a, const std::string& b)
{
  const std::optional<double> number = parsed<double>(a);
  return a == b || (number && number == parsed<double>(b));
}

bool fulfils(const SweepCase& setting, const std::vector<Assignment>& where)
{
  const auto fits = [&setting](const Assignment& wanted)
  {
    return std::any_of(setting.values.begin(), setting.values.end(),
                       [&wanted](const auto& own) {
                         return own.first == wanted.key && own.second && areEqual(*own.second, wanted.value);
                       });
  };
  return std::all_of(where.begin(), where.end(), fits);
}

/// The settings whose seeds are all completed and that meet the criteria, best first.
constexpr const char* RANKED =
    "SELECT p.position / ?3 AS point, ABS(AVG(c.separation) FILTER (WHERE c.status = 'done')) AS mean "
    "FROM plan p LEFT JOIN cases c ON c.run_hash = p.run_hash AND c.physics = ?2 WHERE p.sweep = ?1 "
    "GROUP BY point HAVING COUNT(*) = COUNT(c.status) AND mean IS NOT NULL "
    "AND AVG(COALESCE(c.processed, 0)) FILTER (WHERE c.status = 'done') >= ?4 "
    "AND AVG(COALESCE({}, 0)) FILTER (WHERE c.status = 'done') >= ?5 ORDER BY mean DESC, point";

bool hasSeparation(const ResultStore& store, const SweepPlan& plan)
{
  Statement select(store.database(),
                   "SELECT 1 FROM plan p JOIN cases c ON c.run_hash = p.run_hash WHERE p.sweep = ?1 "
                   "AND c.physics = ?2 AND c.separation IS NOT NULL LIMIT 1");
  return select.bind(1, plan.id()).bind(2, PHYSICS_VERSION).step();
}

constexpr double CONFIDENCE_OF_SEPARATION = 0.95;

}  // namespace

double SettingMean::quality() const
{
  return std::abs(separation);
}

std::optional<bool> SettingMean::separated() const
{
  if (!error)
    return std::nullopt;
  return quality() > halfWidthOver(CONFIDENCE_OF_SEPARATION, seeds) * *error;
}

std::optional<SettingMean> meanOfSetting(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                                         std::uint64_t point)
{
  Statement select(store.database(),
                   "SELECT c.separation, COALESCE(c.processed, 0.0), COALESCE(" + countedColumn(store) +
                       ", 0) FROM plan p JOIN cases c ON c.run_hash = p.run_hash WHERE p.sweep = ?1 "
                       "AND c.physics = ?2 AND c.status = 'done' AND p.position BETWEEN ?3 AND ?4");
  const auto first = static_cast<std::int64_t>(point * sweep.seedCount());
  const auto last = first + static_cast<std::int64_t>(sweep.seedCount()) - 1;
  select.bind(1, plan.id()).bind(2, PHYSICS_VERSION).bind(3, first).bind(4, last);
  SettingMean mean;
  mean.point = point;
  std::vector<double> separations;
  double rows = 0.0;
  for (; select.step(); ++rows)
  {
    if (!select.isNull(0))
      separations.push_back(select.real(0));
    mean.processed += select.real(1);
    mean.counted += select.real(2);
  }
  if (separations.empty())
    return std::nullopt;
  mean.processed /= rows;
  mean.counted /= rows;
  mean.seeds = separations.size();
  const auto count = static_cast<double>(separations.size());
  for (const double separation : separations)
    mean.separation += separation / count;
  double squares = 0.0;
  for (const double separation : separations)
    squares += (separation - mean.separation) * (separation - mean.separation);
  if (separations.size() > 1)
    mean.error = std::sqrt(squares / (count - 1.0) / count);
  return mean;
}

std::optional<SettingMean> bestSetting(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                                       const BestCriteria& criteria)
{
  if (!store.hasColumn("separation"))
    return std::nullopt;
  Statement select(store.database(), fmt::format(RANKED, countedColumn(store)));
  select.bind(1, plan.id())
      .bind(2, PHYSICS_VERSION)
      .bind(3, static_cast<std::int64_t>(sweep.seedCount()))
      .bind(4, criteria.least_processed)
      .bind(5, criteria.least_counted);
  CaseBuilder builder(sweep);
  while (select.step())
  {
    const auto point = static_cast<std::uint64_t>(select.integer(0));
    if (criteria.where.empty() || fulfils(builder.at(point * sweep.seedCount()), criteria.where))
      return meanOfSetting(store, plan, sweep, point);
  }
  return std::nullopt;
}

std::vector<std::string> keysAtEdge(const Sweep& sweep, std::uint64_t point,
                                    const std::vector<Assignment>& where)
{
  std::vector<std::string> at_edge;
  for (const Axis& axis : sweep.axes)
  {
    std::map<std::string, std::set<std::optional<double>>> values;
    for (std::uint64_t k = 0; k < axis.size; ++k)
      for (const Assignment& assignment : axis.at(k))
        values[assignment.key].insert(parsed<double>(assignment.value));
    for (const Assignment& own : sweep.point(point))
    {
      const auto found = values.find(own.key);
      const bool is_fixed = std::any_of(where.begin(), where.end(),
                                        [&own](const Assignment& wanted) { return wanted.key == own.key; });
      if (is_fixed || found == values.end() || found->second.size() < 3 ||
          found->second.count(std::nullopt) > 0)
        continue;
      const std::optional<double> value = parsed<double>(own.value);
      if (value == *found->second.begin() || value == *found->second.rbegin())
        at_edge.push_back(own.key);
    }
  }
  return at_edge;
}

std::string meanText(const SettingMean& mean)
{
  const std::string error = mean.error ? fmt::format(" +- {:.3f}", *mean.error) : "";
  return fmt::format("{:.3f}{} over {}{}, P {:.2f}, {} counted", mean.quality(), error,
                     countText(mean.seeds, "seed"), mean.error ? "" : " (error unknown)", mean.processed,
                     countText(static_cast<std::uint64_t>(std::llround(mean.counted)), "disk"));
}

std::string bestText(const ResultStore& store, const SweepPlan& plan, const Sweep& sweep,
                     const BestCriteria& criteria, const std::optional<SettingMean>& best)
{
  if (!best)
  {
    if (!store.hasColumn("separation") || !hasSeparation(store, plan))
      return "";
    return fmt::format(
        "no best Q: no setting with all seeds completed has a mean P >= {:g} and a mean of {:g} counted "
        "disks "
        "(--least-processed, --least-counted)",
        criteria.least_processed, criteria.least_counted);
  }
  const std::string setting = meanText(*best) + ": " + CaseBuilder(sweep).settingName(best->point);
  if (best->separated() == false)
    return "not separated: the interval of 95 % contains 0 even at the largest mean Q, " + setting;
  std::string text = "best mean Q " + setting;
  std::string edges;
  for (const std::string& key : keysAtEdge(sweep, best->point, criteria.where))
    edges += (edges.empty() ? "" : ", ") + key;
  return text + (edges.empty() ? "" : "; at the grid's edge in " + edges);
}

}  // namespace ratchet_sieve
