#include <csignal>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command_line.h"
#include "python_plots.h"
#include "ratchet_sieve/page/sweep_page.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/progress_bar.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"
#include "sweep_arguments.h"

namespace
{

using namespace ratchet_sieve;

/// More cases than this are likely a mistake, and need --yes.
constexpr std::uint64_t MANY_CASES = 1'000'000;

/// Checks that the outputs of a subcommand are none of the sweep's files, nor its results, which `run` and
/// `merge` alone write.
void requireDistinctFiles(const CLI::App& app, const Sweep& sweep, const SweepArguments& arguments)
{
  std::vector<NamedFile> inputs = {{"SWEEP", arguments.sweep}};
  if (!sweep.scene_is_inside)
    inputs.push_back({"the sweep's scene", sweep.scene_source});
  for (const std::string& file : sweep.feedFiles())
    inputs.push_back({"feed.file", file});
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
    std::vector<std::string> written = {".csv", ".png", ".svg", ".json", "/report.html"};
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
  throw Refusal(sweep.source + ": " + costLines(sweep).front() + "; use --yes to run them");
}

void warn(const std::string& text)
{
  std::fprintf(stderr, "sieve_sweep: warning: %s\n", text.c_str());
}

int listOnly(const Sweep& sweep, const SweepArguments& arguments)
{
  const LegalCases cases = *legalCases(sweep);
  for (const std::string& line : cases.warnings.lines(sweep.size(), "case"))
    warn(line);
  listCases(sweep, cases, arguments.results, std::cout);
  for (const std::string& line : costLines(sweep))
    std::fprintf(stderr, "sieve_sweep: %s\n", line.c_str());
  return DONE;
}

std::string titleOf(const std::string& sweep, const SweepCase& sweep_case)
{
  std::string title = sweep + ':';
  for (const auto& [key, value] : sweep_case.values)
    if (value)
      title += ' ' + key + '=' + *value;
  return title + " seed=" + std::to_string(sweep_case.scene.seed);
}

/// Keeps the page of each case as RUN_HASH.html in a folder, which is made. @throws OutputError
OpenRecord casePages(const PageArguments& arguments, const std::string& sweep)
{
  makeFolder(arguments.path);
  AtomicFile probe(arguments.path + "/probe");
  return [folder = arguments.path, bytes = arguments.bytes(), sweep](const SweepCase& sweep_case)
  {
    auto page = std::make_unique<RunPage>(bytes);
    const std::string path = folder + '/' + runHash(sweep_case.scene) + ".html";
    const auto keep = [&run = *page, path, title = titleOf(sweep, sweep_case)](
                          const nlohmann::ordered_json& summary) { run.write(path, title, summary); };
    return CaseRecord{std::move(page), pageRates(PAGE_RATE), keep};
  };
}

int run(const Sweep& sweep, SweepArguments& arguments)
{
  requireFewOrYes(sweep, arguments);
  if (arguments.dry_run)
    return listOnly(sweep, arguments);
  if (arguments.pages.isWanted())
    arguments.options.record = casePages(arguments.pages, arguments.name());
  attendSignals();
  arguments.options.stop_wanted = [] { return stop_requested.load(); };
  arguments.options.warn = warn;
  SweepOutcome outcome;
  {
    ProgressBar line;
    if (line.isVisible())
      arguments.options.progress = [&line](const SweepProgress& progress)
      { line.show(sweepProgressText(progress)); };
    outcome = runSweep(sweep, arguments.results, arguments.options);
  }
  const SweepCounts& counts = outcome.counts;
  if (outcome.stopped)
  {
    const std::string where = counts.cases == 0 ? "while the cases were listed: none was run"
                                                : fmt::format("with {} of {} to go", counts.open(),
                                                              countText(counts.cases, "case"));
    std::fprintf(stderr, "sieve_sweep: stopped %s; run the same command to continue\n", where.c_str());
    return FAILED;
  }
  std::fputs(statusText(sweep, arguments.results).c_str(), stderr);
  return counts.failed == 0 ? DONE : FAILED;
}

int merge(const Sweep& sweep, const SweepArguments& arguments)
{
  const LegalCases cases = orRefuse<DatabaseError>([&] { return requireMergeable(sweep, arguments.parts); });
  mergeResults(sweep, cases, arguments.results, arguments.parts);
  std::fputs(statusText(sweep, arguments.results).c_str(), stderr);
  return DONE;
}

int exportResults(const Sweep& sweep, const SweepArguments& arguments)
{
  if (arguments.out.empty())
  {
    exportCsv(sweep, arguments.results, std::cout);
    return DONE;
  }
  AtomicFile file(arguments.out);
  exportCsv(sweep, arguments.results, file.stream());
  file.commit();
  return DONE;
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

/// Writes the table of a report, and what it does not say, for the Python package; this draws the pictures
/// and works out the page's data.
int report(const Sweep& sweep, SweepArguments& arguments)
{
  if (arguments.pages.path.empty())
    arguments.pages.path = arguments.beside("_runs");
  makeFolder(arguments.out);
  AtomicFile table(arguments.out + "/cases.csv");
  exportCsv(sweep, arguments.results, table.stream());
  table.commit();
  AtomicFile basis(arguments.out + "/sweep.json");
  basis.stream() << reportBasis(sweep, arguments.results, scenePath(sweep, arguments.out))
                        .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
                 << '\n';
  basis.commit();
  std::signal(SIGINT, requestStop);  // ends Python, which says so
  const int status = plotTables("ratchet_sieve.plots.sweep", arguments.plotOptions());
  if (status != DONE)
    return status;
  const std::string page = arguments.out + "/report.html";
  std::ifstream file(arguments.out + "/report.json");
  const auto data = nlohmann::ordered_json::parse(file);
  writeSweepPage(page, data);
  print(page + "\n");
  for (const auto& line : data.at("findings"))
    std::fprintf(stderr, "%s\n", line.get<std::string>().c_str());
  return DONE;
}

int dispatch(const CLI::App& app, SweepArguments& arguments)
{
  if (arguments.results.empty())
    arguments.results = arguments.ownResults();
  Sweep sweep = loadSweep(arguments.sweep);
  sweep.part = arguments.part.value_or(SweepPart());
  if (app.got_subcommand("report") && arguments.out.empty())
    arguments.out = arguments.beside("_report");
  if (arguments.results == IN_MEMORY)
    throw Refusal(std::string("--db ") + IN_MEMORY + ": must be a file");
  orRefuse<SameFileError>([&] { requireDistinctFiles(app, sweep, arguments); });
  if (app.got_subcommand("run"))
    return run(sweep, arguments);
  if (app.got_subcommand("merge"))
    return merge(sweep, arguments);
  if (app.got_subcommand("export"))
    return exportResults(sweep, arguments);
  if (app.got_subcommand("report"))
    return report(sweep, arguments);
  print(statusText(sweep, arguments.results));
  return DONE;
}

}  // namespace

int main(int argc, char** argv)
{
  SweepArguments arguments;
  CLI::App app("Run many cases of one scene and keep the results in one file.", "sieve_sweep");
  describe(app, arguments);
  return runProgram(app, argc, argv,
                    [&] { return orRefuse<SceneError>([&] { return dispatch(app, arguments); }); });
}
