#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "page_arguments.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// The arguments of sieve_run.
struct RunArguments
{
  std::string scene;
  std::vector<std::string> overrides;  ///< of --set, --seed, --duration and --until, in this order
  std::string bag;
  double bag_rate = FrameRates().particles;
  std::string trajectory;
  double trajectory_rate = FrameRates().particles;
  PageArguments page;
  double page_rate = PAGE_RATE;
  std::string collisions;
  std::string exits;
  std::string summary;
  std::string checkpoint;
  double checkpoint_every = 60.0;
  std::string resume;
  bool check_floor = false;
  bool verbose = false;  ///< whether the plan is said
  std::size_t threads = 0;
};

/// Describes the options of sieve_run, which are parsed into `arguments`, and its help.
void describe(CLI::App& app, RunArguments& arguments);

}  // namespace ratchet_sieve
