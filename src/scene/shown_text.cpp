#include "shown_text.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{

/// Longer texts are cut [characters].
constexpr std::size_t LONGEST_SHOWN = 60;

constexpr unsigned char DELETE = 0x7f;

}  // namespace

std::string shownText(std::string text)
{
  if (text.size() > LONGEST_SHOWN)
    text = text.substr(0, LONGEST_SHOWN) + "...";
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == DELETE; }, ' ');
  return text;
}

}  // namespace ratchet_sieve
