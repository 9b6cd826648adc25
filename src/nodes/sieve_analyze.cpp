#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "command_line.h"
#include "plot_script.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/analysis/analysis_tables.h"
#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/bag_reader.h"

namespace
{

using namespace ratchet_sieve;

/// What a bag calls its version or scene may be no text at all.
constexpr auto REPLACE = nlohmann::ordered_json::error_handler_t::replace;

struct Arguments
{
  std::vector<std::string> bags;
  std::string summary;
  std::string directory;
};

void describe(CLI::App& app, Arguments& arguments)
{
  app.add_option("BAG", arguments.bags, "A recorded run; all its files, where it was split")
      ->required()
      ->type_name("FILE");
  app.add_option("--summary", arguments.summary, "Write the results as JSON")->type_name("FILE");
  app.add_option("--out", arguments.directory, "Write tables (CSV) and plots (PNG) there")->type_name("DIR");
  app.footer("Exit status: 0 done; 2 bad arguments; 1 anything else, such as a bag that cannot be read.");
}

int analyze(const Arguments& arguments)
{
  std::unique_ptr<AtomicFile> summary;
  if (!arguments.summary.empty())
    summary = std::make_unique<AtomicFile>(arguments.summary);
  RunAnalysis analysis;
  readBags(arguments.bags, analysis);
  const RunResult result = analysis.result();
  std::fputs(reportText(result).c_str(), stdout);
  if (summary)
  {
    summary->stream() << reportJson(result).dump(2, ' ', false, REPLACE) << '\n';
    summary->commit();
  }
  if (!arguments.directory.empty())
  {
    std::puts("\nTables and plots:");
    for (const std::string& path : writeTables(result, arguments.directory))
      std::puts(path.c_str());
    std::fflush(stdout);
    return plotTables("plot_analysis.py", {arguments.directory});
  }
  return DONE;
}

}  // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app("Analyses a recorded run: Q, P, mean velocities, displacements, contacts.", "sieve_analyze");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return analyze(arguments); });
}
