#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "findings.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/database.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

/// That of the seeds: one with both results, one with a case that failed and one that died.
constexpr const char* SWEEP = R"(
scene:
  base: {teeth: 2}
  boundary: open
  species: [{name: A, count: 1, radius: 0.001, mass: 0.010}]
  duration: 0.01
grid: {base.inclination: [0.1, 0.2]}
)";

template <typename Act>
void attempt(const Act& act)
{
  try
  {
    act();
  }
  catch (const DatabaseError& error)
  {
    requireOneLine(error.what());
  }
}

/// What sieve_sweep does with a results file. @param path of it @param other of a new one
void use(const Sweep& sweep, const std::string& path, const std::string& other)
{
  // A plan is that of one version of the program.
  const std::string adopt = "UPDATE sweeps SET fingerprint = '" + sweep.fingerprint() + "'";
  attempt([&] { Database(path, Database::Access::WRITE).execute(adopt); });
  std::ostringstream out;
  attempt([&] { statusText(sweep, path); });
  attempt([&] { exportCsv(sweep, path, out); });
  attempt(
      [&] {
        reportBasis(sweep, path, "scene.yaml").dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
      });
  attempt([&] { listCases(sweep, *legalCases(sweep), path, out); });
  attempt([&] { mergeResults(sweep, requireMergeable(sweep, {path}), other, {path}); });
  SweepRunOptions options;
  options.threads = 1;
  attempt([&] { runSweep(sweep, path, options); });
}

}  // namespace
}  // namespace ratchet_sieve

/// A results file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  using namespace ratchet_sieve;
  static const Sweep sweep = sweepFromText(SWEEP, "sweep.yaml");
  static const fs::path directory = fs::temp_directory_path() / ("results_fuzz_" + std::to_string(getpid()));
  fs::create_directories(directory);
  std::ofstream(directory / "s.db", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<long>(size));
  use(sweep, directory / "s.db", directory / "merged.db");
  fs::remove_all(directory);
  return 0;
}
