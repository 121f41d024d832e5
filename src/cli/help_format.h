#pragma once  // internal to src/cli

// Help in lines that fit a terminal.

#include <string>

#include <CLI/Formatter.hpp>

namespace cutis {

class HelpFormat : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

// Breaks at blanks so that no line is longer than `width` bytes, as far as words allow; keeps the
// breaks there are.
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace cutis
