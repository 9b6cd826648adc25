#include "model/base_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ratchet_sieve/core/drive_of_scene.h"

namespace ratchet_sieve
{
namespace
{
/// Ramps whose ends differ by less than this fraction of the remaining time end together. Otherwise rounding
/// could leave a segment shorter than the time resolution.
constexpr double SAME_END = 1e-12;

double fraction(double x)
{
  return x - std::floor(x);
}

/// From the axes of the base into those of the world. While the base turns, the stroke turns with it.
void turnDrive(FrameOfBase& frame)
{
  frame.displacement = frame.outOf(frame.displacement);
  const Eigen::Vector2d across(-frame.displacement.y(), frame.displacement.x());
  frame.velocity = frame.outOf(frame.velocity) + frame.inclination_rate * across;
}

/// A bound on a vector's components after a rotation.
Eigen::Vector2d turnedBound(const Rotation& rotation, const Eigen::Vector2d& bound)
{
  const double cosine = std::abs(rotation.cosine);
  const double sine = std::abs(rotation.sine);
  return {sine * bound.y() + cosine * bound.x(), cosine * bound.y() + sine * bound.x()};
}

Rotation rotationBy(double angle)
{
  const auto turned = sineCosineOfTurns(angle / RADIANS_PER_TURN);
  return {turned.cosine, turned.sine};
}
}  // namespace

void BaseMotion::Ramp::advance(double elapsed)
{
  const auto end = remaining();
  start = end && *end <= elapsed * (1.0 + SAME_END) ? target : at(elapsed);
}

BaseMotion::BaseMotion(const BaseDefinition& base, double max_turn)
    : orbit_(base),
      scene_amplitude_(base.amplitude),
      scaled_(base.amplitude > 0.0),
      max_turn_(max_turn),
      turned_(base.drive_frame == DriveFrame::BASE)
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    ramp(q.quantity) = {base.*q.definition, 0.0, base.*q.definition};
  turns_ = fraction(base.phase / RADIANS_PER_TURN);
  plan();
}

std::optional<double> BaseMotion::timeOfTurns(double turns) const
{
  const double left = turns - turns_;
  if (left <= 0.0)
    return segment_start_;
  const double squared = frequency_.start * frequency_.start + 2.0 * frequency_.rate * left;
  if (squared <= 0.0)
    return std::nullopt;
  return segment_start_ + 2.0 * left / (frequency_.start + std::sqrt(squared));
}

void BaseMotion::evaluate(double time, FrameOfBase& frame) const
{
  const double elapsed = time - segment_start_;
  frame.inclination = inclination_.at(elapsed);
  frame.inclination_rate = inclination_.rate;
  frame.rotation = rotation_;
  if (!oscillates_)
  {
    frame.displacement = standstill_;
    frame.velocity.setZero();
  }
  else if (!next_change_)
  {
    // At its setpoints: the same bits as with ramps, but faster.
    const auto stroke = strokeAt(drive(), time);
    frame.displacement = {0.0, stroke.displacement};
    frame.velocity = {0.0, stroke.velocity};
  }
  else
  {
    const auto phase = sineCosineOfTurns(turns(elapsed));
    const auto stroke =
        strokeAtPhase(driveOf(amplitude_.at(elapsed), frequency_.at(elapsed), time, turns(elapsed)), phase);
    frame.displacement = {0.0, stroke.displacement};
    frame.velocity = {0.0, stroke.velocity + amplitude_.rate * phase.sine};
  }
  if (turning())
    frame.rotation = rotationBy(frame.inclination);
  if (plain_)
    return;
  if (orbits_)
    followOrbit(elapsed, frame);
  if (turned_)
    turnDrive(frame);
}

void BaseMotion::followOrbit(double elapsed, FrameOfBase& frame) const
{
  const Orbit::Point point = orbit_.at(turns(elapsed));
  const double scale = orbitScale(amplitude_.at(elapsed));
  const double phase_rate = angularFrequency(frequency_.at(elapsed));
  frame.displacement += scale * point.displacement;
  frame.velocity += scale * phase_rate * point.slope + orbitScaleRate() * point.displacement;
}

DriveState BaseMotion::state(double time) const
{
  const double elapsed = time - segment_start_;
  const FrameOfBase frame = at(time);
  DriveState state;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    state.*q.applied = ramp(q.quantity).at(elapsed);
    state.*q.commanded = ramp(q.quantity).target;
  }
  state.phase = RADIANS_PER_TURN * fraction(turns(elapsed));
  state.displacement = frame.displacement.y();
  state.velocity = frame.velocity.y();
  state.horizontal_displacement = frame.displacement.x();
  state.horizontal_velocity = frame.velocity.x();
  return state;
}

void BaseMotion::advanceTo(double time)
{
  const double elapsed = time - segment_start_;
  turns_ = fraction(turns(elapsed));
  for (const auto ramp : RAMPS)
    (this->*ramp).advance(elapsed);
  segment_start_ = time;
}

void BaseMotion::pursue(Ramp& ramp, double slew_rate) const
{
  ramp.rate = ramp.start == ramp.target ? 0.0 : std::copysign(slew_rate, ramp.target - ramp.start);
  const auto remaining = ramp.remaining();
  if (!remaining || segment_start_ + *remaining > segment_start_)
    return;
  // The end of the ramp is closer than a double can resolve: the target is reached.
  ramp.start = ramp.target;
  ramp.rate = 0.0;
}

void BaseMotion::plan()
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    pursue(ramp(q.quantity), slew_rates_.*q.slew_rate);

  rotation_ = rotationBy(inclination_.start);

  next_change_.reset();
  for (const auto ramp : RAMPS)
    if (const auto remaining = (this->*ramp).remaining())
    {
      const double end = segment_start_ + *remaining;
      next_change_ = std::min(next_change_.value_or(end), end);
    }
  if (turning())
    next_change_ = std::min(*next_change_, segment_start_ + max_turn_ / std::abs(inclination_.rate));
  updateBounds();
  noteDerived();
}

void BaseMotion::rebase(double length)
{
  if (segment_start_ < length)
  {
    if (next_change_)
      beginSegment(length);
    else
      turns_ = fraction(turns_ + fraction((length - segment_start_) * frequency_.start));
    segment_start_ = length;
  }
  segment_start_ -= length;
  if (next_change_)
    next_change_ = *next_change_ - length;
}

/// As speedBound(), without the turning of the drive's axes.
double BaseMotion::driveSpeedBound() const
{
  const double phase_rate = angularFrequency(std::max(frequency_.start, frequency_.target));
  const double amplitude = std::max(amplitude_.start, amplitude_.target);
  const Eigen::Vector2d stroke(0.0, phase_rate * amplitude + std::abs(amplitude_.rate));
  const Eigen::Vector2d orbit =
      orbitScale(amplitude) * phase_rate * orbit_.bound(1) + std::abs(orbitScaleRate()) * orbit_.bound(0);
  return (stroke + orbit).norm();
}

double BaseMotion::speedBound() const
{
  const double turning_axes = turned_ ? std::abs(inclination_.rate) * displacement_bound_.norm() : 0.0;
  return driveSpeedBound() + turning_axes;
}

/// A bound on the components in the world, from one along the drive's axes.
Eigen::Vector2d BaseMotion::boundInWorld(const Eigen::Vector2d& bound) const
{
  if (!turned_)
    return bound;
  return turning() ? Eigen::Vector2d::Constant(bound.norm()).eval() : turnedBound(rotation_, bound);
}

double BaseMotion::throwHeight(double gravity) const
{
  const Eigen::Vector2d orbit =
      orbitScale(amplitude_.start) * angularFrequency(frequency_.start) * orbit_.bound(1);
  const double speed = boundInWorld({orbit.x(), drive().speed + orbit.y()}).y();
  return gravity > 0.0 ? 0.5 * speed * speed / gravity : std::numeric_limits<double>::infinity();
}

void BaseMotion::updateBounds()
{
  const double length = next_change_ ? *next_change_ - segment_start_ : 0.0;
  const double amplitude = std::max(amplitude_.start, amplitude_.at(length));
  const double phase_rate = angularFrequency(std::max(frequency_.start, frequency_.at(length)));
  const double phase_acceleration = RADIANS_PER_TURN * std::abs(frequency_.rate);
  const double scale = orbitScale(amplitude);
  const Eigen::Vector2d orbit =
      scale * phase_rate * phase_rate * orbit_.bound(2) +
      (2.0 * std::abs(orbitScaleRate()) * phase_rate + scale * phase_acceleration) * orbit_.bound(1);
  const double stroke = amplitude * phase_rate * phase_rate + 2.0 * std::abs(amplitude_.rate) * phase_rate +
                        amplitude * phase_acceleration;
  acceleration_bound_ = Eigen::Vector2d(0.0, stroke) + orbit;
  displacement_bound_ = Eigen::Vector2d(0.0, amplitude) + scale * orbit_.bound(0);
}

/// Over the present segment, for any phase.
bool BaseMotion::hasStroke() const
{
  return amplitude_.start != 0.0 || amplitude_.rate != 0.0 || (!orbit_.empty() && !scaled_);
}

/// Members derived from the others, not archived. Without amplitude or with a constant phase, the drive gives
/// exactly the same displacement over the whole segment.
void BaseMotion::noteDerived()
{
  world_displacement_ = boundInWorld(displacement_bound_);
  world_acceleration_ = boundInWorld(acceleration_bound_);
  if (turned_ && turning())
  {
    // The Coriolis and the centripetal acceleration of the stroke in the turning axes.
    const double rate = std::abs(inclination_.rate);
    world_acceleration_.array() += 2.0 * rate * driveSpeedBound() + rate * rate * displacement_bound_.norm();
  }
  greatest_acceleration_ = world_acceleration_.norm();
  reach_ = turned_ ? displacement_bound_ : turnedBound(rotation_, displacement_bound_);
  const bool halted = frequency_.start == 0.0 && frequency_.rate == 0.0 && amplitude_.rate == 0.0;
  oscillates_ = hasStroke() && !halted;
  orbits_ = oscillates_ && !orbit_.empty();
  plain_ = !orbits_ && !turned_;
  standstill_.setZero();
  if (oscillates_ || !hasStroke())
    return;
  standstill_.y() = amplitude_.start * sineCosineOfTurns(turns_).sine;
  if (!orbit_.empty())
    standstill_ += orbitScale(amplitude_.start) * orbit_.at(turns_).displacement;
}

}  // namespace ratchet_sieve
