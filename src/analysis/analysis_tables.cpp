#include "ratchet_sieve/analysis/analysis_tables.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

std::string field(const std::optional<double>& value)
{
  return value ? fmt::format("{}", *value) : "";
}

std::string runTable(const RunResult& result)
{
  return fmt::format("scene_hash,seed,version,open_ends,start [s],end [s]\n{},{},{},{:d},{},{}\n",
                     shownText(result.scene_frame.scene_hash), result.scene_frame.seed,
                     shownText(result.scene_frame.version), result.scene.boundary == Boundary::OPEN,
                     result.start, result.end);
}

std::string driftTable(const RunResult& result)
{
  std::string text = "time [s],species,disks,displacement [m]\n";
  for (const Drift& drift : result.drift)
    for (std::size_t i = 0; i < drift.displacements.size(); ++i)
      text += fmt::format("{},{},{},{}\n", drift.time, result.species[i], drift.disks[i],
                          field(drift.displacements[i]));
  return text;
}

std::string binTable(const RunResult& result)
{
  std::string text = "time [s],species,left,right,on_base,left_mass [kg],right_mass [kg]\n";
  for (const BinFrame& frame : result.bins)
    for (std::size_t i = 0; i < frame.bins.size(); ++i)
    {
      const SpeciesBins& bins = frame.bins[i];
      text += fmt::format("{},{},{},{},{},{},{}\n", frame.time, result.species[i], bins.left, bins.right,
                          bins.on_base, bins.left_mass, bins.right_mass);
    }
  return text;
}

std::string segregationTable(const RunResult& result)
{
  std::string text = "time [s],quality,processed,separation\n";
  for (const BinFrame& frame : result.bins)
    text += fmt::format("{},{},{},{}\n", frame.time, field(frame.quality), field(frame.processed),
                        field(frame.separation));
  return text;
}

std::string driveTable(const RunResult& result)
{
  std::string text =
      "time [s],inclination [rad],commanded_inclination [rad],frequency [Hz],commanded_frequency [Hz],"
      "amplitude [m],commanded_amplitude [m]\n";
  for (const BaseFrame& frame : result.base)
    text += fmt::format("{},{},{},{},{},{},{}\n", frame.time, frame.base.inclination,
                        frame.base.commanded_inclination, frame.base.frequency,
                        frame.base.commanded_frequency, frame.base.amplitude, frame.base.commanded_amplitude);
  return text;
}

std::string statisticsTable(const RunResult& result)
{
  std::string text = "time [s],species";
  const SpeciesMeans any;
  Fields<SpeciesMeans>::each([&text](const FieldInfo& info, const auto&)
                             { text += fmt::format(",{} [{}]", info.name, info.unit); },
                             any);
  text += ",window_start [s],window_end [s],granular_temperature [J]\n";
  for (const StatisticsFrame& frame : result.statistics)
    for (std::size_t i = 0; i < frame.species.size(); ++i)
    {
      text += fmt::format("{},{}", frame.time, result.species[i]);
      Fields<SpeciesMeans>::each([&text](const FieldInfo&, const std::optional<double>& mean)
                                 { text += "," + field(mean); },
                                 frame.species[i].means);
      text += fmt::format(",{},{},{}\n", frame.window_start, frame.window_end,
                          field(frame.species[i].granular_temperature));
    }
  return text;
}

std::string contactTable(const RunResult& result)
{
  std::string text =
      "time [s],disk_disk,left_slope,right_slope,apex,wall,level,short_to_long,window_start [s],window_end "
      "[s],"
      "disk_disk_rate [1/s],left_slope_rate [1/s],right_slope_rate [1/s],apex_rate [1/s],wall_rate [1/s],"
      "level_rate [1/s],collision_rate [1/s]\n";
  for (const StatisticsFrame& frame : result.statistics)
  {
    const CollisionCounts& counts = frame.collisions;
    const CollisionRates& rates = frame.collision_rates;
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", frame.time, counts.disk_disk,
                        counts.left_slope, counts.right_slope, counts.apex, counts.wall, counts.level,
                        field(counts.shortToLong(result.scene.base.slopeAsymmetry())), frame.window_start,
                        frame.window_end, rates.disk_disk_rate, rates.left_slope_rate, rates.right_slope_rate,
                        rates.apex_rate, rates.wall_rate, rates.level_rate, rates.total());
  }
  return text;
}

std::string velocityTable(const RunResult& result)
{
  std::string text = "species,disks,mean_vx [m/s],mean_vx_stderr [m/s]\n";
  for (std::size_t i = 0; i < result.velocities.size(); ++i)
    text += fmt::format("{},{},{},{}\n", result.species[i], result.velocities[i].disks,
                        field(result.velocities[i].mean), field(result.velocities[i].mean_stderr));
  return text;
}

std::string displacementTable(const RunResult& result)
{
  std::string text = "time [s],species,from [m],to [m],count,density [1/m]\n";
  for (const DisplacementDistribution& distribution : result.displacement_distributions)
    for (std::size_t bin = 0; bin < distribution.counts.size(); ++bin)
      text += fmt::format("{},{},{},{},{},{}\n", distribution.time, result.species[distribution.species],
                          distribution.edge(bin), distribution.edge(bin + 1), distribution.counts[bin],
                          distribution.density(bin));
  return text;
}

std::string unitText(const std::string& unit)
{
  return unit.empty() ? "" : " [" + shownText(unit) + "]";
}

std::string observedTable(const RunResult& result)
{
  std::string text = "observable,place,species,number,unit,value\n";
  for (const Observed& observed : result.observed)
    for (const ObservedRow& row : observed.rows)
      for (const ObservedNumber& number : row.numbers)
        text += fmt::format("{},{},{},{},{},{}\n", observed.name, row.place, row.species,
                            shownText(number.name), shownText(number.unit), field(number.value));
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
    for (std::size_t line = 0; !row.table.empty() && line < row.table.front().values.size(); ++line)
    {
      text += row.place + "," + row.species;
      for (const ObservedColumn& column : row.table)
        text += "," + field(column.values[line]);
      text += '\n';
    }
  return text;
}

}  // namespace

std::vector<std::string> writeTables(const RunResult& result, const std::string& directory)
{
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw OutputError(directory + ": cannot be made a directory: " + error.message());
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
    std::filesystem::remove(std::filesystem::path(directory) / "observed.csv", error);
  for (const Observed& observed : result.observed)
    write(observed.name + ".csv", tableOf(observed));
  return paths;
}

}  // namespace ratchet_sieve
