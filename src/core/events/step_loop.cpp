#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "events/event_loop.h"
#include "events/step_contacts.h"
#include "ratchet_sieve/geometry/overlap_search.h"
#include "search/base_overlap.h"
#include "state/contact_execution.h"
#include "state/contact_prediction.h"

namespace ratchet_sieve
{
namespace
{

/// The simulation by fixed integration steps instead of an event queue. A step moves every disk along its
/// flight to the end of the step and looks for overlaps there. For overlapping disks only, the first contacts
/// are computed by the searches of the event loops, and executed at their times in order. A disk whose flight
/// was changed by a contact is checked again. So a contact is exact if its disks would overlap at the end of
/// the step. It is missed if they would not: a grazing contact that is over by then. The fraction of missed
/// contacts is proportional to the square of the step.
///
/// A disk that may move by more than the height of a tooth within a step, or on a profile by more than its
/// diameter, relative to the base, is always searched for contacts with the base, so that none passes through
/// a tooth.
///
/// A step always terminates. A disk with MOST_CONTACTS contacts within the step starts no further search. So
/// a step of N disks has at most (MOST_CONTACTS + 1) N searches. Each finds every image of another disk and
/// the base at most once, and no more contacts are executed than found. That bounds an inelastic collapse.
/// Rounding needs no such bound: a contact that turns out to be separating at its execution leaves both
/// flights unchanged; a new search from its time gives the same time and the same decision.
///
/// Steps are counted from the last event of the whole machine (catchUp()). Between the steps disks are in
/// free flight, so the results do not depend on the calls of advanceTo().
///
/// @tparam Overlaps OverlapSearch, or OverlapLevels for wide sizes
template <typename Overlaps>
class StepLoop : public EventLoop
{
public:
  explicit StepLoop(SystemState& state)
      : state_(state),
        prediction_(state),
        execution_(state),
        step_(state_.scene().accuracy.step),
        gravity_(state_.scene().gravity),
        overlaps_(state_.shape().width(), state_.largestDiameter(),
                  state_.scene().boundary == Boundary::PERIODIC),
        base_overlap_(state_.shape())
  {
  }

  double advanceTo(double time) override
  {
    // The caller's times and the steps' times round differently.
    while (start_ + step_ <= time + ROUNDING * step_)
      if (!advanceBy(start_ + step_))
        return stopped_at_;
    return time;
  }

  void catchUp(double time) override
  {
    if (time > start_)
      advanceBy(time);
    start_ = time;
  }

  double executedUntil(double time) const override { return std::min(time, start_); }

  void added(std::uint32_t /*slot*/, double time) override { start_ = time; }

  void motionChanged(double /*time*/) override { prediction_.renew(); }

  void rebase(double length) override
  {
    prediction_.renew();
    start_ -= length;
  }

  void archive(StateArchive& state) override
  {
    EventLoop::archive(state);
    state(start_);
    prediction_.renew();
  }

private:
  /// As a fraction of a step.
  static constexpr double ROUNDING = 1e-9;

  /// A disk with this many contacts within a step starts no further search in the step.
  static constexpr std::uint32_t MOST_CONTACTS = 100;

  /// @return false if the run must stop
  bool advanceBy(double end)
  {
    end_ = end;
    frame_ = prediction_.base().at(end);
    ring_ = frame_.image(state_.shape().width());
    contacts_.begin(start_, end, state_.disks().size());
    placeDisks();
    for (const std::uint32_t slot : near_base_)
      pushOut(slot);
    overlaps_.forEachPair([this](std::uint32_t slot, std::uint32_t other, int shift)
                          { findContact(slot, other, shift, start_); });
    for (const std::uint32_t slot : near_base_)
      findBaseContact(slot, start_);
    for (StepContact next; contacts_.pop(next);)
      if (!stale(next))
      {
        stopped_at_ = next.time;
        if (state_.collapseWatch().count(next.slot, next.time) && state_.collapseWatch().stops())
          return false;
        execute(next);
      }
    start_ = end;
    return true;
  }

  void placeDisks()
  {
    near_base_.clear();
    contacts_of_.assign(state_.disks().size(), 0);
    overlaps_.begin(state_.disks().size());
    length_ = end_ - start_;
    base_reach_ = state_.motion().speedBound() * length_;
    turning_ = state_.motion().turning();
    for (std::uint32_t slot = 0; slot < state_.disks().size(); ++slot)
    {
      if (!state_.active(slot))
        continue;
      Eigen::Vector2d at = atEnd(slot);
      if (!withinEnds(at))
      {
        state_.wrapIntoWidth(slot, at.x(), start_);
        at = atEnd(slot);
      }
      overlaps_.place(slot, at.x(), at.y(), state_.radius(slot));
      if (mayTouchBase(slot, at))
        near_base_.push_back(slot);
    }
    overlaps_.sort();
  }

  bool withinEnds(const Eigen::Vector2d& at) const
  {
    return at.x() >= 0.0 && at.x() < state_.shape().width();
  }

  /// The disk's position at the end of the step in the absence of contacts, in the frame of the base.
  Eigen::Vector2d atEnd(std::uint32_t slot) const
  {
    return frame_.positionInto(positionAt(state_.disk(slot), end_, gravity_));
  }

  /// Whether the disk may touch the base, or pass an end of an open or walled base.
  bool mayTouchBase(std::uint32_t slot, const Eigen::Vector2d& at) const
  {
    const double radius = state_.radius(slot);
    if (turning_ && !withinEnds(at))
      return true;
    if (base_overlap_.overlaps(at.x(), at.y(), radius))
      return true;
    const Two velocity = kinematicsAt(state_.disk(slot), end_, gravity_).velocity;
    const double reach = (std::abs(velocity[0]) + std::abs(velocity[1])) * length_ + base_reach_;
    return reach > base_overlap_.shortestPassage(radius) &&
           base_overlap_.overlaps(at.x(), at.y(), radius + reach);
  }

  /// Moves a disk out of the base. A missed contact may leave a disk below the surface, where no search would
  /// find a contact.
  void pushOut(std::uint32_t slot)
  {
    const FrameOfBase& base = prediction_.base().at(start_);
    const Eigen::Vector2d at = base.positionInto(positionAt(state_.disk(slot), start_, gravity_));
    const auto way = base_overlap_.wayOut(at.x(), at.y(), state_.radius(slot));
    if (!way)
      return;
    ++state_.sums().contacts.counts.pushed_out;
    state_.redirect(slot, {twoOf(base.outOf({0.0, *way}))}, start_);
    redirect(slot);
  }

  /// Finds the contact of two disks that may overlap at the end of the step, searching backwards from there.
  /// If the contact is not after `from`, the search of the event loops decides whether they approach there,
  /// by the same sum as the execution.
  void findContact(std::uint32_t slot, std::uint32_t other, int shift, double from)
  {
    if (slot == other)
      return;
    const Disk& a = state_.disk(slot);
    const Disk& b = state_.disk(other);
    const Relative seen = FlightLine(a, shift * ring_.shift).seenFrom(b, end_);
    const Eigen::Vector2d position = vectorOf(seen.position);
    const Eigen::Vector2d velocity = vectorOf(seen.velocity) - shift * ring_.velocity;
    const double excess = position.squaredNorm() - seen.distance * seen.distance;
    if (excess >= 0.0)
      return;
    std::optional<double> time = end_ - timeSinceContact(position, velocity, excess);
    if (!(*time > from))
      time = prediction_.pairsOf(slot, from).contactWith(other, shift);
    if (time && *time <= end_)
      contacts_.push({*time, slot, a.event_count, other, b.event_count, shift, {}});
  }

  void findBaseContact(std::uint32_t slot, double from)
  {
    const BaseEvent event = prediction_.nextBaseEvent(slot, state_.flown(slot, from), end_);
    if (event.feature && event.time <= end_)
      contacts_.push({event.time, slot, state_.disk(slot).event_count, slot, 0, 0, event.feature});
  }

  bool stale(const StepContact& contact) const
  {
    return state_.disk(contact.slot).event_count != contact.event_count ||
           (!contact.feature && state_.disk(contact.partner).event_count != contact.partner_event_count);
  }

  void execute(const StepContact& contact)
  {
    ++events_;
    ++contacts_of_[contact.slot];
    if (contact.feature)
    {
      const bool turned =
          execution_.handleBaseEvent(contact.slot, contact.feature, contact.time, prediction_.base());
      if (!turned && contacts_of_[contact.slot] < MOST_CONTACTS)
        findBaseContact(contact.slot, contact.time);
      if (turned && state_.active(contact.slot))
        searchFrom(contact.slot, redirect(contact.slot), contact.time);
      return;
    }
    ++contacts_of_[contact.partner];
    if (!execution_.collidePair(contact.slot, contact.partner, contact.shift, contact.time).closed)
      return;
    const Eigen::Vector2d at = redirect(contact.slot);
    const Eigen::Vector2d partner_at = redirect(contact.partner);
    searchFrom(contact.slot, at, contact.time);
    searchFrom(contact.partner, partner_at, contact.time);
  }

  /// Updates a disk after a change of its flight. @return its position at the end of the step, in the frame
  /// of the base
  Eigen::Vector2d redirect(std::uint32_t slot)
  {
    Eigen::Vector2d at = atEnd(slot);
    overlaps_.move(slot, at.x(), at.y());
    return at;
  }

  void searchFrom(std::uint32_t slot, const Eigen::Vector2d& at, double now)
  {
    if (contacts_of_[slot] >= MOST_CONTACTS)
      return;
    overlaps_.forEachAround(slot, [this, now](std::uint32_t disk, std::uint32_t other, int shift)
                            { findContact(disk, other, shift, now); });
    if (mayTouchBase(slot, at))
      findBaseContact(slot, now);
  }

  SystemState& state_;
  ContactPrediction prediction_;
  ContactExecution execution_;
  double step_;         ///< [s]
  double gravity_;      ///< [m/s^2]
  double start_ = 0.0;  ///< of the next step
  double end_ = 0.0;
  double length_ = 0.0;      ///< of the step [s]
  bool turning_ = false;     ///< the base, within the step
  double base_reach_ = 0.0;  ///< largest displacement of the base within the step [m]
  Overlaps overlaps_;
  BaseOverlap base_overlap_;
  std::vector<std::uint32_t> near_base_;
  StepContacts contacts_;
  std::vector<std::uint32_t> contacts_of_;  ///< within the step, per slot
  FrameOfBase frame_;                       ///< at the end of the step
  Image ring_;                              ///< shift by the base's width, at the end of the step
  double stopped_at_ = 0.0;
};

}  // namespace

std::unique_ptr<EventLoop> makeStepLoop(SystemState& state)
{
  if (state.wideSizes())
    return std::make_unique<StepLoop<OverlapLevels>>(state);
  return std::make_unique<StepLoop<OverlapSearch>>(state);
}

}  // namespace ratchet_sieve
