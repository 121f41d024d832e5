// Drawings as SVG: well-formed whatever the words are; scales, and labels that keep clear.

#include "src/report/drawing.h"

#include <cmath>
#include <limits>

#include <QXmlStreamReader>
#include <QtTest>

#include "src/report/label_placement.h"
#include "src/report/scale.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr double kSize = 12.0;

class DrawingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void svgIsWellFormedWhateverTheWords() {
    const std::string words = "a<b & \"c\" >d\x01 é–²";
    Drawing drawing(100.0, 50.0, words, words);
    drawing.text({1.0, 2.0}, words, {}, Anchor::end);
    drawing.textUpwards({1.0, 2.0}, words, {});
    drawing.rectangle({0.0, 0.0, 10.0, 5.0}, "#ffffff", {"none", 0.0, ""}, 2.0);
    drawing.polyline(std::vector<Point>{{0.0, 0.0}, {-0.04, 3.25}}, {"#000000", 1.0, "3 3"});
    QXmlStreamReader reader(QString::fromStdString(drawing.svg("Sans \"quoted\"")));
    QStringList texts;
    bool line = false;
    while (!reader.atEnd()) {
      reader.readNext();
      if (!reader.isStartElement()) continue;
      if (reader.name() == QLatin1String("polyline")) {
        line = true;
        QCOMPARE(reader.attributes().value("points").toString(), QString("0,0 0,3.2"));
      }
      if (reader.name() == QLatin1String("text")) texts << reader.readElementText();
    }
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
    QVERIFY(line);
    QCOMPARE(texts, QStringList(2, QString::fromUtf8("a<b & \"c\" >d  é–²")));
  }

  void exponentsAreRaised() {
    Drawing drawing(100.0, 50.0, "", "");
    drawing.powerOfTen({50.0, 20.0}, -7, {kSize, "#000000", false}, Anchor::end);
    const std::string svg = drawing.svg("Sans");
    QVERIFY2(svg.find(">10</text>") != std::string::npos, svg.c_str());
    QVERIFY2(svg.find(">−7</text>") != std::string::npos, svg.c_str());
    QVERIFY2(svg.find("y=\"15\"") != std::string::npos, svg.c_str());
  }

  void longWordsAreCutToTheirRoom() {
    const std::string words = "Prozessor für alle Fälle ²²²²²²²²²²²²²²";
    QCOMPARE(shortened(words, kSize, 1000.0), words);
    for (double room = 10.0; room < textWidth(words, kSize); room += 7.0) {
      const std::string cut = shortened(words, kSize, room);
      QVERIFY(cut.ends_with("…"));
      QVERIFY(textWidth(cut, kSize) <= room || cut == "…");
      QVERIFY(!QString::fromStdString(cut).contains(QChar::ReplacementCharacter));
    }
  }

  void ticksHoldTheirValues() {
    for (const auto& [least, most] :
         {std::pair(0.2, 0.9), std::pair(1.0, 1.0), std::pair(3e-3, 7e4), std::pair(20.0, 50.0)}) {
      const auto ticks = logarithmicTicks(least, most);
      QVERIFY(ticks.size() >= 2 && ticks.size() <= 10);
      QVERIFY(ticks.front() <= least && ticks[1] > least);
      QVERIFY(ticks.back() >= most && ticks[ticks.size() - 2] < most * (1.0 + 1e-12));
    }
    for (const double most : {0.3, 1.0, 42.2, 99.0, 1e6}) {
      const auto ticks = linearTicks(most);
      QCOMPARE(ticks.front(), 0.0);
      QVERIFY(ticks.back() >= most && ticks.size() <= 6);
    }
  }

  void valuesBeyondAScaleArePutAtItsEnds() {
    const Scale scale = {1.0, 100.0, 10.0, 30.0, true};
    QCOMPARE(scale.at(10.0), 20.0);
    QCOMPARE(scale.at(0.0), 10.0);
    QCOMPARE(scale.at(1e9), 30.0);
    QCOMPARE(scale.at(std::numeric_limits<double>::quiet_NaN()), 10.0);
  }

  // Crowds of points such as methods of like speed and error make them.
  void labelsKeepClear_data() {
    QTest::addColumn<double>("spread");
    for (const double spread : {0.0, 3.0, 12.0, 40.0, 160.0})
      QTest::addRow("%g", spread) << spread;
  }

  void labelsKeepClear() {
    QFETCH(double, spread);
    const Box area = {0.0, 0.0, 800.0, 330.0};
    const std::vector<Box> taken = {{0.0, 160.0, 800.0, 164.0}};
    std::vector<LabelledPoint> points;
    for (int i = 0; i < 6; ++i) {
      points.push_back(
          {{400.0 + spread * std::cos(2.4 * i), 150.0 + 0.6 * spread * std::sin(2.4 * i)},
           5.0,
           "three stages, exhaustive"});
    }
    const auto labels = placeLabels(points, taken, area, kSize);
    QCOMPARE(labels.size(), points.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      QVERIFY(area.holds(labels[i].box));
      QVERIFY(!taken[0].overlaps(labels[i].box));
      for (const LabelledPoint& point : points) {
        const Box marker = {point.at.x - 5.0, point.at.y - 5.0, point.at.x + 5.0, point.at.y + 5.0};
        QVERIFY(!marker.overlaps(labels[i].box));
      }
      for (std::size_t k = 0; k < i; ++k)
        QVERIFY(!labels[k].box.overlaps(labels[i].box));
    }
  }
};

CUTIS_TEST(DrawingTest)

}  // namespace
}  // namespace cutis::test

#include "drawing_test.moc"
