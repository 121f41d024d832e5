#include "src/cli/help_format.h"

#include <sstream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>

namespace cutis {
namespace {

constexpr std::size_t kLineWidth = 96;
// Options stand left of their texts.
constexpr std::size_t kNameWidth = 30;

std::string wrappedLine(const std::string& line, std::size_t width) {
  std::istringstream words(line);
  std::string result;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    const bool fits = column + 1 + word.size() <= width;
    if (column > 0) result += fits ? ' ' : '\n';
    column = column > 0 && fits ? column + 1 + word.size() : word.size();
    result += word;
  }
  return result;
}

}  // namespace

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  return wrapped(CLI::Formatter::make_option_desc(option), kLineWidth - kNameWidth);
}

std::string HelpFormat::make_description(const CLI::App* app) const {
  return wrapped(CLI::Formatter::make_description(app), kLineWidth) + "\n";
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  std::stringstream out;
  CLI::detail::format_help(out, command->get_name(),
                           wrapped(command->get_description(), kLineWidth - kNameWidth),
                           kNameWidth);
  return out.str();
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (!result.empty()) result += '\n';
    result += wrappedLine(line, width);
  }
  return result;
}

}  // namespace cutis
