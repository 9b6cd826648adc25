#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "command_line.h"
#include "python_plots.h"
#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_builder.h"
#include "ratchet_sieve/sweep/case_file.h"
#include "ratchet_sieve/sweep/engine_run.h"
#include "ratchet_sieve/sweep/floor_check.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"

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

struct Arguments
{
  std::string sweep;
  std::string results;
  std::string out;
  std::string engine = "threads";
  std::string hosts;
  std::string program;
  std::vector<std::string> engine_options;
  std::vector<std::string> plot_options;
  std::vector<std::string> where;
  bool check_floor = false;
  bool dry_run = false;
  bool yes = false;
  SweepRunOptions options;
};

void describeThreads(CLI::App& command, Arguments& arguments)
{
  command
      .add_option("--threads", arguments.options.threads,
                  "Number of cases run at the same time, at most 1024; 0: one per processor")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

/// The limits for the best setting, which is the one with the highest mean Q.
void describeBest(CLI::App& command, Arguments& arguments)
{
  command
      .add_option("--least-processed", arguments.options.best.least_processed,
                  "Least P of the best setting, averaged over its seeds, from 0 to 1")
      ->type_name("P")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--least-counted", arguments.options.best.least_counted,
                  "Least number of disks that left in the best setting, averaged over its seeds: Q of few "
                  "disks can be "
                  "high by chance")
      ->type_name("N")
      ->check(CLI::Range(0.0, 1e12))
      ->capture_default_str();
}

void describeEngine(CLI::App& run, Arguments& arguments)
{
  run.add_option(
         "--engine", arguments.engine,
         "What runs the cases: threads of this program, GNU parallel over ssh (parallel), or a job array of "
         "Slurm (slurm)")
      ->type_name("threads|parallel|slurm")
      ->check(CLI::IsMember({"threads", "parallel", "slurm"}))
      ->capture_default_str();
  run.add_option("--hosts", arguments.hosts,
                 "Hosts of --engine parallel, in the format of its --sshloginfile")
      ->type_name("FILE");
  run.add_option("--per-job", arguments.options.per_job,
                 "Number of cases in one job of an engine; 0: as many as give at most a thousand jobs")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
  run.add_option("--sbatch", arguments.engine_options,
                 "Option of sbatch, such as --sbatch=--partition=short; repeatable")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  run.add_option("--program", arguments.program,
                 "Path of this program on the hosts; without this option the same as here")
      ->type_name("FILE");
}

void describeRun(CLI::App& run, Arguments& arguments)
{
  describeThreads(run, arguments);
  describeBest(run, arguments);
  run.add_option("--checkpoint-every", arguments.options.checkpoint_period,
                 "Period at which a running case is saved [s of wall time]")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  describeEngine(run, arguments);
  run.add_flag("--retry-failed", arguments.options.retry_failed, "Run failed cases again");
  run.add_flag("--dry-run", arguments.dry_run, "List the cases and run none");
  run.add_flag("--yes", arguments.yes, "Confirm a sweep of more than a million cases");
}

/// Options that ratchet_sieve.plots.sweep takes as well.
void describePlots(CLI::App& report, Arguments& arguments)
{
  const auto plot_option = [&](const std::string& name, const char* type, const char* text)
  {
    const auto take = [&arguments, name](const std::vector<std::string>& values)
    {
      for (const std::string& value : values)
      {
        arguments.plot_options.insert(arguments.plot_options.end(), {name, value});
        if (name == "--where")
          arguments.where.push_back(value);
      }
    };
    report.add_option_function<std::vector<std::string>>(name, take, text)
        ->type_name(type)
        ->allow_extra_args(false);
  };
  plot_option("--x", "KEY", "Key on the x axis; without this option the key with the most values");
  plot_option("--y", "KEY", "Key on the y axis of maps, with one curve for each of its values");
  plot_option("--field", "NAME",
              "Column to draw, repeatable; without this option Q, P, the disks that leave and velocities");
  plot_option("--where", "KEY=VALUE", "Draw only the cases with this value; repeatable");
}

void describeReport(CLI::App& report, Arguments& arguments)
{
  report
      .add_option("--out", arguments.out,
                  "Directory of the report; without this option SWEEP_report beside the sweep")
      ->type_name("DIR");
  describePlots(report, arguments);
  describeBest(report, arguments);
  report.add_flag(
      "--check-floor", arguments.check_floor,
      "Run the seeds of the best setting again at a half and a quarter of contact.min_rebound_speed, into "
      "the results file, and print whether Q depends on it");
  describeThreads(report, arguments);
}

void describe(CLI::App& app, Arguments& arguments)
{
  app.require_subcommand(1);
  const auto verb = [&](const char* name, const char* text)
  {
    CLI::App* command = app.add_subcommand(name, text);
    command->add_option("SWEEP", arguments.sweep, "Sweep file (YAML)")->required()->type_name("FILE");
    command
        ->add_option("--db", arguments.results, "Results file; without this option SWEEP.db beside the sweep")
        ->type_name("FILE");
    return command;
  };
  describeRun(*verb("run", "Run the cases that have no result yet"), arguments);
  describeBest(*verb("status", "Print the progress of the sweep and its best setting"), arguments);
  verb("export", "Write the results as CSV")
      ->add_option("--out", arguments.out, "Write to a file instead of standard output")
      ->type_name("FILE");
  describeReport(
      *verb("report", "Draw curves and maps of the results, averaged over the seeds, as an HTML page"),
      arguments);
  app.add_subcommand("case", "Run the cases of a case file; engines call this")
      ->add_option("CASE", arguments.sweep, "Case file; the results are written beside it")
      ->required()
      ->type_name("FILE");
  app.footer(
      "Exit status: 0 if done; 2 for bad arguments or a bad sweep (nothing is run); 1 for any other failure, "
      "such as a "
      "failed case, or if it was stopped.");
}

void requireFewOrYes(const Sweep& sweep, const Arguments& arguments)
{
  if (sweep.size() <= MANY_CASES || arguments.yes)
    return;
  const std::size_t threads = std::max<std::size_t>(arguments.options.threads, 1);
  throw Refusal(sweep.source + ": has " + std::to_string(sweep.size()) + " cases, which take " +
                estimateText(sweep, threads) + " on " + countText(threads, "thread") +
                "; use --yes to run them");
}

SweepOutcome runCases(const Sweep& sweep, const Arguments& arguments)
{
  if (arguments.engine == "threads")
    return runSweep(sweep, arguments.results, arguments.options);
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string program = arguments.program.empty() ? self : arguments.program;
  if (arguments.engine == "slurm")
  {
    SlurmEngine engine(program, arguments.engine_options);
    return runSweepOn(engine, sweep, arguments.results, arguments.options);
  }
  if (arguments.hosts.empty())
    throw Refusal("--engine parallel needs --hosts");
  ParallelEngine engine(arguments.hosts, program);
  return runSweepOn(engine, sweep, arguments.results, arguments.options);
}

int runCaseHere(const std::string& file)
{
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  return runCaseFile(file, [] { return stop_signal != 0; }) ? DONE : FAILED;
}

void warn(const std::string& text)
{
  std::fprintf(stderr, "sieve_sweep: warning: %s\n", text.c_str());
}

/// Runs cases, with handlers of signals, warnings and progress.
template <typename Run>
auto runAttended(SweepRunOptions& options, const Run& cases)
{
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  options.stop_wanted = [] { return stop_signal != 0; };
  options.warn = warn;
  SweepProgressLine line;
  if (line.isVisible())
    options.progress = [&line](const SweepProgress& progress) { line.show(progress); };
  return cases();
}

int listOnly(const Sweep& sweep, const Arguments& arguments)
{
  for (const std::string& line : requireLegal(sweep).lines(sweep.size(), "case"))
    warn(line);
  listCases(sweep, arguments.results, std::cout);
  return DONE;
}

int run(const Sweep& sweep, Arguments& arguments)
{
  if (arguments.options.threads == 0)
    arguments.options.threads = std::max(1u, std::thread::hardware_concurrency());
  requireFewOrYes(sweep, arguments);
  if (arguments.dry_run)
    return listOnly(sweep, arguments);
  const SweepOutcome outcome = runAttended(arguments.options, [&] { return runCases(sweep, arguments); });
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

int exportResults(const Sweep& sweep, const Arguments& arguments)
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
bool checkFloor(const Sweep& sweep, Arguments& arguments, SweepFindings& findings,
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

void writeFindings(const Sweep& sweep, const SweepFindings& findings,
                   const nlohmann::ordered_json& floor_check, const std::string& directory)
{
  nlohmann::ordered_json json = findingsJson(sweep, findings);
  json["floor_check"] = floor_check;
  AtomicFile file(directory + "/findings.json");
  file.stream() << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  file.commit();
}

int report(const Sweep& sweep, Arguments& arguments)
{
  for (const std::string& condition : arguments.where)
  {
    const std::size_t equals = condition.find('=');
    arguments.options.best.where.push_back(
        {condition.substr(0, equals), equals == std::string::npos ? "" : condition.substr(equals + 1)});
  }
  const std::filesystem::path file = arguments.sweep;
  if (arguments.out.empty())
    arguments.out = (file.parent_path() / file.stem()).string() + "_report";
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
  std::vector<std::string> options = {arguments.out, "--title", file.stem().string()};
  options.insert(options.end(), arguments.plot_options.begin(), arguments.plot_options.end());
  const int status = plotTables("ratchet_sieve.plots.sweep", options);
  if (status == DONE)
    for (const std::string& line : findings.lines)
      std::fprintf(stderr, "%s\n", line.c_str());
  return status;
}

int dispatch(const CLI::App& app, Arguments& arguments)
{
  if (app.got_subcommand("case"))
    return runCaseHere(arguments.sweep);
  if (arguments.results.empty())
    arguments.results = std::filesystem::path(arguments.sweep).replace_extension(".db").string();
  try
  {
    const Sweep sweep = loadSweep(arguments.sweep);
    if (app.got_subcommand("run"))
      return run(sweep, arguments);
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
  Arguments arguments;
  CLI::App app("Run many cases of one scene and keep the results in one file.", "sieve_sweep");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return dispatch(app, arguments); });
}
