#include "ui/dialogs/open_as_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

ImageInspection twoLayers() {
  ImageInspection image;
  image.format = "OpenEXR, 64 × 48 pixels, half";
  image.colorSpaces = {"sRGB", "Display P3"};
  LayerInspection depth;
  depth.name = "depth";
  depth.channels = "Z";
  depth.decision = "its colours are Linear Rec.709, as the format usually has them";
  depth.isDecided = true;
  LayerInspection albedo;
  albedo.name = "albedo";
  albedo.channels = "R, G and B";
  albedo.hasColors = true;
  albedo.decision = "its colours are 'nobody', which is not known";
  albedo.statements = {"its attribute: 'nobody'"};
  image.layers = {depth, albedo};
  image.usualLayer = 0;
  return image;
}

template <typename Widget>
Widget& named(const QWidget& dialog, const QString& name) {
  for (Widget* widget : dialog.findChildren<Widget*>())
    if (widget->accessibleName() == name) return *widget;
  qFatal("no widget is called %s", qPrintable(name));
}

// Without the places where lines may break.
QString shownText(const QWidget& dialog, const QString& name) {
  return named<QLabel>(dialog, name).text().remove(QChar(0x200b));
}

QPushButton& openButton(const QWidget& dialog) {
  for (QPushButton* button : dialog.findChildren<QPushButton*>())
    if (button->isDefault()) return *button;
  qFatal("no button is the default");
}

class OpenAsDialogTest : public test::UiTest {
  Q_OBJECT

 private Q_SLOTS:
  void opensOnlyWhatCanBeRead() {
    OpenAsDialog dialog("/folder/face.exr", twoLayers(), {});
    dialog.show();
    QPushButton& open = openButton(dialog);
    QComboBox& layer = named<QComboBox>(dialog, "Layer");
    QComboBox& colors = named<QComboBox>(dialog, "Colour space");
    QVERIFY(!open.isEnabled());  // depth has no colours
    QTest::keyClick(&layer, Qt::Key_Down);
    QCOMPARE(layer.currentIndex(), 1);
    QVERIFY(!open.isEnabled());  // nobody knows its colour space
    QCOMPARE(colors.itemText(0), QString("Choose one"));
    QTest::keyClick(&colors, Qt::Key_Down);
    QVERIFY(open.isEnabled());
    const OpenChoice choice = dialog.choice();
    QCOMPARE(choice.source.layer, std::string("albedo"));
    QCOMPARE(choice.source.colorSpace, std::string("sRGB"));
    QVERIFY(!choice.exposure);
    dialog.close();
  }

  void saysWhatTheFileSays() {
    ImageInspection image = twoLayers();
    image.usualLayer = 1;
    image.layers[1].contradictions = {"EXIF says Adobe RGB"};
    OpenAsDialog dialog("/folder/face.exr", image, "face.exr: its colour space is not known");
    const QString said = shownText(dialog, "What the file says");
    QVERIFY(said.contains("Its colours are 'nobody', which is not known."));
    QVERIFY(said.contains("EXIF says Adobe RGB."));
    QVERIFY(said.contains("Stated by its attribute: 'nobody'."));
    QCOMPARE(shownText(dialog, "Why you are asked"),
             QString("face.exr: its colour space is not known"));
  }

  void aSingleLayerIsNoQuestion() {
    ImageInspection image = twoLayers();
    image.layers.erase(image.layers.begin());
    image.layers.front().isDecided = true;
    OpenAsDialog dialog("/folder/face.png", image, {});
    dialog.show();
    QVERIFY(!named<QComboBox>(dialog, "Layer").isVisible());
    QVERIFY(openButton(dialog).isEnabled());
    QCOMPARE(dialog.choice().source.colorSpace, std::string());
    dialog.close();
  }

  void exposureAndMaskAreChosen() {
    ImageInspection image = twoLayers();
    image.usualLayer = 1;
    OpenAsDialog dialog("/folder/face.png", image, {});
    dialog.show();
    QDoubleSpinBox& exposure = named<QDoubleSpinBox>(dialog, "Exposure");
    QVERIFY(!exposure.isEnabled());
    dialog.findChild<QCheckBox*>()->click();
    QVERIFY(exposure.isEnabled());
    exposure.setValue(2.5);
    QLineEdit& mask = named<QLineEdit>(dialog, "Mask");
    QTest::keyClicks(&mask, "/folder/mask.png");
    const OpenChoice choice = dialog.choice();
    QCOMPARE(choice.exposure, std::optional<double>(2.5));
    QCOMPARE(choice.source.mask.string(), std::string("/folder/mask.png"));
    dialog.close();
  }

  void whatIsOpenIsShownAsItWasRead() {
    OpenAsDialog dialog("/folder/face.exr", twoLayers(), {});
    OpenChoice read;
    read.source.layer = "albedo";
    read.source.colorSpace = "Display P3";
    read.source.mask = "/folder/mask.png";
    read.exposure = 0.71;
    dialog.showInterpretation(read);
    dialog.show();
    const OpenChoice choice = dialog.choice();
    QCOMPARE(choice.source.layer, read.source.layer);
    QCOMPARE(choice.source.colorSpace, read.source.colorSpace);
    QCOMPARE(choice.source.mask, read.source.mask);
    QCOMPARE(choice.exposure, std::optional<double>(0.71));
    QCOMPARE(openButton(dialog).text(), QString("&Apply"));
    dialog.close();
  }

  // Long names and many statements: at the smallest size the buttons below are inside, and all else
  // can be scrolled to.
  void nothingIsCutOffAtTheSmallestSize() {
    ImageInspection image = twoLayers();
    image.usualLayer = 1;
    image.layers[1].contradictions = {std::string(100, 'w') + " says something else"};
    OpenAsDialog dialog("/folder/" + std::string(200, 'n') + ".png", image, "Why");
    dialog.show();
    dialog.resize(dialog.minimumSizeHint());
    auto* scroll = dialog.findChild<QScrollArea*>();
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
      if (scroll->isAncestorOf(button)) scroll->ensureWidgetVisible(button, 0, 0);
      const QRect place(button->mapTo(&dialog, QPoint()), button->size());
      QVERIFY2(dialog.rect().contains(place), qPrintable(button->text()));
    }
    QVERIFY(dialog.width() <= 772);
    dialog.close();
  }
};

CUTIS_TEST(OpenAsDialogTest)

}  // namespace
}  // namespace cutis

#include "open_as_dialog_test.moc"
