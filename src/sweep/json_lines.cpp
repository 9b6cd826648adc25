#include "json_lines.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "ratchet_sieve/core/physics_version.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

using Json = nlohmann::ordered_json;

std::string firstLine(const char* kind, std::size_t lines)
{
  return Json({{"ratchet_sieve", kind},
               {"version", version()},
               {"physics", PHYSICS_VERSION},
               {"lines", lines}})
      .dump();
}

bool isControl(unsigned char c)
{
  return c < ' ';
}

/// Rejects, during parsing, input that would overflow the stack or take minutes to parse.
class BoundedParse
{
public:
  bool operator()(int depth, Json::parse_event_t event, const Json& value)
  {
    if (depth >= DEEPEST_JSON)
      throw CaseFileError("is nested too deeply");
    if (event == Json::parse_event_t::object_start)
      keys_[static_cast<std::size_t>(depth) + 1] = 0;
    if (event == Json::parse_event_t::key)
      takeKey(static_cast<std::size_t>(depth), value.get_ref<const std::string&>());
    return true;
  }

private:
  void takeKey(std::size_t depth, const std::string& key)
  {
    if (++keys_[depth] > MOST_KEYS)
      throw CaseFileError("has a map with too many keys");
    if (key.size() > LONGEST_KEY || std::any_of(key.begin(), key.end(), isControl))
      throw CaseFileError("has an invalid key: " + shownText(key));
  }

  std::array<std::size_t, DEEPEST_JSON + 1> keys_{};  ///< of the open map at each depth
};

/// @return the first line @throws CaseFileError that does not name the file
std::string readLines(std::istream& file, std::vector<Json>& lines)
{
  std::string first;
  std::getline(file, first);
  try
  {
    for (std::string line; std::getline(file, line);)
      lines.push_back(Json::parse(line, BoundedParse()));
  }
  catch (const Json::exception& error)
  {
    throw CaseFileError("is damaged: " + shownText(error.what(), 200));
  }
  return first;
}

void requireReadable(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error)))
    throw CaseFileError("cannot be read");
  if (std::filesystem::file_size(path, error) > LARGEST_FILE)
    throw CaseFileError("is larger than " + std::to_string(LARGEST_FILE) + " bytes");
}

}  // namespace

std::vector<Json> readJsonLines(const std::string& path, const char* kind)
{
  std::vector<Json> lines;
  try
  {
    requireReadable(path);
    std::ifstream file(path);
    const std::string first = readLines(file, lines);
    if (first.empty())
      throw CaseFileError("cannot be read");
    if (first != firstLine(kind, lines.size()))
      throw CaseFileError(std::string("is no complete file of ") + kind + " of version " + version() +
                          ", but begins with " + shownText(first, 100));
  }
  catch (const CaseFileError& error)
  {
    throw CaseFileError(path + ": " + error.what());
  }
  return lines;
}

void writeJsonLines(const std::string& path, const char* kind, const std::vector<Json>& lines)
{
  AtomicFile file(path);
  file.stream() << firstLine(kind, lines.size()) << '\n';
  for (const Json& line : lines)
    file.stream() << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

}  // namespace ratchet_sieve
