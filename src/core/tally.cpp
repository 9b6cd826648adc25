#include "ratchet_sieve/core/tally.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ratchet_sieve
{

Tally::Tally(const std::vector<SpeciesDefinition>& species, double gravity, bool spin)
    : species_(species),
      gravity_(gravity),
      spin_(spin),
      gone_(species.size()),
      at_piece_end_(species.size()),
      blocks_(species.size()),
      contacts_(species.size())
{
}

void Tally::entered(const Disk& disk, double time)
{
  Passage passage;
  passage.entered_x = disk.x;
  passage.counted_x = disk.x;
  passage.counted_from = time;
  passages_.push_back(passage);
}

void Tally::integrate(Passage& passage, const Disk& disk, double local_time) const
{
  const double span = local_time - disk.time;
  const double fall = gravity_ * span;
  passage.translation += translationOver(disk.vx, disk.vy, fall, span);
  if (spin_)
    passage.rotation += rotationOver(disk.spin, span);
}

void Tally::flew(std::uint32_t id, const Disk& disk, double time)
{
  integrate(passages_[id], disk, time);
}

void Tally::pushed(std::uint32_t id, double x, double y)
{
  passages_[id].impulse_x += x;
  passages_[id].impulse_y += y;
}

void Tally::keep(const std::vector<std::uint32_t>& places, const std::vector<Disk>& disks,
                 const std::vector<std::uint8_t>& active)
{
  for (std::uint32_t id = 0; id < disks.size(); ++id)
  {
    if (active[id])
      continue;
    addLeft(disks[id], passages_[id], gone_);
    gone_impulse_x_ += passages_[id].impulse_x;
    gone_impulse_y_ += passages_[id].impulse_y;
  }
  keepPlaces(passages_, places);
}

double Tally::impulseX() const
{
  return std::accumulate(passages_.begin(), passages_.end(), gone_impulse_x_,
                         [](double sum, const Passage& passage) { return sum + passage.impulse_x; });
}

double Tally::impulseY() const
{
  return std::accumulate(passages_.begin(), passages_.end(), gone_impulse_y_,
                         [](double sum, const Passage& passage) { return sum + passage.impulse_y; });
}

void Tally::restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
                    double local_time)
{
  std::fill(gone_.begin(), gone_.end(), Sums());
  gone_impulse_x_ = 0.0;
  gone_impulse_y_ = 0.0;
  std::fill(at_piece_end_.begin(), at_piece_end_.end(), Sums());
  std::fill(blocks_.begin(), blocks_.end(), BlockAverages());
  std::fill(contacts_.begin(), contacts_.end(), 0);
  for (std::uint32_t id = 0; id < disks.size(); ++id)
  {
    Passage& passage = passages_[id];
    passage.impulse_x = 0.0;
    passage.impulse_y = 0.0;
    passage.counted_from = NEVER;
    if (!active[id])
      continue;
    // What the present flight brought before now will be taken in at its end: taken off beforehand.
    Passage before;
    integrate(before, disks[id], local_time);
    passage.translation = -before.translation;
    passage.rotation = -before.rotation;
    passage.counted_x = flown(disks[id], local_time, gravity_).x + passage.offset;
    passage.counted_from = time;
  }
}

void Tally::Sums::add(const Passage& passage, double x, double until)
{
  const double dx = x + passage.offset - passage.counted_x;
  const double dt = until - passage.counted_from;
  disks += 1.0;
  displacement += dx;
  time += dt;
  displacement_squared += dx * dx;
  displacement_time += dx * dt;
  time_squared += dt * dt;
  translation += passage.translation;
  rotation += passage.rotation;
}

SpeciesMeans Tally::Sums::means(const SpeciesDefinition& species) const
{
  SpeciesMeans means;
  if (time <= 0.0)
    return means;
  const double vx = displacement / time;
  means.mean_vx = vx;
  means.kinetic_translational = species.mass * translation / time;
  means.kinetic_rotational = species.inertia() * rotation / time;
  if (disks > 1.0)
  {
    // The ratio estimator's error: the scatter of what each disk travelled about vx times its time.
    const double scatter = displacement_squared - 2.0 * vx * displacement_time + vx * vx * time_squared;
    means.mean_vx_stderr = std::sqrt(std::max(0.0, scatter) * disks / (disks - 1.0)) / time;
  }
  return means;
}

std::vector<Tally::Sums> Tally::sums(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active,
                                     double time, double local_time) const
{
  std::vector<Sums> sums = gone_;
  for (std::uint32_t id = 0; id < disks.size(); ++id)
  {
    if (!active[id])
    {
      addLeft(disks[id], passages_[id], sums);
      continue;
    }
    Passage passage = passages_[id];
    integrate(passage, disks[id], local_time);
    sums[disks[id].species].add(passage, flown(disks[id], local_time, gravity_).x, time);
  }
  return sums;
}

void Tally::addLeft(const Disk& disk, const Passage& passage, std::vector<Sums>& sums)
{
  if (passage.counted_from < NEVER)
    sums[disk.species].add(passage, disk.x, passage.left_when);
}

void Tally::endPiece(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
                     double local_time)
{
  std::vector<Sums> now = sums(disks, active, time, local_time);
  for (std::size_t s = 0; s < species_.size(); ++s)
    blocks_[s].add(now[s].displacement - at_piece_end_[s].displacement, now[s].time - at_piece_end_[s].time);
  at_piece_end_ = std::move(now);
}

std::vector<SpeciesMeans> Tally::means(const std::vector<Disk>& disks,
                                       const std::vector<std::uint8_t>& active, double time,
                                       double local_time) const
{
  const std::vector<Sums> all = sums(disks, active, time, local_time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < species_.size(); ++s)
  {
    means.push_back(all[s].means(species_[s]));
    if (all[s].time > 0.0)
      means[s].collision_rate = static_cast<double>(contacts_[s]) / all[s].time;
    // Whichever sees more: disks that differ among each other, or a layer that moves as a whole.
    const auto over_time = blocks_[s].standardError();
    if (over_time && means[s].mean_vx)
      means[s].mean_vx_stderr = std::max(means[s].mean_vx_stderr.value_or(0.0), *over_time);
  }
  return means;
}

}  // namespace ratchet_sieve
