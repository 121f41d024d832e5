#include "core/base/echoed_text.h"

#include <algorithm>

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class EchoedTextTest : public QObject {
  Q_OBJECT

 private slots:
  void shortTextsStay() {
    QCOMPARE(inQuotes("sRGB"), std::string("'sRGB'"));
    QCOMPARE(inQuotes(""), std::string("''"));
    QCOMPARE(shortened(std::string(80, 'x')), std::string(80, 'x'));
  }

  void longOnesLoseTheirMiddle() {
    const std::string text = "begin" + std::string(100000, 'x') + "end";
    const QString shown = QString::fromStdString(shortened(text));
    QCOMPARE(shown.size(), 80);
    QVERIFY(shown.startsWith("begin") && shown.endsWith("end") && shown.contains("…"));
  }

  void placesKeepTheNameOfTheirFile() {
    QCOMPARE(shortenedPlace("folder/rig.json:3:10"), std::string("folder/rig.json:3:10"));
    const std::string deep = "/begin" + std::string(200, 'x') + "/face_of_a_long_name.exr:12:5";
    const QString shown = QString::fromStdString(shortenedPlace(deep));
    QCOMPARE(shown.size(), 80);
    QVERIFY(shown.startsWith("/begin") && shown.endsWith("/face_of_a_long_name.exr:12:5"));
    const std::string name = "a" + std::string(58, 'n') + "z.exr";
    QVERIFY(shortenedPlace(std::string(100, 'f') + "/" + name).ends_with("/" + name));
    QCOMPARE(QString::fromStdString(shortenedPlace(std::string(300, 'n'))).size(), 80);
  }

  // Cut between characters, of which some take several bytes.
  void charactersStayWhole() {
    std::string text;
    for (int i = 0; i < 300; ++i)
      text += "皮";
    const QString shown = QString::fromStdString(shortened(text));
    QCOMPARE(shown.size(), 80);
    QCOMPARE(shown.count("皮"), 79);
  }

  void everythingIsOnOneLine() {
    QCOMPARE(onOneLine("a\nb\tc\x1b[1m\x7f"), std::string("a b c [1m "));
    QCOMPARE(inQuotes("two\r\nlines"), std::string("'two  lines'"));
    const std::string bytes = inQuotes(std::string(500, '\xff') + std::string(1, '\0'));
    QVERIFY(bytes.find('\0') == std::string::npos);
  }
};

CUTIS_TEST(EchoedTextTest)

}  // namespace
}  // namespace cutis

#include "echoed_text_test.moc"
