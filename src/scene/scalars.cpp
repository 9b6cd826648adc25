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

/// The text of a scalar, unless it is in quotes: in YAML quoted text is never a number.
std::optional<std::string> plainText(const Entry& entry)
{
  if (!entry.node().IsScalar() || entry.node().Tag() == "!")
    return std::nullopt;
  return entry.node().Scalar();
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

bool allowedInName(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.';
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
  const std::optional<std::string> text = plainText(entry);
  const std::optional<double> number = text ? parsed<double>(*text) : std::nullopt;
  if (!number || !std::isfinite(*number) || !range.holds(*number))
    entry.refuseValue("must be a number " + range.text() + (number ? hint(range, *number) : ""));
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, int& value)
{
  const std::optional<std::string> text = plainText(entry);
  const std::optional<int> number = text ? parsed<int>(*text) : std::nullopt;
  if (!number || !range.holds(*number))
    entry.refuseValue("must be an integer " + range.text());
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, std::uint64_t& value)
{
  const std::optional<std::string> text = plainText(entry);
  const bool digits =
      text && std::all_of(text->begin(), text->end(), [](char c) { return c >= '0' && c <= '9'; });
  const std::optional<std::uint64_t> number = digits ? parsed<std::uint64_t>(*text) : std::nullopt;
  if (!number)
    entry.refuseValue("must be an integer from " + legalValues(range, value).values);
  value = *number;
}

void readScalar(const Entry& entry, const Range& range, bool& value)
{
  const std::optional<std::string> text = plainText(entry);
  if (!text || (*text != "true" && *text != "false"))
    entry.refuseValue("must be " + legalValues(range, value).values);
  value = *text == "true";
}

void readScalar(const Entry& entry, const Range& range, std::string& value)
{
  const bool legal = entry.node().IsScalar() && !entry.node().Scalar().empty() &&
                     entry.node().Scalar().size() <= LONGEST_NAME &&
                     std::all_of(entry.node().Scalar().begin(), entry.node().Scalar().end(), allowedInName);
  if (!legal)
    entry.refuseValue("must be a name of " + legalValues(range, value).values);
  value = entry.node().Scalar();
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
  return {"integer", "0 to " + scalarText(std::numeric_limits<std::uint64_t>::max())};
}

LegalValues legalValues(const Range&, bool)
{
  return {"boolean", "true or false"};
}

LegalValues legalValues(const Range&, const std::string&)
{
  return {"name", "1 to " + std::to_string(LONGEST_NAME) + " letters, digits, '_', '-' or '.'"};
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

std::string scalarText(int value)
{
  return std::to_string(value);
}

std::string scalarText(std::uint64_t value)
{
  return std::to_string(value);
}

std::string scalarText(bool value)
{
  return value ? "true" : "false";
}

std::string scalarText(const std::string& value)
{
  return '"' + value + '"';
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
