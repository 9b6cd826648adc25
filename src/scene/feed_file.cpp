#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string_view>
#include <vector>

#include "ratchet_sieve/scene/scene_file.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

namespace fs = std::filesystem;

constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";  ///< some programs begin a file of UTF-8 with it

/// With or without quotes and blanks around each.
std::vector<std::string> cellsOf(const std::string& line, char separator)
{
  constexpr const char* BLANKS = " \t\r";
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (const char c : line)
    if (c == '"')
      is_quoted = !is_quoted;
    else if (c == separator && !is_quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  for (std::string& cell : cells)
    cell.erase(cell.find_last_not_of(BLANKS) + 1).erase(0, cell.find_first_not_of(BLANKS));
  return cells;
}

/// Of each of the columns, its place in the header.
std::map<std::string, std::size_t> placesOf(const std::set<std::string>& columns,
                                            const std::vector<std::string>& header, const Entry& file)
{
  std::map<std::string, std::size_t> places;
  for (const std::string& column : columns)
  {
    const auto found = std::find(header.begin(), header.end(), column);
    if (found == header.end())
      file.refuse("its first line has no column " + column +
                  "; must be a CSV file as sieve_run --exits writes");
    places[column] = static_cast<std::size_t>(found - header.begin());
  }
  return places;
}

}  // namespace

std::string pathFromScene(const std::string& source, const std::string& path)
{
  std::error_code none;
  return fs::exists(source, none) ? (fs::path(source).parent_path() / path).string() : path;
}

std::string forEachRow(const Entry& feed, const std::set<std::string>& columns,
                       const std::function<void(const Entry&)>& visit)
{
  FeedFile file;
  readValues(feed, FEED_FILE_KEYS, file);
  std::string path = pathFromScene(feed.source(), file.path.text);
  std::error_code none;
  if (const auto why = whyUnreadable(path))
    feed.at("file").refuseValue(path == file.path.text ? *why : *why + ": " + path);
  if (!fs::is_regular_file(path, none))
    feed.at("file").refuseValue("must be a file on a disk");
  std::ifstream text(path, std::ios::binary);
  std::set<std::string> wanted = columns;
  if (file.side != FeedSide::BOTH)
    wanted.insert("side");
  std::string line;
  std::getline(text, line);
  if (line.compare(0, BYTE_ORDER_MARK.size(), BYTE_ORDER_MARK) == 0)
    line.erase(0, BYTE_ORDER_MARK.size());
  // As spreadsheets write it where a comma begins the decimals, which are no numbers here.
  const char separator = line.find(',') == std::string::npos ? ';' : ',';
  const std::vector<std::string> header = cellsOf(line, separator);
  const std::map<std::string, std::size_t> places =
      placesOf(wanted, header, Entry({}, path + ":1", "header"));
  for (std::size_t number = 2, rows = 0; std::getline(text, line); ++number)
  {
    if (line.empty() || line == "\r")
      continue;
    const std::string source = path + ":" + std::to_string(number);
    const std::vector<std::string> cells = cellsOf(line, separator);
    if (cells.size() != header.size())
      Entry({}, source, "row").refuse("must have " + std::to_string(header.size()) + " cells, as the header");
    YAML::Node node;
    for (const auto& [column, place] : places)
      node[column] = cells[place];
    const Entry row(node, source);
    FeedSide side = file.side;
    if (file.side != FeedSide::BOTH)
      readScalar(row.at("side"), {}, side);
    if (side != file.side)
      continue;
    if (++rows > MOST_FED)
      feed.at("file").refuse("must have at most " + std::to_string(MOST_FED) + " rows");
    visit(row);
  }
  return path;
}

}  // namespace ratchet_sieve
