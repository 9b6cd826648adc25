#include <algorithm>
#include <cstddef>
#include <sstream>

#include "depth_limiter.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

namespace ratchet_sieve
{
namespace
{

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
    requireShallow(text);
    return YAML::Load(text);
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

/// Refuses a key of the sawtooth where a profile gives the tooth; a profile replaces the sawtooth's keys.
void chooseTooth(YAML::Node& root, const std::vector<std::string>& path, const std::string& assignment)
{
  if (path.size() != 2 || path[0] != "base" || !root["base"].IsMap())
    return;
  YAML::Node base = root["base"];
  if (!base["profile"].IsDefined())
    return;
  if (sawtoothKeys().count(path[1]) > 0)
    refuse(assignment,
           "base.profile gives the tooth; for a sawtooth take it out first, with base.profile=null");
  if (path[1] == "profile")
    for (const std::string& key : sawtoothKeys())
      base.remove(key);
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
  chooseTooth(root, path, assignment);
}

}  // namespace

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
