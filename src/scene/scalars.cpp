#include "ratchet_sieve/scene/scalars.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ratchet_sieve/scene/parsed.h"

namespace ratchet_sieve
{
namespace
{

constexpr const char* IN_NAMES = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";

/// A smaller value is unlikely to be in degrees, percent or ms.
constexpr double LEAST_SLIP = 2.0;

constexpr double DEGREE = 3.14159265358979323846 / 180.0;  ///< [rad]

/// The text of a scalar; empty if it is in quotes, because in YAML quoted text is never a number.
std::string plainText(const Entry& entry)
{
  return entry.node().IsScalar() && entry.node().Tag() != "!" ? entry.node().Scalar() : "";
}

/// A suggestion for a number that is out of range: it may be in degrees, ms or percent. Empty if the
/// converted number is out of range, too.
std::string hint(const Range& range, double value)
{
  const std::string unit = range.unit;
  const auto suggest = [&](double factor, const char* as) -> std::string
  {
    const double other = factor * value;
    if (std::abs(value) < LEAST_SLIP || !range.holds(other))
      return "";
    return fmt::format("; did you mean {:.4g}{}{} ({:.4g} {})?", other, unit.empty() ? "" : " ", unit, value,
                       as);
  };
  if (unit == "rad")
    return suggest(DEGREE, "degrees");
  if (unit == "s")
    return suggest(1e-3, "ms");
  return unit.empty() && range.highest <= 1.0 ? suggest(0.01, "%") : "";
}

}  // namespace

std::string Range::values() const
{
  return isBounded() ? scalarText(lowest) + " to " + scalarText(highest) : "any";
}

std::string Range::text() const
{
  if (!isBounded())
    return "that is finite";
  return "from " + values() + (*unit == '\0' ? "" : std::string(" ") + unit);
}

void readScalar(const Entry& entry, const Range& range, double& value)
{
  const std::optional<double> number = parsed<double>(plainText(entry));
  if (!number || !range.holds(*number))
    entry.refuseValue("must be a number " + range.text() + (number ? hint(range, *number) : ""));
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, int& value)
{
  const std::optional<int> number = parsed<int>(plainText(entry));
  if (!number || !range.holds(*number))
    entry.refuseValue("must be an integer " + range.text());
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, std::uint64_t& value)
{
  const std::string text = plainText(entry);
  const std::optional<std::uint64_t> number = parsed<std::uint64_t>(text);
  // The standard library reads -1 as the largest number.
  if (!number || text.find_first_not_of("0123456789") != std::string::npos)
    entry.refuseValue("must be an integer from " + legalValues<std::uint64_t>(range).values);
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, bool& value)
{
  const std::string text = plainText(entry);
  if (text != "true" && text != "false")
    entry.refuseValue("must be " + legalValues<bool>(range).values);
  value = text == "true";
}

void readScalar(const Entry& entry, const Range& range, std::string& value)
{
  const std::string name = entry.node().IsScalar() ? entry.node().Scalar() : "";
  if (name.empty() || name.size() > LONGEST_NAME || name.find_first_not_of(IN_NAMES) != std::string::npos)
    entry.refuseValue("must be a name of " + legalValues<std::string>(range).values);
  value = name;
}

void readScalar(const Entry& entry, const Range& range, FilePath& value)
{
  value.text = entry.node().IsScalar() ? entry.node().Scalar() : "";
  if (value.text.empty())
    entry.refuseValue("must be the " + legalValues<FilePath>(range).values);
}

void readScalar(const Entry& entry, const Range& range, std::vector<std::string>& value)
{
  const std::vector<std::string> known = observableNames();
  value.clear();
  for (const Entry& item : entry.list())
  {
    const std::string name = item.node().IsScalar() ? item.node().Scalar() : std::string();
    if (std::find(known.begin(), known.end(), name) == known.end())
      item.refuseValue("must be one of " + legalValues<std::vector<std::string>>(range).values);
    if (std::find(value.begin(), value.end(), name) != value.end())
      item.refuseValue("is given twice");
    value.push_back(name);
  }
}

void readScalar(const Entry& entry, const Range& range, std::vector<double>& values)
{
  values.clear();
  for (const Entry& item : entry.list())
    readScalar(item, range, values.emplace_back());
}

std::string scalarText(double value)
{
  // 17 digits restore every double; fewer restore most, and are easier to read.
  for (int digits = 15; digits < 17; ++digits)
  {
    std::string text = fmt::format("{:.{}g}", value + 0.0, digits);  // there is one zero, as for parsed()
    if (parsed<double>(text) == value)
      return text;
  }
  return fmt::format("{:.17g}", value);
}

std::string scalarText(bool value)
{
  return value ? "true" : "false";
}

std::string scalarText(const std::string& value)
{
  return '"' + value + '"';
}

std::string scalarText(const FilePath& value)
{
  return value.text;
}

std::string listText(const std::vector<std::string>& words, const char* last)
{
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "" : i + 1 < words.size() ? ", " : last) + words[i];
  return list;
}

std::string scalarText(const std::vector<std::string>& words)
{
  return '[' + listText(words) + ']';
}

}  // namespace ratchet_sieve
