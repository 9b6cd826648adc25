#pragma once

#include "model/base_shape.h"
#include "state/observer.h"

namespace ratchet_sieve
{

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
