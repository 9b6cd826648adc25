#include "plausibility.h"

#include <cmath>
#include <sstream>

#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/warning_id.h"

namespace ratchet_sieve
{

std::string figureText(const Figure& figure)
{
  std::ostringstream out;
  const bool whole = std::abs(figure.value) >= 1e4 && std::abs(figure.value) < 1e9;
  out.precision(whole ? 0 : 4);
  if (whole)
    out << std::fixed;
  out << figure.value;
  if (*figure.unit != '\0')
    out << ' ' << figure.unit;
  return out.str();
}

std::string Plausibility::suggestion(const Subject& subject, std::initializer_list<double> factors) const
{
  if (!count_)
    return "";
  const std::size_t now = count_();
  for (const double factor : factors)
  {
    std::vector<double> given;
    for (double* part : subject.parts)
    {
      given.push_back(*part);
      *part *= factor;
    }
    const std::size_t then = count_();
    for (std::size_t k = 0; k < given.size(); ++k)
      *subject.parts[k] = given[k];
    if (then < now)
      return "; did you mean " + figureText({factor * *subject.value, subject.unit}) + "?";
  }
  return "";
}

void Plausibility::rule(const char* id, const Subject& subject, double ratio, double bound, const char* text,
                        std::initializer_list<Figure> figures, std::initializer_list<double> factors)
{
  if (!(ratio > bound))
    return;
  std::string line = subject.key;
  if (subject.value)
    line += " = " + scalarText(*subject.value) + (*subject.unit == '\0' ? "" : " ") + subject.unit;
  if (!line.empty())
    line += ": ";
  const Figure* next = figures.begin();
  for (const char* c = text; *c != '\0'; ++c)
    if (*c == '#')
      line += figureText(*next++);
    else
      line += *c;
  lines_.push_back(withId(line + suggestion(subject, factors), id));
}

}  // namespace ratchet_sieve
