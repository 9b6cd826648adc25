#include "mixture_run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace ratchet_sieve::peers
{
namespace
{
#ifdef __clang__
constexpr const char* COMPILER = __VERSION__;
#else
constexpr const char* COMPILER = "GCC " __VERSION__;
#endif

/// Disks this near to an end are left out of the audit [m]: two teeth. A program without a periodic boundary
/// moves disks onto each other there, independently of its solver, and some need a tenth of a second to
/// separate.
constexpr double SEAM = 0.040;

/// A fraction of a block, so that the rounding of k * LOOK does not delay its end to the next sample.
constexpr double ROUNDING = 1e-6;
}  // namespace

Watch::Watch(const SceneDefinition& scene, std::vector<std::uint32_t> species)
    : kinds_(scene.species), species_(std::move(species)), shape_(scene.base, scene.boundary)
{
}

void Watch::restart(double time, const std::vector<double>& x)
{
  block_start_ = time;
  x_at_block_start_ = x;
  blocks_.clear();
  largest_overlap_ = 0.0;
  largest_base_overlap_ = 0.0;
  most_behind_base_ = 0;
}

void Watch::look(double time, double base_y, const std::vector<double>& x, const std::vector<Point>& place)
{
  if (time - block_start_ >= BLOCK * (1.0 - ROUNDING))
    endBlock(time, x);
  audit(base_y, place);
}

void Watch::endBlock(double time, const std::vector<double>& x)
{
  std::vector<double> sums(kinds_.size(), 0.0);
  std::vector<double> counts(kinds_.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    sums[species_[i]] += x[i] - x_at_block_start_[i];
    counts[species_[i]] += 1.0;
  }
  for (std::size_t s = 0; s < sums.size(); ++s)
    sums[s] /= counts[s] * (time - block_start_);
  blocks_.push_back(sums);
  block_start_ = time;
  x_at_block_start_ = x;
}

void Watch::audit(double base_y, const std::vector<Point>& place)
{
  std::vector<std::size_t> by_x;
  std::size_t behind = 0;
  for (std::size_t i = 0; i < place.size(); ++i)
  {
    const double height = shape_.heightAbove(place[i].x, place[i].y - base_y);
    behind += height < 0.0;
    if (place[i].x > SEAM && place[i].x < shape_.width() - SEAM)
    {
      by_x.push_back(i);
      if (height > 0.0)
        largest_base_overlap_ = std::max(largest_base_overlap_, kinds_[species_[i]].radius - height);
    }
  }
  most_behind_base_ = std::max(most_behind_base_, behind);
  std::sort(by_x.begin(), by_x.end(), [&](auto a, auto b) { return place[a].x < place[b].x; });
  const auto radius = [&](std::size_t i) { return kinds_[species_[i]].radius; };
  double largest = 0.0;
  for (const SpeciesDefinition& kind : kinds_)
    largest = std::max(largest, kind.radius);
  for (std::size_t a = 0; a < by_x.size(); ++a)
    for (std::size_t b = a + 1; b < by_x.size(); ++b)
    {
      const Point& p = place[by_x[a]];
      const Point& q = place[by_x[b]];
      if (q.x - p.x > 2.0 * largest)
        break;
      const double overlap = radius(by_x[a]) + radius(by_x[b]) - std::hypot(q.x - p.x, q.y - p.y);
      largest_overlap_ = std::max(largest_overlap_, overlap);
    }
}

RunOptions readOptions(int argc, char** argv, const std::string& what, const std::vector<OwnOption>& own,
                       std::vector<std::string>* chosen)
{
  RunOptions options;
  std::vector<std::string> values;
  for (const OwnOption& option : own)
    values.push_back(option.values.front());
  CLI::App app(what + ": the mixture of Fig. 8, for compare_peers.py. Prints one line of JSON.");
  app.add_option("--seed", options.seed, "of the disks' places at the start");
  app.add_option("--settle", options.settle, "simulated before anything is counted [s]");
  app.add_option("--duration", options.duration, "simulated after that [s]");
  app.add_option("--step", options.step, "time step, if the program has one [s]")->check(CLI::PositiveNumber);
  for (std::size_t i = 0; i < own.size(); ++i)
    app.add_option(own[i].name, values[i], own[i].help)->check(CLI::IsMember(own[i].values));
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    std::exit(app.exit(error) == 0 ? 0 : 2);
  }
  if (chosen != nullptr)
    *chosen = values;
  return options;
}

void print(const Outcome& outcome, const RunOptions& options, const Watch& watch)
{
  nlohmann::json line;
  line["program"] = outcome.program;
  line["version"] = outcome.version;
  line["compiler"] = COMPILER;
  line["configuration"] = outcome.configuration;
  line["step"] = outcome.step ? nlohmann::json(*outcome.step) : nlohmann::json();
  line["seed"] = options.seed;
  line["settle"] = options.settle;
  line["duration"] = options.duration;
  line["wall_seconds"] = outcome.wall_seconds;
  line["processor_seconds"] = outcome.processor_seconds;
  line["collisions"] = outcome.collisions;
  line["lost"] = outcome.lost;
  line["behind_base"] = watch.mostBehindBase();
  line["overlap"] = watch.largestOverlap();
  line["base_overlap"] = watch.largestBaseOverlap();
  line["drift_blocks"] = watch.blocks();
  std::printf("%s\n", line.dump().c_str());
}

}  // namespace ratchet_sieve::peers
