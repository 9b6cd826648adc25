#include "state/machine_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/walls.h"

namespace ratchet_sieve
{
namespace
{
/// Limit for a saved state, in teeth: distance of a disk, and its path within the time scale. So the index of
/// the tooth stays representable within an epoch.
constexpr double FARTHEST_TOOTH = 0x1p28;
constexpr double FASTEST_TOOTH = 0x1p26;

double maxTurn(const SceneDefinition& scene, double largest_diameter)
{
  const bool lattice = scene.boundary == Boundary::PERIODIC && scene.contact.pair_collisions;
  return lattice ? MachineState::LATTICE_MARGIN * largest_diameter / scene.base.width()
                 : std::numeric_limits<double>::infinity();
}

const Plan& covering(const Plan& plan, const SceneDefinition& scene)
{
  if (!covers(plan, scene))
    throw std::invalid_argument("the plan does not cover the scene: " + planText(plan));
  return plan;
}
}  // namespace

MachineState::MachineState(const SceneDefinition& scene, const Plan& plan)
    : scene_(scene),
      plan_(covering(plan, scene)),
      shape_(scene.base, scene.boundary, wallHeight(scene)),
      largest_diameter_(ratchet_sieve::largestDiameter(scene)),
      time_scale_(ratchet_sieve::timeScale(scene)),
      epoch_{0.0, epochLength(time_scale_)},
      motion_(scene.base, maxTurn(scene, largest_diameter_), plan.drive && !planOf(scene).drive),
      search_(shape_, motion_, scene.gravity, timeResolution(epoch_.length), plan.search_above_band),
      passages_(scene.gravity, plan.spin),
      bins_(scene.species.size()),
      pair_scene_{disks_, radii_, motion_, shape_.width(), scene.gravity, timeResolution(epoch_.length)}
{
  for (const SpeciesDefinition& species : scene_.species)
    radii_.push_back(species.radius);
}

/// From the length of the epoch.
void MachineState::setTimeResolution()
{
  pair_scene_.time_resolution = timeResolution(epoch_.length);
  search_.setTimeResolution(pair_scene_.time_resolution);
}

BaseEvent MachineState::nextBaseEvent(std::uint32_t slot, double from, double until, BaseInstant& base) const
{
  // Without gravity there may be no event for very long; one epoch at a time is enough.
  double end = std::min(until, from + epoch_.length);
  const auto change = motion_.nextChange();
  if (change)
    end = std::min(end, *change);
  BaseEvent event = search_.find(disks_[slot], radius(slot), from, end, base);
  if (!event.feature && change && event.time >= *change)
    event.time = std::numeric_limits<double>::infinity();
  return event;
}

void MachineState::reserve(std::size_t count)
{
  disks_.reserve(count);
  active_.reserve(count);
  passages_.reserve(count);
}

std::uint32_t MachineState::add(const Disk& disk)
{
  const auto slot = static_cast<std::uint32_t>(disks_.size());
  disks_.push_back(disk);
  active_.push_back(1);
  ++active_count_;
  ++bins_[disk.species].on_base;
  ids_.added();
  passages_.entered(disk, epoch_.start + disk.time);
  return slot;
}

double MachineState::startAt(double start)
{
  epoch_.start = epoch_.length * std::floor(start / epoch_.length);
  const double local = start - epoch_.start;
  motion_.startAt(local);
  return local;
}

std::vector<std::uint32_t> MachineState::slots(bool active) const
{
  std::vector<std::uint32_t> found;
  found.reserve(active ? active_count_ : disks_.size() - active_count_);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
    if (this->active(slot) == active)
      found.push_back(slot);
  return found;
}

void MachineState::compact(const std::vector<std::uint32_t>& kept)
{
  passages_.keep(kept);
  ids_.keep(kept);
  keepSlots(disks_, kept);
  keepSlots(active_, kept);
}

Disk& MachineState::fly(std::uint32_t slot, double time)
{
  Disk& disk = disks_[slot];
  passages_.flew(slot, disk, time);
  disk = flown(disk, time, scene_.gravity);
  ++disk.flights;
  return disk;
}

void MachineState::passEnd(std::uint32_t slot, bool to_the_right, double time)
{
  if (scene_.boundary == Boundary::PERIODIC)
    wrap(slot, to_the_right ? -1.0 : 1.0, time);
  else
    leave(slot, to_the_right, time);
}

void MachineState::leave(std::uint32_t slot, bool to_the_right, double time)
{
  SpeciesBins& bins = bins_[disks_[slot].species];
  fly(slot, time);
  --bins.on_base;
  ++(to_the_right ? bins.right : bins.left);
  endPassage(slot, time);
}

void MachineState::remove(std::uint32_t slot, double time)
{
  fly(slot, time);
  endPassage(slot, time);
}

void MachineState::endPassage(std::uint32_t slot, double time)
{
  active_[slot] = 0;
  --active_count_;
  passages_.left(slot, epoch_.start + time);
}

void MachineState::wrap(std::uint32_t slot, double shift, double time)
{
  moveTo(slot, image(shift, time), time);
}

void MachineState::moveTo(std::uint32_t slot, const Image& image, double time)
{
  Disk& disk = fly(slot, time);
  disk.position += image.shift;
  disk.velocity += image.velocity;
  passages_.wrapped(slot, -image.shift.x());
}

void MachineState::wrapIntoWidth(std::uint32_t slot, double s, double time)
{
  if (scene_.boundary != Boundary::PERIODIC || motion_.turning())
    return;
  const double laps = wholeWidths(s, 1.0 / shape_.width());
  if (laps != 0.0)
    wrap(slot, -laps, time);
}

/// Wraps all disks when the base begins to turn. Before, an image moves exactly as its disk does.
void MachineState::wrapAll(double time)
{
  if (scene_.boundary != Boundary::PERIODIC)
    return;
  FrameOfBase base = motion_.at(time);
  base.inclination_rate = 0.0;
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
  {
    if (!active(slot))
      continue;
    const double s = search_.seenFromBase(disks_[slot], base, time).s();
    const double laps = wholeWidths(s, 1.0 / shape_.width());
    if (laps != 0.0)
      moveTo(slot, base.image(-laps * shape_.width()), time);
  }
}

void MachineState::archive(StateArchive& state)
{
  state(epoch_, motion_, disks_, active_, active_count_, ids_, passages_, bins_);
  setTimeResolution();
  const std::size_t count = disks_.size();
  const bool of_this_scene = bins_.size() == scene_.species.size() && active_.size() == count &&
                             passages_.size() == count && ids_.fits(count) &&
                             std::all_of(disks_.begin(), disks_.end(),
                                         [this](const Disk& disk) { return disk.species < bins_.size(); });
  if (!of_this_scene)
    throw StateError("it is of another scene");
  state.require(isLegal(), "the state of the machine or of a disk is impossible");
}

bool MachineState::canBeTime(double time) const
{
  return time >= -2.0 * epochLength(time_scale_);
}

bool MachineState::isLegal() const
{
  int exponent = 0;
  if (!std::isfinite(epoch_.start) || epoch_.start < 0.0 || std::frexp(epoch_.length, &exponent) != 0.5 ||
      epoch_.length > epochLength(time_scale_) || epoch_.start + epoch_.length == epoch_.start ||
      !canBeTime(motion_.segmentStart()))
    return false;
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
    if (active_[slot] > 1 || (active(slot) && !isLegal(slot)))
      return false;
  return static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1)) == active_count_;
}

bool MachineState::isLegal(std::uint32_t slot) const
{
  const Disk& disk = disks_[slot];
  const double tooth = shape_.toothWidth();
  return canBeTime(disk.time) && disk.time <= epoch_.length && disk.position.allFinite() &&
         (scene_.boundary != Boundary::PERIODIC ||
          std::abs(motion_.at(disk.time).into(disk.position).x()) <= FARTHEST_TOOTH * tooth) &&
         disk.velocity.lpNorm<Eigen::Infinity>() <= FASTEST_TOOTH * tooth / time_scale_ &&
         std::isfinite(disk.angle) && std::isfinite(disk.spin);
}

double MachineState::smallestRadius() const
{
  return *std::min_element(radii_.begin(), radii_.end());
}

double MachineState::shortenEpoch(double now)
{
  const double longest = longestEpoch(motion_.speedBound(), smallestRadius());
  if (longest >= epoch_.length)
    return 0.0;
  epoch_.length = longest;
  setTimeResolution();
  return epoch_.length * std::floor(now / epoch_.length);
}

void MachineState::rebase(double length)
{
  motion_.rebase(length);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
  {
    // A state older than an epoch is renewed along its flight, because its rounding error grows with the time
    // of flight.
    if (active(slot) && disks_[slot].time < 0.0)
    {
      passages_.flew(slot, disks_[slot], length);
      disks_[slot] = flown(disks_[slot], length, scene_.gravity);
    }
    disks_[slot].time -= length;
  }
  epoch_.start += length;
}

}  // namespace ratchet_sieve
