#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// The radii of a species' disks: their distribution by number. Own arithmetic of roots, products and
/// quotients, so that the radii are the same on every machine.
class Sizes
{
public:
  explicit Sizes(const SpeciesDefinition& species);

  double smallest() const { return smallest_; }  ///< [m]
  double largest() const { return largest_; }    ///< [m]
  /// Expected [m].
  double meanRadius() const
  {
    return mean([](double r) { return r; });
  }
  /// Of the square of the radius, expected [m^2].
  double meanSquare() const
  {
    return mean([](double r) { return r * r; });
  }

  /// Of a function of the radius, expected.
  double mean(const std::function<double(double)>& of_radius) const;

  /// The bounds of a few classes of radii for counts and means, increasing: four equal steps of the radius,
  /// or of its logarithm if lognormal; those of a table, every few of them if there are many [m].
  std::vector<double> classEdges() const;

  /// The radius of one more disk [m].
  /// @param uniform gives random numbers in [0, 1); not called if all disks are equal
  double draw(const std::function<double()>& uniform) const;

private:
  /// A part of the distribution: an interval of the coordinate x of radius(). A single radius if both ends
  /// are equal.
  struct Piece
  {
    double from;
    double to;
    double share;  ///< of the disks, times a common factor
  };

  /// One of a table. @param weight of the disks in it
  void addInterval(double from, double to, double weight);

  double radius(double x) const;
  double density(const Piece& piece, double x) const;
  double shareByNumber(const Piece& piece) const;

  double radius_;
  SizeDefinition size_;
  std::vector<Piece> pieces_;
  double smallest_;
  double largest_;
};

/// Of a disk of the species, expected [kg].
double meanMass(const SpeciesDefinition& species);

/// Disks of one species with radii from `smallest` on up to `largest`, which belongs to the next class, if
/// there is one.
struct SizeClass
{
  std::size_t species = 0;
  double smallest = 0.0;  ///< [m]
  double largest = 0.0;   ///< [m]
};

/// The classes of every species that has sizes, by species and size.
std::vector<SizeClass> sizeClasses(const SceneDefinition& scene);

}  // namespace ratchet_sieve
