#include "sweep_arguments.h"

#include <algorithm>

#include <fmt/format.h>

#include "command_line.h"
#include "ratchet_sieve/scene/parsed.h"

namespace ratchet_sieve
{
namespace
{

constexpr std::uint64_t MOST_PARTS = 1'000'000;

void describeThreads(CLI::App& command, SweepArguments& arguments)
{
  command
      .add_option("--threads", arguments.options.threads,
                  "Number of cases run at the same time, at most 1024; 0: one per processor")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

/// The limits for the best setting, which is the one with the highest mean Q.
void describeBest(CLI::App& command, SweepArguments& arguments)
{
  command
      .add_option("--least-processed", arguments.least_processed,
                  "Least P of the best setting, averaged over its seeds, from 0 to 1")
      ->type_name("P")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command
      .add_option("--least-counted", arguments.least_counted,
                  "Least number of disks that left in the best setting, averaged over its seeds: Q of few "
                  "disks can be "
                  "high by chance")
      ->type_name("N")
      ->check(CLI::Range(0.0, 1e12))
      ->capture_default_str();
}

/// Which cases of the sweep are meant; their results are in a file of their own.
void describePart(CLI::App& command, SweepArguments& arguments)
{
  const auto take = [&arguments](const std::string& text)
  {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto number = parsed<std::uint64_t>(text.substr(0, slash));
    const auto count = parsed<std::uint64_t>(text.substr(std::min(slash + 1, text.size())));
    if (!number || !count || *number < 1 || *number > *count || *count > MOST_PARTS)
      throw CLI::ValidationError("--part " + text + ": must be K/N, a part from 1 to the number of parts");
    arguments.part = SweepPart{*number, *count};
  };
  command
      .add_option_function<std::string>(
          "--part", take,
          "Only every N-th case from the K-th on, as another machine runs the others; --db then is "
          "SWEEP.K-of-N.db if not given")
      ->type_name("K/N");
}

void describePages(CLI::App& run, SweepArguments& arguments)
{
  CLI::Option* html =
      run.add_option(
             "--html", arguments.pages.path,
             "Keep each case that is run as an HTML page in this directory, as sieve_run --html does, "
             "for report to link to")
          ->type_name("DIR");
  describeSize(run, arguments.pages, html);
}

void describeRun(CLI::App& run, SweepArguments& arguments)
{
  describeThreads(run, arguments);
  run.add_option("--checkpoint-every", arguments.options.checkpoint_period,
                 "Period at which a running case is saved [s of wall time]")
      ->type_name("S")
      ->check(within(0.0, 1e9, "s"))
      ->capture_default_str();
  describePart(run, arguments);
  describePages(run, arguments);
  run.add_flag("--retry-failed", arguments.options.retry_failed, "Run failed cases again");
  run.add_flag(
      "--dry-run", arguments.dry_run,
      "List the cases, estimate what they cost from a short run of each corner of the grid, and keep no "
      "results");
  run.add_flag("--yes", arguments.yes, "Confirm a sweep of more than a million cases");
}

/// Options that are those of ratchet_sieve.plots.sweep.
void describePlots(CLI::App& report, SweepArguments& arguments)
{
  const auto plot_option = [&](const std::string& name, const char* type, const char* text)
  {
    const auto take = [&arguments, name](const std::vector<std::string>& values)
    {
      for (const std::string& value : values)
        arguments.plot_options.push_back(fmt::format("{}={}", name, value));
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

void describeReport(CLI::App& report, SweepArguments& arguments)
{
  report
      .add_option("--out", arguments.out,
                  "Directory of the report; without this option SWEEP_report beside the sweep")
      ->type_name("DIR");
  report
      .add_option("--html", arguments.pages.path,
                  "Directory of the pages that run --html has kept, to which the report links; without this "
                  "option SWEEP_runs beside the sweep")
      ->type_name("DIR");
  describePlots(report, arguments);
  describeBest(report, arguments);
  report.add_flag(
      "--check-floor", arguments.check_floor,
      "Run the seeds of the best setting again at a half and a quarter of contact.min_rebound_speed, into "
      "the results file, and print whether Q depends on it");
  describeThreads(report, arguments);
}

}  // namespace

std::vector<std::string> SweepArguments::plotOptions() const
{
  std::vector<std::string> all = {out,
                                  "--title=" + name(),
                                  "--html=" + pages.path,
                                  fmt::format("--least-processed={}", least_processed),
                                  fmt::format("--least-counted={}", least_counted),
                                  "--threads=" + std::to_string(options.threads)};
  if (check_floor)
    all.push_back("--check-floor=" + results);
  all.insert(all.end(), plot_options.begin(), plot_options.end());
  return all;
}

void describe(CLI::App& app, SweepArguments& arguments)
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
  describePart(*verb("status", "Print the progress of the sweep"), arguments);
  verb("export", "Write the results as CSV")
      ->add_option("--out", arguments.out, "Write to a file instead of standard output")
      ->type_name("FILE");
  describeReport(
      *verb("report", "Draw curves and maps of the results, averaged over the seeds, as an HTML page"),
      arguments);
  verb("merge", "Copy the results of the sweep's parts into its results file")
      ->add_option("FILE", arguments.parts, "Results file of a part, which stays as it is; repeatable")
      ->required()
      ->type_name("FILE");
  app.footer(
      "Exit status: 0 if done; 2 for bad arguments or a bad sweep (nothing is run); 1 for any other failure, "
      "such as a "
      "failed case, or if it was stopped.");
}

}  // namespace ratchet_sieve
