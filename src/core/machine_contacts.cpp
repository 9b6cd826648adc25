#include <algorithm>
#include <cmath>
#include <cstring>

#include "ratchet_sieve/core/machine.h"

namespace ratchet_sieve
{
namespace
{
CollisionKind collisionKind(BaseFeatureKind kind, Boundary boundary)
{
  switch (kind)
  {
    case BaseFeatureKind::LEFT_SLOPE:
      return CollisionKind::LEFT_SLOPE;
    case BaseFeatureKind::RIGHT_SLOPE:
      return CollisionKind::RIGHT_SLOPE;
    case BaseFeatureKind::LEFT_WALL:
    case BaseFeatureKind::RIGHT_WALL:
      return CollisionKind::WALL;
    case BaseFeatureKind::END_CORNER:
      return boundary == Boundary::WALLED ? CollisionKind::WALL : CollisionKind::APEX;
    default:
      return CollisionKind::APEX;
  }
}
}  // namespace

void Machine::meetBase(std::uint32_t id, const BaseFeature& feature, double time, BaseInstant& base)
{
  if (feature.kind == BaseFeatureKind::LEFT_END || feature.kind == BaseFeatureKind::RIGHT_END)
    return leave(id, feature.kind == BaseFeatureKind::RIGHT_END, time);

  const Disk disk = flown(disks_[id], time, scene_.gravity);
  const SpeciesDefinition& species = scene_.species[disk.species];
  const BaseKinematics& k = base.at(time);
  const BasePoint point = toBase(k, disk.x, disk.y, disk.vx, disk.vy);
  const Approach approach = sawtooth_.approach(feature, point, species.radius);
  noteOverlap(-approach.gap);
  if (approach.rate >= 0.0)
    return push(id, disk, {}, {}, 1.0);

  Contact contact;
  contact.nx = k.cosine * approach.normal_s - k.sine * approach.normal_n;
  contact.ny = k.sine * approach.normal_s + k.cosine * approach.normal_n;
  contact.normal_velocity = approach.rate;
  // The base's surface turns with it: at the contact, r below the centre, it differs by r d theta/dt.
  if (plan_.spin)
    contact.tangential_velocity = approach.normal_s * point.vn - approach.normal_n * point.vs -
                                  species.radius * (disk.spin - k.inclination_rate);

  const CollisionKind kind = collisionKind(feature.kind, scene_.boundary);
  const bool no_loss = lossless(id, time);
  ContactCoefficients coefficients = no_loss ? LOSSLESS : species.contact;
  if (kind == CollisionKind::WALL)
    coefficients.friction = 0.0;
  const Impulse impulse =
      respond(coefficients, base_masses_[disk.species], contact, reboundFloor(id, no_loss));
  push(id, disk, contact, impulse, 1.0);
  tally_.pushed(id, impulse.normal * contact.nx - impulse.tangential * contact.ny,
                impulse.normal * contact.ny + impulse.tangential * contact.nx);
  touched(id, time);
  report(time, kind, id, nullptr, contact, impulse);
}

void Machine::meetPair(std::uint32_t i, std::uint32_t j, int shift, double time)
{
  const Disk a = flown(disks_[i], time, scene_.gravity);
  const Disk b = flown(disks_[j], time, scene_.gravity);
  const Image there = image(shift, time);
  const double dx = a.x - there.dx - b.x;
  const double dy = a.y - there.dy - b.y;
  const double distance = std::sqrt(dx * dx + dy * dy);
  noteOverlap(radius(i) + radius(j) - distance);
  const double dvx = a.vx - b.vx - there.dvx;
  const double dvy = a.vy - b.vy - there.dvy;
  // The very sum that the prediction looks at (timeToTouch): were it another, rounding could have a
  // contact predicted here and left alone there, again and again.
  if (dx * dvx + dy * dvy >= 0.0)
  {
    push(i, a, {}, {}, 1.0);
    push(j, b, {}, {}, -1.0);
    return;
  }
  Contact contact;
  contact.nx = dx / distance;
  contact.ny = dy / distance;
  contact.normal_velocity = std::min(0.0, dvx * contact.nx + dvy * contact.ny);
  if (plan_.spin)
    contact.tangential_velocity =
        dvy * contact.nx - dvx * contact.ny - (radius(i) * a.spin + radius(j) * b.spin);

  const std::size_t pair = a.species * scene_.species.size() + b.species;
  const bool no_loss = lossless(i, time) || lossless(j, time);
  const Impulse impulse = respond(no_loss ? LOSSLESS : pair_coefficients_[pair], pair_masses_[pair], contact,
                                  std::max(reboundFloor(i, no_loss), reboundFloor(j, no_loss)));
  push(i, a, contact, impulse, 1.0);
  push(j, b, contact, impulse, -1.0);
  touched(i, time);
  touched(j, time);
  report(time, CollisionKind::DISK_DISK, i, &j, contact, impulse);
}

Impulse Machine::respond(const ContactCoefficients& coefficients, const ContactMasses& masses,
                         const Contact& contact, double floor) const
{
  CollisionLaw law = scene_.contact;
  law.min_rebound_speed = floor;
  return plan_.spin ? collide(law, coefficients, masses, contact.normal_velocity, contact.tangential_velocity)
                    : collideSmooth(law, coefficients, masses, contact.normal_velocity);
}

/// Gives a partner, which is flown to the contact as `now`, its share of the impulse. The contact lies on the
/// normal's other side for the second partner, so that the torque of the tangential impulse has the same sign
/// on both.
///
/// In an inelastic collapse contacts follow one another sooner than the disk comes a resolution of its place
/// further: a place that is rounded at each of them stands still or runs ahead, while the partner moves on,
/// and the overlap grows by that way. So an impulse that changes the place by nothing to speak of if it is
/// given at the start of the flight is given there, and the place is left as it was written down.
void Machine::push(std::uint32_t id, const Disk& now, const Contact& contact, const Impulse& impulse,
                   double sign)
{
  Disk& disk = disks_[id];
  const Response& response = responses_[disk.species];
  const double change = response.velocity * (std::abs(impulse.normal) + std::abs(impulse.tangential));
  if (change * (now.time - disk.time) > negligible_way_)
  {
    tally_.flew(id, disk, now.time);
    disk = now;
  }
  ++disk.flights;
  const double per_mass = sign * response.velocity;
  const Two normal{contact.nx, contact.ny};
  const Two tangent{-contact.ny, contact.nx};
  const Two velocity =
      Two{disk.vx, disk.vy} + per_mass * (impulse.normal * normal + impulse.tangential * tangent);
  std::memcpy(&disk.vx, &velocity, sizeof velocity);
  disk.spin -= response.spin * impulse.tangential;
}

bool Machine::lossless(std::uint32_t id, double time) const
{
  if (collapse_watch_.loosened(id))
    return true;
  return !last_contacts_.empty() && time - last_contacts_[id] < scene_.contact.contact_duration;
}

/// v_min does not apply to a contact that loses nothing: it would put energy in. Where a collapse has
/// loosened the disk, it is energy that is asked for.
double Machine::reboundFloor(std::uint32_t id, bool no_loss) const
{
  if (collapse_watch_.loosened(id))
    return collapse_watch_.floorSpeed(id);
  return no_loss ? 0.0 : scene_.contact.min_rebound_speed;
}

void Machine::touched(std::uint32_t id, double time)
{
  if (!last_contacts_.empty())
    last_contacts_[id] = time;
}

void Machine::report(double time, CollisionKind kind, std::uint32_t i, const std::uint32_t* j,
                     const Contact& contact, const Impulse& impulse)
{
  collisions_.add(kind);
  tally_.collided(disks_[i].species);
  if (j)
    tally_.collided(disks_[*j].species);
  if (!observer_)
    return;
  CollisionRecord record;
  record.time = epoch_.start + time;
  record.kind = kind;
  record.i = number(i);
  if (j)
    record.j = number(*j);
  record.normal_speed = -contact.normal_velocity;
  record.normal_impulse = impulse.normal;
  record.tangential_impulse = impulse.tangential;
  observer_(record);
}

}  // namespace ratchet_sieve
