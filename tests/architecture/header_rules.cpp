#include "tests/architecture/header_rules.h"

#include <map>
#include <set>
#include <sstream>

#include "tests/architecture/house_plan.h"

namespace cutis::test {
namespace {

constexpr char kPragma[] = "#pragma once";
constexpr char kMark[] = "  // internal to ";

bool isHeader(const std::string& path) {
  return path.ends_with(".h");
}

bool isVectorised(const std::string& path) {
  return path.ends_with("-inl.h");
}

bool isComment(const std::string& line) {
  return line.starts_with("//");
}

bool endsSentence(const std::string& line) {
  return line.find(". ") != std::string::npos || line.ends_with(".") || line.ends_with(":");
}

// The sentence may stand at the one declaration of a header, behind what it includes.
bool isBeforeCode(const std::string& line) {
  const bool named = line.starts_with("class ") && line.ends_with(";");
  return line.empty() || line.starts_with("#") || line.starts_with("namespace ") || named;
}

// The first paragraph of the first comment before any code.
std::vector<std::string> openingOf(const std::string& text) {
  std::vector<std::string> opening;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (line == "//" && !opening.empty()) break;
    if (isComment(line)) {
      opening.push_back(line);
    } else if (!opening.empty() || !isBeforeCode(line)) {
      break;
    }
  }
  return opening;
}

// The rooms whose files include a header, by its path; tests do not count.
std::map<std::string, std::set<std::string>> includingRooms(const SourceTree& tree) {
  std::map<std::string, std::set<std::string>> rooms;
  for (const auto& [path, text] : tree) {
    for (const Include& include : includesOf(text))
      rooms[include.name].insert(roomOf(path));
  }
  return rooms;
}

}  // namespace

std::vector<std::string> checkOpening(const std::string& path, const std::string& text) {
  const std::vector<std::string> opening = openingOf(text);
  if (opening.empty()) return {path + " does not open with a sentence on what it is"};
  for (const std::string& line : opening) {
    if (endsSentence(line)) return {};
  }
  return {path + ": the opening comment is not a sentence"};
}

std::string markedRoom(const std::string& text) {
  const std::string start = std::string(kPragma) + kMark;
  if (!text.starts_with(start)) return {};
  return text.substr(start.size(), text.find('\n') - start.size());
}

std::vector<std::string> checkInternal(const SourceTree& tree) {
  std::vector<std::string> violations;
  const auto includedBy = includingRooms(tree);
  for (const auto& [path, text] : tree) {
    if (!isHeader(path) || isVectorised(path)) continue;
    const std::string room = roomOf(path), marked = markedRoom(text);
    bool outside = false;
    const auto found = includedBy.find(path);
    if (found != includedBy.end()) {
      for (const std::string& other : found->second) {
        if (other == room) continue;
        outside = true;
        if (!marked.empty())
          violations.push_back(path + " is internal, but " + other + " includes it");
      }
    }
    if (!marked.empty() && marked != room) {
      violations.push_back(path + " lies in " + room + " and says that it is internal to " +
                           marked);
    }
    if (marked.empty() && !outside) {
      violations.push_back(path + ": no other room includes it; its first line must be \"" +
                           kPragma + kMark + room + "\"");
    }
  }
  return violations;
}

std::vector<std::string> checkRoomSizes(const SourceTree& tree) {
  std::map<std::string, std::size_t> files;
  for (const auto& [path, text] : tree)
    ++files[path.substr(0, path.rfind('/'))];
  std::vector<std::string> violations;
  for (const auto& [folder, count] : files) {
    if (count <= kMaximumFiles) continue;
    violations.push_back(folder + " has " + std::to_string(count) + " files; a room beyond " +
                         std::to_string(kMaximumFiles) + " is two");
  }
  return violations;
}

}  // namespace cutis::test
