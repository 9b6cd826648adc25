#include "ratchet_sieve/scene/scene_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <yaml-cpp/eventhandler.h>

#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

/// A scene that places a hundred thousand disks one by one has about ten megabytes. yaml-cpp needs up to 250
/// times as much memory for its tokens and nodes.
constexpr std::size_t LARGEST_TEXT = 16u << 20;  ///< [bytes]

/// Deepest nesting of lists and maps; no scene needs as much.
constexpr int DEEPEST_NESTING = 16;

class DepthLimiter : public YAML::EventHandler
{
public:
  void OnDocumentStart(const YAML::Mark& mark) override
  {
    if (++documents_ > 1)
      throw YAML::ParserException(mark, "a second document; a scene must be a single one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override
  {
    throw YAML::ParserException(mark, "an alias (*NAME): not allowed; write out its value");
  }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override
  {
    descend(mark);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override
  {
    descend(mark);
  }
  void OnMapEnd() override { --depth_; }

private:
  void descend(const YAML::Mark& mark)
  {
    if (++depth_ > DEEPEST_NESTING)
      throw YAML::ParserException(mark, "lists and maps nest deeper than " + std::to_string(DEEPEST_NESTING));
  }

  int depth_ = 0;
  int documents_ = 0;
};

/// Checks the text before its tree is built: a short text can nest so deeply that a recursive reader runs out
/// of stack. Aliases (*name) are refused: an override of one part would change the other as well, and nested
/// ones make a tree huge or endless.
/// @throws YAML::Exception if it nests deeper than DEEPEST_NESTING, has a second document or an alias, or is
/// not YAML
YAML::Node shallowYaml(const std::string& text)
{
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DepthLimiter limiter;
  while (parser.HandleNextDocument(limiter))
  {
  }
  return YAML::Load(text);
}

[[noreturn]] void refuse(const std::string& assignment, const std::string& reason)
{
  const std::size_t equals = std::min(assignment.find('='), assignment.size());
  throw SceneError("override " + shownText(assignment) + ": " + reason, assignment.substr(0, equals),
                   assignment.substr(std::min(equals + 1, assignment.size())), reason);
}

std::vector<std::string> splitPath(const std::string& path, const std::string& assignment)
{
  std::vector<std::string> parts;
  std::istringstream stream(path + '.');
  for (std::string part; std::getline(stream, part, '.');)
  {
    if (part.empty())
      refuse(assignment, "the key has an empty part");
    parts.push_back(part);
  }
  return parts;
}

YAML::Node parseValue(const std::string& text, const std::string& assignment)
{
  try
  {
    return shallowYaml(text);
  }
  catch (const YAML::Exception& error)
  {
    refuse(assignment, "the value is not YAML: " + shownText(error.msg));
  }
}

/// The child named by a part of the path; added to a map that does not have it.
/// @param name of the parent, for errors
YAML::Node childOf(YAML::Node parent, const std::string& name, const std::string& part,
                   const std::string& assignment)
{
  if (parent.IsScalar())
    refuse(assignment, shownText(name) + " is a single value and has no key " + shownText(part));
  if (!parent.IsSequence())
    return parent[part];
  // 00 would be a second name of the first element.
  const bool is_index = part.size() <= 9 && part.find_first_not_of("0123456789") == std::string::npos &&
                        (part == "0" || part.front() != '0');
  if (!is_index || std::stoul(part) >= parent.size())
    refuse(assignment, shownText(part) + " is not an index of " + shownText(name) + ", a list of length " +
                           std::to_string(parent.size()));
  return parent[std::stoul(part)];
}

/// Refuses a key of the base in whose place another one stands, as base.profile in that of the sawtooth's;
/// that other one takes it out.
void replaceOthers(YAML::Node& root, const std::vector<std::string>& path, const std::string& assignment)
{
  if (path.size() != 2 || path[0] != "base" || !root["base"].IsMap())
    return;
  YAML::Node base = root["base"];
  for (const Replacement& replacement : baseReplacements())
  {
    const std::string name = std::string("base.") + replacement.key;
    if (!base[replacement.key].IsDefined())
      continue;
    if (replacement.others.count(path[1]) > 0)
      refuse(assignment,
             fmt::format("{0} gives {1}; take it out first, with {0}=null", name, replacement.gives));
    if (path[1] == replacement.key)
      for (const std::string& other : replacement.others)
        base.remove(other);
  }
}

/// @param take_out whether a map loses the key @param assignment for errors
void setKey(YAML::Node& root, const std::string& key, const YAML::Node& value, bool take_out,
            const std::string& assignment)
{
  const std::vector<std::string> path = splitPath(key, assignment);
  YAML::Node place;
  place.reset(root);
  YAML::Node parent;
  std::string name = "scene";
  for (const std::string& part : path)
  {
    parent.reset(place);
    place.reset(childOf(parent, name, part, assignment));
    name = part;
  }
  if (take_out && parent.IsMap())
    parent.remove(name);
  else
    place = copyWithoutLines(value);  // which are not those of the tree that it becomes a part of
  replaceOthers(root, path, assignment);
}

}  // namespace

std::optional<std::string> whyUnreadable(const std::string& path)
{
  struct stat status;
  if (stat(path.c_str(), &status) != 0)
    return errno == ENOENT || errno == ENOTDIR ? "no such file" : std::strerror(errno);
  if (S_ISDIR(status.st_mode))
    return "is a directory";
  // A named pipe is not opened: that would disturb its writer.
  if (S_ISFIFO(status.st_mode) ? access(path.c_str(), R_OK) != 0 : !std::ifstream(path))
    return std::strerror(errno);
  return std::nullopt;
}

std::string readYamlText(const std::string& path)
{
  if (const auto why = whyUnreadable(path))
    throw SceneError(path + ": " + *why);
  std::ifstream file(path, std::ios::binary);
  std::string text;
  char part[4096];
  while (text.size() <= LARGEST_TEXT && (file.read(part, sizeof part), file.gcount() > 0))
    text.append(part, static_cast<std::size_t>(file.gcount()));
  return text;
}

YAML::Node copyableYaml(const std::string& text, const std::string& source)
{
  if (text.size() > LARGEST_TEXT)
    throw SceneError(source + ": too large; must have at most " + std::to_string(LARGEST_TEXT) + " bytes");
  try
  {
    return shallowYaml(text);
  }
  catch (const YAML::Exception& error)
  {
    throw SceneError(source + ":" + std::to_string(error.mark.line + 1) +
                     ": not YAML: " + shownText(error.msg));
  }
}

Scene sceneFromText(const std::string& text, const std::string& source,
                    const std::vector<std::string>& overrides)
{
  YAML::Node root = copyableYaml(text, source);
  for (const std::string& assignment : overrides)
    applyOverride(root, assignment);
  return sceneFromYaml(root, source);
}

Scene loadSceneFile(const std::string& path, const std::vector<std::string>& overrides)
{
  return sceneFromText(readYamlText(path), path, overrides);
}

YAML::Node copyWithoutLines(const YAML::Node& node)
{
  YAML::Node copy(node.Type());
  if (node.IsScalar())
  {
    copy = node.Scalar();
    copy.SetTag(node.Tag());
  }
  for (const auto& item : node)
  {
    if (node.IsMap())
      copy.force_insert(copyWithoutLines(item.first), copyWithoutLines(item.second));
    else
      copy.push_back(copyWithoutLines(item));
  }
  return copy;
}

void applyOverride(YAML::Node& root, const std::string& assignment)
{
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    refuse(assignment, "must be KEY=VALUE, such as base.inclination=0.105");
  const std::string text = assignment.substr(equals + 1);
  const YAML::Node value = parseValue(text, assignment);
  setKey(root, assignment.substr(0, equals), value, value.IsNull() && !text.empty(), assignment);
}

void applyOverride(YAML::Node& root, const std::string& key, const YAML::Node& value)
{
  setKey(root, key, value, value.IsNull(), key + '=' + (value.IsScalar() ? value.Scalar() : "..."));
}

}  // namespace ratchet_sieve
