// Projects on the command line: the same pixels as the source with the same options.

#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kManifest[] = R"({"cutis_project": 1,
  "source": {"kind": "image", "path": "skin.png", "files": [], "lights": [], "exposure": "auto"},
  "fit": {"profile": "skin2026", "method": "refined", "shading": false}, "maps": null,
  "edits": [{"name": "Pale", "melanin": {"mode": "scale", "value": 0.5}}], "regions": [],
  "view": {"view": "skin", "place": null, "light": "D65", "observer": "cie1931"}})";

bool says(const Outcome& outcome, const std::string& part) {
  return outcome.errors.find(part) != std::string::npos ||
         outcome.output.find(part) != std::string::npos;
}

class ProjectTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.writeImage("skin.png", skinTexture(24, 16, {"R", "G", "B"}), SampleType::uint8);
    run_.write("face.cutis", kManifest);
  }

  void appliedItIsTheSourceWithItsEdits() {
    QCOMPARE(run_.run("apply skin.png -o a.png --profile skin2026 --melanin 0.5 --quiet").status,
             0);
    QCOMPARE(run_.run("apply face.cutis -o b.png --quiet").status, 0);
    QCOMPARE(run_.read("b.png"), run_.read("a.png"));
    // The options' edit comes after those of the project.
    QCOMPARE(run_.run("apply skin.png -o c.png --profile skin2026 --melanin 0.25 --quiet").status,
             0);
    QCOMPARE(run_.run("apply face.cutis -o d.png --melanin 0.5 --quiet").status, 0);
    QCOMPARE(run_.read("d.png"), run_.read("c.png"));
  }

  void infoSaysWhatIsInIt() {
    const Outcome outcome = run_.run("info face.cutis");
    EXPECT_DONE(outcome);
    for (const char* part : {"kind: project\n", "skin.png\n", "exposure: chosen by each fit\n",
                             "profile: skin2026\n", "method: refined\n", "maps: not fitted yet\n",
                             "edit: Pale: melanin × 0.5\n", "light: D65\n"}) {
      QVERIFY2(says(outcome, part), (part + outcome.output).c_str());
    }
  }

  void whatCannotBeIsRefused_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* command, const char* sentence) {
      QTest::newRow(command) << command << sentence;
    };
    row("apply face.cutis -o o.png --maps m.exr", "--maps: a project says itself how");
    row("apply face.cutis -o o.png --profile li2024", "--profile: a project says itself how");
    row("apply face.cutis -o skin.png", "sources are never written to");
    row("apply later.cutis -o o.png", "cutis_project is 2, written by a newer version");
    row("apply lost.cutis -o o.png", "gone.png is not there; put it back, or open the project");
    row("apply maps.cutis -o o.png", "maps alone, which hold no albedo");
    row("apply both.cutis -o o.png", "both.cutis: fit: Discrepancy: it does not go with free");
    row("apply noise.cutis -o o.png", "noise.cutis: fit.noise must be a list of 2 finite numbers");
  }

  void whatCannotBeIsRefused() {
    run_.write("later.cutis", R"({"cutis_project": 2})");
    std::string lost = kManifest;
    lost.replace(lost.find("skin.png"), 8, "gone.png");
    run_.write("lost.cutis", lost);
    std::string maps = kManifest;
    maps.replace(maps.find("\"image\""), 7, "\"maps\"");
    run_.write("maps.cutis", maps);
    writeFit("both.cutis", R"("free": ["thickness"], "discrepancy": true)");
    writeFit("noise.cutis", R"("noise": [0.001, "x"])");
    QFETCH(QString, command);
    QFETCH(QString, sentence);
    const Outcome outcome = run_.run(command);
    QVERIFY(outcome.status == 2 || outcome.status == 3);
    QVERIFY2(isOneError(outcome.errors), outcome.errors.c_str());
    QVERIFY2(says(outcome, sentence.toStdString()), outcome.errors.c_str());
  }

  // It is read before this is known.
  void whatTheProfileDoesNotAllowIsRefused() {
    writeFit("held.cutis", R"("fixed": {"melanin": 9})");
    const Outcome outcome = run_.run("apply held.cutis -o o.png");
    QCOMPARE(outcome.status, 3);
    QVERIFY2(says(outcome, "held.cutis: fit: Held parameters: melanin of 9 is out of range"),
             outcome.errors.c_str());
  }

 private:
  // The manifest with one more choice of the fit.
  void writeFit(const std::string& name, const std::string& choice) const {
    std::string text = kManifest;
    text.insert(text.find("\"shading\""), choice + ", ");
    run_.write(name, text);
  }

  ProgramRun run_;
};

CUTIS_TEST(ProjectTest)

}  // namespace
}  // namespace cutis::test

#include "project_test.moc"
