#pragma once

#include "model/base_shape.h"
#include "state/contact_outcome.h"

namespace ratchet_sieve
{

/// Counts contacts with each face and corner of a profile; nothing of a sawtooth, whose kinds of contacts say
/// it.
class FaceCounts
{
public:
  explicit FaceCounts(const BaseShape& shape)
  {
    if (!shape.isProfile())
      return;
    contacts_.face_contacts.resize(shape.faces().size());
    contacts_.corner_contacts.resize(shape.faces().size());
  }

  /// @pre outcome.closed
  void take(const ContactOutcome& outcome)
  {
    if (contacts_.face_contacts.empty())
      return;
    const auto index = static_cast<std::size_t>(outcome.feature.index());
    if (outcome.feature.kind() == BaseFeatureKind::FACE)
      ++contacts_.face_contacts[index];
    else if (outcome.kind == CollisionKind::APEX)
      ++contacts_.corner_contacts[index];
  }

  const FaceContacts& contacts() const { return contacts_; }

  /// @throws StateError if the state is of another profile
  void archive(StateArchive& state)
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
