#pragma once

// A folder for one test, gone with it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <QTemporaryDir>

namespace cutis::test {

class ScratchFolder {
 public:
  std::filesystem::path path() const { return folder_.path().toStdString(); }
  std::filesystem::path operator/(const std::string& name) const { return path() / name; }

  // Creates folders in between. Returns where it was written.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;
  std::string read(const std::string& name) const;
  // Files and folders directly in it, hidden ones included, sorted.
  std::vector<std::string> names() const;

 private:
  QTemporaryDir folder_;
};

// While it lives, this process may do what an ordinary user may. Root is turned into nobody; anyone
// else stays who they are.
class OrdinaryUser {
 public:
  OrdinaryUser();
  ~OrdinaryUser();
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;
};

}  // namespace cutis::test
