#include "state/contact_execution.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// The component of a velocity along the tangent: the normal turned by +90 degrees.
double across(const Eigen::Vector2d& normal, const Eigen::Vector2d& velocity)
{
  return normal.x() * velocity.y() - normal.y() * velocity.x();
}
}  // namespace

ContactExecution::ContactExecution(SystemState& system, ThreadBuffer* buffer)
    : system_(system),
      buffer_(buffer),
      law_(system.scene().contact),
      spin_(system.plan().spin),
      contact_times_(system.plan().contact_times)
{
  const std::vector<SpeciesDefinition>& species = system.scene().species;
  for (std::size_t i = 0; i < species.size(); ++i)
  {
    levers_.push_back(leverOf(species[i]));
    for (std::size_t j = 0; j < species.size(); ++j)
      pair_coefficients_.push_back(contactBetween(system.scene(), i, j));
  }
}

ContactOutcome ContactExecution::collideWithBase(std::uint32_t slot, const BaseFeature& feature, double time,
                                                 BaseInstant& base)
{
  const SceneDefinition& scene = system_.scene();
  const Disk& disk = system_.disk(slot);
  const SpeciesDefinition& species = scene.species[disk.species];
  const FrameOfBase& frame = base.at(time);
  const BasePoint point = frame.see(kinematicsAt(disk, time, scene.gravity));
  const Approach approach = system_.shape().approach(feature, point, disk.radius);
  ContactOutcome outcome;
  outcome.time = time;
  outcome.kind = system_.shape().kindOf(feature);
  outcome.feature = feature;
  outcome.i = slot;
  outcome.species = disk.species;
  outcome.overlap = -approach.gap;
  outcome.closed = approach.rate < 0.0;
  if (outcome.closed)
  {
    outcome.normal = frame.outOf(approach.normal);
    outcome.normal_velocity = approach.rate;
    // The surface moves with the turning base: at the contact, r below the centre, its velocity differs by r
    // d theta/dt.
    const double tangential_velocity =
        across(approach.normal, point.velocity) - disk.radius * (disk.spin - frame.inclination_rate);
    outcome.lossless = lossless(slot, -outcome.normal_velocity, time);
    ContactCoefficients coefficients = outcome.lossless ? LOSSLESS : species.contact;
    if (outcome.kind == CollisionKind::WALL)
      coefficients.friction = 0.0;
    respond(outcome, coefficients, contactMasses(inertia(slot)), tangential_velocity,
            reboundFloor(slot, outcome.lossless));
    push(slot, outcome, 1.0);
    system_.record(slot).base_impulse += impulseOf(outcome);
  }
  system_.collided(outcome, buffer_);
  return outcome;
}

ContactOutcome ContactExecution::collidePair(std::uint32_t i, std::uint32_t j, int shift, double time)
{
  const Disk& a = system_.disk(i);
  const Disk& b = system_.disk(j);
  const Image there = system_.image(shift, time);
  const Relative seen = FlightLine(a, there.shift).seenFrom(b, time);
  const Eigen::Vector2d position = vectorOf(seen.position);
  const Eigen::Vector2d velocity = vectorOf(seen.velocity) - there.velocity;
  const double distance = position.norm();
  ContactOutcome outcome;
  outcome.time = time;
  outcome.kind = CollisionKind::DISK_DISK;
  outcome.i = i;
  outcome.j = j;
  outcome.species = a.species;
  outcome.partner_species = b.species;
  outcome.overlap = seen.distance - distance;
  // The very sum of the prediction: see FlightLine.
  outcome.closed = position.dot(velocity) < 0.0;
  if (outcome.closed)
  {
    outcome.normal = position / distance;
    outcome.normal_velocity = velocity.dot(outcome.normal);
    // If the normal velocity is lost to rounding, the disks still approach, within the rounding error.
    if (outcome.normal_velocity >= 0.0)
      outcome.normal_velocity = -std::numeric_limits<double>::epsilon() * velocity.norm();
    const double tangential_velocity =
        across(outcome.normal, velocity) - (a.radius * a.spin + b.radius * b.spin);
    const double speed = -outcome.normal_velocity;
    outcome.lossless = lossless(i, speed, time) || lossless(j, speed, time);
    const std::size_t pair = a.species * system_.scene().species.size() + b.species;
    respond(outcome, outcome.lossless ? LOSSLESS : pair_coefficients_[pair],
            contactMasses(inertia(i), inertia(j)), tangential_velocity,
            std::max(reboundFloor(i, outcome.lossless), reboundFloor(j, outcome.lossless)));
    push(i, outcome, 1.0);
    push(j, outcome, -1.0);
  }
  system_.collided(outcome, buffer_);
  return outcome;
}

void ContactExecution::respond(ContactOutcome& outcome, const ContactCoefficients& coefficients,
                               const ContactMasses& masses, double tangential_velocity, double floor) const
{
  CollisionLaw law = law_;
  law.min_rebound_speed = floor;
  const Impulse impulse =
      spin_ ? collide(law, coefficients, masses, outcome.normal_velocity, tangential_velocity)
            : Impulse{normalImpulse(law, contactNumbers(coefficients, masses), outcome.normal_velocity), 0.0};
  outcome.normal_impulse = impulse.normal;
  outcome.tangential_impulse = impulse.tangential;
}

/// Applies the impulse to a partner. For the second partner the contact is on the opposite side, so that the
/// torque of the tangential impulse has the same sign on both.
void ContactExecution::push(std::uint32_t slot, const ContactOutcome& contact, double sign)
{
  const DiskProperties& properties = system_.properties(slot);
  const Eigen::Vector2d velocity = sign / properties.mass * impulseOf(contact);
  system_.redirect(slot, {Two{}, twoOf(velocity), -properties.spin_response * contact.tangential_impulse},
                   contact.time, buffer_);
  if (contact_times_)
    system_.record(slot).last_contact = contact.time;
}

/// v_min does not apply to lossless contacts, because it would add energy. For a disk that is lossless
/// because of a collapse, adding energy is intended.
double ContactExecution::reboundFloor(std::uint32_t slot, bool no_loss) const
{
  if (system_.collapseWatch().lossless(slot))
    return system_.collapseWatch().floorSpeed(slot);
  return no_loss ? 0.0 : law_.min_rebound_speed;
}

}  // namespace ratchet_sieve
