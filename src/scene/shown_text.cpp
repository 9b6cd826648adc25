#include "ratchet_sieve/scene/shown_text.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{

constexpr unsigned char DELETE = 0x7f;

}  // namespace

std::string shownText(std::string text, std::size_t longest)
{
  if (text.size() > longest)
    text = text.substr(0, longest) + "...";
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == DELETE; }, ' ');
  return text;
}

}  // namespace ratchet_sieve
