#pragma once

// The plan of the house held against its include lines, links and texts. Every check returns
// sentences, one per violation, each naming file and line; none means that all is well.

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace cutis::test {

// Texts by path from the root of the repository, e.g. "core/skin/profile/profile.h".
using SourceTree = std::map<std::string, std::string>;

struct Include {
  int line = 0;
  std::string name;
  bool angled = false;
};

// The #include lines of a text; comments do not count.
std::vector<Include> includesOf(const std::string& text);

// The Qt module of a header such as "QString" or "QtGui/QImage": "QtCore", "QtGui", …; empty if
// unknown.
using QtModuleOf = std::function<std::string(const std::string& header)>;

// Our own headers and third-party ones.
std::vector<std::string> checkIncludes(const SourceTree& tree, const QtModuleOf& qtModuleOf);

// Translation units compiled for several instruction sets, and what they include: no Eigen.
std::vector<std::string> checkVectorised(const SourceTree& tree);

// Lines "folder: used used … | external external …" (packaging/cmake/CutisTargets.cmake).
std::vector<std::string> checkLinks(const std::string& report);

// Length, tabs, and words that mark unfinished work.
std::vector<std::string> checkStyle(const std::string& path, const std::string& text);

inline constexpr int kMaximumLines = 450;

}  // namespace cutis::test
