#include "src/files/io/csv.h"

#include <clocale>
#include <cmath>
#include <limits>

#include <QtTest>

#include "core/base/random.h"
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

  void numbersAreWhollyNumbers() {
    for (const auto& [text, value] : std::vector<std::pair<const char*, double>>{
             {"0", 0.0},
             {"-1.5", -1.5},
             {"+2", 2.0},
             {"1e-3", 1e-3},
             {".5", 0.5},
             {"5.", 5.0},
             {"1E+2", 100.0},
             {"4.9406564584124654e-324", 4.9406564584124654e-324}}) {
      QVERIFY2(parseNumber(text), text);
      EXPECT_NEAR(*parseNumber(text), value, 0.0);
    }
    for (const char* text : {"", " ", "1 ", " 1", "1,5", "1.5x", "0x10", "--1", "+-1", "++1", "+",
                             "-", "e5", "1e", "1e999", "one", "1_000"}) {
      QVERIFY2(!parseNumber(text), text);
    }
  }

  void numbersIgnoreTheLocale() {
    const std::string saved = std::setlocale(LC_ALL, nullptr);
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"}) {
      found = found || std::setlocale(LC_ALL, name) != nullptr;
    }
    EXPECT_NEAR(*parseNumber("1.5"), 1.5, 0.0);
    QVERIFY(!parseNumber("1,5"));
    QCOMPARE(formatNumber(1.5), std::string("1.5"));
    std::setlocale(LC_ALL, saved.c_str());
    if (!found) QSKIP("no locale with a decimal comma is installed");
  }

  void numbersAreWrittenShort() {
    QCOMPARE(formatNumber(0.0), std::string("0"));
    QCOMPARE(formatNumber(0.25), std::string("0.25"));
    QCOMPARE(formatNumber(1.0 / 3.0, 4), std::string("0.3333"));
    QCOMPARE(formatNumber(123456789.0), std::string("123456789"));
    QCOMPARE(formatNumber(std::numeric_limits<double>::quiet_NaN()), std::string("nan"));
    QCOMPARE(formatNumber(-std::numeric_limits<double>::infinity()), std::string("-inf"));
  }

  void writtenNumbersComeBack() {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
      const double value =
          std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.uniform(-300, 300)));
      EXPECT_NEAR(*parseNumber(formatNumber(value)), value, 1e-8 * std::abs(value));
      EXPECT_NEAR(*parseNumber(formatNumber(value, 17)), value, 0.0);
    }
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
