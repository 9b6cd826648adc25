#include "ratchet_sieve/live/run_mirror.h"

#include <algorithm>

#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{
/// Base frames kept for disks that arrive after the base of their time: more than a second at the default
/// rates.
constexpr std::size_t BASES_KEPT = 100;

/// The base extrapolated to a slightly later time: the phase advances, setpoints being slewed to do not.
BaseFrame carriedOn(const SceneDefinition& scene, BaseFrame frame, double time)
{
  if (frame.time == time)
    return frame;
  BaseDefinition drive = withAmplitude(scene.base, frame.base.amplitude);
  drive.inclination = frame.base.inclination;
  drive.frequency = frame.base.frequency;
  drive.phase = frame.base.phase;
  const DriveState later = driveStateAt(drive, time - frame.time);
  frame.base.phase = later.phase;
  frame.base.displacement = later.displacement;
  frame.base.velocity = later.velocity;
  frame.base.horizontal_displacement = later.horizontal_displacement;
  frame.base.horizontal_velocity = later.horizontal_velocity;
  frame.time = time;
  return frame;
}

/// Whether a base can move so. Other frames are damaged, and cannot be carried on.
bool isLegal(const DriveState& base)
{
  constexpr Interval TURN{0.0, 6.2831854};  // [rad]
  return TURN.contains(base.phase) &&
         std::all_of(COMMANDED_QUANTITIES.begin(), COMMANDED_QUANTITIES.end(),
                     [&](const CommandedQuantity& q) { return q.legal.contains(base.*q.applied); });
}
}  // namespace

void RunMirror::take(const AnyFrame& any)
{
  any.visit([this](const auto& frame) { see(frame); });
}

void RunMirror::see(const SceneFrame& frame)
{
  if (scene_ && frame.yaml == yaml_)
    return;
  try
  {
    scene_ = sceneFromText(frame.yaml, "scene").definition;
    scene_error_.reset();
    yaml_ = frame.yaml;
  }
  catch (const SceneError& error)
  {
    scene_error_ = error.what();
  }
}

template <typename Frame>
void RunMirror::see(const Frame& frame, std::optional<Frame>& last)
{
  if (last && frame.time < last->time)
    jumpBackTo(frame.time);
  last = frame;
}

void RunMirror::see(const BaseFrame& frame)
{
  if (!isLegal(frame.base))
    return;
  if (!bases_.empty() && frame.time < bases_.back().time)
    jumpBackTo(frame.time);
  bases_.push_back(frame);
  if (bases_.size() > BASES_KEPT)
    bases_.pop_front();
}

/// Discards the frames of later times, which are from before the jump.
void RunMirror::jumpBackTo(double time)
{
  if (particles_ && particles_->time > time)
    particles_.reset();
  if (bins_ && bins_->time > time)
    bins_.reset();
  if (statistics_ && statistics_->time > time)
    statistics_.reset();
  bases_.erase(
      std::find_if(bases_.begin(), bases_.end(), [time](const BaseFrame& base) { return base.time > time; }),
      bases_.end());
}

std::optional<double> RunMirror::time() const
{
  if (!scene_)
    return {};
  if (particles_)
    return particles_->time;
  if (!bases_.empty())
    return bases_.back().time;
  return bins_ ? std::optional<double>(bins_->time) : std::nullopt;
}

BaseFrame RunMirror::baseAt(double time) const
{
  if (bases_.empty())
    return carriedOn(*scene_, {0.0, driveStateAt(scene_->base, 0.0)}, time);
  const auto later = std::upper_bound(bases_.begin(), bases_.end(), time,
                                      [](double t, const BaseFrame& base) { return t < base.time; });
  return carriedOn(*scene_, later == bases_.begin() ? *later : *std::prev(later), time);
}

Picture RunMirror::picture() const
{
  Picture picture{*scene_, baseAt(*time()), {}, {}, {}};
  const auto is_known = [this](const DiskState& disk) { return disk.species < scene_->species.size(); };
  if (particles_ && std::all_of(particles_->disks.begin(), particles_->disks.end(), is_known))
    picture.particles = particles_;
  if (bins_ && bins_->bins.size() == scene_->species.size())
    picture.bins = bins_;
  if (statistics_ && statistics_->species.size() == scene_->species.size())
    for (const SpeciesRow& species : statistics_->species)
      picture.means.push_back(species.means);
  return picture;
}

}  // namespace ratchet_sieve
