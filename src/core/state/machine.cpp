#include "state/machine.h"

#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// Smallest number of slots that compaction removes. Usual runs never reach it; a machine with an endless
/// feed is compacted once in a while.
constexpr std::size_t LEAST_COMPACTED = 1024;

/// Speed of a fall from a tooth's height; without gravity, a tooth per time scale [m/s].
double speedScale(const SceneDefinition& scene, double time_scale)
{
  const double width = scene.base.tooth_width;
  return scene.gravity > 0.0 ? std::sqrt(scene.gravity * width) : width / time_scale;
}
}  // namespace

Machine::Machine(const SceneDefinition& scene, const Plan& plan)
    : state_(scene, plan),
      collapse_watch_(scene.contact, state_.timeScale(), speedScale(scene, state_.timeScale()), state_.ids()),
      record_(state_),
      execution_(state_, collapse_watch_, record_.contactTimes())
{
}

void Machine::reserve(std::size_t count)
{
  state_.reserve(count);
  collapse_watch_.reserve(count);
  record_.reserve(count);
}

std::uint32_t Machine::add(const Disk& disk, const Grain& grain)
{
  collapse_watch_.added();
  record_.added();
  return state_.add(disk, grain);
}

bool Machine::compact()
{
  const std::size_t left = state_.disks().size() - state_.activeCount();
  if (left < LEAST_COMPACTED || left <= state_.activeCount())
    return false;
  const std::vector<std::uint32_t> kept = state_.slots(true);
  record_.keep(kept, state_.slots(false));
  collapse_watch_.keep(kept);
  state_.compact(kept);
  return true;
}

double Machine::startAt(double start)
{
  const double local = state_.startAt(start);
  collapse_watch_.rebase(0.0, state_.epoch().start);
  return local;
}

void Machine::rebase(double length)
{
  state_.rebase(length);
  record_.rebase(length);
  collapse_watch_.rebase(length, state_.epoch().start);
}

void Machine::restartMeans(double time)
{
  state_.restartTrajectories(time);
  record_.restartMeans();
}

void Machine::archive(StateArchive& state)
{
  state(state_, collapse_watch_, record_);
  if (collapse_watch_.disks() != state_.disks().size())
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
