#pragma once

// The rooms of the house and who sees whom: the one table from which the checks of include lines
// and of linked libraries follow.
//
// A room is a folder with source files, "core/skin/profile" and "core/skin" being two. A library is
// named after the upper folder and takes in the rooms below: "core/skin", "src/files", "ui".

#include <string>
#include <vector>

namespace cutis::test {

// The room a file lies in, "core/skin/profile" of "core/skin/profile/profile.h"; empty for files
// that are neither under core, src and ui nor in resources and tests.
std::string roomOf(const std::string& path);

// The library a path belongs to: "core/skin", "src/files", "ui", "resources", "tests".
std::string libraryOf(const std::string& path);

// Sentences on the table itself: names that are no rooms, and rooms that see a later one, without
// which there is no circle.
std::vector<std::string> planErrors();

bool isRoom(const std::string& name);

// Whether files of one room may include those of another. What has no place in the plan may use
// nothing and be used by nobody.
bool mayInclude(const std::string& room, const std::string& other);

// Whether some room of one library may include some room of another.
bool mayLink(const std::string& library, const std::string& other);

}  // namespace cutis::test
