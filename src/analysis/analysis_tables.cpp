#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

std::string unitText(const std::string& unit)
{
  return unit.empty() ? "" : " [" + shownText(unit) + "]";
}

/// The heads of a struct's columns, with a comma before each.
template <typename Struct>
std::string headsOf()
{
  std::string text;
  const Struct any;
  Fields<Struct>::each([&text](const FieldInfo& info, const auto&)
                       { text += fmt::format(",{}{}", info.name, unitText(info.unit)); },
                       any);
  return text;
}

/// The values of a row, separated by commas: of a struct all its fields, of an undefined value an empty one.
template <typename First, typename... Others>
std::string fields(const First& first, const Others&... others)
{
  std::string text;
  if constexpr (IS_DESCRIBED<First>)
  {
    Fields<First>::each([&text](const FieldInfo&, const auto& value) { text += fields(value) + ','; }, first);
    text.pop_back();
  }
  else if constexpr (IS_OPTIONAL<First>)
    text = first ? fields(*first) : "";
  else
    text = fmt::format("{}", first);
  ((text += "," + fields(others)), ...);
  return text;
}

/// A line of such values.
template <typename... Values>
std::string line(const Values&... values)
{
  return fields(values...) + '\n';
}

std::string runTable(const RunResult& result)
{
  return "scene_hash,seed,version,open_ends,start [s],end [s]\n" +
         line(shownText(result.scene_frame.scene_hash), result.scene_frame.seed,
              shownText(result.scene_frame.version), result.scene.boundary == Boundary::OPEN ? 1 : 0,
              result.start, result.end);
}

std::string driftTable(const RunResult& result)
{
  std::string text = "time [s],species,disks,displacement [m]\n";
  for (const Drift& drift : result.drift)
    for (std::size_t i = 0; i < drift.displacements.size(); ++i)
      text += line(drift.time, result.species[i], drift.disks[i], drift.displacements[i]);
  return text;
}

std::string binTable(const RunResult& result)
{
  std::string text = "time [s],species" + headsOf<SpeciesBins>() + "\n";
  for (const BinFrame& frame : result.bins)
    for (std::size_t i = 0; i < frame.bins.size(); ++i)
      text += line(frame.time, result.species[i], frame.bins[i]);
  return text;
}

std::string segregationTable(const RunResult& result)
{
  std::string text = "time [s],quality,processed,separation\n";
  for (const BinFrame& frame : result.bins)
    text += line(frame.time, frame.quality, frame.processed, frame.separation);
  return text;
}

std::string driveTable(const RunResult& result)
{
  std::string text = "time [s]";
  for (const CommandedQuantity& quantity : COMMANDED_QUANTITIES)
    text += fmt::format(",{0} [{1}],commanded_{0} [{1}]", quantity.name, quantity.unit);
  text += '\n';
  for (const BaseFrame& frame : result.base)
  {
    const DriveState& base = frame.base;
    text += line(frame.time, base.inclination, base.commanded_inclination, base.frequency,
                 base.commanded_frequency, base.amplitude, base.commanded_amplitude);
  }
  return text;
}

std::string statisticsTable(const RunResult& result)
{
  std::string text = "time [s],species" + headsOf<SpeciesMeans>() +
                     ",window_start [s],window_end [s],granular_temperature [J]\n";
  for (const StatisticsFrame& frame : result.statistics)
    for (std::size_t i = 0; i < frame.species.size(); ++i)
      text += line(frame.time, result.species[i], frame.species[i].means, frame.window_start,
                   frame.window_end, frame.species[i].granular_temperature);
  return text;
}

std::string contactTable(const RunResult& result)
{
  std::string text = "time [s]" + headsOf<CollisionCounts>() +
                     ",short_to_long,window_start [s],window_end [s]" + headsOf<CollisionRates>() +
                     ",collision_rate [1/s]\n";
  for (const StatisticsFrame& frame : result.statistics)
    text +=
        line(frame.time, frame.collisions, frame.collisions.shortToLong(result.scene.base.slopeAsymmetry()),
             frame.window_start, frame.window_end, frame.collision_rates, frame.collision_rates.total());
  return text;
}

std::string velocityTable(const RunResult& result)
{
  std::string text = "species,disks,mean_vx [m/s],mean_vx_stderr [m/s]\n";
  for (std::size_t i = 0; i < result.velocities.size(); ++i)
    text += line(result.species[i], result.velocities[i].disks, result.velocities[i].mean,
                 result.velocities[i].mean_stderr);
  return text;
}

std::string displacementTable(const RunResult& result)
{
  std::string text = "time [s],species,from [m],to [m],count,density [1/m]\n";
  for (const DisplacementDistribution& distribution : result.displacement_distributions)
    for (std::size_t bin = 0; bin < distribution.counts.size(); ++bin)
      text += line(distribution.time, result.species[distribution.species], distribution.edge(bin),
                   distribution.edge(bin + 1), distribution.counts[bin], distribution.density(bin));
  return text;
}

std::string observedTable(const RunResult& result)
{
  std::string text = "observable,place,species,number,unit,value\n";
  for (const Observed& observed : result.observed)
    for (const ObservedRow& row : observed.rows)
      for (const ObservedNumber& number : row.numbers)
        text += line(observed.name, row.place, row.species, shownText(number.name), shownText(number.unit),
                     number.value);
  return text;
}

/// The tables of an observable's rows, one below the other.
std::string tableOf(const Observed& observed)
{
  std::string text = "place,species";
  if (!observed.rows.empty())
    for (const ObservedColumn& column : observed.rows.front().table)
      text += "," + shownText(column.name) + unitText(column.unit);
  text += '\n';
  for (const ObservedRow& row : observed.rows)
    for (std::size_t k = 0; !row.table.empty() && k < row.table.front().values.size(); ++k)
    {
      text += row.place + "," + row.species;
      for (const ObservedColumn& column : row.table)
        text += "," + fields(column.values.at(k));
      text += '\n';
    }
  return text;
}

}  // namespace

std::vector<std::string> writeTables(const RunResult& result, const std::string& directory)
{
  std::error_code ignored;
  makeFolder(directory);
  std::vector<std::string> paths;
  const auto write = [&](const std::string& name, const std::string& text)
  {
    const std::string path = (std::filesystem::path(directory) / name).string();
    AtomicFile file(path);
    file.stream() << text;
    file.commit();
    paths.push_back(path);
  };
  write("run.csv", runTable(result));
  write("bins.csv", binTable(result));
  write("segregation.csv", segregationTable(result));
  write("drive.csv", driveTable(result));
  write("statistics.csv", statisticsTable(result));
  write("contacts.csv", contactTable(result));
  write("velocities.csv", velocityTable(result));
  write("drift.csv", driftTable(result));
  write("displacements.csv", displacementTable(result));
  if (!result.observed.empty())
    write("observed.csv", observedTable(result));
  else  // that of an earlier run
    std::filesystem::remove(std::filesystem::path(directory) / "observed.csv", ignored);
  for (const Observed& observed : result.observed)
    write(observed.name + ".csv", tableOf(observed));
  return paths;
}

}  // namespace ratchet_sieve
