#include "src/files/io/atomic_write.h"

#include <fstream>
#include <new>
#include <thread>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

Status writeHalfAndFail(const fs::path& temporary) {
  std::ofstream(temporary) << "half a fi";
  return resourceError("disk", "full");
}

class AtomicWriteTest : public QObject {
  Q_OBJECT

 private slots:
  void writesWhatItWasGiven() {
    const test::ScratchFolder folder;
    const std::string text("two\r\nlines\0and a zero", 21);
    EXPECT_OK(writeTextAtomically(folder / "a.txt", text));
    QVERIFY(folder.read("a.txt") == text);
    EXPECT_OK(writeTextAtomically(folder / "a.txt", "new"));
    QVERIFY(folder.read("a.txt") == "new");
    EXPECT_OK(writeTextAtomically(folder / "empty.txt", ""));
    QVERIFY((folder.names() == std::vector<std::string>{"a.txt", "empty.txt"}));
  }

  // Writers choose their format by the extension.
  void theTemporaryLooksLikeTheFile() {
    const test::ScratchFolder folder;
    fs::path seen;
    EXPECT_OK(writeAtomically(folder / "maps.exr", [&](const fs::path& temporary) -> Status {
      seen = temporary;
      std::ofstream(temporary) << "x";
      return {};
    }));
    QCOMPARE(seen.extension().string(), std::string(".exr"));
    QVERIFY(seen.parent_path() == folder.path());
    QVERIFY(seen.filename() != "maps.exr");
  }

  // Nobody can make files in /proc, and there is no lack of space.
  void whatCannotBeWrittenIsNotCalledFull() {
    if (!fs::exists("/proc/version")) QSKIP("a system without /proc");
    const Status refused = writeTextAtomically("/proc/cutis.txt", "text");
    EXPECT_ERROR(refused, "write elsewhere");
    QVERIFY(refused.error().text().find("disk space") == std::string::npos);
  }

  void aFailureLeavesTheOldFile() {
    const test::ScratchFolder folder;
    folder.write("maps.exr", "old");
    EXPECT_ERROR(writeAtomically(folder / "maps.exr", writeHalfAndFail), "disk: full");
    QVERIFY(folder.read("maps.exr") == "old");
    QVERIFY(folder.names() == std::vector<std::string>{"maps.exr"});
  }

  void aFailureLeavesNothingWhereNothingWas() {
    const test::ScratchFolder folder;
    EXPECT_ERROR(writeAtomically(folder / "maps.exr", writeHalfAndFail), "disk: full");
    QVERIFY(folder.names().empty());
  }

  void cancellingLeavesTheOldFile() {
    const test::ScratchFolder folder;
    folder.write("maps.exr", "old");
    QVERIFY(writeAtomically(folder / "maps.exr", [](const fs::path& temporary) -> Status {
              std::ofstream(temporary) << "half";
              return Cancelled{};
            }).cancelled());
    QVERIFY(folder.read("maps.exr") == "old");
    QVERIFY(folder.names() == std::vector<std::string>{"maps.exr"});
  }

  void anExceptionLeavesTheOldFile() {
    const test::ScratchFolder folder;
    folder.write("maps.exr", "old");
    bool thrown = false;
    try {
      static_cast<void>(
          writeAtomically(folder / "maps.exr", [](const fs::path& temporary) -> Status {
            std::ofstream(temporary) << "half";
            throw std::bad_alloc();
          }));
    } catch (const std::bad_alloc&) {
      thrown = true;
    }
    QVERIFY(thrown);
    QVERIFY(folder.read("maps.exr") == "old");
    QVERIFY(folder.names() == std::vector<std::string>{"maps.exr"});
  }

  void aWriterThatWritesNothingFails() {
    const test::ScratchFolder folder;
    folder.write("maps.exr", "old");
    const Status status =
        writeAtomically(folder / "maps.exr", [](const fs::path&) -> Status { return {}; });
    QVERIFY(status.failed());
    QVERIFY(folder.read("maps.exr") == "old");
  }

  void impossiblePlacesAreToldBeforehand() {
    const test::ScratchFolder folder;
    folder.write("file", "x");
    fs::create_directory(folder / "sub");
    bool called = false;
    const auto write = [&](const fs::path& path) {
      return writeAtomically(path, [&](const fs::path&) -> Status {
        called = true;
        return {};
      });
    };
    EXPECT_ERROR(write(folder / "gone/a.txt"), "does not exist; create it or write elsewhere");
    EXPECT_ERROR(write(folder / "sub"), "this is a folder; name a file to write");
    EXPECT_ERROR(write(folder / "file/a.txt"), "does not exist");
    EXPECT_ERROR(checkWritable(folder / "gone/a.txt"), "does not exist");
    QVERIFY(checkWritable(folder / "gone/a.txt").error().kind == ErrorKind::resource);
    QCOMPARE(checkWritable(folder / "gone/a.txt").error().place, (folder / "gone/a.txt").string());
    EXPECT_OK(checkWritable(folder / "sub/a.txt"));
    QVERIFY(!called);
  }

  void namesInTheWorkingDirectory() {
    const test::ScratchFolder folder;
    const fs::path here = fs::current_path();
    fs::current_path(folder.path());
    const Status status = writeTextAtomically("plain.txt", "x");
    fs::current_path(here);
    EXPECT_OK(status);
    QVERIFY(folder.names() == std::vector<std::string>{"plain.txt"});
  }

  // The longest name a file may have (255 bytes), and odd ones.
  void oddNames() {
    const test::ScratchFolder folder;
    std::string skin;  // 84 characters of three bytes each
    for (int i = 0; i < 84; ++i)
      skin += "皮";
    for (const std::string& name :
         {std::string(251, 'n') + ".txt", "a." + std::string(253, 'x'), skin + ".no",
          std::string(".hidden"), std::string("no extension"), std::string("häut 皮肤.txt"),
          std::string("a.b.c"), std::string("-rf")}) {
      EXPECT_OK(writeTextAtomically(folder / name, name));
      QVERIFY(folder.read(name) == name);
    }
    QCOMPARE(folder.names().size(), std::size_t{8});
    EXPECT_ERROR(checkWritable(folder / std::string(256, 'n')), "choose a shorter one");
  }

  // When several write at once, one wins, whole.
  void writersDoNotMix() {
    const test::ScratchFolder folder;
    {
      std::vector<std::jthread> threads;
      for (char c = 'a'; c < 'i'; ++c) {
        threads.emplace_back([&folder, c] {
          for (int i = 0; i < 10; ++i) {
            static_cast<void>(writeTextAtomically(folder / "f.txt", std::string(5000, c)));
          }
        });
      }
    }
    const std::string text = folder.read("f.txt");
    QCOMPARE(text.size(), std::size_t{5000});
    QVERIFY(text == std::string(5000, text.front()));
    QVERIFY(folder.names() == std::vector<std::string>{"f.txt"});
  }
};

CUTIS_TEST(AtomicWriteTest)

}  // namespace
}  // namespace cutis

#include "atomic_write_test.moc"
