// Drawings as files: PNG with letters on any machine, and endings that are not known.

#include "src/report/picture_file.h"

#include <set>

#include <QImage>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

Drawing smallDrawing(const std::string& words) {
  Drawing drawing;
  drawing.width = 120.0;
  drawing.height = 40.0;
  drawing.add(Rectangle{{0.0, 0.0, 120.0, 40.0}, Color::rgb(0xffffff), kNoStroke, 0.0});
  drawing.add(Text{{60.0, 26.0}, words, {20.0, Color::rgb(0), false}, Anchor::middle});
  return drawing;
}

class PictureFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pngHasTwiceThePixels() {
    const QImage image = pngOf("words");
    QCOMPARE(image.size(), QSize(240, 80));
    QCOMPARE(image.pixel(0, 0), qRgb(255, 255, 255));
  }

  // A font that has no letters draws the same box for all of them.
  void lettersAreLetters() {
    std::set<QString> shapes;
    const std::vector<std::string> letters = {"W", "i", "g", "7", "²", "–",
                                              "−", "é", "β", "≤", "…"};
    for (const std::string& letter : letters) {
      const QImage image = pngOf(letter);
      int dark = 0;
      QString shape;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          const bool ink = qGray(image.pixel(x, y)) < 128;
          dark += ink ? 1 : 0;
          shape += QLatin1Char(ink ? '#' : '.');
        }
      }
      QVERIFY2(dark > 5, letter.c_str());
      shapes.insert(shape);
    }
    QCOMPARE(shapes.size(), letters.size());
  }

  void svgNamesFontsThatViewersHave() {
    EXPECT_OK(writeDrawing(folder_ / "a.svg", smallDrawing("words")));
    const std::string svg = folder_.read("a.svg");
    QVERIFY(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
    QVERIFY(svg.find("sans-serif") != std::string::npos);
  }

  void otherEndingsAreRefused() {
    for (const char* name : {"a.pdf", "a", "a.PNG.txt"}) {
      const Status status = checkDrawingOutput(folder_ / name);
      QVERIFY(status.failed());
      QVERIFY(status.error().kind == ErrorKind::usage);
    }
    EXPECT_OK(checkDrawingOutput(folder_ / "a.png"));
    EXPECT_OK(checkDrawingOutput(folder_ / "a.svg"));
    const Status nowhere = writeDrawing(folder_ / "none/a.png", smallDrawing("words"));
    QVERIFY(nowhere.failed() && nowhere.error().kind == ErrorKind::resource);
  }

 private:
  QImage pngOf(const std::string& words) {
    const auto path = folder_ / "a.png";
    const Status status = writeDrawing(path, smallDrawing(words));
    if (!status) return {};
    return QImage(QString::fromStdString(path.string()));
  }

  ScratchFolder folder_;
};

CUTIS_TEST(PictureFileTest)

}  // namespace
}  // namespace cutis::test

#include "picture_file_test.moc"
