#include "src/files/io/csv.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Fields = std::vector<std::string_view>;

Fields fieldsOf(const CsvRow& row) {
  return {row.fields.begin(), row.fields.end()};
}

class CsvTest : public QObject {
  Q_OBJECT

 private slots:
  void splitsRowsAndFields() {
    const auto rows = splitCsv("a,b\n1, 2 \n\n# note, not data\n  # another\n3,\n");
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(rows[0].line, 1);
    QCOMPARE(rows[1].line, 2);
    QCOMPARE(rows[2].line, 6);
    QVERIFY((fieldsOf(rows[0]) == Fields{"a", "b"}));
    QVERIFY((fieldsOf(rows[1]) == Fields{"1", "2"}));
    QVERIFY((fieldsOf(rows[2]) == Fields{"3", ""}));
  }

  void lineEndingsAndMarksDoNotMatter() {
    const auto rows = splitCsv("\xEF\xBB\xBFnm,value\r\n400,1\r\n\r\n401,2");
    QCOMPARE(rows.size(), std::size_t{3});
    QVERIFY((fieldsOf(rows[0]) == Fields{"nm", "value"}));
    QCOMPARE(rows[2].line, 4);
    QVERIFY((fieldsOf(rows[2]) == Fields{"401", "2"}));
  }

  void onePairOfQuotesIsTakenOff() {
    const auto rows = splitCsv("\"wavelength\", \" x \",\"\",\"\n");
    QVERIFY((fieldsOf(rows[0]) == Fields{"wavelength", " x ", "", "\""}));
  }

  void quotedFieldsHoldWhatSeparates() {
    const auto rows = splitCsv("a,\"b, c\",\"d \"\"e\"\"\"\n\"two\nlines\" ,2,\n3,\" \",\"\"\n");
    QCOMPARE(rows.size(), std::size_t{3});
    QVERIFY((fieldsOf(rows[0]) == Fields{"a", "b, c", "d \"e\""}));
    QVERIFY((fieldsOf(rows[1]) == Fields{"two\nlines", "2", ""}));
    QVERIFY((fieldsOf(rows[2]) == Fields{"3", " ", ""}));
    QCOMPARE(rows[1].line, 2);
    QCOMPARE(rows[2].line, 4);
  }

  void otherQuotesAreCharacters() {
    const auto rows = splitCsv("5\" wide,\"a\"b,\"c\n1,2,3\n");
    QVERIFY((fieldsOf(rows[0]) == Fields{"5\" wide", "\"a\"b", "\"c"}));
    QVERIFY((fieldsOf(rows[1]) == Fields{"1", "2", "3"}));
    QCOMPARE(rows.unclosedQuoteLine(), 1);
  }

  void otherSeparators() {
    const auto semicolons = splitCsv("a; \"b;c\" ;0,5\n", ';');
    QVERIFY((fieldsOf(semicolons[0]) == Fields{"a", "b;c", "0,5"}));
    const auto tabs = splitCsv("a\t\tb c\t\n", '\t');
    QVERIFY((fieldsOf(tabs[0]) == Fields{"a", "", "b c", ""}));
    const auto blanks = splitCsv("  a \t b\n\"c d\"  e \n", kBlanks);
    QVERIFY((fieldsOf(blanks[0]) == Fields{"a", "b"}));
    QVERIFY((fieldsOf(blanks[1]) == Fields{"c d", "e"}));
  }

  void carriageReturnsAloneEndLines() {
    const auto rows = splitCsv("a,b\r1,2\r\r\"x\ry\",4");
    QCOMPARE(rows.size(), std::size_t{3});
    QVERIFY((fieldsOf(rows[1]) == Fields{"1", "2"}));
    QVERIFY((fieldsOf(rows[2]) == Fields{"x\ry", "4"}));
    QCOMPARE(rows[2].line, 4);
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
