#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_line.h"
#include "page_arguments.h"
#include "python_plots.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/analysis/analysis_tables.h"
#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/bag_reader.h"

namespace
{

using namespace ratchet_sieve;

/// Version and scene of a damaged bag may be invalid UTF-8.
constexpr auto REPLACE = nlohmann::ordered_json::error_handler_t::replace;

struct Arguments
{
  std::vector<std::string> bags;
  std::string summary;
  std::string directory;
  PageArguments page;
};

void describe(CLI::App& app, Arguments& arguments)
{
  app.add_option("BAG", arguments.bags, "Bag of a recorded run; all files of a split one")
      ->required()
      ->type_name("FILE");
  app.add_option("--summary", arguments.summary, "Write the results as JSON to a file")->type_name("FILE");
  app.add_option("--out", arguments.directory, "Write tables (CSV) and plots (PNG) to a directory")
      ->type_name("DIR");
  describe(app, arguments.page);
  app.footer(
      "Exit status: 0 if done; 2 for bad arguments; 1 for any other failure, such as a bag that cannot be "
      "read.");
}

/// @throws OutputError if standard output could not be written in full, as on a full disk
void requirePrinted()
{
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw OutputError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

int analyze(const Arguments& arguments)
{
  std::unique_ptr<AtomicFile> summary;
  if (!arguments.summary.empty())
    summary = std::make_unique<AtomicFile>(arguments.summary);
  const std::unique_ptr<RunPage> page = arguments.page.isWanted() ? arguments.page.open() : nullptr;
  RunAnalysis analysis;
  readBags(arguments.bags, page ? static_cast<FrameSink&>(*page) : analysis);
  const RunResult result = (page ? page->analysis() : analysis).result();
  std::fputs(reportText(result).c_str(), stdout);
  requirePrinted();
  if (summary)
  {
    summary->stream() << reportJson(result).dump(2, ' ', false, REPLACE) << '\n';
    summary->commit();
  }
  if (page)
  {
    page->write(arguments.page.path, std::filesystem::path(arguments.bags.front()).filename(), {});
    std::printf("\nPage: %s\n", arguments.page.path.c_str());
    requirePrinted();
  }
  if (!arguments.directory.empty())
  {
    std::puts("\nTables and plots:");
    for (const std::string& path : writeTables(result, arguments.directory))
      std::puts(path.c_str());
    requirePrinted();
    return plotTables("ratchet_sieve.plots.analysis", {arguments.directory});
  }
  return DONE;
}

}  // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  CLI::App app(
      "Analyse a recorded run: separation quality Q, processed share P, mean velocities, displacements, "
      "contacts.",
      "sieve_analyze");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return analyze(arguments); });
}
