#pragma once

#include <vector>

#include <Eigen/Core>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// A phase over 2 pi: the fractional part only, because whole turns would cost precision.
double turnsOf(double phase);

/// The whole drive: A sin(phi) with its horizontal part, and the harmonics.
std::vector<HarmonicDefinition> sinesOf(const BaseDefinition& base);

/// The parts of the drive besides A sin(phi) upwards: the horizontal part and the harmonics, D(phi) = sum
/// over k of (A_x,k sin(k phi + phi_x,k), A_k sin(k phi + phi_k)), where k = 1 is the horizontal part only.
/// World frame. Empty for the paper's machine, which has only A sin(phi).
class Orbit
{
public:
  explicit Orbit(const BaseDefinition& base);

  bool empty() const { return terms_.empty(); }

  /// The largest k; 1 without harmonics.
  int highestMultiple() const
  {
    int highest = 1;
    for (const Term& term : terms_)
      highest = std::max(highest, term.multiple);
    return highest;
  }

  /// D at a phase, and its derivatives by the phase.
  struct Point
  {
    Eigen::Vector2d displacement;  ///< D [m]
    Eigen::Vector2d slope;         ///< dD/dphi [m]
  };

  /// @param turns phi over 2 pi
  Point at(double turns) const;

  /// sup |d^i D / dphi^i| of each component, i = `derivative` [m]
  Eigen::Vector2d bound(int derivative) const;

private:
  struct Term
  {
    int multiple;                ///< k
    Eigen::Vector2d amplitudes;  ///< (A_x,k, A_k) [m]
    Eigen::Vector2d turns;       ///< (phi_x,k, phi_k) over 2 pi
  };

  std::vector<Term> terms_;
};

}  // namespace ratchet_sieve
