#include "model/orbit.h"

#include <algorithm>
#include <cmath>

#include "model/motion.h"

namespace ratchet_sieve
{

double turnsOf(double phase)
{
  const double turns = phase / RADIANS_PER_TURN;
  return turns - std::floor(turns);
}

std::vector<HarmonicDefinition> sinesOf(const BaseDefinition& base)
{
  std::vector<HarmonicDefinition> sines = base.harmonics;
  sines.insert(sines.begin(), {1, base.amplitude, 0.0, base.horizontal_amplitude, base.horizontal_phase});
  return sines;
}

Orbit::Orbit(const BaseDefinition& base)
{
  std::vector<HarmonicDefinition> sines = sinesOf(base);
  sines.front().amplitude = 0.0;
  for (const HarmonicDefinition& sine : sines)
    if (sine.horizontal_amplitude != 0.0 || sine.amplitude != 0.0)
      terms_.push_back({sine.multiple,
                        {sine.horizontal_amplitude, sine.amplitude},
                        {turnsOf(sine.horizontal_phase), turnsOf(sine.phase)}});
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

}  // namespace ratchet_sieve
