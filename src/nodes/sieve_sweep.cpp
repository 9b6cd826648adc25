#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "case_pages.h"
#include "command_line.h"
#include "python_plots.h"
#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/page/sweep_page.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/cost_estimate.h"
#include "ratchet_sieve/sweep/floor_check.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_arguments.h"

namespace
{

using namespace ratchet_sieve;

/// More cases than this are likely a mistake, and need --yes.
constexpr std::uint64_t MANY_CASES = 1'000'000;

volatile std::sig_atomic_t stop_signal = 0;

void onSignal(int signal)
{
  stop_signal = signal;
}

/// Checks that the outputs of a subcommand are none of the sweep's files, nor its results, which `run` and
/// `merge` alone write.
void requireDistinctFiles(const CLI::App& app, const Sweep& sweep, const SweepArguments& arguments)
{
  std::vector<NamedFile> inputs = {{"SWEEP", arguments.sweep}};
  if (!sweep.scene_is_inside)
    inputs.push_back({"the sweep's scene", sweep.scene_source});
  for (const std::string& part : arguments.parts)
    inputs.push_back({"FILE", part});
  std::vector<NamedFile> outputs = {{"--db", arguments.results}};
  if (!app.got_subcommand("run") && !app.got_subcommand("merge"))
  {
    for (const char* part : {"", "-wal", "-shm"})
      inputs.push_back({"--db", arguments.results + part});
    outputs = {{"--out", arguments.out}};
  }
  if (app.got_subcommand("report"))
  {
    std::vector<std::string> written = {".csv",           ".png",         ".svg",
                                        "/findings.json", "/report.json", "/report.html"};
    if (sweep.scene_is_inside)
      written.emplace_back("/scene.yaml");
    outputs = outputsInFolder(outputs.front(), inputs, written);
  }
  requireDistinct(inputs, outputs);
}

void requireFewOrYes(const Sweep& sweep, const SweepArguments& arguments)
{
  if (sweep.sizeOfPart() <= MANY_CASES || arguments.yes)
    return;
  const std::size_t threads = std::max<std::size_t>(arguments.options.threads, 1);
  throw Refusal(sweep.source + ": has " + std::to_string(sweep.sizeOfPart()) + " cases, which take " +
                estimateText(sweep, threads) + " on " + countText(threads, "thread") +
                "; use --yes to run them");
}

void warn(const std::string& text)
{
  std::fprintf(stderr, "sieve_sweep: warning: %s\n", text.c_str());
}

/// Runs cases, with handlers of signals, warnings and progress.
template <typename Run>
auto runAttended(SweepRunOptions& options, const Run& cases)
{
  attendSignals(onSignal);
  options.stop_wanted = [] { return stop_signal != 0; };
  options.warn = warn;
  SweepProgressLine line;
  if (line.isVisible())
    options.progress = [&line](const SweepProgress& progress) { line.show(progress); };
  return cases();
}

int listOnly(const Sweep& sweep, const SweepArguments& arguments)
{
  for (const std::string& line : legalCases(sweep)->warnings.lines(sweep.size(), "case"))
    warn(line);
  listCases(sweep, arguments.results, std::cout);
  for (const std::string& line : costLines(sweep))
    std::fprintf(stderr, "sieve_sweep: %s\n", line.c_str());
  return DONE;
}

int run(const Sweep& sweep, SweepArguments& arguments)
{
  if (arguments.options.threads == 0)
    arguments.options.threads = std::max(1u, std::thread::hardware_concurrency());
  requireFewOrYes(sweep, arguments);
  if (arguments.dry_run)
    return listOnly(sweep, arguments);
  if (arguments.pages.isWanted())
    arguments.options.record = casePages(arguments.pages, arguments.name());
  const SweepOutcome outcome =
      runAttended(arguments.options, [&] { return runSweep(sweep, arguments.results, arguments.options); });
  const SweepCounts& counts = outcome.counts;
  if (outcome.stopped)
  {
    std::fprintf(stderr, "sieve_sweep: stopped with %llu of %s to go; run the same command to continue\n",
                 static_cast<unsigned long long>(counts.open()), countText(counts.cases, "case").c_str());
    return FAILED;
  }
  std::fputs(statusText(sweep, arguments.results, arguments.options.best).c_str(), stderr);
  return counts.failed == 0 ? DONE : FAILED;
}

int merge(const Sweep& sweep, SweepArguments& arguments)
{
  try
  {
    requireMergeable(sweep, arguments.parts);
  }
  catch (const DatabaseError& error)
  {
    throw Refusal(error.what());
  }
  const auto copy = [&]
  { return mergeResults(sweep, arguments.results, arguments.parts, arguments.options); };
  if (runAttended(arguments.options, copy).stopped)
  {
    std::fputs("sieve_sweep: stopped; run the same command to continue\n", stderr);
    return FAILED;
  }
  std::fputs(statusText(sweep, arguments.results, arguments.options.best).c_str(), stderr);
  return DONE;
}

int exportResults(const Sweep& sweep, const SweepArguments& arguments)
{
  if (arguments.out.empty())
  {
    exportCsv(sweep, arguments.results, std::cout);
    if (!std::cout.flush())
      throw OutputError("the results could not be written to standard output");
    return DONE;
  }
  AtomicFile file(arguments.out);
  exportCsv(sweep, arguments.results, file.stream());
  file.commit();
  return DONE;
}

/// Adds its results to the findings. @return false if it was stopped
bool checkFloor(const Sweep& sweep, SweepArguments& arguments, SweepFindings& findings,
                nlohmann::ordered_json& json)
{
  if (!findings.best)
    throw Refusal("--check-floor: there is no best setting to check");
  const std::uint64_t point = findings.best->point;
  if (CaseBuilder(sweep).at(point * sweep.seedCount()).scene.contact.min_rebound_speed <= 0.0)
    throw Refusal(
        "--check-floor: contact.min_rebound_speed of the best setting is 0: there is no floor to check");
  const auto means =
      runAttended(arguments.options, [&]
                  { return runSettingAtLowerFloors(sweep, point, arguments.results, arguments.options); });
  if (!means)
    return false;
  for (const std::string& line : floorCheckLines(*means))
    findings.lines.push_back(line);
  json = floorCheckJson(*means);
  return true;
}

/// The path of the sweep's scene from here, or of a copy if it is in the sweep's own file.
std::string scenePath(const Sweep& sweep, const std::string& directory)
{
  namespace fs = std::filesystem;
  if (!sweep.scene_is_inside)
    return fs::path(sweep.scene_source).is_absolute() ? fs::weakly_canonical(sweep.scene_source).string()
                                                      : fs::proximate(sweep.scene_source).string();
  AtomicFile file(directory + "/scene.yaml");
  file.stream() << sweep.scene_text << '\n';
  file.commit();
  return directory + "/scene.yaml";
}

void writeFindings(const Sweep& sweep, const SweepFindings& findings,
                   const nlohmann::ordered_json& floor_check, const std::string& directory)
{
  nlohmann::ordered_json json = findingsJson(sweep, findings);
  json["floor_check"] = floor_check;
  json["command"] = commandText(sweep, scenePath(sweep, directory));
  AtomicFile file(directory + "/findings.json");
  file.stream() << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  file.commit();
}

/// Draws the pictures, and makes the page of what they show.
int draw(const SweepArguments& arguments)
{
  std::vector<std::string> options = {arguments.out, "--title", arguments.name(), "--html",
                                      arguments.pages.path};
  options.insert(options.end(), arguments.plot_options.begin(), arguments.plot_options.end());
  const int status = plotTables("ratchet_sieve.plots.sweep", options);
  if (status != DONE)
    return status;
  const std::string page = arguments.out + "/report.html";
  std::ifstream data(arguments.out + "/report.json");
  writeSweepPage(page, nlohmann::ordered_json::parse(data));
  std::printf("%s\n", page.c_str());
  return DONE;
}

int report(const Sweep& sweep, SweepArguments& arguments)
{
  for (const std::string& condition : arguments.where)
  {
    const std::size_t equals = condition.find('=');
    arguments.options.best.where.push_back(
        {condition.substr(0, equals), equals == std::string::npos ? "" : condition.substr(equals + 1)});
  }
  if (arguments.pages.path.empty())
    arguments.pages.path = arguments.beside("_runs");
  std::error_code error;
  std::filesystem::create_directories(arguments.out, error);
  if (error)
    throw OutputError(arguments.out + ": cannot be made: " + error.message());
  AtomicFile table(arguments.out + "/cases.csv");
  exportCsv(sweep, arguments.results, table.stream());
  table.commit();
  SweepFindings findings = findingsOf(sweep, arguments.results, arguments.options.best);
  nlohmann::ordered_json floor_check;
  if (arguments.check_floor && !checkFloor(sweep, arguments, findings, floor_check))
  {
    std::fputs("sieve_sweep: stopped; run the same command to continue\n", stderr);
    return FAILED;
  }
  writeFindings(sweep, findings, floor_check, arguments.out);
  const int status = draw(arguments);
  if (status == DONE)
    for (const std::string& line : findings.lines)
      std::fprintf(stderr, "%s\n", line.c_str());
  return status;
}

int dispatch(const CLI::App& app, SweepArguments& arguments)
{
  if (arguments.results.empty())
    arguments.results = arguments.ownResults();
  try
  {
    Sweep sweep = loadSweep(arguments.sweep);
    sweep.part = arguments.part.value_or(SweepPart());
    if (app.got_subcommand("report") && arguments.out.empty())
      arguments.out = arguments.beside("_report");
    if (arguments.results == IN_MEMORY)
      throw Refusal(std::string("--db ") + IN_MEMORY + ": must be a file");
    requireDistinctFiles(app, sweep, arguments);
    if (app.got_subcommand("run"))
      return run(sweep, arguments);
    if (app.got_subcommand("merge"))
      return merge(sweep, arguments);
    if (app.got_subcommand("export"))
      return exportResults(sweep, arguments);
    if (app.got_subcommand("report"))
      return report(sweep, arguments);
    std::fputs(statusText(sweep, arguments.results, arguments.options.best).c_str(), stdout);
    return DONE;
  }
  catch (const SceneError& error)
  {
    throw Refusal(error.what());
  }
}

}  // namespace

int main(int argc, char** argv)
{
  SweepArguments arguments;
  CLI::App app("Run many cases of one scene and keep the results in one file.", "sieve_sweep");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return dispatch(app, arguments); });
}
