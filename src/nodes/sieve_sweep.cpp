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
#include "plot_script.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/sweep/case_file.h"
#include "ratchet_sieve/sweep/engine_run.h"
#include "ratchet_sieve/sweep/sweep_report.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace
{

using namespace ratchet_sieve;

/// More are likely a slip, and are asked about.
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
  bool dry_run = false;
  bool yes = false;
  SweepRunOptions options;
};

void describeRun(CLI::App& run, Arguments& arguments)
{
  run.add_option("--threads", arguments.options.threads,
                 "Cases at a time, 0: as many as there are processors")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  run.add_option("--checkpoint-every", arguments.options.checkpoint_period,
                 "Save a case under way so often, in seconds of wall time")
      ->type_name("S")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str();
  run.add_option(
         "--engine", arguments.engine,
         "What runs the cases: the threads of this program, GNU parallel over ssh, or an array of Slurm's")
      ->check(CLI::IsMember({"threads", "parallel", "slurm"}))
      ->capture_default_str();
  run.add_option("--hosts", arguments.hosts, "Hosts of --engine parallel, as its --sshloginfile has them")
      ->type_name("FILE");
  run.add_option("--per-job", arguments.options.per_job,
                 "Cases that an engine runs in one job; 0: so many that there are a thousand jobs at most")
      ->type_name("N")
      ->check(CLI::Range(0, 1'000'000'000))
      ->capture_default_str();
  run.add_option("--sbatch", arguments.engine_options,
                 "An option of sbatch, such as --sbatch=--partition=short; may be given again")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  run.add_option("--program", arguments.program, "This program on the hosts; without it where it is here")
      ->type_name("FILE");
  run.add_flag("--retry-failed", arguments.options.retry_failed, "Run cases again that failed");
  run.add_flag("--dry-run", arguments.dry_run, "List the cases, run none");
  run.add_flag("--yes", arguments.yes, "Run more than a million cases");
}

void describeReport(CLI::App& report, Arguments& arguments)
{
  report
      .add_option("--out", arguments.out,
                  "Directory of the report; without it SWEEP_report, beside the sweep")
      ->type_name("DIR");
  const auto plot_option = [&](const std::string& name, const char* type, const char* text)
  {
    const auto take = [&arguments, name](const std::vector<std::string>& values)
    {
      for (const std::string& value : values)
        arguments.plot_options.insert(arguments.plot_options.end(), {name, value});
    };
    report.add_option_function<std::vector<std::string>>(name, take, text)
        ->type_name(type)
        ->allow_extra_args(false);
  };
  plot_option("--x", "KEY", "Along x; without it the key with the most values");
  plot_option("--y", "KEY", "Along y of a map, and one curve for each of its values");
  plot_option("--field", "NAME",
              "A column to be drawn, may be given again; without it Q, P, what leaves, velocities");
  plot_option("--where", "KEY=VALUE", "Only cases of this value, may be given again");
}

void describe(CLI::App& app, Arguments& arguments)
{
  app.require_subcommand(1);
  const auto verb = [&](const char* name, const char* text)
  {
    CLI::App* command = app.add_subcommand(name, text);
    command->add_option("SWEEP", arguments.sweep, "The sweep, a YAML file")->required()->type_name("FILE");
    command->add_option("--db", arguments.results, "Results file; without it SWEEP.db, beside the sweep")
        ->type_name("FILE");
    return command;
  };
  describeRun(*verb("run", "Run the cases of which there is no result yet"), arguments);
  verb("status", "Say how far the sweep is");
  verb("export", "Write the results as CSV")
      ->add_option("--out", arguments.out, "Into this file, not to standard output")
      ->type_name("FILE");
  describeReport(
      *verb("report", "Draw curves and maps of the results, averaged over the seeds, and a page of them"),
      arguments);
  app.add_subcommand("case", "Run the cases of a file that an engine hands over")
      ->add_option("CASE", arguments.sweep, "The file; what comes of it is written beside it")
      ->required()
      ->type_name("FILE");
  app.footer(
      "Exit status: 0 done; 2 bad arguments or bad sweep, nothing run; 1 anything else, such as a case that "
      "failed, or an interruption.");
}

void requireFewOrYes(const Sweep& sweep, const Arguments& arguments)
{
  if (sweep.size() <= MANY_CASES || arguments.yes)
    return;
  const std::size_t threads = std::max<std::size_t>(arguments.options.threads, 1);
  throw Refusal(sweep.source + ": has " + std::to_string(sweep.size()) + " cases, which take " +
                estimateText(sweep, threads) + " on " + std::to_string(threads) +
                " threads; --yes runs them");
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

int run(const Sweep& sweep, Arguments& arguments)
{
  if (arguments.options.threads == 0)
    arguments.options.threads = std::max(1u, std::thread::hardware_concurrency());
  requireFewOrYes(sweep, arguments);
  if (arguments.dry_run)
  {
    requireLegal(sweep);
    listCases(sweep, arguments.results, std::cout);
    return DONE;
  }
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  arguments.options.stop_wanted = [] { return stop_signal != 0; };
  arguments.options.warn = [](const std::string& text)
  { std::fprintf(stderr, "sieve_sweep: warning: %s\n", text.c_str()); };
  SweepOutcome outcome;
  {
    SweepProgressLine line;
    arguments.options.progress = [&line](const SweepProgress& progress) { line.show(progress); };
    outcome = runCases(sweep, arguments);
  }
  const SweepCounts& counts = outcome.counts;
  if (outcome.stopped)
  {
    std::fprintf(stderr, "sieve_sweep: stopped, %llu of %llu cases to go; the same command goes on\n",
                 static_cast<unsigned long long>(counts.open()),
                 static_cast<unsigned long long>(counts.cases));
    return FAILED;
  }
  std::fputs(statusText(sweep, arguments.results).c_str(), stderr);
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

int report(const Sweep& sweep, Arguments& arguments)
{
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
  std::vector<std::string> options = {arguments.out, "--title", file.stem().string()};
  options.insert(options.end(), arguments.plot_options.begin(), arguments.plot_options.end());
  return plotTables("plot_sweep.py", options);
}

int obey(const CLI::App& app, Arguments& arguments)
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
    std::fputs(statusText(sweep, arguments.results).c_str(), stdout);
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
  CLI::App app("Runs many cases of a scene, and keeps what comes of them in one file.", "sieve_sweep");
  describe(app, arguments);
  return runProgram(app, argc, argv, [&] { return obey(app, arguments); });
}
