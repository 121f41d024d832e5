// The check on TIFF files made by hand, in all four forms a TIFF has.

#include "src/images/inputs/tiff_check.h"

#include <QtTest>

#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

enum class Type { uint16 = 3, uint32 = 4, ascii = 2, uint64 = 16 };

struct Tag {
  int name = 0;
  Type type = Type::uint32;
  std::vector<quint64> values = {};
};

// Header, one directory, and after it what does not fit into the directory.
class Tiff {
 public:
  Tiff(bool isBig, bool littleEndian) : isBig_(isBig), littleEndian_(littleEndian) {}

  QByteArray make(const std::vector<Tag>& tags) const {
    const int word = isBig_ ? 8 : 4;
    QByteArray head = littleEndian_ ? "II" : "MM";
    if (isBig_) {
      head += number(43, 2) + number(8, 2) + number(0, 2) + number(16, 8) + number(tags.size(), 8);
    } else {
      head += number(42, 2) + number(8, 4) + number(tags.size(), 2);
    }
    const qsizetype entryBytes = 4 + 2 * word;
    const qsizetype end = head.size() + static_cast<qsizetype>(tags.size()) * entryBytes + word;
    QByteArray outside;
    for (const Tag& tag : tags) {
      QByteArray list;
      for (const quint64 value : tag.values)
        list += number(value, bytesOf(tag.type));
      head += number(static_cast<quint64>(tag.name), 2) +
              number(static_cast<quint64>(tag.type), 2) + number(tag.values.size(), word);
      if (list.size() <= word) {
        head += list.leftJustified(word, '\0');
      } else {
        head += number(static_cast<quint64>(end + outside.size()), word);
        outside += list;
      }
    }
    return head + QByteArray(word, '\0') + outside;
  }

 private:
  static int bytesOf(Type type) {
    if (type == Type::ascii) return 1;
    return type == Type::uint16 ? 2 : type == Type::uint32 ? 4 : 8;
  }
  QByteArray number(quint64 value, int bytes) const {
    QByteArray digits(bytes, '\0');
    for (int i = 0; i < bytes; ++i) {
      digits[littleEndian_ ? i : bytes - 1 - i] = static_cast<char>(value >> (8 * i));
    }
    return digits;
  }

  bool isBig_;
  bool littleEndian_;
};

class TiffCheckTest : public QObject {
  Q_OBJECT

  test::ImageFolder folder_;

  Status check(const QByteArray& bytes) {
    test::writeBytes(folder_.path("a.tif"), bytes);
    return checkTiffExtent(folder_.path("a.tif"));
  }

 private slots:
  void everyByteIsMissed_data() {
    QTest::addColumn<bool>("isBig");
    QTest::addColumn<bool>("littleEndian");
    for (const bool isBig : {false, true}) {
      for (const bool littleEndian : {false, true}) {
        QTest::addRow("%s, %s", isBig ? "BigTIFF" : "TIFF", littleEndian ? "II" : "MM")
            << isBig << littleEndian;
      }
    }
  }
  void everyByteIsMissed() {
    QFETCH(bool, isBig);
    QFETCH(bool, littleEndian);
    const Tiff tiff(isBig, littleEndian);
    const Type wide = isBig ? Type::uint64 : Type::uint32;
    // One strip whose place stands in the directory, then several whose places lie outside; as
    // strips and as tiles.
    for (const auto& [offsets, counts] : {std::pair{273, 279}, std::pair{324, 325}}) {
      for (const std::vector<quint64>& lengths : {std::vector<quint64>{300}, {100, 0, 77, 2000}}) {
        for (const Type narrow : {Type::uint16, Type::uint32}) {
          const auto made = [&](quint64 start) {
            std::vector<quint64> places;
            for (const quint64 length : lengths) {
              places.push_back(start);
              start += length;
            }
            return tiff.make(
                {{256, Type::uint16, {10}}, {offsets, wide, places}, {counts, narrow, lengths}});
          };
          const auto header = static_cast<quint64>(made(0).size());
          quint64 total = 0;
          for (const quint64 length : lengths)
            total += length;
          const QByteArray whole = made(header) + QByteArray(static_cast<qsizetype>(total), 'x');
          EXPECT_OK(check(whole));
          EXPECT_OK(check(whole + "more"));
          EXPECT_ERROR(check(whole.chopped(1)), "a.tif: the TIFF file is cut off");
          EXPECT_ERROR(check(whole.left(static_cast<qsizetype>(header))), "cut off");
          // Lists outside the directory are cut off themselves.
          if (lengths.size() > 1) {
            EXPECT_ERROR(check(whole.left(static_cast<qsizetype>(header) - 1)), "cut off");
          }
        }
      }
    }
  }

  void absurdNumbersAreNoTrouble() {
    const quint64 huge = ~quint64{0};
    const Tiff big(true, true), small(false, true);
    EXPECT_ERROR(check(big.make({{273, Type::uint64, {huge}}, {279, Type::uint64, {huge}}})),
                 "cut off");
    EXPECT_ERROR(check(big.make({{273, Type::uint64, {8}}, {279, Type::uint64, {huge}}})),
                 "cut off");
    QByteArray manyStrips = small.make({{273, Type::uint32, {1}}, {279, Type::uint32, {1}}});
    manyStrips.replace(10 + 4, 4, "\xff\xff\xff\xff");  // the count of the first entry
    EXPECT_ERROR(check(manyStrips), "cut off");
  }

  // The decoder knows better what to say of these.
  void whatIsNotAboutLengthIsLeftToTheDecoder() {
    const Tiff tiff(false, true);
    EXPECT_OK(check("II*"));
    EXPECT_OK(check(QByteArray("II*\0\xff\xff\xff\xff", 8)));
    EXPECT_OK(check(tiff.make({{256, Type::uint16, {10}}})));
    EXPECT_OK(check(tiff.make({{273, Type::uint32, {5000}}})));
    EXPECT_OK(check(tiff.make({{273, Type::ascii, {'a'}}, {279, Type::ascii, {'b'}}})));
  }
};

CUTIS_TEST(TiffCheckTest)

}  // namespace
}  // namespace cutis

#include "tiff_check_test.moc"
