#pragma once

#include <cstddef>
#include <string>

#include <CLI/CLI.hpp>

#include "wrapped_text.h"

namespace ratchet_sieve
{

/// Help within TEXT_WIDTH: an option's name and argument on the left, its description, ended by the default,
/// on the right.
class HelpFormat : public CLI::Formatter
{
public:
  HelpFormat() { column_width(NAMES_WIDTH); }

  std::string make_option(const CLI::Option* option, bool is_positional) const override
  {
    // Behind a colon CLI11 describes the check of the value.
    const std::string type = option->get_type_name().substr(0, option->get_type_name().find(':'));
    std::string names = "  " + make_option_name(option, is_positional);
    if (option->get_type_size() != 0 && !is_positional)
      names += " " + type;
    std::string text = option->get_description();
    if (!option->get_default_str().empty())
      text += " (default: " + option->get_default_str() + ")";
    std::string lines = wrappedText(text, NAMES_WIDTH);
    if (names.size() + 2 > NAMES_WIDTH)
      return names + "\n" + lines;
    return lines.replace(0, names.size(), names);
  }

  std::string make_description(const CLI::App* app) const override
  {
    return wrappedText(app->get_description(), 0);
  }

  std::string make_footer(const CLI::App* app) const override { return wrappedText(app->get_footer(), 0); }

private:
  static constexpr std::size_t NAMES_WIDTH = 26;
};

}  // namespace ratchet_sieve
