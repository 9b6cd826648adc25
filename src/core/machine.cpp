#include "ratchet_sieve/core/machine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/walls.h"

namespace ratchet_sieve
{
namespace
{
/// A way that counts for nothing, as a share of a double's resolution at the base's width: a million of them,
/// as many as a collapse may have events, come to one resolution.
constexpr double NEGLIGIBLE_WAY = 0x1p-20 * std::numeric_limits<double>::epsilon();

/// Fewer places of disks that have left are not worth giving up: so a run of the usual kind never does, and a
/// machine that is fed for ever is searched anew once in a while.
constexpr std::size_t LEAST_GIVEN_UP = 1024;

/// Of a fall over a tooth, or where nothing falls, over a tooth within the time scale [m/s].
double speedScale(const SceneDefinition& scene, double time_scale)
{
  const double width = scene.base.tooth_width;
  return scene.gravity > 0.0 ? std::sqrt(scene.gravity * width) : width / time_scale;
}

double largestDiameter(const SceneDefinition& scene)
{
  double largest = 0.0;
  for (const auto& species : scene.species)
    largest = std::max(largest, 2.0 * species.radius);
  return largest;
}

double maxTurn(const SceneDefinition& scene, double largest_diameter)
{
  const bool lattice = scene.boundary == Boundary::PERIODIC && scene.contact.pair_collisions;
  return lattice ? Machine::LATTICE_MARGIN * largest_diameter / scene.base.width()
                 : std::numeric_limits<double>::infinity();
}

const Plan& covering(const Plan& plan, const SceneDefinition& scene)
{
  if (!covers(plan, scene))
    throw std::invalid_argument("the plan does not cover the scene: " + planText(plan));
  return plan;
}
}  // namespace

Machine::Machine(const SceneDefinition& scene, const Plan& plan)
    : scene_(scene),
      plan_(covering(plan, scene)),
      sawtooth_(scene.base, scene.boundary, wallHeight(scene)),
      largest_diameter_(ratchet_sieve::largestDiameter(scene)),
      time_scale_(ratchet_sieve::timeScale(scene)),
      negligible_way_(NEGLIGIBLE_WAY * sawtooth_.width()),
      epoch_{0.0, epochLength(time_scale_)},
      motion_(scene.base, maxTurn(scene, largest_diameter_), plan.drive && !planOf(scene).drive),
      search_(sawtooth_, motion_, scene.gravity, timeResolution(epoch_.length), plan.search_above_band),
      collapse_watch_(scene.contact, time_scale_, speedScale(scene, time_scale_), numbers_),
      bins_(scene.species.size()),
      tally_(scene.species, scene.gravity, plan.spin)
{
  for (std::size_t i = 0; i < scene_.species.size(); ++i)
  {
    radii_.push_back(scene_.species[i].radius);
    base_masses_.push_back(contactMasses(scene_.species[i], nullptr));
    responses_.push_back(
        {1.0 / scene_.species[i].mass, scene_.species[i].radius / scene_.species[i].inertia()});
    for (std::size_t j = 0; j < scene_.species.size(); ++j)
    {
      pair_coefficients_.push_back(contactBetween(scene_, i, j));
      pair_masses_.push_back(contactMasses(scene_.species[i], &scene_.species[j]));
    }
  }
}

BaseEvent Machine::nextBaseEvent(std::uint32_t id, double from, double until, BaseInstant& base) const
{
  // Nothing may come for very long where nothing falls; an epoch at a time is enough.
  double end = std::min(until, from + epoch_.length);
  const auto change = motion_.nextChange();
  if (change)
    end = std::min(end, *change);
  BaseEvent event = search_.find(disks_[id], radius(id), from, end, base);
  if (!event.feature && change && event.time >= *change)
    event.time = std::numeric_limits<double>::infinity();
  return event;
}

void Machine::reserve(std::size_t count)
{
  disks_.reserve(count);
  active_.reserve(count);
  collapse_watch_.reserve(count);
  tally_.reserve(count);
}

std::uint32_t Machine::add(const Disk& disk)
{
  const auto id = static_cast<std::uint32_t>(disks_.size());
  disks_.push_back(disk);
  active_.push_back(1);
  ++active_count_;
  ++bins_[disk.species].on_base;
  numbers_.added();
  collapse_watch_.added();
  tally_.entered(disk, epoch_.start + disk.time);
  if (plan_.contact_times)
    last_contacts_.push_back(-std::numeric_limits<double>::infinity());
  return id;
}

double Machine::startAt(double start)
{
  epoch_.start = epoch_.length * std::floor(start / epoch_.length);
  collapse_watch_.rebase(0.0, epoch_.start);
  const double local = start - epoch_.start;
  motion_.startAt(local);
  return local;
}

bool Machine::mostlyLeft() const
{
  const std::size_t left = disks_.size() - active_count_;
  return left >= LEAST_GIVEN_UP && left > active_count_;
}

void Machine::giveUpPlaces()
{
  std::vector<std::uint32_t> kept;
  kept.reserve(active_count_);
  for (std::uint32_t id = 0; id < disks_.size(); ++id)
    if (active(id))
      kept.push_back(id);
  tally_.keep(kept, disks_, active_);
  collapse_watch_.keep(kept);
  numbers_.keep(kept);
  keepPlaces(disks_, kept);
  keepPlaces(active_, kept);
  if (plan_.contact_times)
    keepPlaces(last_contacts_, kept);
}

Disk& Machine::fly(std::uint32_t id, double time)
{
  Disk& disk = disks_[id];
  tally_.flew(id, disk, time);
  disk = flown(disk, time, scene_.gravity);
  ++disk.flights;
  return disk;
}

void Machine::leave(std::uint32_t id, bool to_the_right, double time)
{
  SpeciesBins& bins = bins_[disks_[id].species];
  fly(id, time);
  --bins.on_base;
  ++(to_the_right ? bins.right : bins.left);
  endPassage(id, time);
}

void Machine::takeOut(std::uint32_t id, double time)
{
  fly(id, time);
  endPassage(id, time);
}

void Machine::endPassage(std::uint32_t id, double time)
{
  active_[id] = 0;
  --active_count_;
  tally_.left(id, epoch_.start + time);
}

void Machine::wrap(std::uint32_t id, double shift, double time)
{
  Disk& disk = fly(id, time);
  const Image to = image(shift, time);
  disk.x += to.shift.x();
  disk.y += to.shift.y();
  disk.vx += to.velocity.x();
  disk.vy += to.velocity.y();
  tally_.wrapped(id, -to.shift.x());
}

void Machine::bringHome(std::uint32_t id, double s, double time)
{
  const double laps = wholeWidths(s, 1.0 / sawtooth_.width());
  if (scene_.boundary == Boundary::PERIODIC && laps != 0.0)
    wrap(id, -laps, time);
}

void Machine::archive(StateArchive& state)
{
  state(epoch_, motion_, disks_, active_, last_contacts_, active_count_, numbers_, collapse_watch_, bins_,
        tally_, collisions_, max_overlap_);
  search_.setTimeResolution(timeResolution(epoch_.length));
  const std::size_t count = disks_.size();
  const std::size_t contacts = plan_.contact_times ? count : 0;
  const bool of_this_scene = bins_.size() == scene_.species.size() && active_.size() == count &&
                             last_contacts_.size() == contacts && collapse_watch_.disks() == count &&
                             tally_.disks() == count && numbers_.fits(count) &&
                             std::all_of(disks_.begin(), disks_.end(),
                                         [this](const Disk& disk) { return disk.species < bins_.size(); });
  if (!of_this_scene)
    throw StateError("it is of another scene");
}

double Machine::smallestRadius() const
{
  return *std::min_element(radii_.begin(), radii_.end());
}

double Machine::shortenEpoch(double now)
{
  const double longest = longestEpoch(motion_.speedBound(), smallestRadius());
  if (longest >= epoch_.length)
    return 0.0;
  epoch_.length = longest;
  search_.setTimeResolution(timeResolution(epoch_.length));
  return epoch_.length * std::floor(now / epoch_.length);
}

void Machine::rebase(double length)
{
  motion_.rebase(length);
  for (std::uint32_t id = 0; id < disks_.size(); ++id)
  {
    // A state that is older than an epoch is renewed on its flight: over a long one its rounding would grow.
    if (active(id) && disks_[id].time < 0.0)
    {
      tally_.flew(id, disks_[id], length);
      disks_[id] = flown(disks_[id], length, scene_.gravity);
    }
    disks_[id].time -= length;
  }
  for (double& time : last_contacts_)
    time -= length;
  epoch_.start += length;
  collapse_watch_.rebase(length, epoch_.start);
}

void Machine::restartMeans(double time)
{
  tally_.restart(disks_, active_, epoch_.start + time, time);
}

void Machine::endPieceOfMeans(double time)
{
  tally_.endPiece(disks_, active_, epoch_.start + time, time);
}

std::vector<SpeciesBins> Machine::bins() const
{
  return bins_;
}

std::vector<SpeciesMeans> Machine::means(double time) const
{
  return tally_.means(disks_, active_, epoch_.start + time, time);
}

}  // namespace ratchet_sieve
