#include "model/orbit.h"
#include "ratchet_sieve/core/drive_of_scene.h"

#include <algorithm>
#include <cmath>

#include "model/drive.h"

namespace ratchet_sieve
{
namespace
{
/// The fractional part only, because whole turns would cost precision.
double turnsOf(double phase)
{
  const double turns = phase / RADIANS_PER_TURN;
  return turns - std::floor(turns);
}

/// Of the ellipse (X sin(t + lead), Y sin(t)).
double greatestRadius(const Eigen::Vector2d& amplitudes, double lead)
{
  const Eigen::Vector2d squares = amplitudes.cwiseAbs2();
  const double half_difference = 0.5 * (squares.y() - squares.x());
  const double joint = amplitudes.prod() * sineCosineOfTurns(turnsOf(lead)).cosine;
  return std::sqrt(0.5 * squares.sum() + std::sqrt(half_difference * half_difference + joint * joint));
}
}  // namespace

Orbit::Orbit(const BaseDefinition& base)
{
  add({1, {base.horizontal_amplitude, 0.0}, {turnsOf(base.horizontal_phase), 0.0}});
  for (const HarmonicDefinition& harmonic : base.harmonics)
    add({harmonic.multiple,
         {harmonic.horizontal_amplitude, harmonic.amplitude},
         {turnsOf(harmonic.horizontal_phase), turnsOf(harmonic.phase)}});
}

void Orbit::add(const Term& term)
{
  if (!term.amplitudes.isZero(0.0))
    terms_.push_back(term);
}

int Orbit::highestMultiple() const
{
  int highest = 1;
  for (const Term& term : terms_)
    highest = std::max(highest, term.multiple);
  return highest;
}

Orbit::Point Orbit::at(double turns) const
{
  Point point{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  for (const Term& term : terms_)
  {
    const auto x = sineCosineOfTurns(term.multiple * turns + term.turns.x());
    const auto y = sineCosineOfTurns(term.multiple * turns + term.turns.y());
    point.displacement += term.amplitudes.cwiseProduct(Eigen::Vector2d(x.sine, y.sine));
    point.slope += term.multiple * term.amplitudes.cwiseProduct(Eigen::Vector2d(x.cosine, y.cosine));
  }
  return point;
}

Eigen::Vector2d Orbit::bound(int derivative) const
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Term& term : terms_)
  {
    double factor = 1.0;
    for (int i = 0; i < derivative; ++i)
      factor *= term.multiple;
    sum += factor * term.amplitudes.cwiseAbs();
  }
  return sum;
}

DriveBounds driveBounds(const BaseDefinition& base)
{
  const double rate = angularFrequency(base.frequency);
  const double stroke = greatestRadius({base.horizontal_amplitude, base.amplitude}, base.horizontal_phase);
  DriveBounds bounds{stroke, rate * stroke, rate * rate * stroke};
  for (const HarmonicDefinition& harmonic : base.harmonics)
  {
    const double radius = greatestRadius({harmonic.horizontal_amplitude, harmonic.amplitude},
                                         harmonic.horizontal_phase - harmonic.phase);
    const double pulse = harmonic.multiple * rate;
    bounds.displacement += radius;
    bounds.speed += pulse * radius;
    bounds.acceleration += pulse * pulse * radius;
  }
  return bounds;
}

double peakLift(const BaseDefinition& base)
{
  constexpr int STEPS_PER_PERIOD = 512;  // of the fastest harmonic: the peak within 2e-5
  const bool turned = base.drive_frame == DriveFrame::BASE;
  const Eigen::Vector2d up = turned ? Eigen::Vector2d(std::sin(base.inclination), std::cos(base.inclination))
                                    : Eigen::Vector2d::UnitY();
  const int steps = STEPS_PER_PERIOD * Orbit(base).highestMultiple();
  double peak = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double turns = static_cast<double>(k) / steps;
    const auto sine = [turns](int multiple, double phase)
    { return multiple * multiple * sineCosineOfTurns(multiple * turns + turnsOf(phase)).sine; };
    Eigen::Vector2d bend(base.horizontal_amplitude * sine(1, base.horizontal_phase),
                         base.amplitude * sine(1, 0.0));
    for (const HarmonicDefinition& harmonic : base.harmonics)
      bend +=
          Eigen::Vector2d(harmonic.horizontal_amplitude * sine(harmonic.multiple, harmonic.horizontal_phase),
                          harmonic.amplitude * sine(harmonic.multiple, harmonic.phase));
    peak = std::max(peak, up.dot(bend));
  }
  const double rate = angularFrequency(base.frequency);
  return rate * rate * peak;
}

bool hasStroke(const BaseDefinition& base)
{
  return base.amplitude > 0.0 || !Orbit(base).empty();
}

BaseDefinition withAmplitude(const BaseDefinition& base, double amplitude)
{
  BaseDefinition scaled = base;
  scaled.amplitude = amplitude;
  if (base.amplitude == 0.0)
    return scaled;
  const double factor = amplitude / base.amplitude;
  scaled.horizontal_amplitude *= factor;
  for (HarmonicDefinition& harmonic : scaled.harmonics)
  {
    harmonic.amplitude *= factor;
    harmonic.horizontal_amplitude *= factor;
  }
  return scaled;
}

}  // namespace ratchet_sieve
