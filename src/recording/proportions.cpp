#include "ratchet_sieve/recording/proportions.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{

ProportionInterval wilsonInterval(double share, double count, double z)
{
  const double centre = (share + z * z / (2.0 * count)) / (1.0 + z * z / count);
  const double half =
      z / (1.0 + z * z / count) * std::sqrt(share * (1.0 - share) / count + z * z / (4.0 * count * count));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

std::optional<double> correlationOf(const Portion& portion, double confidence)
{
  const BlockSum all = sumOf(portion.number);
  const std::optional<double> half_width = correlatedHalfWidth(portion.number, confidence);
  if (!half_width || all.sum <= 0.0 || all.sum >= all.weight)
    return std::nullopt;
  const double error = *half_width / halfWidthOver(confidence, 0);
  const double share = all.sum / all.weight;
  return std::max(1.0, error * error * all.weight / (share * (1.0 - share)));
}

PortionEstimates portionEstimates(const Portion& portion, double correlation, double part_mass,
                                  double rest_mass, double confidence)
{
  const BlockSum number = sumOf(portion.number);
  if (number.weight <= 0.0)
    return {};
  const double share = number.sum / number.weight;
  const double count = number.weight / correlationOf(portion, confidence).value_or(correlation);
  const ProportionInterval ends = wilsonInterval(share, count, halfWidthOver(confidence, 0));
  const auto farther_end = [](double value, const ProportionInterval& interval)
  { return std::max(value - interval.low, interval.high - value); };
  PortionEstimates estimates;
  estimates.number = Estimate{share, farther_end(share, ends)};

  const BlockSum mass = sumOf(portion.mass);
  const double rest = number.weight - number.sum;
  const double part_each = number.sum > 0.0 ? mass.sum / number.sum : part_mass;
  const double rest_each = rest > 0.0 ? (mass.weight - mass.sum) / rest : rest_mass;
  const auto by_mass = [&](double by_number)
  {
    const double part = by_number * part_each;
    return part / (part + (1.0 - by_number) * rest_each);
  };
  const double value = mass.sum / mass.weight;
  double half_width = farther_end(value, {by_mass(ends.low), by_mass(ends.high)});
  if (const std::optional<double> of_blocks = correlatedHalfWidth(portion.mass, confidence))
    half_width = std::max(half_width, *of_blocks);
  estimates.mass = Estimate{value, half_width};
  return estimates;
}

}  // namespace ratchet_sieve
