#include "events/engine.h"

#include <algorithm>
#include <limits>
#include <string>
#include <thread>

#include "simd/simd_batch.h"
#include "state/placement.h"

namespace ratchet_sieve
{
namespace
{
/// The SIMD batches are emptied at the end of a block: about as often as at the end of an epoch.
constexpr double SCALES_PER_ENSEMBLE_BLOCK = 8.0;

/// Makes the feed's random numbers other ones than those of the same seed that place the disks.
constexpr std::uint64_t FEED_STREAM = 0x9e3779b97f4a7c15;
}  // namespace

const Engine::MachineEvent Engine::MACHINE_EVENTS[] = {{&Engine::nextSettle, &Engine::settle},
                                                       {&Engine::nextBlockEnd, &Engine::endBlock},
                                                       {&Engine::nextPeriodSample, &Engine::samplePeriod},
                                                       {&Engine::nextSegmentEnd, &Engine::beginSegment},
                                                       {&Engine::nextFeed, &Engine::feed},
                                                       {&Engine::nextEpochEnd, &Engine::endEpoch}};

Engine::Engine(const SceneDefinition& scene, double start_time, const PourObserver& pour_observer)
    : state_(scene), random_(scene.seed), feed_random_(scene.seed ^ FEED_STREAM), start_(start_time)
{
  now_ = state_.startAt(start_);
  next_feed_ = start_;
  drawNextFeed();
  if (scene.initial.empty())
    pourDisks(state_, pourOrder(scene.species, random_), scene.pour.stretch, now_, random_, pour_observer);
  else
    placeInitialDisks(state_, now_);
  loop_ = makeLoop();
  announce(0);
}

Engine::Engine(const SceneDefinition& scene, std::string_view saved_state)
    : state_(scene), random_(scene.seed), feed_random_(scene.seed), loop_(makeLoop())
{
  StateArchive state(saved_state);
  archive(state);
  state.requireEnd();
}

void Engine::archive(StateArchive& state)
{
  state(state_, random_, feed_random_, *loop_, start_, now_, settled_, blocks_, fed_, next_feed_);
}

void Engine::advanceTo(double time)
{
  if (!(time >= this->time()))
    return;
  while (true)
  {
    if (state_.collapseWatch().stops())
      throw StallError(state_.collapseWatch().text());
    const double target = time - state_.epoch().start;
    now_ = loop_->advanceTo(std::min(target, nextMachineEvent()));
    state_.log().deliver();
    if (state_.collapseWatch().stops())
      stopAtATimeOfTheRun();
    else if (!executeMachineEvent() && now_ >= target)
      return;
  }
}

void Engine::pour(std::size_t species, std::size_t count, const Stretch& stretch,
                  const PourObserver& observer)
{
  if (const std::size_t present = state_.activeCount(); present > MOST_DISKS || count > MOST_DISKS - present)
    throw std::invalid_argument("a pour of " + std::to_string(count) + " onto " + std::to_string(present) +
                                " disks: there must be at most " + std::to_string(MOST_DISKS) + " in total");
  const double width = state_.scene().base.width();
  if (!(0.0 <= stretch.from && stretch.from <= std::min(stretch.to, width)))
    throw std::invalid_argument("a pour between " + std::to_string(stretch.from) + " and " +
                                std::to_string(stretch.to) + " m: must be on the base, 0 to " +
                                std::to_string(width) + " m, from left to right");
  pourOnto(stretch, species, count, observer);
}

void Engine::pourOnto(const Stretch& stretch, std::size_t species, std::size_t count,
                      const PourObserver& observer, const FedDisk* own)
{
  const SceneDefinition& scene = state_.scene();
  if (species >= scene.species.size())
    throw std::invalid_argument("there is no species " + std::to_string(species));
  if (own == nullptr && 2.0 * state_.sizes(species).largest() > scene.base.width())
    throw std::invalid_argument("disks of species " + scene.species[species].name +
                                " are wider than the machine: there is no room for them");
  loop_->catchUp(now_);
  const auto before = static_cast<std::uint32_t>(state_.disks().size());
  Random random = random_;
  pourDisks(state_, std::vector<std::uint32_t>(count, static_cast<std::uint32_t>(species)), stretch, now_,
            random, observer, own);
  random_ = random;
  announce(before);
}

void Engine::setThreads(std::size_t threads, const StripSettings& strips)
{
  strips_ = strips;
  threads_ = threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
  loop_->setThreads(threads_, strips_);
}

std::size_t Engine::auditOverlaps()
{
  const Audit found = audit(state_, loop_->executedUntil(now_));
  state_.sums().contacts.counts.addOverlap(found.largest_overlap);
  return found.behind_surface;
}

std::unique_ptr<EventLoop> Engine::makeLoop()
{
  // Checked for every scene, so that an invalid limit is an error before the run begins.
  laneLimit();
  if (!hasPairs())
    return makeEnsembleLoop(state_);
  return state_.plan().steps ? makeStepLoop(state_) : makePairLoop(state_);
}

double Engine::nextMachineEvent() const
{
  double next = std::numeric_limits<double>::infinity();
  for (const MachineEvent& event : MACHINE_EVENTS)
    next = std::min(next, (this->*event.when)().value_or(next));
  return std::max(next, now_);
}

bool Engine::executeMachineEvent()
{
  for (const MachineEvent& event : MACHINE_EVENTS)
    if (const auto when = (this->*event.when)(); when && *when <= now_)
    {
      (this->*event.what)();
      return true;
    }
  return false;
}

std::optional<double> Engine::nextSettle() const
{
  return settled_ ? std::nullopt : local(settledTime());
}

void Engine::settle()
{
  settled_ = true;
  state_.restart(now_);
}

std::optional<double> Engine::nextBlockEnd() const
{
  if (!settled_ || !(state_.sums().averages.keepsSeries() || state_.log().wantsBlocks()))
    return std::nullopt;
  return local(blockEnd(blocks_ + 1));
}

/// The block length follows the machine's time scale.
double Engine::blockTime() const
{
  return hasPairs() ? state_.timeScale() : SCALES_PER_ENSEMBLE_BLOCK * state_.timeScale();
}

void Engine::endBlock()
{
  ++blocks_;
  state_.closePaths();
  state_.sums().averages.endBlock(now_);
  state_.log().endBlock(now_);
}

void Engine::beginSegment()
{
  changeMotion([](BaseMotion& motion, double now) { motion.beginSegment(now); });
}

std::optional<double> Engine::nextFeed() const
{
  const FeedDefinition& feed = state_.scene().feed;
  if (fed_ < feed.disks.size())
    return local(start_ + feed.disks[fed_].time);
  return feed.rate > 0.0 ? local(next_feed_) : std::nullopt;
}

void Engine::feed()
{
  const FeedDefinition& feed = state_.scene().feed;
  const std::uint64_t next = fed_++;
  if (next < feed.disks.size())
    return pourOnto(feed.stretch, feed.disks[next].species, 1, {}, &feed.disks[next]);
  pourOnto(feed.stretch, drawSpecies(state_.scene().species, feed_random_), 1, {});
  drawNextFeed();
}

void Engine::drawNextFeed()
{
  const FeedDefinition& feed = state_.scene().feed;
  if (feed.rate <= 0.0)
    return;
  if (feed.even)
    next_feed_ = start_ + static_cast<double>(fed_ + 1) / feed.rate;
  else
    next_feed_ += feed_random_.exponential() / feed.rate;
}

void Engine::endEpoch()
{
  const bool moving = state_.motion().nextChange().has_value();
  loop_->catchUp(now_);
  state_.sums().energies.check(now_);
  moveZero(state_.epoch().length);
  // Otherwise memory and scan time would grow without limit in a machine with a feed.
  if (state_.compact())
    renewLoop();
  else if (loop_->outgrown(now_) || moving)
    loop_->motionChanged(now_);
}

void Engine::moveZero(double length)
{
  state_.rebase(length);
  loop_->rebase(length);
  periods_.rebase(length);
  now_ -= length;
}

/// To be called after slots were reassigned.
void Engine::renewLoop()
{
  const std::uint64_t events = loop_->events();
  loop_ = makeLoop();
  loop_->setEvents(events);
  loop_->setThreads(threads_, strips_);
  announce(0);
}

/// An epoch's times are finer than the run's. The run ends at the next time that the run can represent, so
/// that another run to time() gives the same bits.
void Engine::stopAtATimeOfTheRun()
{
  const double epoch_start = state_.epoch().start;
  double end = time();
  if (end - epoch_start < now_)
    end = std::nextafter(end, std::numeric_limits<double>::infinity());
  now_ = end - epoch_start;
}

void Engine::announce(std::uint32_t first)
{
  for (std::uint32_t slot = first; slot < state_.disks().size(); ++slot)
    loop_->added(slot, now_);
}

}  // namespace ratchet_sieve
