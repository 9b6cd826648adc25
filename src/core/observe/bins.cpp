#include "observe/bins.h"

#include <algorithm>

#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Adds a disk to the bin into which it fell.
void count(const Departure& departure, SpeciesBins& bins)
{
  const bool left = departure.exit == Exit::LEFT_BIN;
  ++(left ? bins.left : bins.right);
  (left ? bins.left_mass : bins.right_mass) += departure.mass;
}
}  // namespace

Bins::Bins(const SystemState& system)
    : system_(system),
      of_species_(system.scene().species.size()),
      of_size_classes_(system.sizeClasses().size())
{
}

void Bins::entered(const Disk& disk, double /*time*/)
{
  ++of_species_[disk.species].on_base;
  if (const std::size_t k = system_.sizeClassOf(disk); k < of_size_classes_.size())
    ++of_size_classes_[k].on_base;
}

void Bins::departed(const Departure& departure)
{
  --of_species_[departure.species].on_base;
  count(departure, of_species_[departure.species]);
  const std::size_t k = system_.sizeClassOf(system_.disk(departure.slot));
  if (k == of_size_classes_.size())
    return;
  --of_size_classes_[k].on_base;
  ++(departure.exit == Exit::LEFT_BIN ? of_size_classes_[k].left : of_size_classes_[k].right);
}

void Bins::archive(StateArchive& state)
{
  const std::size_t species = of_species_.size();
  const std::size_t classes = of_size_classes_.size();
  state(of_species_, of_size_classes_);
  if (of_species_.size() != species || of_size_classes_.size() != classes)
    throw StateError("it is of another scene");
}

void RecentExits::departed(const Departure& departure)
{
  const double time = system_.epoch().start + departure.time;
  if (length_ > 0.0)
    exits_.emplace_back(time, departure);
  while (!exits_.empty() && exits_.front().first <= time - length_)
    exits_.pop_front();
}

void RecentExits::keep(double length, double time)
{
  length_ = length;
  from_ = time;
  exits_.clear();
}

ExitWindow RecentExits::window(double time, double not_before) const
{
  ExitWindow window{std::max({time - length_, from_, not_before}),
                    std::vector<SpeciesBins>(system_.scene().species.size())};
  for (auto exit = exits_.rbegin(); exit != exits_.rend() && exit->first > window.start; ++exit)
    count(exit->second, window.bins[exit->second.species]);
  return window;
}

}  // namespace ratchet_sieve
