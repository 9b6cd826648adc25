#include "ratchet_sieve/core/sizes.h"

#include <algorithm>
#include <cmath>

#include "ratchet_sieve/core/luding_law.h"

namespace ratchet_sieve
{
namespace
{
/// Normal and lognormal distributions are cut at this many standard deviations.
constexpr double CUT = 3.0;

constexpr int CLASSES = 4;
constexpr std::size_t MOST_CLASSES_OF_A_TABLE = 8;

/// Number of intervals for a mean over one piece.
constexpr int INTERVALS = 256;

constexpr double PER_E = 0.36787944117144232;  ///< 1 / e

/// x^exponent for any x > 0; see power().
double powerOf(double x, double exponent)
{
  return x <= 1.0 ? power(x, exponent) : 1.0 / power(1.0 / x, exponent);
}

/// e^x for |x| <= 10.
double exponential(double x)
{
  return x <= 0.0 ? power(PER_E, -x) : 1.0 / power(PER_E, x);
}

/// The mean of (from / r)^exponent over radii r in [from, to].
double meanPower(double from, double to, double exponent)
{
  if (to == from)
    return 1.0;
  // Near an exponent of 1 the quotient below tends to a logarithm; this difference changes it by less than
  // 1e-5.
  constexpr double LEAST = 1e-6;
  const double q = std::abs(exponent - 1.0) < LEAST ? LEAST : exponent - 1.0;
  const double ratio = q > 0.0 ? power(from / to, q) : 1.0 / power(from / to, -q);
  return from * (1.0 - ratio) / (q * (to - from));
}
}  // namespace

double SpeciesDefinition::massOf(double disk_radius) const
{
  return disk_radius == radius ? mass : mass * powerOf(disk_radius / radius, size.mass_exponent);
}

Sizes::Sizes(const SpeciesDefinition& species) : radius_(species.radius), size_(species.size)
{
  switch (size_.distribution)
  {
    case SizeDistribution::UNIFORM:
      pieces_.push_back({radius_ * (1.0 - size_.spread), radius_ * (1.0 + size_.spread), 1.0});
      break;
    case SizeDistribution::NORMAL:
    case SizeDistribution::LOGNORMAL:
      pieces_.push_back({-CUT, CUT, 1.0});
      break;
    case SizeDistribution::TABLE:
      for (std::size_t k = 0; k < size_.radii.size(); ++k)
        addInterval(size_.radii[k > 0 ? k - 1 : 0], size_.radii[k], size_.weights[k]);
  }
  smallest_ = size_.vary() ? radius(pieces_.front().from) : radius_;
  largest_ = size_.vary() ? radius(pieces_.back().to) : radius_;
}

/// Over a wide interval by mass, nearly all disks are small: it is cut, or hardly a draw would be accepted
/// and means would miss the small ones.
void Sizes::addInterval(double from, double to, double weight)
{
  double start = from;
  do
  {
    const double end = size_.by == SizeShare::MASS ? std::min(2.0 * start, to) : to;
    const double share = to > from ? (end - start) / (to - from) : 1.0;
    pieces_.push_back({start, end, weight * share});
    pieces_.back().share = shareByNumber(pieces_.back());
    start = end;
  } while (start < to);
}

double Sizes::radius(double x) const
{
  switch (size_.distribution)
  {
    case SizeDistribution::NORMAL:
      return radius_ * (1.0 + size_.spread * x);
    case SizeDistribution::LOGNORMAL:
      return radius_ * exponential(size_.spread * x);
    default:
      return x;
  }
}

/// Over x, relative to the largest of the piece.
double Sizes::density(const Piece& piece, double x) const
{
  if (size_.distribution == SizeDistribution::TABLE)
    return size_.by == SizeShare::MASS ? power(piece.from / x, size_.mass_exponent) : 1.0;
  return size_.distribution == SizeDistribution::UNIFORM ? 1.0 : power(PER_E, 0.5 * x * x);
}

/// Of a piece of a table whose cumulative share grows in proportion to the radius.
double Sizes::shareByNumber(const Piece& piece) const
{
  if (size_.by == SizeShare::NUMBER)
    return piece.share;
  const double p = size_.mass_exponent;
  return piece.share * power(size_.radii.front() / piece.from, p) * meanPower(piece.from, piece.to, p);
}

double Sizes::draw(const std::function<double()>& uniform) const
{
  if (!size_.vary())
    return radius_;
  double rest = 0.0;
  for (const Piece& piece : pieces_)
    rest += piece.share;
  std::size_t at = 0;
  if (pieces_.size() > 1)
    for (rest *= uniform(); at + 1 < pieces_.size() && rest >= pieces_[at].share; ++at)
      rest -= pieces_[at].share;
  const Piece& piece = pieces_[at];
  // By rejection: accepted with the probability of the density.
  while (true)
  {
    const double x = piece.from + uniform() * (piece.to - piece.from);
    if (const double likely = density(piece, x); likely == 1.0 || uniform() < likely)
      return std::clamp(radius(x), smallest_, largest_);
  }
}

double Sizes::mean(const std::function<double(double)>& of_radius) const
{
  if (!size_.vary())
    return of_radius(radius_);
  double sum = 0.0;
  double shares = 0.0;
  for (const Piece& piece : pieces_)
  {
    double values = 0.0;
    double weights = 0.0;
    for (int k = 0; k < INTERVALS; ++k)
    {
      const double x = piece.from + (k + 0.5) / INTERVALS * (piece.to - piece.from);
      const double weight = density(piece, x);
      values += weight * of_radius(radius(x));
      weights += weight;
    }
    sum += piece.share * values / weights;
    shares += piece.share;
  }
  return sum / shares;
}

double meanMass(const SpeciesDefinition& species)
{
  return Sizes(species).mean([&species](double radius) { return species.massOf(radius); });
}

std::vector<double> Sizes::classEdges() const
{
  std::vector<double> edges;
  if (size_.distribution == SizeDistribution::TABLE)
  {
    const std::size_t stride = (size_.radii.size() + MOST_CLASSES_OF_A_TABLE - 2) / MOST_CLASSES_OF_A_TABLE;
    for (std::size_t k = 0; k + 1 < size_.radii.size(); k += stride)
      edges.push_back(size_.radii[k]);
  }
  else
    for (int k = 0; k < CLASSES; ++k)
      edges.push_back(radius(pieces_[0].from + (pieces_[0].to - pieces_[0].from) * k / CLASSES));
  edges.push_back(largest_);
  if (edges.size() == 1)
    edges.push_back(largest_);
  return edges;
}

std::vector<SizeClass> sizeClasses(const SceneDefinition& scene)
{
  std::vector<SizeClass> classes;
  for (std::size_t s = 0; s < scene.species.size(); ++s)
  {
    if (!scene.species[s].size.vary())
      continue;
    const std::vector<double> edges = Sizes(scene.species[s]).classEdges();
    for (std::size_t k = 0; k + 1 < edges.size(); ++k)
      classes.push_back({s, edges[k], edges[k + 1]});
  }
  return classes;
}

}  // namespace ratchet_sieve
