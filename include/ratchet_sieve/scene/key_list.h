#pragma once

#include <string>
#include <vector>

namespace ratchet_sieve
{

/// One key of a scene, described in texts. An empty text: there is nothing to say.
struct KeyText
{
  std::string key;           ///< dotted path; the index of a list is N, as in species.N.radius
  std::string type;          ///< number, integer, boolean, name, choice or list
  std::string unit;          ///< SI
  std::string values;        ///< allowed, such as "0 to 1000"
  std::string default_text;  ///< the default, or "required"
  std::string meaning;       ///< one sentence
};

/// A part of a scene, such as base.
struct KeyGroup
{
  std::string name;  ///< dotted path; empty at the root
  std::string meaning;
  std::vector<KeyText> keys;
};

/// Every key that the reader of scenes accepts, from the tables by which it reads them.
std::vector<KeyGroup> sceneKeyGroups();

}  // namespace ratchet_sieve
