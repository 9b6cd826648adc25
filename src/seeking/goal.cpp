#include "ratchet_sieve/seeking/goal.h"

#include <cmath>
#include <cstdint>

namespace ratchet_sieve
{
namespace
{
struct Form
{
  const char* name;
  Measure measure;
  bool of_species;
};

constexpr Form FORMS[] = {{"quality", Measure::QUALITY, false},
                          {"purity", Measure::PURITY, true},
                          {"recovery", Measure::RECOVERY, true},
                          {"flow", Measure::FLOW, true},
                          {"throughput", Measure::THROUGHPUT, false}};

constexpr const char* MASS = ":mass";
constexpr const char* BINS[] = {":left", ":right"};

bool cutEnd(std::string& text, const std::string& end)
{
  if (text.size() < end.size() || text.compare(text.size() - end.size(), end.size(), end) != 0)
    return false;
  text.resize(text.size() - end.size());
  return true;
}

/// Disks, counted by one or by their mass.
struct Amount
{
  double disks = 0.0;
  double sum = 0.0;
  double variance = 0.0;  ///< of the sum, if the number of disks of each species is a Poisson number

  void add(std::uint64_t count, double mass, const Goal& goal)
  {
    if (count == 0)
      return;
    const auto number = static_cast<double>(count);
    const double more = goal.by_mass ? mass : number;
    disks += number;
    sum += more;
    variance += more * more / number;
  }

  /// With one more average disk (Laplace's rule): ten of ten do not prove that all are.
  /// @param other has the average where this has no disk
  Amount withOneMore(const Amount& other) const
  {
    const double each = disks > 0.0 ? sum / disks : other.sum / other.disks;
    return {disks + 1.0, sum + each, variance + each * each};
  }
};

Measured shareOf(const Amount& part, const Amount& rest)
{
  if (part.disks + rest.disks == 0.0)
    return {};
  const Amount more = part.withOneMore(rest);
  const Amount more_rest = rest.withOneMore(part);
  const double whole = more.sum + more_rest.sum;
  const double share = more.sum / whole;
  const double error =
      std::sqrt((1.0 - share) * (1.0 - share) * more.variance + share * share * more_rest.variance) / whole;
  return {part.sum / (part.sum + rest.sum), error, true};
}

Measured flowOf(const Amount& part, const Amount& all, double duration)
{
  if (duration <= 0.0 || all.disks == 0.0)
    return {};
  return {part.sum / duration, std::sqrt(part.withOneMore(all).variance) / duration, true};
}

/// Variance of the fraction of a species that leaves on the right, by Laplace's rule.
double shareVariance(const SpeciesBins& bins)
{
  const auto counted = static_cast<double>(bins.counted());
  const double share = (static_cast<double>(bins.right) + 1.0) / (counted + 2.0);
  return share * (1.0 - share) / counted;
}

Measured quality(const std::vector<SpeciesBins>& bins)
{
  const PairSeparation best = bestSeparation(bins);
  if (!best.separation)
    return {};
  return {*best.quality(), std::sqrt(shareVariance(bins[best.first]) + shareVariance(bins[best.second])),
          true};
}

/// What left, by whether it is of the goal's species and in its bin.
struct Parts
{
  Amount wanted;        ///< of the species, in the bin
  Amount contaminants;  ///< of other species, in the bin
  Amount lost;          ///< of the species, in the other bin
  Amount all;
};

Parts partsOf(const Goal& goal, const Outflow& outflow)
{
  Parts parts;
  for (std::size_t k = 0; k < outflow.bins.size(); ++k)
  {
    const bool own = outflow.species[k] == goal.species;
    const SpeciesBins& bins = outflow.bins[k];
    for (const bool right : {false, true})
    {
      const std::uint64_t count = right ? bins.right : bins.left;
      const double mass = right ? bins.right_mass : bins.left_mass;
      parts.all.add(count, mass, goal);
      if (right == goal.right)
        (own ? parts.wanted : parts.contaminants).add(count, mass, goal);
      else if (own)
        parts.lost.add(count, mass, goal);
    }
  }
  return parts;
}
}  // namespace

std::optional<Goal> goalFromText(const std::string& text)
{
  std::string rest = text;
  Goal goal;
  goal.by_mass = cutEnd(rest, MASS);
  for (const Form& form : FORMS)
  {
    goal.measure = form.measure;
    const std::string begin = std::string(form.name) + ':';
    if (!form.of_species && rest == form.name && !(goal.by_mass && form.measure == Measure::QUALITY))
      return goal;
    if (!form.of_species || rest.rfind(begin, 0) != 0)
      continue;
    goal.right = cutEnd(rest, BINS[1]);
    if ((!goal.right && !cutEnd(rest, BINS[0])) || rest.size() <= begin.size())
      return std::nullopt;
    goal.species = rest.substr(begin.size());
    return goal;
  }
  return std::nullopt;
}

std::string goalText(const Goal& goal)
{
  std::string text;
  for (const Form& form : FORMS)
    if (form.measure == goal.measure)
      text = form.of_species ? std::string(form.name) + ':' + goal.species + BINS[goal.right ? 1 : 0]
                             : form.name;
  return text + (goal.by_mass ? MASS : "");
}

Measured measured(const Goal& goal, const Outflow& outflow)
{
  if (goal.measure == Measure::QUALITY)
    return quality(outflow.bins);
  const Parts parts = partsOf(goal, outflow);
  switch (goal.measure)
  {
    case Measure::PURITY:
      return shareOf(parts.wanted, parts.contaminants);
    case Measure::RECOVERY:
      return shareOf(parts.wanted, parts.lost);
    case Measure::FLOW:
      return flowOf(parts.wanted, parts.all, outflow.duration);
    default:
      return flowOf(parts.all, parts.all, outflow.duration);
  }
}

}  // namespace ratchet_sieve
