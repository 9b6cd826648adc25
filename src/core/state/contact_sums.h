#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
