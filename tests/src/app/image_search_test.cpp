#include "src/app/open/image_search.h"

#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

class ImageSearchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesTellMasks() {
    for (const char* name : {"mask.png", "face_mask.tif", "face-Mask.exr", "face (mask).png"})
      QCOMPARE(isNamedMask(name), std::string(name) != "face (mask).png");
    for (const char* name : {"mask.png", "face_mask.tif", "faceMask.exr", "mask of face.png",
                             "Mask2.png", "face (mask).png"})
      QVERIFY2(mayBeMask(name), name);
    for (const char* name : {"damask.png", "unmasked.png", "masked.png", "face.png", "mask.txt"})
      QVERIFY2(!mayBeMask(name), name);
  }

  void theMaskOfItsNameComesFirst() {
    const ScratchFolder folder;
    for (const char* name : {"face.png", "mask.png", "face_mask.tif", "arm.png"})
      folder.write(name, "");
    QCOMPARE(maskBeside(folder / "face.png"), folder / "face_mask.tif");
    QCOMPARE(maskBeside(folder / "arm.png"), folder / "mask.png");
    QCOMPARE(photographsIn(folder.path()).size(), std::size_t{2});
  }
};

CUTIS_TEST(ImageSearchTest)

}  // namespace
}  // namespace cutis::test

#include "image_search_test.moc"
