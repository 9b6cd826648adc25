#include "ratchet_sieve/recording/resimulation.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/recording/commands.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{
/// The first value of a disk that differs.
std::string diskDifference(const DiskState& recorded, const DiskState& now)
{
  struct Field
  {
    const char* name;
    double DiskState::*value;
  };
  for (const auto& [name, value] :
       {Field{"x", &DiskState::x}, Field{"y", &DiskState::y}, Field{"angle", &DiskState::angle},
        Field{"vx", &DiskState::vx}, Field{"vy", &DiskState::vy}, Field{"spin", &DiskState::spin},
        Field{"displacement", &DiskState::displacement}})
    if (!sameBits(recorded.*value, now.*value))
      return fmt::format("{} of disk {} was {}, is {}", name, now.id, recorded.*value, now.*value);
  return fmt::format("disk {} of species {} was disk {} of species {}", now.id, now.species, recorded.id,
                     recorded.species);
}

std::string particleDifference(const ParticleFrame& recorded, const ParticleFrame& now)
{
  if (recorded.disks.size() != now.disks.size())
    return fmt::format("{} disks were recorded, {} are there", recorded.disks.size(), now.disks.size());
  for (std::size_t k = 0; k < now.disks.size(); ++k)
    if (!sameBits(recorded.disks[k], now.disks[k]))
      return diskDifference(recorded.disks[k], now.disks[k]);
  return "nothing";
}

/// What the wall clock and the looking on decide counts for nothing.
StatisticsFrame comparable(StatisticsFrame frame)
{
  frame.real_time_factor = 0.0;
  frame.max_overlap = 0.0;
  return frame;
}

/// The first frames of a later file of a split recording are of periods before it.
StatisticsFrame withoutWindow(StatisticsFrame frame)
{
  frame.window_start = frame.window_end = 0.0;
  frame.collision_rates = {};
  frame.granular_temperature.clear();
  return frame;
}
}  // namespace

Resimulation::Resimulation(std::function<void(const Simulation&)> progress) : progress_(std::move(progress))
{
}
Resimulation::~Resimulation() = default;

bool Resimulation::Instant::empty() const
{
  return particles.empty() && bins.empty() && bases.empty() && statistics.empty() && commands.empty();
}

double Resimulation::time() const
{
  return simulation_ ? simulation_->time() : 0.0;
}

void Resimulation::take(const SceneFrame& frame)
{
  if (scene_)
  {
    if (frame.yaml == scene_->yaml && sameBits(frame.start_time, scene_->start_time))
      return;
    throw std::invalid_argument("holds several runs: another one begins at " + std::to_string(frame.time) +
                                " s");
  }
  if (!(frame.start_time >= 0.0 && frame.start_time <= frame.time))
    throw std::invalid_argument("a run that began at " + std::to_string(frame.start_time) +
                                " s is not recorded from " + std::to_string(frame.time) + " s on");
  scene_ = frame;
  simulation_ = std::make_unique<Simulation>(sceneFromText(frame.yaml, "the recorded scene").definition,
                                             frame.start_time);
}

/// As the one that recorded it did, from where the recording begins.
void Resimulation::observePeriods()
{
  if (std::exchange(periods_observed_, true))
    return;
  simulation_->advanceTo(scene_->time);
  simulation_->observePeriods([this](const PeriodRecord& period) { window_.take(period); });
}

void Resimulation::comeTo(double time)
{
  if (!simulation_)
    throw std::invalid_argument("does not begin with a scene");
  if (time == instant_.time)
    return;
  compareInstant();
  instant_.time = time;
}

void Resimulation::finish()
{
  compareInstant();
  if (!difference_ && frames_ == 0)
    throw std::invalid_argument("holds no state of the run: there is nothing to compare");
  // A later file of a split recording, by itself.
  if (difference_ && scene_->time > scene_->start_time)
    *difference_ += fmt::format("; it is recorded from {:g} s on, and not what the run was told since {:g} s",
                                scene_->time, scene_->start_time);
}

void Resimulation::compareInstant()
{
  if (difference_ || instant_.empty())
    return;
  try
  {
    observePeriods();
    simulation_->advanceTo(instant_.time);
  }
  catch (const StallError&)
  {
    // The run that was recorded ended so, too, or its time tells.
  }
  compareAsThingsAre();
  for (const CommandFrame& command : std::exchange(instant_.commands, {}))
  {
    apply(command, *simulation_);
    ++commands_;
    compareAsThingsAre();
  }
  if (!instant_.empty())
    difference_ = describeDifference();
  if (progress_)
    progress_(*simulation_);
}

template <typename Frame>
void Resimulation::dropSame(std::vector<Frame>& frames, const Frame& now)
{
  const auto end = std::remove_if(frames.begin(), frames.end(),
                                  [&](const Frame& recorded) { return sameBits(recorded, now); });
  frames_ += static_cast<std::uint64_t>(frames.end() - end);
  frames.erase(end, frames.end());
}

void Resimulation::compareAsThingsAre()
{
  if (!instant_.particles.empty())
    dropSame(instant_.particles, makeParticleFrame(*simulation_));
  if (!instant_.bins.empty())
    dropSame(instant_.bins, makeBinFrame(*simulation_));
  if (!instant_.bases.empty())
    dropSame(instant_.bases, makeBaseFrame(*simulation_));
  if (instant_.statistics.empty())
    return;
  window_.moveTo(*simulation_);
  const StatisticsFrame now = comparable(makeStatisticsFrame(*simulation_, window_));
  for (StatisticsFrame& recorded : instant_.statistics)
  {
    recorded = comparable(recorded);
    if (recorded.window_start < scene_->time && sameBits(withoutWindow(recorded), withoutWindow(now)))
      recorded = now;
  }
  dropSame(instant_.statistics, now);
}

std::string Resimulation::describeDifference() const
{
  const auto differs = [&](const char* what)
  { return fmt::format("at {:.17g} s the {} differ", instant_.time, what); };
  if (simulation_->stalled() && simulation_->time() < instant_.time)
    return fmt::format("at {:.17g} s the run stopped: {}", simulation_->time(), simulation_->collapseText());
  if (!instant_.particles.empty())
    return differs("disks") + ": " +
           particleDifference(instant_.particles.front(), makeParticleFrame(*simulation_));
  if (!instant_.bases.empty())
    return differs("base's motions");
  return differs(instant_.bins.empty() ? "statistics" : "counts of the bins");
}

}  // namespace ratchet_sieve
