#pragma once

#include <cstdint>
#include <vector>

#include "model/collision_law.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Executes the events of disks: applies the collision law to the partners of a contact, and hands the
/// outcome to the observers. Times are local to the epoch.
class ContactExecution
{
public:
  /// @param system outlives this
  /// @param buffer of the thread, if several advance disks at the same time: see SystemState::collided();
  /// outlives this
  explicit ContactExecution(SystemState& system, ThreadBuffer* buffer = nullptr);

  /// Executes a disk's event with the base: a contact, or the passage of an end.
  /// @return whether the disk's flight has changed
  bool handleBaseEvent(std::uint32_t slot, const BaseFeature& feature, double time, BaseInstant& base)
  {
    if (!feature.isEnd())
      return collideWithBase(slot, feature, time, base).closed;
    system_.passEnd(slot, feature.kind() == BaseFeatureKind::RIGHT_END, time, buffer_);
    return true;
  }

  /// Collides a disk with the base. A separating contact changes nothing.
  /// @pre the feature is not an end at which a disk leaves
  ContactOutcome collideWithBase(std::uint32_t slot, const BaseFeature& feature, double time,
                                 BaseInstant& base);

  /// Collides disk i with the image of disk j that is `shift` widths to the right of j. If they separate, it
  /// changes nothing.
  ContactOutcome collidePair(std::uint32_t i, std::uint32_t j, int shift, double time);

private:
  Inertia inertia(std::uint32_t slot) const
  {
    return {system_.properties(slot).mass, levers_[system_.disk(slot).species]};
  }
  /// @param speed of approach [m/s]
  bool lossless(std::uint32_t slot, double speed, double time) const
  {
    return (system_.collapseWatch().lossless(slot) && speed < system_.collapseWatch().slow(slot)) ||
           (contact_times_ &&
            time - system_.record(slot).last_contact < system_.scene().contact.contact_duration);
  }
  double reboundFloor(std::uint32_t slot, bool no_loss) const;
  void respond(ContactOutcome& outcome, const ContactCoefficients& coefficients, const ContactMasses& masses,
               double tangential_velocity, double floor) const;
  void push(std::uint32_t slot, const ContactOutcome& contact, double sign);

  SystemState& system_;
  ThreadBuffer* buffer_;
  CollisionLaw law_;
  bool spin_;
  bool contact_times_;

  std::vector<ContactCoefficients> pair_coefficients_;  ///< per (species, species)
  std::vector<double> levers_;                          ///< per species; see Inertia
};

}  // namespace ratchet_sieve
