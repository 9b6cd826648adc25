#include "ratchet_sieve/core/drive_of_scene.h"

#include <algorithm>
#include <cmath>

#include "model/base_motion.h"
#include "model/motion.h"
#include "model/orbit.h"

namespace ratchet_sieve
{
namespace
{
/// Of the ellipse (X sin(t + lead), Y sin(t)).
double greatestRadius(const Eigen::Vector2d& amplitudes, double lead)
{
  const Eigen::Vector2d squares = amplitudes.cwiseAbs2();
  const double half_difference = 0.5 * (squares.y() - squares.x());
  const double joint = amplitudes.prod() * sineCosineOfTurns(turnsOf(lead)).cosine;
  return std::sqrt(0.5 * squares.sum() + std::sqrt(half_difference * half_difference + joint * joint));
}
}  // namespace

DriveBounds driveBounds(const BaseDefinition& base)
{
  const double rate = angularFrequency(base.frequency);
  DriveBounds bounds{};
  for (const HarmonicDefinition& sine : sinesOf(base))
  {
    const double radius =
        greatestRadius({sine.horizontal_amplitude, sine.amplitude}, sine.horizontal_phase - sine.phase);
    const double pulse = sine.multiple * rate;
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
  const std::vector<HarmonicDefinition> sines = sinesOf(base);
  const int steps = STEPS_PER_PERIOD * Orbit(base).highestMultiple();
  double peak = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    const double turns = static_cast<double>(k) / steps;
    Eigen::Vector2d bend = Eigen::Vector2d::Zero();
    for (const auto& [multiple, amplitude, phase, horizontal_amplitude, horizontal_phase] : sines)
    {
      const auto sine = [turns, k = multiple](double lead)
      { return k * k * sineCosineOfTurns(k * turns + turnsOf(lead)).sine; };
      bend += Eigen::Vector2d(horizontal_amplitude * sine(horizontal_phase), amplitude * sine(phase));
    }
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

DriveState driveStateAt(const BaseDefinition& base, double time)
{
  return BaseMotion(base).state(time);
}

}  // namespace ratchet_sieve
