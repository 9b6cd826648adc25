#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/base_shape.h"
#include "state/observer.h"

namespace ratchet_sieve
{

/// Counts of contacts since the start of the run, independent of their order.
class ContactCounts final : public Observer
{
public:
  CollisionCounts collisions;
  double max_overlap = 0.0;      ///< [m]
  std::uint64_t pushed_out = 0;  ///< how often a disk was found below the base's surface and moved out

  void collided(const ContactOutcome& outcome) override { collisions.add(outcome.kind); }
  void addOverlap(double overlap) { max_overlap = overlap > max_overlap ? overlap : max_overlap; }

  void add(const ContactCounts& more)
  {
    addOverlap(more.max_overlap);
    pushed_out += more.pushed_out;
    collisions.add(more.collisions);
  }

  void archive(StateArchive& state) override { state(collisions, max_overlap, pushed_out); }
};

/// Contacts of each species since the means began, independent of their order. A contact counts for each disk
/// that takes part.
class SpeciesContacts final : public Observer
{
public:
  explicit SpeciesContacts(std::size_t species) : contacts_(species) {}

  std::uint64_t of(std::size_t species) const { return contacts_[species]; }

  void collided(const ContactOutcome& outcome) override
  {
    ++contacts_[outcome.species];
    if (outcome.j != ContactOutcome::BASE)
      ++contacts_[outcome.partner_species];
  }

  void add(const SpeciesContacts& more)
  {
    for (std::size_t species = 0; species < contacts_.size(); ++species)
      contacts_[species] += more.contacts_[species];
  }

  void restart(double /*time*/) override { std::fill(contacts_.begin(), contacts_.end(), 0); }

  void archive(StateArchive& state) override { state(contacts_); }

private:
  std::vector<std::uint64_t> contacts_;
};

/// The time of each disk's last contact, for the contact duration t_c. Empty if the plan has no contact
/// times.
class ContactTimes final : public Observer
{
public:
  explicit ContactTimes(bool kept) : kept_(kept) {}

  void entered(const Disk& /*disk*/, double /*time*/) override
  {
    if (kept_)
      times_.push_back(-std::numeric_limits<double>::infinity());
  }

  void collided(const ContactOutcome& outcome) override
  {
    if (!kept_)
      return;
    times_[outcome.i] = outcome.time;
    if (outcome.j != ContactOutcome::BASE)
      times_[outcome.j] = outcome.time;
  }

  /// Of one disk's last contact; 0 if there are no contact times.
  double of(std::uint32_t slot) const { return kept_ ? times_[slot] : 0.0; }
  void set(std::uint32_t slot, double time)
  {
    if (kept_)
      times_[slot] = time;
  }

  /// Whether the disk's last contact was less than `duration` ago.
  bool within(double duration, std::uint32_t slot, double time) const
  {
    return kept_ && time - times_[slot] < duration;
  }

  void compact(const Compaction& compaction) override
  {
    if (kept_)
      keepSlots(times_, compaction.kept);
  }

  void rebase(double length) override
  {
    for (double& time : times_)
      time -= length;
  }

  bool fits(std::size_t slots) const override { return times_.size() == (kept_ ? slots : 0); }
  void archive(StateArchive& state) override { state(times_); }

private:
  bool kept_;
  std::vector<double> times_;  ///< per slot, local to the epoch [s]
};

/// The impulse given by the base to the disks since the means began. Summed per disk, so that the bits do not
/// depend on the order in which independent disks are advanced. World frame [N s].
class BaseImpulses final : public Observer
{
public:
  void reserve(std::size_t count) override { given_.reserve(count); }
  void entered(const Disk& /*disk*/, double /*time*/) override { given_.push_back(Eigen::Vector2d::Zero()); }

  void collided(const ContactOutcome& outcome) override
  {
    if (outcome.j == ContactOutcome::BASE)
      given_[outcome.i] += impulseOf(outcome);
  }

  /// The impulse given to one disk.
  const Eigen::Vector2d& of(std::uint32_t slot) const { return given_[slot]; }
  void set(std::uint32_t slot, const Eigen::Vector2d& impulse) { given_[slot] = impulse; }

  Eigen::Vector2d total() const
  {
    Eigen::Vector2d sum = gone_;
    for (const Eigen::Vector2d& given : given_)
      sum += given;
    return sum;
  }

  void restart(double /*time*/) override
  {
    std::fill(given_.begin(), given_.end(), Eigen::Vector2d::Zero());
    gone_ = Eigen::Vector2d::Zero();
  }

  void compact(const Compaction& compaction) override
  {
    for (const std::uint32_t slot : compaction.gone)
      gone_ += given_[slot];
    keepSlots(given_, compaction.kept);
  }

  bool fits(std::size_t slots) const override { return given_.size() == slots; }

  void archive(StateArchive& state) override { state(given_, gone_); }

private:
  std::vector<Eigen::Vector2d> given_;              ///< per slot
  Eigen::Vector2d gone_ = Eigen::Vector2d::Zero();  ///< to disks removed by compaction
};

/// Counts contacts with each face and corner of a profile. A sawtooth needs none: its kinds of contacts say
/// it.
class FaceCounts final : public Observer
{
public:
  explicit FaceCounts(const BaseShape& shape)
  {
    contacts_.face_contacts.resize(shape.faces().size());
    contacts_.corner_contacts.resize(shape.faces().size());
  }

  unsigned subscriptions() const override { return CONTACTS; }

  void collided(const ContactOutcome& outcome) override
  {
    const auto index = static_cast<std::size_t>(outcome.feature.index());
    if (outcome.feature.kind() == BaseFeatureKind::FACE)
      ++contacts_.face_contacts[index];
    else if (outcome.kind == CollisionKind::APEX)
      ++contacts_.corner_contacts[index];
  }

  const FaceContacts& contacts() const { return contacts_; }

  /// @throws StateError if the state is of another profile
  void archive(StateArchive& state) override
  {
    const std::size_t faces = contacts_.face_contacts.size();
    state(contacts_);
    if (contacts_.face_contacts.size() != faces || contacts_.corner_contacts.size() != faces)
      throw StateError("it is of another scene");
  }

private:
  FaceContacts contacts_;
};

}  // namespace ratchet_sieve
