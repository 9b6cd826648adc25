#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "page_arguments.h"
#include "ratchet_sieve/sweep/sweep_run.h"

namespace ratchet_sieve
{

/// The arguments of sieve_sweep.
struct SweepArguments
{
  std::string sweep;
  std::string results;
  std::string out;
  std::optional<SweepPart> part;          ///< all of the sweep if not given
  std::vector<std::string> parts;         ///< results files to merge
  std::vector<std::string> plot_options;  ///< of ratchet_sieve.plots.sweep, as given
  PageArguments pages;                    ///< of cases; the path is that of their directory
  double least_processed = 0.5;
  double least_counted = 50.0;
  bool check_floor = false;
  bool dry_run = false;
  bool yes = false;
  SweepRunOptions options;

  /// Of the sweep, from its file's.
  std::string name() const { return std::filesystem::path(sweep).stem().string(); }

  /// The results file without --db.
  std::string ownResults() const
  {
    return beside(part ? '.' + std::to_string(part->number) + "-of-" + std::to_string(part->count) + ".db"
                       : ".db");
  }

  /// All options of ratchet_sieve.plots.sweep.
  std::vector<std::string> plotOptions() const;

  /// A path next to the sweep's file.
  std::string beside(const std::string& ending) const
  {
    return (std::filesystem::path(sweep).parent_path() / name()).string() + ending;
  }
};

/// Describes the subcommands of sieve_sweep and their options, which are parsed into `arguments`, and its
/// help.
void describe(CLI::App& app, SweepArguments& arguments);

}  // namespace ratchet_sieve
