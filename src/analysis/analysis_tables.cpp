#include "ratchet_sieve/analysis/analysis_tables.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "ratchet_sieve/recording/atomic_file.h"

namespace ratchet_sieve
{
namespace
{

std::string field(const std::optional<double>& value)
{
  return value ? fmt::format("{}", *value) : "";
}

std::string binTable(const RunResult& result)
{
  std::string text = "time,species,left,right,on_base\n";
  for (const BinFrame& frame : result.bins)
    for (std::size_t i = 0; i < frame.bins.size(); ++i)
      text += fmt::format("{},{},{},{},{}\n", frame.time, result.species[i], frame.bins[i].left,
                          frame.bins[i].right, frame.bins[i].on_base);
  return text;
}

std::string segregationTable(const RunResult& result)
{
  std::string text = "time,quality,processed\n";
  for (const BinFrame& frame : result.bins)
    text += fmt::format("{},{},{}\n", frame.time, field(frame.quality), field(frame.processed));
  return text;
}

std::string driveTable(const RunResult& result)
{
  std::string text =
      "time,inclination,commanded_inclination,frequency,commanded_frequency,amplitude,commanded_amplitude\n";
  for (const BaseFrame& frame : result.base)
    text += fmt::format("{},{},{},{},{},{},{}\n", frame.time, frame.base.inclination,
                        frame.base.commanded_inclination, frame.base.frequency,
                        frame.base.commanded_frequency, frame.base.amplitude, frame.base.commanded_amplitude);
  return text;
}

std::string statisticsTable(const RunResult& result)
{
  std::string text = "time,species,mean_vx,mean_vx_stderr,granular_temperature\n";
  for (const StatisticsFrame& frame : result.statistics)
    for (std::size_t i = 0; i < frame.means.size(); ++i)
      text += fmt::format("{},{},{},{},{}\n", frame.time, result.species[i], field(frame.means[i].mean_vx),
                          field(frame.means[i].mean_vx_stderr), frame.granular_temperature[i]);
  return text;
}

std::string contactTable(const RunResult& result)
{
  std::string text = "time,disk_disk,left_slope,right_slope,apex,wall,short_to_long,collision_rate\n";
  for (const StatisticsFrame& frame : result.statistics)
  {
    const CollisionCounts& counts = frame.collisions;
    text += fmt::format("{},{},{},{},{},{},{},{}\n", frame.time, counts.disk_disk, counts.left_slope,
                        counts.right_slope, counts.apex, counts.wall,
                        field(counts.shortToLong(result.scene.base.asymmetry)), frame.collision_rate);
  }
  return text;
}

std::string velocityTable(const RunResult& result)
{
  std::string text = "species,disks,mean_vx,mean_vx_stderr\n";
  for (std::size_t i = 0; i < result.velocities.size(); ++i)
    text += fmt::format("{},{},{},{}\n", result.species[i], result.velocities[i].disks,
                        field(result.velocities[i].mean), field(result.velocities[i].mean_stderr));
  return text;
}

std::string displacementTable(const RunResult& result)
{
  std::string text = "time,species,from,to,count,density\n";
  for (const DisplacementDistribution& distribution : result.displacement_distributions)
    for (std::size_t bin = 0; bin < distribution.counts.size(); ++bin)
      text += fmt::format("{},{},{},{},{},{}\n", distribution.time, result.species[distribution.species],
                          distribution.edge(bin), distribution.edge(bin + 1), distribution.counts[bin],
                          distribution.density(bin));
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
  const auto write = [&](const char* name, const std::string& text)
  {
    const std::string path = (std::filesystem::path(directory) / name).string();
    AtomicFile file(path);
    file.stream() << text;
    file.commit();
    paths.push_back(path);
  };
  write("bins.csv", binTable(result));
  write("segregation.csv", segregationTable(result));
  write("drive.csv", driveTable(result));
  write("statistics.csv", statisticsTable(result));
  write("contacts.csv", contactTable(result));
  write("velocities.csv", velocityTable(result));
  write("displacements.csv", displacementTable(result));
  return paths;
}

}  // namespace ratchet_sieve
