#include "html_page.h"

#include <sstream>
#include <stdexcept>
#include <utility>

#include <zlib.h>
#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/page/answer_page.h"
#include "ratchet_sieve/page/sweep_page.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

Json drivePart(const BaseDefinition& base)
{
  Json harmonics = Json::array();
  for (const HarmonicDefinition& harmonic : base.harmonics)
    harmonics.push_back({{"multiple", harmonic.multiple},
                         {"amplitude", harmonic.amplitude},
                         {"phase", harmonic.phase},
                         {"horizontal_amplitude", harmonic.horizontal_amplitude},
                         {"horizontal_phase", harmonic.horizontal_phase}});
  return {{"turns_with_base", base.drive_frame == DriveFrame::BASE},
          {"amplitude", base.amplitude},
          {"horizontal_amplitude", base.horizontal_amplitude},
          {"horizontal_phase", base.horizontal_phase},
          {"harmonics", std::move(harmonics)}};
}

/// A text as HTML.
std::string htmlText(const std::string& text)
{
  std::string html;
  for (const char c : text)
    html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return html;
}

}  // namespace

std::string base64(const std::string& bytes)
{
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  return std::string(Letters(bytes.begin()), Letters(bytes.end())) +
         std::string((3 - bytes.size() % 3) % 3, '=');
}

std::string deflated(const std::string& bytes)
{
  uLongf length = compressBound(bytes.size());
  std::string result(length, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &length,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("the page could not be compressed");
  result.resize(length);
  return result;
}

std::string jsonForHtml(const nlohmann::ordered_json& json)
{
  std::string text;
  for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
    text += c == '<' ? "\\u003c" : std::string(1, c);  // "<" stands only within JSON's strings
  return text;
}

std::string pageText(std::string_view page, const std::string& title, const nlohmann::ordered_json& json,
                     const std::vector<PageData>& data)
{
  const std::string_view title_mark = "{{title}}", data_mark = "{{data}}";
  const std::size_t title_at = page.find(title_mark), data_at = page.find(data_mark);
  std::ostringstream out;
  out << page.substr(0, title_at) << htmlText(shownText(title))
      << page.substr(title_at + title_mark.size(), data_at - title_at - title_mark.size());
  out << R"(<script type="application/json" id="data">)" << jsonForHtml(json) << "</script>\n";
  for (const PageData& each : data)
    out << R"(<script type="text/plain" id=")" << each.id << R"(">)" << base64(each.bytes) << "</script>\n";
  out << page.substr(data_at + data_mark.size());
  return out.str();
}

void writePage(AtomicFile&& file, std::string_view page, const std::string& title,
               const nlohmann::ordered_json& json, const std::vector<PageData>& data)
{
  file.stream() << pageText(page, title, json, data);
  file.commit();
}

std::string answerPage(const std::string& answer)
{
  const Json json = Json::parse(answer);
  return pageText(ANSWER_TEMPLATE, json.at("title").get<std::string>(), json);
}

nlohmann::ordered_json machinePart(const SceneDefinition& scene)
{
  Json tooth = Json::array();
  for (const OutlineCorner& corner : scene.base.outline())
    tooth.push_back({corner.s, corner.n});
  Json species = Json::array();
  for (const SpeciesDefinition& each : scene.species)
    species.push_back(
        {{"name", each.name}, {"radius", each.radius}, {"mass", each.mass}, {"varies", each.size.vary()}});
  return {{"tooth", std::move(tooth)},
          {"teeth", scene.base.teeth},
          {"boundary", scalarText(scene.boundary)},
          {"wall_height", scene.boundary == Boundary::WALLED ? Json(wallHeight(scene)) : Json(nullptr)},
          {"gravity", scene.gravity},
          {"duration", scene.duration},
          {"fed", scene.feed.any()},
          {"drive", drivePart(scene.base)},
          {"species", std::move(species)}};
}

void writeSweepPage(const std::string& path, const nlohmann::ordered_json& report)
{
  writePage(path, SWEEP_TEMPLATE, report.at("title").get<std::string>(), report);
}

}  // namespace ratchet_sieve
