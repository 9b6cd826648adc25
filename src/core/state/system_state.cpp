#include "state/system_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/geometry/size_levels.h"

namespace ratchet_sieve
{
namespace
{
/// Smallest number of slots that compaction removes. Usual runs never reach it; a machine with an endless
/// feed is compacted once in a while.
constexpr std::size_t LEAST_COMPACTED = 1024;

/// What latticeMargin() may be [lattice diameters]: cells are so much wider while a periodic base turns.
constexpr double LATTICE_MARGIN = 0.05;
constexpr double LATTICE_MARGIN_OF_WIDE = 0.45;

/// The lattice may rise so far across the width [lattice diameters]. With more, the disks at the ends would
/// be far from the rows that are meant for them; with less, cells are built anew more often.
constexpr double LATTICE_ROWS = 2.0;

/// Speed of a fall from a tooth's height; without gravity, a tooth per time scale [m/s].
double speedScale(const SceneDefinition& scene, double time_scale)
{
  const double width = scene.base.toothWidth();
  return scene.gravity > 0.0 ? std::sqrt(scene.gravity * width) : width / time_scale;
}

double latticeDiameter(const SceneDefinition& scene, double largest_diameter)
{
  double disks = 0.0;
  double squares = 0.0;
  const auto add = [&](const SpeciesDefinition& species, double count)
  {
    disks += count;
    squares += count * 4.0 * Sizes(species).meanSquare();
  };
  for (const SpeciesDefinition& species : scene.species)
    add(species, species.count);
  for (const InitialDisk& disk : scene.initial)
    add(scene.species[disk.species], 1.0);
  disks += static_cast<double>(scene.feed.disks.size());
  for (const FedDisk& disk : scene.feed.disks)
    squares += 4.0 * disk.radius * disk.radius;
  if (disks == 0.0)
    for (const SpeciesDefinition& species : scene.species)
      add(species, species.share);
  return disks > 0.0 && areWide(largest_diameter, squares / disks) ? std::sqrt(squares / disks)
                                                                   : largest_diameter;
}

/// See SystemState::latticeTurn().
double latticeTurn(const SceneDefinition& scene, double lattice_diameter, bool wide)
{
  if (scene.boundary != Boundary::PERIODIC || !scene.contact.pair_collisions)
    return std::numeric_limits<double>::infinity();
  const double diameters = lattice_diameter / scene.base.width();
  return wide ? LATTICE_MARGIN_OF_WIDE * diameters
              : std::min(std::sqrt(2.0 * LATTICE_MARGIN * diameters), LATTICE_ROWS * diameters);
}
}  // namespace

SystemState::SystemState(const SceneDefinition& scene)
    : scene_(scene),
      sizes_(scene.species.begin(), scene.species.end()),
      size_classes_(ratchet_sieve::sizeClasses(scene)),
      plan_(planOf(scene)),
      shape_(scene.base, scene.boundary, wallHeight(scene)),
      largest_diameter_(ratchet_sieve::largestDiameter(scene)),
      lattice_diameter_(ratchet_sieve::latticeDiameter(scene, largest_diameter_)),
      lattice_turn_(ratchet_sieve::latticeTurn(scene, lattice_diameter_, wideSizes())),
      time_scale_(ratchet_sieve::timeScale(scene)),
      epoch_{0.0, std::min(epochLength(time_scale_),
                           longestFall(scene.gravity, ratchet_sieve::smallestRadius(scene)))},
      motion_(scene.base, 2.0 * lattice_turn_),
      collapse_watch_(scene.contact, time_scale_, speedScale(scene, time_scale_), records_, ids_),
      sums_{ContactSums(scene.species.size()), Averages(*this), EnergyWatch(*this)},
      log_(*this)
{
}

double SystemState::latticeMargin() const
{
  return wideSizes() ? LATTICE_MARGIN_OF_WIDE * lattice_diameter_
                     : shape_.width() * (1.0 - std::cos(lattice_turn_));
}

void SystemState::reserve(std::size_t count)
{
  disks_.reserve(count);
  records_.reserve(count);
}

std::uint32_t SystemState::add(Disk disk, const DiskProperties& properties, double time)
{
  DiskRecord record;
  record.properties = properties;
  record.entered_x = disk.position.x();
  record.counted_x = record.entered_x;
  record.counted_from = epoch_.start + time;
  moveZero(disk, -time, scene_.gravity);
  record.fly(disk, time, scene_.gravity, -1.0);
  collapse_watch_.added(properties.mass);
  log_.entered(disk, time);
  const auto slot = static_cast<std::uint32_t>(disks_.size());
  disks_.push_back(disk);
  records_.push_back(record);
  ++active_count_;
  ids_.added();
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

double SystemState::startAt(double start)
{
  epoch_.start = epoch_.length * std::floor(start / epoch_.length);
  const double local = start - epoch_.start;
  motion_.startAt(local);
  collapse_watch_.setEpoch(epoch_.start);
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

void SystemState::closePaths()
{
  for (std::uint32_t slot = 0; slot < records_.size(); ++slot)
    if (DiskRecord& record = records_[slot]; !record.active && record.counts())
    {
      sums_.averages.close(slot);
      record.counted_from = DiskRecord::NEVER;
    }
}

bool SystemState::compact()
{
  const std::size_t gone = disks_.size() - active_count_;
  if (gone < LEAST_COMPACTED || gone <= active_count_)
    return false;
  const std::vector<std::uint32_t> kept = slots(true), forgotten = slots(false);
  closePaths();
  for (const std::uint32_t slot : forgotten)
    impulse_of_gone_ += records_[slot].base_impulse;
  log_.keep(kept);
  ids_.keep(kept);
  keepSlots(disks_, kept);
  keepSlots(records_, kept);
  return true;
}

void SystemState::passEnd(std::uint32_t slot, bool to_the_right, double time, ThreadBuffer* buffer)
{
  if (scene_.boundary == Boundary::PERIODIC)
    return wrap(slot, to_the_right ? -1.0 : 1.0, time, buffer);
  Disk& disk = disks_[slot];
  log_.flew(slot, disk, time, buffer);
  disk.position = positionAt(disk, time, scene_.gravity);
  disk.countEvent();
  DiskRecord& record = records_[slot];
  record.fly(disk, time, scene_.gravity);
  record.left_when = epoch_.start + time;
  record.active = false;
  const Departure departure{slot, disk.species, record.properties.mass,
                            to_the_right ? Exit::RIGHT_BIN : Exit::LEFT_BIN, time};
  if (buffer == nullptr)
    --active_count_;
  log_.departed(departure, buffer);
}

void SystemState::merge(ThreadBuffer&& buffer)
{
  active_count_ -= buffer.departures;
  sums_.contacts.add(buffer.contacts);
  log_.take(std::exchange(buffer.reports, {}));
}

void SystemState::restart(double time)
{
  sums_.contacts.restart();
  sums_.averages.restart();
  log_.restart(time);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
    records_[slot].count(disks_[slot], time, epoch_.start, scene_.gravity);
  impulse_of_gone_.setZero();
}

Eigen::Vector2d SystemState::baseImpulse() const
{
  Eigen::Vector2d sum = impulse_of_gone_;
  for (const DiskRecord& record : records_)
    sum += record.base_impulse;
  return sum;
}

void SystemState::moveTo(std::uint32_t slot, const Image& image, double time, ThreadBuffer* buffer)
{
  redirect(slot, {twoOf(image.shift), twoOf(image.velocity)}, time, buffer);
  records_[slot].offset -= image.shift.x();
}

void SystemState::wrapIntoWidth(std::uint32_t slot, double s, double time, ThreadBuffer* buffer)
{
  if (scene_.boundary != Boundary::PERIODIC || motion_.turning())
    return;
  if (const double widths = widthsOutside(s); widths != 0.0)
    wrap(slot, -widths, time, buffer);
}

/// Wraps all disks when the base begins to turn. Before, an image moves exactly as its disk does.
void SystemState::wrapAll(double time)
{
  if (scene_.boundary != Boundary::PERIODIC)
    return;
  FrameOfBase base = motion_.at(time);
  base.inclination_rate = 0.0;
  for (const std::uint32_t slot : slots(true))
  {
    const double s = base.see(flown(slot, time)).s();
    if (const double widths = widthsOutside(s); widths != 0.0)
      moveTo(slot, base.image(-widths * shape_.width()), time, nullptr);
  }
}

void SystemState::archive(StateArchive& state)
{
  state(epoch_, motion_, disks_, records_, active_count_, impulse_of_gone_, ids_, collapse_watch_);
  const std::size_t count = disks_.size();
  const bool of_this_scene =
      records_.size() == count && ids_.fits(count) &&
      std::all_of(disks_.begin(), disks_.end(),
                  [this](const Disk& disk) { return disk.species < scene_.species.size(); });
  if (!of_this_scene)
    throw StateError("it is of another scene");
  state(sums_);
  log_.archive(state, count);
}

std::vector<double> SystemState::activeRadii() const
{
  std::vector<double> radii;
  radii.reserve(active_count_);
  for (const std::uint32_t slot : slots(true))
    radii.push_back(radius(slot));
  return radii;
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
  return epoch_.length * std::floor(now / epoch_.length);
}

void SystemState::rebase(double length)
{
  log_.endSegment(length);
  log_.rebase(length);
  motion_.rebase(length);
  for (std::uint32_t slot = 0; slot < disks_.size(); ++slot)
  {
    DiskRecord& record = records_[slot];
    record.last_contact -= length;
    record.window.end -= length;
    if (!record.active)
      continue;
    record.fly(disks_[slot], length, scene_.gravity);
    moveZero(disks_[slot], length, scene_.gravity);
  }
  epoch_.start += length;
  collapse_watch_.setEpoch(epoch_.start);
}

}  // namespace ratchet_sieve
