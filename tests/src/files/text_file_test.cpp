#include "src/files/io/text_file.h"

#include <fstream>
#include <sys/stat.h>
#include <thread>

#include <QtTest>

#include "src/files/io/presence.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

class TextFileTest : public QObject {
  Q_OBJECT

 private slots:
  void filesAreReadWhole() {
    const test::ScratchFolder folder;
    const std::string text = std::string(200000, 'x') + std::string("\0\r\n", 3) + "end";
    const auto read = readTextFile(folder.write("a.txt", text));
    EXPECT_OK(read);
    QVERIFY(read.value() == text);
    EXPECT_OK(readTextFile(folder / "a.txt", text.size()));
    EXPECT_ERROR(readTextFile(folder / "a.txt", text.size() - 1), "larger than 0 MiB");
  }

  void whatIsNoFileIsTold() {
    const test::ScratchFolder folder;
    fs::create_symlink("round", folder / "round");
    EXPECT_ERROR(readTextFile(folder / "gone"), "there is no such file");
    EXPECT_ERROR(readTextFile(folder / "round"), "goes round in circles");
    EXPECT_ERROR(readTextFile(folder.path()), "this is a folder");
    EXPECT_ERROR(readTextFile(folder.write("empty", "")), "the file is empty");
    EXPECT_ERROR(readTextFile("/dev/null"), "the file is empty");
    EXPECT_ERROR(readTextFile("/dev/zero", 1 << 20), "larger than 1 MiB");
  }

  void permissionsAreNotAbsence() {
    const test::ScratchFolder folder;
    folder.write("closed/a.txt", "text");
    folder.write("secret.txt", "text");
    fs::permissions(folder.path(), fs::perms(0755));
    fs::permissions(folder / "closed", fs::perms(0600));
    fs::permissions(folder / "secret.txt", fs::perms(0200));
    {
      const test::OrdinaryUser user;
      EXPECT_ERROR(readTextFile(folder / "closed/a.txt"), "may not be entered");
      EXPECT_ERROR(presentStatus(folder / "closed/a.txt"), "may not be entered");
      EXPECT_ERROR(readTextFile(folder / "secret.txt"), "check its permissions");
    }
    fs::permissions(folder / "closed", fs::perms(0755));
  }

  // Whoever writes may come late and pause.
  void pipesAreReadToTheirEnd() {
    const test::ScratchFolder folder;
    QCOMPARE(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    const std::jthread writer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(120));
      std::ofstream stream(folder / "pipe");
      for (int i = 0; i < 4; ++i) {
        stream << std::string(30000, 'a') << std::flush;
        std::this_thread::sleep_for(std::chrono::milliseconds(80));
      }
    });
    const auto read = readTextFile(folder / "pipe");
    EXPECT_OK(read);
    QVERIFY(read.value() == std::string(120000, 'a'));
  }
};

CUTIS_TEST(TextFileTest)

}  // namespace
}  // namespace cutis

#include "text_file_test.moc"
