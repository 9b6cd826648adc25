#include "state/system_state.h"

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
  return lattice ? SystemState::LATTICE_MARGIN * largest_diameter / scene.base.width()
                 : std::numeric_limits<double>::infinity();
}

const Plan& covering(const Plan& plan, const SceneDefinition& scene)
{
  if (!covers(plan, scene))
    throw std::invalid_argument("the plan does not cover the scene: " + planText(plan));
  return plan;
}
}  // namespace

SystemState::SystemState(const SceneDefinition& scene, const Plan& plan)
    : scene_(scene),
      sizes_(scene.species.begin(), scene.species.end()),
      size_classes_(ratchet_sieve::sizeClasses(scene)),
      plan_(covering(plan, scene)),
      sawtooth_(scene.base, scene.boundary, wallHeight(scene)),
      largest_diameter_(ratchet_sieve::largestDiameter(scene)),
      time_scale_(ratchet_sieve::timeScale(scene)),
      epoch_{0.0, epochLength(time_scale_)},
      motion_(scene.base, maxTurn(scene, largest_diameter_), plan.drive && !planOf(scene).drive),
      search_(sawtooth_, motion_, scene.gravity, timeResolution(epoch_.length), plan.search_above_band),
      trajectories_(scene.gravity, plan.spin),
      bins_(scene.species.size()),
      size_class_bins_(size_classes_.size()),
      pair_scene_{disks_, motion_, sawtooth_.width(), scene.gravity, timeResolution(epoch_.length)}
{
}

/// From the length of the epoch.
void SystemState::setTimeResolution()
{
  pair_scene_.time_resolution = timeResolution(epoch_.length);
  search_.setTimeResolution(pair_scene_.time_resolution);
}

BaseEvent SystemState::nextBaseEvent(std::uint32_t slot, double from, double until, BaseInstant& base) const
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

void SystemState::reserve(std::size_t count)
{
  disks_.reserve(count);
  grains_.reserve(count);
  active_.reserve(count);
  trajectories_.reserve(count);
}

std::uint32_t SystemState::add(const Disk& disk, const Grain& grain)
{
  const auto slot = static_cast<std::uint32_t>(disks_.size());
  disks_.push_back(disk);
  grains_.push_back(grain);
  active_.push_back(1);
  ++active_count_;
  countIn(disk, [](SpeciesBins& bins) { ++bins.on_base; });
  ids_.added();
  trajectories_.entered(disk, epoch_.start + disk.time);
  return slot;
}

std::size_t SystemState::sizeClassOf(const Disk& disk) const
{
  std::size_t found = size_classes_.size();
  for (std::size_t k = 0; k < size_classes_.size(); ++k)
    if (size_classes_[k].species == disk.species && (found > k || disk.radius >= size_classes_[k].smallest))
      found = k;
  return found;
}

/// In the bins of its species, and of its size class if it has one.
template <typename Count>
void SystemState::countIn(const Disk& disk, Count&& count)
{
  count(bins_[disk.species]);
  if (const std::size_t size_class = sizeClassOf(disk); size_class < size_class_bins_.size())
    count(size_class_bins_[size_class]);
}

double SystemState::startAt(double start)
{
  epoch_.start = epoch_.length * std::floor(start / epoch_.length);
  const double local = start - epoch_.start;
  motion_.startAt(local);
  return local;
}

std::vector<std::uint32_t> SystemState::slots(bool active) const
{
  std::vector<std::uint32_t> found;
  found.reserve(active ? active_count_ : disks_.size() - active_count_);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
    if (this->active(slot) == active)
      found.push_back(slot);
  return found;
}

void SystemState::compact(const std::vector<std::uint32_t>& kept)
{
  trajectories_.keep(kept);
  ids_.keep(kept);
  keepSlots(disks_, kept);
  keepSlots(grains_, kept);
  keepSlots(active_, kept);
}

Disk& SystemState::fly(std::uint32_t slot, double time)
{
  Disk& disk = disks_[slot];
  trajectories_.flew(slot, disk, time);
  disk = flown(disk, time, scene_.gravity);
  ++disk.flights;
  return disk;
}

void SystemState::passEnd(std::uint32_t slot, bool to_the_right, double time)
{
  if (scene_.boundary == Boundary::PERIODIC)
    wrap(slot, to_the_right ? -1.0 : 1.0, time);
  else
    leave(slot, to_the_right, time);
}

void SystemState::leave(std::uint32_t slot, bool to_the_right, double time)
{
  fly(slot, time);
  countIn(disks_[slot],
          [to_the_right](SpeciesBins& bins)
          {
            --bins.on_base;
            ++(to_the_right ? bins.right : bins.left);
          });
  endTrajectory(slot, time);
}

void SystemState::remove(std::uint32_t slot, double time)
{
  fly(slot, time);
  endTrajectory(slot, time);
}

void SystemState::endTrajectory(std::uint32_t slot, double time)
{
  active_[slot] = 0;
  --active_count_;
  trajectories_.left(slot, epoch_.start + time);
}

void SystemState::wrap(std::uint32_t slot, double shift, double time)
{
  moveTo(slot, image(shift, time), time);
}

void SystemState::moveTo(std::uint32_t slot, const Image& image, double time)
{
  Disk& disk = fly(slot, time);
  disk.position += image.shift;
  disk.velocity += image.velocity;
  trajectories_.wrapped(slot, -image.shift.x());
}

void SystemState::wrapIntoWidth(std::uint32_t slot, double s, double time)
{
  if (scene_.boundary != Boundary::PERIODIC || motion_.turning())
    return;
  const double laps = wholeWidths(s, 1.0 / sawtooth_.width());
  if (laps != 0.0)
    wrap(slot, -laps, time);
}

/// Wraps all disks when the base begins to turn. Before, an image moves exactly as its disk does.
void SystemState::wrapAll(double time)
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
    const double laps = wholeWidths(s, 1.0 / sawtooth_.width());
    if (laps != 0.0)
      moveTo(slot, base.image(-laps * sawtooth_.width()), time);
  }
}

void SystemState::archive(StateArchive& state)
{
  state(epoch_, motion_, disks_, grains_, active_, active_count_, ids_, trajectories_, bins_,
        size_class_bins_);
  setTimeResolution();
  const std::size_t count = disks_.size();
  const bool of_this_scene = bins_.size() == scene_.species.size() &&
                             size_class_bins_.size() == size_classes_.size() && active_.size() == count &&
                             grains_.size() == count && trajectories_.size() == count && ids_.fits(count) &&
                             std::all_of(disks_.begin(), disks_.end(),
                                         [this](const Disk& disk) { return disk.species < bins_.size(); });
  if (!of_this_scene)
    throw StateError("it is of another scene");
  state.require(isLegal(), "the state of the machine or of a disk is impossible");
}

bool SystemState::canBeTime(double time) const
{
  return time >= -2.0 * epochLength(time_scale_);
}

bool SystemState::isLegal() const
{
  int exponent = 0;
  if (!std::isfinite(epoch_.start) || epoch_.start < 0.0 || std::frexp(epoch_.length, &exponent) != 0.5 ||
      epoch_.length > epochLength(time_scale_) || epoch_.start + epoch_.length == epoch_.start ||
      !canBeTime(motion_.segmentStart()))
    return false;
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
    if (active_[slot] > 1 || !hasLegalGrain(slot) || (active(slot) && !isLegal(slot)))
      return false;
  return static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1)) == active_count_;
}

bool SystemState::hasLegalGrain(std::uint32_t slot) const
{
  const Disk& disk = disks_[slot];
  const Sizes& sizes = sizes_[disk.species];
  return disk.radius >= sizes.smallest() && disk.radius <= sizes.largest() &&
         grains_[slot].mass == scene_.species[disk.species].massOf(disk.radius);
}

bool SystemState::isLegal(std::uint32_t slot) const
{
  const Disk& disk = disks_[slot];
  const double tooth = sawtooth_.toothWidth();
  return canBeTime(disk.time) && disk.time <= epoch_.length && disk.position.allFinite() &&
         (scene_.boundary != Boundary::PERIODIC ||
          std::abs(motion_.at(disk.time).into(disk.position).x()) <= FARTHEST_TOOTH * tooth) &&
         disk.velocity.lpNorm<Eigen::Infinity>() <= FASTEST_TOOTH * tooth / time_scale_ &&
         std::isfinite(trajectories_[slot].angle) && std::isfinite(disk.spin);
}

double SystemState::smallestRadius() const
{
  return ratchet_sieve::smallestRadius(scene_);
}

double SystemState::shortenEpoch(double now)
{
  const double longest = longestEpoch(motion_.speedBound(), smallestRadius());
  if (longest >= epoch_.length)
    return 0.0;
  epoch_.length = longest;
  setTimeResolution();
  return epoch_.length * std::floor(now / epoch_.length);
}

void SystemState::rebase(double length)
{
  motion_.rebase(length);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
  {
    // A state older than an epoch is renewed along its flight, because its rounding error grows with the time
    // of flight.
    if (active(slot) && disks_[slot].time < 0.0)
    {
      trajectories_.flew(slot, disks_[slot], length);
      disks_[slot] = flown(disks_[slot], length, scene_.gravity);
    }
    disks_[slot].time -= length;
  }
  epoch_.start += length;
}

}  // namespace ratchet_sieve
