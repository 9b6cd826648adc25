#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command_line.h"
#include "page_arguments.h"
#include "python_plots.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/analysis/run_analysis.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/ros/bag.h"

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

void requireDistinctFiles(const Arguments& arguments)
{
  std::vector<NamedFile> bags;
  for (const std::string& bag : arguments.bags)
    bags.push_back({"BAG", bag});
  std::vector<NamedFile> outputs = {
      {"standard output", "/dev/stdout"}, {"--summary", arguments.summary}, {"--html", arguments.page.path}};
  std::vector<NamedFile> files = bags;
  files.insert(files.end(), outputs.begin(), outputs.end());
  for (const NamedFile& table : outputsInFolder({"--out", arguments.directory}, files, {".csv", ".png"}))
    outputs.push_back(table);
  requireDistinct(bags, outputs);
}

void writePage(const RunPage& page, AtomicFile& file, const Arguments& arguments)
{
  page.write(std::move(file), std::filesystem::path(arguments.bags.front()).filename());
  print("\nPage: " + arguments.page.path + "\n");
}

/// @return the status of the plots
int writeTablesAndPlots(const RunResult& result, const Arguments& arguments)
{
  const std::vector<std::string> tables = writeTables(result, arguments.directory);
  print(fmt::format("\nTables and plots:\n{}\n", fmt::join(tables, "\n")));
  return plotTables("ratchet_sieve.plots.analysis", {arguments.directory});
}

int analyze(const Arguments& arguments)
{
  orRefuse<SameFileError>([&] { requireDistinctFiles(arguments); });
  std::signal(SIGPIPE, SIG_IGN);  // where nobody reads its text, the files are written all the same
  std::unique_ptr<AtomicFile> summary;
  if (!arguments.summary.empty())
    summary = std::make_unique<AtomicFile>(arguments.summary);
  std::unique_ptr<AtomicFile> page_file;
  std::unique_ptr<RunPage> page;
  if (arguments.page.isWanted())
  {
    page_file = std::make_unique<AtomicFile>(arguments.page.path);
    page = std::make_unique<RunPage>(arguments.page.bytes());
  }
  RunAnalysis analysis;
  readBags(arguments.bags, page ? static_cast<FrameSink&>(*page) : analysis);
  const RunResult result = (page ? page->analysis() : analysis).result();
  OutputAttempts outputs("sieve_analyze");
  int status = DONE;
  if (summary)
    outputs.attempt(
        [&]
        {
          summary->stream() << reportJson(result).dump(2, ' ', false, REPLACE) << '\n';
          summary->commit();
        });
  outputs.attempt([&] { print(reportText(result)); });
  if (page)
    outputs.attempt([&] { writePage(*page, *page_file, arguments); });
  if (!arguments.directory.empty())
    outputs.attempt([&] { status = writeTablesAndPlots(result, arguments); });
  return outputs.complete() ? status : FAILED;
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
