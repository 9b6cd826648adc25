#include "ratchet_sieve/sweep/sweep.h"

#include <cstdio>

#include "ratchet_sieve/core/fnv1a.h"
#include "ratchet_sieve/recording/version.h"

namespace ratchet_sieve
{

std::uint64_t Sweep::points() const
{
  std::uint64_t product = 1;
  for (const Axis& axis : axes)
    product *= axis.size;
  return product;
}

std::vector<std::string> Sweep::keys() const
{
  std::vector<std::string> all;
  for (const Axis& axis : axes)
    all.insert(all.end(), axis.keys.begin(), axis.keys.end());
  return all;
}

std::vector<Assignment> Sweep::point(std::uint64_t point) const
{
  std::vector<std::uint64_t> steps(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;)
  {
    steps[i] = point % axes[i].size;
    point /= axes[i].size;
  }
  std::vector<Assignment> all;
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (Assignment& assignment : axes[i].at(steps[i]))
      all.push_back(std::move(assignment));
  return all;
}

std::string Sweep::fingerprint() const
{
  std::string text = std::string(version()) + '\n' + scene_text + '\n';
  for (const Assignment& assignment : fixed)
    text += assignment.key + '=' + assignment.value + '\n';
  for (const Axis& axis : axes)
    text += axis.text + '\n';
  text += "seeds " + std::to_string(seeds.first) + ' ' + std::to_string(seeds.count);
  for (const std::uint64_t seed : seeds.listed)
    text += ' ' + std::to_string(seed);
  if (part.count > 1)
    text += "\npart " + std::to_string(part.number) + ' ' + std::to_string(part.count);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(fnv1a(text)));
  return digits;
}

}  // namespace ratchet_sieve
