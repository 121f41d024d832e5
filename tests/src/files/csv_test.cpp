#include "src/files/io/csv.h"

#include <QtTest>

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

CUTIS_TEST(CsvTest)

}  // namespace
}  // namespace cutis

#include "csv_test.moc"
