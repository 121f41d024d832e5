// Drawings as SVG: well-formed whatever the words are, and every primitive is there.

#include "src/report/svg.h"

#include <QXmlStreamReader>
#include <QtTest>

#include "src/report/text_metrics.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr TextStyle kStyle = {12.0, Color::rgb(0x102030), false};

class SvgTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void svgIsWellFormedWhateverTheWords() {
    const std::string words = "a<b & \"c\" >d\x01 é–²";
    Drawing drawing;
    drawing.width = 100.0;
    drawing.height = 50.0;
    drawing.title = drawing.description = words;
    drawing.add(Text{{1.0, 2.0}, words, kStyle, Anchor::end});
    drawing.add(Text{{1.0, 2.0}, words, kStyle, Anchor::middle, true});
    drawing.add(Rectangle{{0.0, 0.0, 10.0, 5.0}, Color::rgb(0xffffff), kNoStroke, 2.0});
    drawing.add(Disc{{3.0, 3.0}, 2.0, kNoColor, {Color::rgb(0), 1.0}});
    drawing.add(Area{{{0.0, 0.0}, {1.0, 1.0}, {2.0, 0.0}}, Color::rgb(0xff0000).faded(51)});
    drawing.add(Polyline{{{0.0, 0.0}, {-0.04, 3.25}}, {Color::rgb(0), 1.0, 3.0, 2.5}});
    QXmlStreamReader reader(QString::fromStdString(svgOf(drawing, "Sans \"quoted\"")));
    QStringList texts, names;
    QXmlStreamAttributes line, area;
    while (!reader.atEnd()) {
      reader.readNext();
      if (!reader.isStartElement()) continue;
      names << reader.name().toString();
      if (reader.name() == QLatin1String("polyline")) line = reader.attributes();
      if (reader.name() == QLatin1String("polygon")) area = reader.attributes();
      if (reader.name() == QLatin1String("text")) texts << reader.readElementText();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QCOMPARE(names, QStringList({"svg", "title", "desc", "text", "text", "rect", "circle",
                                 "polygon", "polyline"}));
    QCOMPARE(line.value("points").toString(), QString("0,0 0,3.2"));
    QCOMPARE(line.value("stroke-dasharray").toString(), QString("3 2.5"));
    QCOMPARE(area.value("fill").toString(), QString("#ff0000"));
    QCOMPARE(area.value("fill-opacity").toString(), QString("0.200"));
    QCOMPARE(texts, QStringList(2, QString::fromUtf8("a<b & \"c\" >d  é–²")));
  }

  void longWordsAreCutToTheirRoom() {
    const TextMetrics& metrics = printMetrics();
    const std::string words = "Prozessor für alle Fälle ²²²²²²²²²²²²²²";
    QCOMPARE(shortened(words, kStyle, 1000.0, metrics), words);
    for (double room = 10.0; room < metrics.width(words, kStyle); room += 7.0) {
      const std::string cut = shortened(words, kStyle, room, metrics);
      QVERIFY(cut.ends_with("…"));
      QVERIFY(metrics.width(cut, kStyle) <= room || cut == "…");
      QVERIFY(!QString::fromStdString(cut).contains(QChar::ReplacementCharacter));
    }
  }

  void wrappedLinesFitAndLoseNothing() {
    const std::string words = "Measured on a processor of some name, with all of its threads";
    const auto lines = wrapped(words, kStyle, 120.0, printMetrics());
    QVERIFY(lines.size() > 2);
    std::string joined;
    for (const std::string& line : lines) {
      QVERIFY(printMetrics().width(line, kStyle) <= 120.0);
      joined += (joined.empty() ? "" : " ") + line;
    }
    QCOMPARE(joined, words);
  }
};

CUTIS_TEST(SvgTest)

}  // namespace
}  // namespace cutis::test

#include "svg_test.moc"
