#include "core/base/number_text.h"

#include <clocale>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include <QtTest>

#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class NumberTextTest : public QObject {
  Q_OBJECT

 private slots:
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

  void fixedNumbersKeepTheirDecimals() {
    QCOMPARE(fixedNumber(1.0 / 3.0, 4), std::string("0.3333"));
    QCOMPARE(fixedNumber(-2.0, 0), std::string("-2"));
    QCOMPARE(fixedNumber(1e300, 2).size(), std::size_t{304});
    QCOMPARE(fixedNumber(std::numeric_limits<double>::quiet_NaN(), 2), std::string("-"));
    QCOMPARE(fixedNumber(std::numeric_limits<double>::infinity(), 2), std::string("-"));
  }

  void shortScientificDropsZerosOfTheExponent() {
    QCOMPARE(shortScientific(3.8249e-6), std::string("3.82e-6"));
    QCOMPARE(shortScientific(-1e10), std::string("-1.00e+10"));
    QCOMPARE(shortScientific(1.0), std::string("1.00e+0"));
    QCOMPARE(shortScientific(0.0), std::string("0"));
    QCOMPARE(shortScientific(std::numeric_limits<double>::infinity()), std::string("-"));
  }

  void sharesAreWrittenForPeople() {
    const std::vector<std::tuple<double, int, std::string>> cases = {
        {1.0, 2, "100 %"},      {0.0, 2, "0 %"},         {0.5, 2, "50 %"},
        {0.126, 2, "13 %"},     {0.0521, 2, "5.2 %"},    {0.996, 2, "99.6 %"},
        {0.9999, 2, "99.99 %"}, {0.00012, 2, "0.012 %"}, {0.05, 3, "5 %"},
        {12.5, 2, "1250 %"},    {1e-7, 2, "0.00001 %"},  {-0.25, 2, "-25 %"},
        {0.666666, 3, "66.7 %"}};
    for (const auto& [share, digits, text] : cases)
      QCOMPARE(percentText(share, digits), text);
    QCOMPARE(percentText(std::numeric_limits<double>::quiet_NaN(), 2), std::string("-"));
  }

  void roundedNumbersAreThoseWritten() {
    EXPECT_NEAR(roundedTo(0.123456, 3), 0.123, 0.0);
    EXPECT_NEAR(roundedTo(-123456.0, 2), -120000.0, 0.0);
    QVERIFY(std::isnan(roundedTo(std::numeric_limits<double>::quiet_NaN(), 3)));
  }
};

CUTIS_TEST(NumberTextTest)

}  // namespace
}  // namespace cutis

#include "number_text_test.moc"
