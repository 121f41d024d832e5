// What views say of their samples beside the values, on the embedded sample.

#include <algorithm>

#include <QSignalSpy>
#include <QtTest>

#include "src/app/document/document.h"
#include "src/app/views/view_server.h"
#include "tests/support/expect.h"
#include "tests/support/rendered_view.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace view_marks {

constexpr int kPatienceMs = 120000;
constexpr PixelMarks kEvery = kNotSkin | kAtBound | kMostlyPrior;
const ViewRequest kBlend = {ViewKind::melaninBlend, {0, 0, 1024, 1024}, 4, kEvery};

std::size_t countOf(const ViewPart& part, PixelMark mark) {
  return static_cast<std::size_t>(std::count_if(part.marks.begin(), part.marks.end(),
                                                [&](PixelMarks marks) { return marks & mark; }));
}

class ViewMarksTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), kPatienceMs);
    QTRY_VERIFY(jobs_.isIdle());
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  // The sample is skin: few of its pixels are unlike it, and those that are not there are nothing.
  void everySampleHasItsMarks() {
    const ViewPart part = rendered(kBlend);
    QCOMPARE(part.marks.size(), part.pixels.present.size());
    const auto skin = static_cast<double>(
        std::count(part.pixels.present.begin(), part.pixels.present.end(), true));
    QVERIFY(skin > 0);
    EXPECT_AT_MOST(static_cast<double>(countOf(part, kNotSkin)) / skin, 0.1);
    for (std::size_t i = 0; i < part.marks.size(); ++i)
      QVERIFY(part.pixels.present[i] || part.marks[i] == 0);
  }

  // Of a step of two, every other one of a step of one.
  void marksFollowTheSamples() {
    ViewRequest fine = kBlend;
    fine.rect = {256, 300, 352, 364};
    fine.step = 1;
    ViewRequest coarse = fine;
    coarse.step = 2;
    const ViewPart all = rendered(fine), some = rendered(coarse);
    QCOMPARE(all.marks.size(), std::size_t{96 * 64});
    QCOMPARE(some.marks.size(), std::size_t{48 * 32});
    for (std::size_t y = 0; y < 32; ++y) {
      for (std::size_t x = 0; x < 48; ++x)
        QCOMPARE(some.marks[y * 48 + x], all.marks[2 * y * 96 + 2 * x]);
    }
  }

  void onlyWhatIsWantedIsSaid() {
    ViewRequest request = kBlend;
    request.marks = kAtBound;
    const ViewPart part = rendered(request), every = rendered(kBlend);
    QCOMPARE(countOf(part, kNotSkin) + countOf(part, kMostlyPrior), std::size_t{0});
    QCOMPARE(countOf(part, kAtBound), countOf(every, kAtBound));
    request.marks = 0;
    QVERIFY(rendered(request).marks.empty());
  }

  // They are of what was measured.
  void editsDoNotChangeThem() {
    const ViewPart before = rendered(kBlend);
    document_.apply({"blend", {}, [](DocumentState& state) {
                       state.edits.emplace_back().parameters[kMelaninBlend].scale = 0.0;
                     }});
    const ViewPart after = rendered(kBlend);
    document_.undo();
    QVERIFY(before.pixels.channels != after.pixels.channels);
    QVERIFY(before.marks == after.marks);
  }

  void aPictureHasThoseOfThePixelAsAWhole() {
    ViewRequest request = kBlend;
    request.view = ViewKind::photograph;
    const ViewPart photograph = rendered(request), map = rendered(kBlend);
    QCOMPARE(countOf(photograph, kNotSkin), countOf(map, kNotSkin));
    QCOMPARE(countOf(photograph, kAtBound), std::size_t{0});
  }

  // While a control moves parts are coarse, and so are the marks.
  void theServerHandsThemOut() {
    std::vector<std::shared_ptr<const ViewPart>> parts;
    const auto watch =
        server_.watch(ViewPriority::detail, [&](const auto& part) { parts.push_back(part); });
    watch->want(kBlend);
    QTRY_VERIFY(!parts.empty());
    document_.apply({"blend",
                     {},
                     [](DocumentState& state) {
                       state.edits.emplace_back().parameters[kMelaninBlend].scale = 0.5;
                     },
                     true});
    const auto coarse = [&] {
      return std::find_if(parts.begin(), parts.end(),
                          [](const auto& part) { return part->request.step == 8; });
    };
    QTRY_VERIFY(coarse() != parts.end());
    QCOMPARE((*coarse())->marks.size(), (*coarse())->pixels.present.size());
    document_.undo();
    QTRY_VERIFY(server_.isIdle());
    QVERIFY(parts.back()->marks == parts.front()->marks);
  }

 private:
  ViewPart rendered(const ViewRequest& request) {
    return test::renderedView(document_.scene(), engine_, {}, request).value();
  }

  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
};

CUTIS_TEST(ViewMarksTest)

}  // namespace view_marks
}  // namespace cutis

#include "view_marks_test.moc"
