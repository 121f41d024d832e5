#include "tests/architecture/house_rules.h"

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "tests/architecture/house_plan.h"

namespace cutis::test {
namespace {

bool isCore(const std::string& folder) {
  return folder.starts_with("core/");
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

// Keeps the line breaks of comments.
std::string withoutBlockComments(const std::string& text) {
  std::string kept;
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view pair = std::string_view(text).substr(i, 2);
    if (!inside && pair == "/*") inside = true;
    if (!inside || text[i] == '\n') kept += text[i];
    if (inside && pair == "*/") {
      inside = false;
      ++i;
    }
  }
  return kept;
}

bool isQt(const std::string& header) {
  return header.starts_with("Q") || (header.starts_with("q") && header.ends_with(".h"));
}

// What a folder must not have of a third-party library; empty if it may.
std::string libraryObjection(const std::string& folder, const std::string& header,
                             const QtModuleOf& qtModuleOf) {
  if (header.starts_with("OpenImageIO") && folder != "src/images") {
    return "only src/images includes OpenImageIO";
  }
  if (header == "jpeglib.h" && folder != "src/images") return "only src/images includes libjpeg";
  if (header.starts_with("OpenColorIO") && folder != "src/color") {
    return "only src/color includes OpenColorIO";
  }
  if (header.starts_with("lcms2") && folder != "src/color") {
    return "only src/color includes LittleCMS";
  }
  if (!isQt(header)) return {};
  if (isCore(folder)) return "core includes no Qt";
  const std::string module = qtModuleOf(header);
  if (folder == "src/app" && module != "QtCore") return "src/app includes QtCore only";
  if (folder == "src/cli") return "src/cli includes no Qt";
  if (module == "QtWidgets" && folder != "ui" && folder != "src/cutis") {
    return "only ui includes Qt Widgets";
  }
  return {};
}

std::string linkObjection(const std::string& folder, const std::string& library) {
  const auto is = [&](const char* part) { return library.find(part) != std::string::npos; };
  if (is("OpenImageIO") && folder != "src/images") return "only src/images links OpenImageIO";
  if (is("libjpeg") && folder != "src/images") return "only src/images links libjpeg";
  if (is("OpenColorIO") && folder != "src/color") return "only src/color links OpenColorIO";
  if (is("lcms2") && folder != "src/color") return "only src/color links LittleCMS";
  if (!library.starts_with("Qt6::")) return {};
  if (isCore(folder)) return "core links no Qt";
  if (folder == "src/app" && library != "Qt6::Core") return "src/app links QtCore only";
  // Every start of the program would pay for it.
  if (folder == "src/cli") return "src/cli links no Qt";
  if (library == "Qt6::Widgets" && folder != "ui" && folder != "src/cutis") {
    return "only ui links Qt Widgets";
  }
  return {};
}

std::string place(const std::string& path, int line) {
  return path + ":" + std::to_string(line);
}

// Follows our own headers; the way to an Eigen header, or nothing.
std::string wayToEigen(const SourceTree& tree, const std::string& path,
                       std::set<std::string>& visited) {
  if (!visited.insert(path).second) return {};
  const auto found = tree.find(path);
  if (found == tree.end()) return {};
  for (const Include& include : includesOf(found->second)) {
    if (include.name.starts_with("Eigen/")) return path + " → <" + include.name + ">";
    const std::string way = wayToEigen(tree, include.name, visited);
    if (!way.empty()) return path + " → " + way;
  }
  return {};
}

}  // namespace

std::vector<Include> includesOf(const std::string& text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  int number = 0;
  for (const std::string& line : linesOf(withoutBlockComments(text))) {
    ++number;
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) continue;
    includes.push_back({number, match[2].str(), match[1].str() == "<"});
  }
  return includes;
}

std::vector<std::string> checkIncludes(const SourceTree& tree, const QtModuleOf& qtModuleOf) {
  std::vector<std::string> violations;
  for (const auto& [path, text] : tree) {
    const std::string room = roomOf(path);
    if (room == "tests" || room == "resources") continue;
    if (!isRoom(room)) {
      violations.push_back(path + ": " + room + " is not a room of tests/architecture/house_plan");
      continue;
    }
    for (const Include& include : includesOf(text)) {
      const std::string where = place(path, include.line) + ": ";
      const std::string objection = libraryObjection(libraryOf(path), include.name, qtModuleOf);
      if (!objection.empty()) {
        violations.push_back(where + objection + " (" + include.name + ")");
        continue;
      }
      if (include.angled || include.name.ends_with(".moc")) continue;
      const std::string used = roomOf(include.name);
      if (used.empty()) {
        violations.push_back(where + "\"" + include.name + "\" is not a path from the root");
      } else if (!mayInclude(room, used)) {
        violations.push_back(where + room + " may not include " + used);
      }
    }
  }
  return violations;
}

std::vector<std::string> checkVectorised(const SourceTree& tree) {
  std::vector<std::string> violations;
  for (const auto& [path, text] : tree) {
    const std::vector<Include> includes = includesOf(text);
    const bool vectorised = path.ends_with("-inl.h") ||
                            std::any_of(includes.begin(), includes.end(), [](const auto& i) {
                              return i.name == "hwy/foreach_target.h";
                            });
    if (!vectorised) continue;
    std::set<std::string> visited;
    const std::string way = wayToEigen(tree, path, visited);
    if (!way.empty()) violations.push_back(way + ": vectorised code may not see Eigen");
  }
  return violations;
}

std::vector<std::string> checkLinks(const std::string& report) {
  std::vector<std::string> violations;
  for (const std::string& line : linesOf(report)) {
    const auto colon = line.find(": ");
    if (colon == std::string::npos) {
      violations.push_back("not a line of a link report: " + line);
      continue;
    }
    const std::string folder = line.substr(0, colon);
    std::istringstream names(line.substr(colon + 1));
    bool external = false;
    for (std::string name; names >> name;) {
      if (name == "|") {
        external = true;
      } else if (external) {
        const std::string objection = linkObjection(folder, name);
        if (!objection.empty()) violations.push_back(folder + ": " + objection);
      } else if (!mayLink(folder, name)) {
        violations.push_back(folder + " may not link " + name);
      }
    }
  }
  return violations;
}

std::vector<std::string> checkStyle(const std::string& path, const std::string& text) {
  // In two halves, so that this file passes its own check.
  static const std::regex unfinished(
      "\\b(TO"
      "DO|FIX"
      "ME|X"
      "XX|HA"
      "CK)\\b");
  std::vector<std::string> violations;
  int number = 0;
  for (const std::string& line : linesOf(text)) {
    ++number;
    if (line.find('\t') != std::string::npos) violations.push_back(place(path, number) + ": a tab");
    std::smatch match;
    if (std::regex_search(line, match, unfinished)) {
      violations.push_back(place(path, number) + ": unfinished work, " + match[0].str());
    }
  }
  if (number > kMaximumLines) {
    violations.push_back(path + " has " + std::to_string(number) + " lines; a file beyond " +
                         std::to_string(kMaximumLines) + " is two concepts");
  }
  return violations;
}

}  // namespace cutis::test
