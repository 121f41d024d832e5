// Manifests of projects: written and read they are the same; paths are relative; what a manifest
// may not say is refused with the field's name.

#include "src/app/project/manifest.h"

#include <QtTest>

#include "tests/src/app/project_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

namespace fs = std::filesystem;

Project fullProject() {
  Project project;
  ProjectSource& source = project.source;
  source.kind = SourceKind::image;
  source.path = "/work/faces/face.exr";
  source.options.mask = "/work/masks/mask.png";
  source.options.rig = "/work/rigs/studio.json";
  source.options.layer = "diffuse";
  source.options.colorSpace = "ACEScg";
  source.files = {{"/work/faces/face.exr", "0123"}, {"/work/masks/mask.png", "4567"}};
  project.fit = {
      "/work/profiles/mine.json", FitMethod::threeStage, true, 0.7, SpecularPart::included, 0.03};
  project.edits.emplace_back();
  project.edits.front().name = "Tan";
  project.edits.front().parameters[kMelanin].scale = 1.4;
  project.view = {"melanin", ViewPlace{12.5, 3.25, 0.75}, "/work/lights/lamp.csv", "cie1964",
                  "bradford"};
  project.maps = "/work/projects/face.cutis.data/89ab.exr";
  project.pins = {{{"A", "cheek", 812, 440}, {"C", "", -3, 0}}, 5, "C"};
  return project;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  return at == std::string::npos ? "test is wrong: " + from : text.replace(at, from.size(), to);
}

class ManifestTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsWrittenIsReadAgain() {
    const std::string text = projectText(fullProject(), "/work/projects");
    const auto read = parseProject(text, "/work/projects/face.cutis", {});
    EXPECT_OK(read);
    const Project& project = read.value();
    const Project wanted = fullProject();
    QCOMPARE(project.source.path, wanted.source.path);
    QCOMPARE(project.source.options.mask, wanted.source.options.mask);
    QCOMPARE(project.source.options.rig, wanted.source.options.rig);
    QCOMPARE(project.source.files.size(), std::size_t{2});
    QCOMPARE(project.source.files[1].hash, std::string("4567"));
    QVERIFY(project.fit == wanted.fit);
    QVERIFY(project.view == wanted.view);
    QCOMPARE(project.maps, wanted.maps);
    QVERIFY(project.pins == wanted.pins);
    QCOMPARE(projectText(project, "/work/projects"), text);
  }

  void aProjectWithoutPinsSaysNothingOfThem() {
    Project project = fullProject();
    project.pins = {};
    const std::string text = projectText(project, "/work/projects");
    QVERIFY2(text.find("pin") == std::string::npos, text.c_str());
    const auto read = parseProject(text, "/work/projects/face.cutis", {});
    EXPECT_OK(read);
    QVERIFY(read.value().pins == PinSet());
  }

  // A project that moves along with its source finds it.
  void pathsAreRelative() {
    const std::string text = projectText(fullProject(), "/work/projects");
    QVERIFY2(text.find("/work") == std::string::npos, text.c_str());
    const auto moved = parseProject(text, "/home/me/projects/face.cutis", {});
    EXPECT_OK(moved);
    QCOMPARE(moved.value().source.path, fs::path("/home/me/faces/face.exr"));
    QCOMPARE(moved.value().fit.profile, std::string("/home/me/profiles/mine.json"));
    QCOMPARE(moved.value().view.light, std::string("/home/me/lights/lamp.csv"));
    QCOMPARE(moved.value().view.observer, std::string("cie1964"));
  }

  void aJournalNamesFilesAbsolutely() {
    const std::string text = projectText(fullProject(), {});
    const auto read = parseProject(text, "/somewhere/else.cutis", {});
    EXPECT_OK(read);
    QCOMPARE(read.value().source.path, fullProject().source.path);
    QCOMPARE(projectText(read.value(), {}), text);
  }

  void aJournalNamesItsProject() {
    Project project = fullProject();
    project.editsOf = "/work/projects/face.cutis";
    const auto read = parseProject(projectText(project, {}), "/somewhere/else.cutis", {});
    EXPECT_OK(read);
    QCOMPARE(read.value().editsOf, project.editsOf);
  }

  void sampleAndMapsHaveLess() {
    Project project;
    const auto sample = parseProject(projectText(project, "/a"), "/a/b.cutis", {});
    EXPECT_OK(sample);
    QVERIFY(sample.value().source.kind == SourceKind::sample);
    project.source = {SourceKind::maps, "/a/maps.exr", {}, {{"/a/maps.exr", "01"}}};
    const auto maps = parseProject(projectText(project, "/a"), "/a/b.cutis", {});
    EXPECT_OK(maps);
    QVERIFY(maps.value().source.kind == SourceKind::maps);
    QCOMPARE(maps.value().source.path, fs::path("/a/maps.exr"));
  }

  void whatAManifestMayNotSayIsRefused_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* name, const char* from, const char* to, const char* sentence) {
      QTest::newRow(name) << from << to << sentence;
    };
    row("newer", "\"cutis_project\": 1", "\"cutis_project\": 2",
        "face.cutis: cutis_project is 2, written by a newer version of Cutis; this one reads up to "
        "1");
    row("another file", "\"cutis_project\": 1", "\"cutis_rig\": 1",
        "the field \"cutis_project\": 1 is missing");
    row("kind", "\"image\"", "\"movie\"", "source.kind must be \"sample\", \"image\"");
    row("no path", "\"../faces/face.exr\",\n    \"files\"", "\"\",\n    \"files\"",
        "source.path must be the path of what was opened");
    row("exposure", "0.7", "-0.7", "source.exposure must be \"auto\" or a number above 0");
    row("method", "three-stage", "magic", "fit.method");
    row("place", "0.75", "0.0", "view.place must be x, y and a zoom above 0");
    row("edit", "\"scale\"", "\"match\"", "edits[0].melanin.mode must be");
    row("letter", "\"letter\": \"C\"", "\"letter\": \"A\"", "pins[1].letter must be a letter");
    row("no letter", "\"letter\": \"C\"", "\"letter\": \"c\"", "pins[1].letter must be a letter");
    row("far", "812", "1e9", "pins[0].place must be x and y in pixels");
    row("size", "\"pin_size\": 5", "\"pin_size\": 4", "pin_size must be 1, 3, 5 or 11");
    row("regions", "\"regions\": []", "\"regions\": [{}]", "regions must be empty");
    row("not JSON", "\"view\"", "view", "not valid JSON");
  }

  void whatAManifestMayNotSayIsRefused() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, sentence);
    const std::string text =
        changed(projectText(fullProject(), "/work/projects"), from.toStdString(), to.toStdString());
    EXPECT_ERROR(parseProject(text, "face.cutis", {}), sentence.toStdString());
  }

  void fieldsOfLaterVersionsAreNoted() {
    std::vector<std::string> notes;
    const std::string text =
        changed(projectText(fullProject(), "/a"), "\"fit\": {", "\"mood\": 1, \"fit\": {\"b\": 2,");
    EXPECT_OK(parseProject(text, "face.cutis",
                           [&](const std::string& sentence) { notes.push_back(sentence); }));
    QCOMPARE(notes.size(), std::size_t{2});
    QCOMPARE(notes[0],
             std::string("face.cutis: 'mood' means nothing to this version and is passed over"));
    QVERIFY(notes[1].find("'fit.b'") != std::string::npos);
  }
};

CUTIS_TEST(ManifestTest)

}  // namespace
}  // namespace cutis::test

#include "manifest_test.moc"
