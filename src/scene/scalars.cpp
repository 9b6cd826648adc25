#include "ratchet_sieve/scene/scalars.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>

#include "ratchet_sieve/core/observation.h"
#include "ratchet_sieve/scene/parsed.h"

namespace ratchet_sieve
{
namespace
{

/// Longest name of a species [characters].
constexpr std::size_t LONGEST_NAME = 64;

constexpr const char* IN_NAMES = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";

/// A smaller value is unlikely to be in degrees, percent or ms.
constexpr double LEAST_SLIP = 2.0;

constexpr double DEGREE = 3.14159265358979323846 / 180.0;  ///< [rad]

std::string joined(const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words)
    list += (list.empty() ? "" : ", ") + word;
  return list;
}

/// The text of a scalar; empty if it is in quotes, because in YAML quoted text is never a number.
std::string plainText(const Entry& entry)
{
  return entry.node().IsScalar() && entry.node().Tag() != "!" ? entry.node().Scalar() : "";
}

std::string formatted(double value, int digits)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  stream << value;
  return stream.str();
}

/// A suggestion for a number that is out of range: it may be in degrees, ms or percent. Empty if the
/// converted number is out of range, too.
std::string hint(const Range& range, double value)
{
  const std::string unit = range.unit;
  const auto suggest = [&](double factor, const char* as)
  {
    const double other = factor * value;
    return std::abs(value) < LEAST_SLIP || !range.holds(other)
               ? ""
               : "; did you mean " + formatted(other, 4) + (unit.empty() ? "" : " " + unit) + " (" +
                     formatted(value, 4) + " " + as + ")?";
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
  if (!number || !std::isfinite(*number) || !range.holds(*number))
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
    entry.refuseValue("must be an integer from " + legalValues(range, value).values);
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, bool& value)
{
  const std::string text = plainText(entry);
  if (text != "true" && text != "false")
    entry.refuseValue("must be " + legalValues(range, value).values);
  value = text == "true";
}

void readScalar(const Entry& entry, const Range& range, std::string& value)
{
  const std::string name = entry.node().IsScalar() ? entry.node().Scalar() : "";
  if (name.empty() || name.size() > LONGEST_NAME || name.find_first_not_of(IN_NAMES) != std::string::npos)
    entry.refuseValue("must be a name of " + legalValues(range, value).values);
  value = name;
}

void readScalar(const Entry& entry, const Range& range, FilePath& value)
{
  value.text = entry.node().IsScalar() ? entry.node().Scalar() : "";
  if (value.text.empty())
    entry.refuseValue("must be the " + legalValues(range, value).values);
}

void readScalar(const Entry& entry, const Range& range, std::vector<std::string>& value)
{
  const std::vector<std::string> known = observableNames();
  value.clear();
  for (const Entry& item : entry.list())
  {
    const std::string name = item.node().IsScalar() ? item.node().Scalar() : std::string();
    if (std::find(known.begin(), known.end(), name) == known.end())
      item.refuseValue("must be one of " + legalValues(range, value).values);
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

LegalValues legalValues(const Range& range, double)
{
  return {"number", range.values()};
}

LegalValues legalValues(const Range& range, int)
{
  return {"integer", range.values()};
}

LegalValues legalValues(const Range&, std::uint64_t)
{
  return {"integer", "0 to " + std::to_string(std::numeric_limits<std::uint64_t>::max())};
}

LegalValues legalValues(const Range&, bool)
{
  return {"boolean", "true or false"};
}

LegalValues legalValues(const Range&, const std::string&)
{
  return {"name", "1 to " + std::to_string(LONGEST_NAME) + " letters, digits, '_', '-' or '.'"};
}

LegalValues legalValues(const Range&, const FilePath&)
{
  return {"path", "path of a file"};
}

LegalValues legalValues(const Range&, const std::vector<std::string>&)
{
  return {"list", joined(observableNames())};
}

LegalValues legalValues(const Range& range, const std::vector<double>&)
{
  return {"list", range.values()};
}

std::string scalarText(double value)
{
  // 17 digits restore every double; fewer restore most, and are easier to read.
  for (int digits = 15; digits < 17; ++digits)
  {
    std::string text = formatted(value, digits);
    if (parsed<double>(text) == value)
      return text;
  }
  return formatted(value, 17);
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

std::string scalarText(const std::vector<std::string>& value)
{
  return '[' + joined(value) + ']';
}

std::string scalarText(const std::vector<double>& values)
{
  std::string list;
  for (const double value : values)
    list += (list.empty() ? "" : ", ") + scalarText(value);
  return '[' + list + ']';
}

}  // namespace ratchet_sieve
