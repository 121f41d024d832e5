#include "core/base/content_hash.h"

#include <array>
#include <set>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class ContentHashTest : public QObject {
  Q_OBJECT

 private slots:
  // XXH3, 128 bits, seed 0, of nothing and of one zero byte (xxHash 0.8,
  // tests/sanity_test_vectors).
  void isXxh3() {
    QCOMPARE(ContentHash().digest(), std::string("99aa06d3014798d86001c324468d497f"));
    const std::array<std::byte, 1> zero = {};
    QCOMPARE(ContentHash().add(std::span<const std::byte>(zero)).digest(),
             std::string("a6cd5e9392000f6ac44bdff4074eecdb"));
  }

  void bytesMayComeInPieces() {
    std::array<std::byte, 1000> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      bytes[i] = static_cast<std::byte>(i * 7);
    const std::span<const std::byte> all(bytes);
    const std::string whole = ContentHash().add(all).digest();
    for (const std::size_t cut : {0, 1, 255, 999, 1000}) {
      QCOMPARE(ContentHash().add(all.first(cut)).add(all.subspan(cut)).digest(), whole);
    }
  }

  void textsAreKeptApart() {
    const auto of = [](std::initializer_list<std::string_view> texts) {
      ContentHash hash;
      for (const std::string_view text : texts)
        hash.add(text);
      return hash.digest();
    };
    const std::set<std::string> digests = {of({"ab", "c"}), of({"a", "bc"}), of({"abc"}),
                                           of({"", "abc"}), of({"abc", ""}), of({}),
                                           of({""})};
    QCOMPARE(digests.size(), std::size_t{7});
    QCOMPARE(of({"ab", "c"}), of({"ab", "c"}));
  }

  void everyBitOfANumberCounts() {
    const std::string one = ContentHash().add(1.0).digest();
    QVERIFY(ContentHash().add(std::nextafter(1.0, 2.0)).digest() != one);
    QVERIFY(ContentHash().add(0.0).digest() != ContentHash().add(-0.0).digest());
    const std::array<double, 3> values = {1.0, 2.0, 3.0};
    QCOMPARE(ContentHash().add(std::span<const double>(values)).digest(),
             ContentHash().add(1.0).add(2.0).add(3.0).digest());
  }

  // Names of cached files: they must never change from one version to the next unnoticed.
  void digestsAreStable() {
    QCOMPARE(ContentHash().add(std::string_view("melanin")).add(0.5).digest(),
             std::string("908646dff35ef5ce924ca61d5df21f1e"));
  }

  void askingTwiceChangesNothing() {
    ContentHash hash;
    hash.add(std::string_view("skin"));
    const std::string first = hash.digest();
    QCOMPARE(hash.digest(), first);
    QCOMPARE(first.size(), std::size_t{32});
  }
};

CUTIS_TEST(ContentHashTest)

}  // namespace
}  // namespace cutis

#include "content_hash_test.moc"
