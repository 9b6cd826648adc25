#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/sizes.h"
#include "scene_markers.h"

namespace ratchet_sieve
{
namespace
{
using visualization_msgs::MarkerArray;

/// In widths of the base.
constexpr double LEAST_CAPTION_HEIGHT = 0.345;  // above the left end of the base
constexpr double CAPTION_GAP = 0.23;            // above its middle, at least
constexpr double CAPTION_DEPTH = 0.1;           // of two lines, with room below
constexpr double LEGEND_DEPTH = 0.12;           // of its first line below the lower end of the base
constexpr double MOST_FLIGHT = 0.4;             // that is left free below the caption

constexpr double THROW = 3.0;          // speed of nearly all disks that the base throws up, over its own
constexpr double LETTER_WIDTH = 0.56;  // mean, over their height

constexpr double MM_PER_M = 1e3;  // and mm/s per m/s
constexpr double G_PER_KG = 1e3;

/// "theta = +0.100 rad"; during a ramp to a setpoint "theta = +0.100 -> +0.190 rad".
std::string quantityText(const char* name, const char* format, double applied, double commanded,
                         const char* unit)
{
  const std::string now = fmt::format(format, applied);
  const std::string then = fmt::format(format, commanded);
  return fmt::format("{} = {}{}{} {}", name, now, now == then ? "" : " -> ", now == then ? "" : then, unit);
}

std::string orUndefined(const std::optional<double>& value)
{
  return value ? fmt::format("{:.3f}", *value) : "undefined";
}

/// "<V_x> = +12.3 +- 0.4 mm/s", with its standard error.
std::string velocityText(const SpeciesMeans& means)
{
  if (!means.mean_vx)
    return "<V_x> = undefined";
  const std::string error =
      means.mean_vx_stderr ? fmt::format(" +- {:.1f}", MM_PER_M * *means.mean_vx_stderr) : "";
  return fmt::format("<V_x> = {:+.1f}{} mm/s", MM_PER_M * *means.mean_vx, error);
}

std::vector<Line> captionLines(const Picture& picture)
{
  const DriveState& base = picture.base.base;
  std::vector<Line> lines(1);
  lines[0].words = fmt::format(
      "t = {:.2f} s    {}    {}    {}", picture.base.time,
      quantityText("theta", "{:+.3f}", base.inclination, base.commanded_inclination, "rad"),
      quantityText("f", "{:.1f}", base.frequency, base.commanded_frequency, "Hz"),
      quantityText("A", "{:.2f}", MM_PER_M * base.amplitude, MM_PER_M * base.commanded_amplitude, "mm"));
  std::string second = picture.sieve;
  if (picture.scene.boundary == Boundary::OPEN && picture.bins)
    second += fmt::format("{}Q = {}    P = {}", second.empty() ? "" : "    ",
                          orUndefined(picture.bins->quality), orUndefined(picture.bins->processed));
  if (!second.empty())
    lines.push_back({second});
  return lines;
}

std::vector<Line> legendLines(const Picture& picture)
{
  std::vector<Line> lines;
  for (std::size_t k = 0; k < picture.scene.species.size(); ++k)
  {
    const SpeciesDefinition& species = picture.scene.species[k];
    const Sizes sizes(species);
    std::string words =
        species.name +
        (species.size.vary()
             ? fmt::format(": r = {:.3g} to {:.3g} mm", MM_PER_M * sizes.smallest(),
                           MM_PER_M * sizes.largest())
             : fmt::format(": r = {:g} mm, m = {:g} g", MM_PER_M * species.radius, G_PER_KG * species.mass));
    if (picture.bins)
      words += fmt::format(", {} on the base", picture.bins->bins[k].on_base);
    if (k < picture.means.size())
      words += ", " + velocityText(picture.means[k]);
    lines.push_back({words, speciesColor(k)});
  }
  return lines;
}

/// The height of letters, in widths of the base, at which the longest line fits between the bins.
double fittingLetter(const std::vector<Line>& lines, double inclination)
{
  std::size_t longest = 1;
  for (const Line& line : lines)
    longest = std::max(longest, line.words.size());
  return std::min(LETTER, std::cos(inclination) / (LETTER_WIDTH * static_cast<double>(longest)));
}

}  // namespace

double captionHeight(const SceneDefinition& scene, double inclination)
{
  const double speed = THROW * driveBounds(scene.base).speed;
  const double flight = std::min(MOST_FLIGHT, speed * speed / (2.0 * scene.gravity * scene.base.width()));
  return std::max(LEAST_CAPTION_HEIGHT,
                  0.5 * std::sin(inclination) + std::max(CAPTION_GAP, flight + CAPTION_DEPTH));
}

MarkerArray captionMarkers(const Picture& picture)
{
  const BaseDefinition& base = picture.scene.base;
  const double inclination = picture.base.base.inclination;
  const double letter = LETTER * base.width();
  const double x = 0.5 * base.width();
  const double middle = 0.5 * base.width() * std::sin(inclination);
  const double above = captionHeight(picture.scene, inclination) * base.width();
  const double below = std::min(0.0, middle) - LEGEND_DEPTH * base.width();
  MarkerArray markers;
  addLines(picture.base.time, {"caption", 0, x, above}, letter, captionLines(picture), markers);
  const std::vector<Line> legend = legendLines(picture);
  addLines(picture.base.time, {"legend", 0, x, below}, fittingLetter(legend, inclination) * base.width(),
           legend, markers);
  return markers;
}

}  // namespace ratchet_sieve
