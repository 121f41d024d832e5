#include "src/files/io/csv.h"

#include <QtTest>

#include "src/files/io/text_file.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class CsvTest : public QObject {
  Q_OBJECT

 private slots:
  void splitsRowsAndFields() {
    const auto rows = splitCsv("a,b\n1, 2 \n\n# note, not data\n  # another\n3,\n");
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(rows[0].line, 1);
    QCOMPARE(rows[1].line, 2);
    QCOMPARE(rows[2].line, 6);
    QVERIFY((rows[0].fields == std::vector<std::string_view>{"a", "b"}));
    QVERIFY((rows[1].fields == std::vector<std::string_view>{"1", "2"}));
    QVERIFY((rows[2].fields == std::vector<std::string_view>{"3", ""}));
  }

  void lineEndingsAndMarksDoNotMatter() {
    const auto rows = splitCsv("\xEF\xBB\xBFnm,value\r\n400,1\r\n\r\n401,2");
    QCOMPARE(rows.size(), std::size_t{3});
    QVERIFY((rows[0].fields == std::vector<std::string_view>{"nm", "value"}));
    QCOMPARE(rows[2].line, 4);
    QVERIFY((rows[2].fields == std::vector<std::string_view>{"401", "2"}));
  }

  void onePairOfQuotesIsTakenOff() {
    const auto rows = splitCsv("\"wavelength\", \" x \",\"\",\"\n");
    QVERIFY((rows[0].fields == std::vector<std::string_view>{"wavelength", " x ", "", "\""}));
  }

  void nothingHasNoRows() {
    QVERIFY(splitCsv("").empty());
    QVERIFY(splitCsv("\n\r\n  \n# only a comment").empty());
  }
};

class TextFileTest : public QObject {
  Q_OBJECT

 private slots:
  void readsTheWholeFile() {
    const test::ScratchFolder folder;
    std::string text = "line\r\n";
    text += '\0';
    for (int i = 0; i < 200000; ++i)
      text += static_cast<char>('a' + i % 26);
    const auto read = readTextFile(folder.write("a.txt", text));
    EXPECT_OK(read);
    QVERIFY(read.value() == text);
  }

  void saysWhatIsWrong() {
    const test::ScratchFolder folder;
    EXPECT_ERROR(readTextFile(folder / "no.txt"), (folder / "no.txt").string() + ": there is no");
    EXPECT_ERROR(readTextFile(folder.path()), "this is a folder");
    EXPECT_ERROR(readTextFile(folder.write("e.txt", "")), "is empty");
    EXPECT_ERROR(readTextFile(folder.write("big.txt", std::string(3 << 20, 'x')), 2 << 20),
                 "larger than 2 MiB");
    EXPECT_OK(readTextFile(folder / "big.txt", 3 << 20));
  }

  void unreadableFilesSayWhy() {
    const test::ScratchFolder folder;
    const auto path = folder.write("secret.txt", "x");
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    std::filesystem::permissions(path, std::filesystem::perms::none);
    const test::OrdinaryUser user;
    EXPECT_ERROR(readTextFile(path), "permissions");
  }
};

CUTIS_TEST(CsvTest)
CUTIS_TEST(TextFileTest)

}  // namespace
}  // namespace cutis

#include "csv_test.moc"
