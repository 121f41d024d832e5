// What stands where a file is written: links, devices, protected files, and what a file keeps that
// is replaced.

#include <fstream>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <QtTest>

#include "src/files/io/atomic_write.h"
#include "src/files/system/temporary_path.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

fs::perms modeOf(const fs::path& path) {
  return fs::status(path).permissions();
}

// While it lives, new files have no permissions beyond these.
class Umask {
 public:
  explicit Umask(mode_t mask) : previous_(::umask(mask)) {}
  ~Umask() { ::umask(previous_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t previous_;
};

class ReplacedFileTest : public QObject {
  Q_OBJECT

 private slots:
  void linksAreFollowed() {
    const test::ScratchFolder folder;
    folder.write("data/real.csv", "old");
    fs::create_symlink("data/real.csv", folder / "link.csv");
    fs::create_symlink("link.csv", folder / "link to link.csv");
    fs::create_symlink(folder / "data/real.csv", folder / "absolute.csv");
    fs::create_directory_symlink("data", folder / "folder");
    for (const std::string name :
         {"link.csv", "link to link.csv", "absolute.csv", "folder/real.csv"}) {
      EXPECT_OK(checkWritable(folder / name));
      fs::path temporary;
      EXPECT_OK(writeAtomically(folder / name, [&](const fs::path& path) -> Status {
        temporary = path;
        std::ofstream(path) << name;
        return {};
      }));
      QVERIFY(fs::equivalent(temporary.parent_path(), folder / "data"));
      QVERIFY(folder.read("data/real.csv") == name);
    }
    for (const char* link : {"link.csv", "link to link.csv", "absolute.csv", "folder"})
      QVERIFY(fs::is_symlink(folder / link));
    QVERIFY(!fs::is_symlink(folder / "data/real.csv"));
  }

  void linksToNothingMakeTheirFile() {
    const test::ScratchFolder folder;
    fs::create_directory(folder / "data");
    fs::create_symlink("data/new.csv", folder / "link.csv");
    EXPECT_OK(writeTextAtomically(folder / "link.csv", "new"));
    QVERIFY(folder.read("data/new.csv") == "new" && fs::is_symlink(folder / "link.csv"));
  }

  void linksThatLeadNowhereAreRefused() {
    const test::ScratchFolder folder;
    fs::create_symlink("gone/new.csv", folder / "dangling.csv");
    fs::create_symlink("round.csv", folder / "round.csv");
    fs::create_symlink("b.csv", folder / "a.csv");
    fs::create_symlink("a.csv", folder / "b.csv");
    fs::create_directory(folder / "data");
    fs::create_symlink("data", folder / "to folder");
    const auto before = folder.names();
    const auto write = [&](const char* name) { return writeTextAtomically(folder / name, "new"); };
    EXPECT_ERROR(write("dangling.csv"), "whose folder does not exist; mend the link");
    EXPECT_ERROR(write("round.csv"), "a link that leads to no file");
    EXPECT_ERROR(write("a.csv"), "a link that leads to no file");
    EXPECT_ERROR(write("to folder"), "this is a folder");
    QVERIFY(folder.names() == before);
  }

  void modesAreKept() {
    const test::ScratchFolder folder;
    for (const mode_t mode : {0600, 0640, 0644, 0666, 0664, 0755, 0200}) {
      folder.write("f.csv", "old");
      fs::permissions(folder / "f.csv", fs::perms(mode));
      EXPECT_OK(writeTextAtomically(folder / "f.csv", "new"));
      QCOMPARE(static_cast<mode_t>(modeOf(folder / "f.csv")), mode);
      fs::permissions(folder / "f.csv", fs::perms(0644));
      QVERIFY(folder.read("f.csv") == "new");
    }
  }

  // Bits that run a program as somebody else are not for new content.
  void theBitsOfOtherUsersGo() {
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    fs::permissions(folder / "f.csv", fs::perms(06755));
    EXPECT_OK(writeTextAtomically(folder / "f.csv", "new"));
    QCOMPARE(static_cast<mode_t>(modeOf(folder / "f.csv")), mode_t{0755});
  }

  void privateFilesArePrivateWhileTheyAreWritten() {
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    fs::permissions(folder / "f.csv", fs::perms(0600));
    EXPECT_OK(writeAtomically(folder / "f.csv", [&](const fs::path& path) -> Status {
      std::ofstream(path) << "new";
      if (modeOf(path) != fs::perms(0600)) return resourceError("mode", "open to others");
      return {};
    }));
  }

  void newFilesHonourTheUmask() {
    const test::ScratchFolder folder;
    for (const mode_t mask : {0022, 0002, 0077, 0027}) {
      const Umask umask(mask);
      const fs::path file = folder / ("f" + std::to_string(mask));
      EXPECT_OK(writeTextAtomically(file, "new"));
      QCOMPARE(static_cast<mode_t>(modeOf(file)), mode_t{0666} & ~mask);
    }
  }

  void ownersAreKept() {
    if (::geteuid() != 0) QSKIP("only root gives files away");
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    QCOMPARE(::chown((folder / "f.csv").c_str(), 1234, 4321), 0);
    EXPECT_OK(writeTextAtomically(folder / "f.csv", "new"));
    struct stat now = {};
    QCOMPARE(::stat((folder / "f.csv").c_str(), &now), 0);
    QCOMPARE(now.st_uid, uid_t{1234});
    QCOMPARE(now.st_gid, gid_t{4321});
  }

  // A group that cannot be kept would hand its permissions to another.
  void foreignGroupsLeaveNothingToOurs() {
    if (::geteuid() != 0) QSKIP("only root can prepare it");
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    fs::permissions(folder.path(), fs::perms(0777));
    fs::permissions(folder / "f.csv", fs::perms(0666));
    fs::permissions(folder / "f.csv", fs::perms(0662));
    QCOMPARE(::chown((folder / "f.csv").c_str(), 1234, 4321), 0);
    {
      const test::OrdinaryUser user;
      EXPECT_OK(writeTextAtomically(folder / "f.csv", "new"));
    }
    QCOMPARE(static_cast<mode_t>(modeOf(folder / "f.csv")), mode_t{0622});
  }

  void attributesAreKept() {
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    const std::string file = (folder / "f.csv").string();
    if (::setxattr(file.c_str(), "user.comment", "mine", 4, 0) != 0)
      QSKIP("this file system keeps no attributes");
    EXPECT_OK(writeTextAtomically(file, "new"));
    char value[8] = {};
    QCOMPARE(::getxattr(file.c_str(), "user.comment", value, sizeof value), ssize_t{4});
    QCOMPARE(std::string(value), std::string("mine"));
  }

  // As acl(5) lays it out: user 1234 may read and write, the group nothing.
  void accessListsAreKept() {
    const test::ScratchFolder folder;
    folder.write("f.csv", "old");
    const std::string file = (folder / "f.csv").string();
    constexpr unsigned char kList[] = {2,  0, 0, 0,                        // version
                                       1,  0, 6, 0, 255,  255, 255, 255,   // owner
                                       2,  0, 6, 0, 0xd2, 4,   0,   0,     // user 1234
                                       4,  0, 0, 0, 255,  255, 255, 255,   // group
                                       16, 0, 6, 0, 255,  255, 255, 255,   // mask
                                       32, 0, 0, 0, 255,  255, 255, 255};  // others
    constexpr char kName[] = "system.posix_acl_access";
    if (::setxattr(file.c_str(), kName, kList, sizeof kList, 0) != 0)
      QSKIP("this file system keeps no access lists");
    EXPECT_OK(writeTextAtomically(file, "new"));
    unsigned char kept[64] = {};
    QCOMPARE(::getxattr(file.c_str(), kName, kept, sizeof kept), ssize_t{sizeof kList});
    QVERIFY(std::equal(std::begin(kList), std::end(kList), kept));
  }

  void otherHardLinksKeepTheOldContent() {
    const test::ScratchFolder folder;
    folder.write("a.csv", "old");
    fs::create_hard_link(folder / "a.csv", folder / "b.csv");
    EXPECT_OK(writeTextAtomically(folder / "a.csv", "new"));
    QVERIFY(folder.read("a.csv") == "new" && folder.read("b.csv") == "old");
  }

  void protectedFilesAreLeftAlone() {
    const test::ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms(0777));
    folder.write("f.csv", "old");
    fs::permissions(folder / "f.csv", fs::perms(0444));
    {
      const test::OrdinaryUser user;
      EXPECT_ERROR(writeTextAtomically(folder / "f.csv", "new"), "protected from being written");
    }
    QVERIFY(folder.read("f.csv") == "old");
  }

  void foldersThatMayNotBeWrittenTo() {
    const test::ScratchFolder folder;
    folder.write("locked/old.txt", "old");
    folder.write("closed/old.txt", "old");
    fs::create_symlink("locked/old.txt", folder / "link.txt");
    fs::permissions(folder.path(), fs::perms(0755));
    fs::permissions(folder / "locked", fs::perms(0555));
    fs::permissions(folder / "closed", fs::perms(0600));
    {
      const test::OrdinaryUser user;
      EXPECT_ERROR(writeTextAtomically(folder / "locked/old.txt", "new"), "cannot be written to");
      EXPECT_ERROR(writeTextAtomically(folder / "link.txt", "new"), "cannot be written to");
      EXPECT_ERROR(checkWritable(folder / "locked/new.txt"), "cannot be written to");
      EXPECT_ERROR(checkWritable(folder / "closed/sub/new.txt"), "may not be entered");
    }
    fs::permissions(folder / "locked", fs::perms(0755));
    fs::permissions(folder / "closed", fs::perms(0755));
    QVERIFY(folder.read("locked/old.txt") == "old");
  }

  // A device, a pipe or a socket would be replaced by a file of its name.
  void devicesPipesAndSocketsAreLeftAlone() {
    const test::ScratchFolder folder;
    QCOMPARE(::mkfifo((folder / "pipe").c_str(), 0666), 0);
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    const std::string name = (folder / "socket").string();
    QVERIFY(name.size() < sizeof address.sun_path);
    name.copy(address.sun_path, name.size());
    QCOMPARE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    fs::create_symlink("pipe", folder / "to pipe");
    fs::create_symlink("/dev/null", folder / "to null");
    const auto before = folder.names();
    for (const fs::path& path :
         {folder / "pipe", folder / "socket", folder / "to pipe", folder / "to null",
          fs::path("/dev/null"), fs::path("/dev/full")}) {
      EXPECT_ERROR(checkWritable(path), "not a regular file");
      EXPECT_ERROR(writeTextAtomically(path, "text"), "not a regular file");
    }
    ::close(socket);
    QVERIFY(folder.names() == before);
    QVERIFY(fs::is_fifo(folder / "pipe") && fs::is_character_file("/dev/null"));
  }

  // Whatever they lead to, a file among it: the shell's redirection has it open.
  void openStreamsAreLeftAlone() {
    const test::ScratchFolder folder;
    fs::create_symlink("/proc/self/fd/1", folder / "mine");
    const std::string number = std::to_string(::dup(1));
    for (const fs::path& path :
         {fs::path("/dev/stdout"), fs::path("/dev/stderr"), fs::path("/dev/fd/1"),
          fs::path("/proc/self/fd/1"), fs::path("/proc/self/fd") / number, folder / "mine"}) {
      if (!fs::is_symlink(path)) continue;
      EXPECT_ERROR(writeTextAtomically(path, "text"), "a stream that is open already");
      QVERIFY(fs::is_symlink(path));
    }
    ::close(std::stoi(number));
  }

  // A second interrupt ends the program before anything is destroyed.
  void temporariesVanishWhenTheProcessEnds() {
    const test::ScratchFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
      const TemporaryPath file(temporaryBeside(folder / "f.csv"));
      const TemporaryPath tree(temporaryBeside(folder / "capture"));
      std::ofstream(file.path()) << "half";
      fs::create_directory(tree.path());
      std::ofstream(tree.path() / "a.exr") << "half";
      removeTemporaries();
      ::_exit(0);
    }
    int status = -1;
    QCOMPARE(::waitpid(child, &status, 0), child);
    QCOMPARE(status, 0);
    QVERIFY(folder.names().empty());
  }
};

CUTIS_TEST(ReplacedFileTest)

}  // namespace
}  // namespace cutis

#include "replaced_file_test.moc"
