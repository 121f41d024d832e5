// The rules on made-up snippets: that they let through what they should, and that they can fail.

#include "tests/architecture/house_rules.h"

#include <QtTest>

#include "tests/architecture/house_plan.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

std::string moduleOf(const std::string& header) {
  if (header == "QString" || header == "QtCore/QObject" || header == "QObject") return "QtCore";
  if (header == "QImage" || header == "QtGui/QImage") return "QtGui";
  if (header == "QWidget") return "QtWidgets";
  return {};
}

std::string included(const char* path, const char* name) {
  const bool own = std::string(name).find('<') == std::string::npos;
  const std::string line = own ? std::string("\"") + name + "\"" : std::string(name);
  const auto violations = checkIncludes({{path, "#include " + line + "\n"}}, moduleOf);
  return violations.empty() ? std::string() : violations.front();
}

class HouseRulesTest : public QObject {
  Q_OBJECT

 private slots:
  void includesAreFound() {
    const auto includes = includesOf(
        "#pragma once\n"
        "#include \"core/base/rect.h\"\n"
        "  #  include <vector>  // why\n"
        "// #include \"core/fit/no.h\"\n"
        "/* #include <no>\n#include <neither>\n*/ int x;\n"
        "#include <QtTest>\n"
        "const char* s = \"#include <no>\";\n");
    QCOMPARE(includes.size(), std::size_t{3});
    QCOMPARE(includes[0].name, std::string("core/base/rect.h"));
    QCOMPARE(includes[0].line, 2);
    QVERIFY(!includes[0].angled);
    QCOMPARE(includes[1].name, std::string("vector"));
    QVERIFY(includes[1].angled);
    QCOMPARE(includes[2].line, 8);
  }

  void foldersAreRooms() {
    QCOMPARE(roomOf("core/skin/profile/profile.h"), std::string("core/skin/profile"));
    QCOMPARE(roomOf("core/skin/response_model.h"), std::string("core/skin"));
    QCOMPARE(roomOf("resources/resource_data.h"), std::string("resources"));
    QCOMPARE(roomOf("tests/core/fit/a.h"), std::string("tests"));
    QCOMPARE(roomOf("profile.h"), std::string());
    QCOMPARE(roomOf("hwy/highway.h"), std::string());
    QCOMPARE(libraryOf("core/skin/profile/profile.h"), std::string("core/skin"));
    QCOMPARE(libraryOf("ui/docks/plot.h"), std::string("ui"));
    QCOMPARE(libraryOf("core/CMakeLists.txt"), std::string());
    QCOMPARE(libraryOf("hwy/highway.h"), std::string());
  }

  void coreRunsDownwards() {
    QVERIFY(mayInclude("core/transport", "core/maths"));
    QVERIFY(!mayInclude("core/spectra", "core/transport"));  // no chain: side by side
    QVERIFY(!mayInclude("core/transport", "core/spectra"));
    QVERIFY(mayInclude("core/fit", "core/rig") && !mayInclude("core/rig", "core/fit"));
    for (const char* beside : {"core/edit", "core/render"}) {
      QVERIFY(mayInclude(beside, "core/base") && mayInclude(beside, "core/skin"));
      QVERIFY(!mayInclude(beside, "core/rig") && !mayInclude(beside, "core/fit"));
      QVERIFY(!mayInclude(beside, "core/simulate") && !mayInclude("core/fit", beside));
    }
    QVERIFY(mayInclude("core/render", "core/edit") && !mayInclude("core/edit", "core/render"));
    QVERIFY(!mayInclude("core/simulate", "core/fit") && mayInclude("core/evaluate", "core/fit"));
    QVERIFY(!mayInclude("core/fit", "src/files") && !mayInclude("core/base", "resources"));
  }

  void theThirdLevelRunsDownwards() {
    // Skin: each part sees those before it, none sees the face.
    const char* parts[] = {"core/skin/profile", "core/skin/layers", "core/skin/model",
                           "core/skin/free", "core/skin"};
    for (int from = 0; from < 5; ++from) {
      for (int to = 0; to < 5; ++to)
        QCOMPARE(mayInclude(parts[from], parts[to]), to <= from);
    }
    // Fit: the methods stand on the run and are apart, but for free on refined.
    const char* methods[] = {"core/fit/table", "core/fit/refined", "core/fit/free",
                             "core/fit/spectra", "core/fit/reference"};
    for (const char* method : methods) {
      QVERIFY(mayInclude(method, "core/fit") && !mayInclude("core/fit", method));
      QVERIFY(mayInclude("core/analyse", method));
      for (const char* other : methods) {
        const bool same = std::string(method) == other;
        const bool stands =
            std::string(method) == "core/fit/free" && std::string(other) == "core/fit/refined";
        QCOMPARE(mayInclude(method, other), same || stands);
      }
    }
    QVERIFY(mayInclude("core/neural", "core/neural/dense"));
    QVERIFY(!mayInclude("core/neural/dense", "core/neural"));
    QVERIFY(!mayInclude("core/neural/dense", "core/skin/profile"));
    QVERIFY(!mayInclude("core/simulate/paint", "core/simulate"));
  }

  void sourceRunsDownwards() {
    QVERIFY(mayInclude("src/files", "core/fit/table") && mayInclude("src/files", "resources"));
    QVERIFY(mayInclude("src/files/profiles", "src/files"));
    QVERIFY(!mayInclude("src/files", "src/files/profiles"));
    QVERIFY(!mayInclude("src/files/profiles", "src/files/networks"));
    QVERIFY(!mayInclude("src/files/io", "src/files") && !mayInclude("src/files/io", "core/skin"));
    QVERIFY(mayInclude("src/images/maps", "src/images/codec"));
    QVERIFY(!mayInclude("src/images/codec", "src/images"));
    QVERIFY(!mayInclude("src/images/maps", "src/images/capture"));
    for (const char* reader : {"src/images", "src/color", "src/report"}) {
      QVERIFY(mayInclude(reader, "src/files/io") && !mayInclude("src/files", reader));
      QVERIFY(!mayInclude(reader, "src/app") && !mayInclude(reader, "ui/view"));
      QVERIFY(mayInclude("src/cli/commands", reader));
    }
    QVERIFY(mayInclude("src/images/color", "src/color"));
    QVERIFY(!mayInclude("src/color", "src/images") && !mayInclude("src/report", "core/skin"));
    QVERIFY(mayInclude("src/app/document", "src/app/open"));
    QVERIFY(!mayInclude("src/app/open", "src/app/document"));
    QVERIFY(mayInclude("src/app/export", "src/app/document"));
    QVERIFY(!mayInclude("src/app/document", "src/app/export"));
    QVERIFY(!mayInclude("src/app", "src/app/open") && !mayInclude("src/app/open", "src/cli"));
    QVERIFY(mayInclude("src/bench", "src/app/training") && !mayInclude("src/bench", "src/cli"));
    QVERIFY(!mayInclude("src/bench", "src/report") && !mayInclude("src/app", "src/bench"));
    QVERIFY(mayInclude("src/cli", "src/cli/options") && !mayInclude("src/cli/options", "src/cli"));
    QVERIFY(mayInclude("src/cli/commands/bench", "src/bench"));
    QVERIFY(!mayInclude("src/cli/commands/bench", "src/cli/commands/train"));
    QVERIFY(!mayInclude("src/cli", "src/cli/commands") && !mayInclude("src/cli", "ui/plot"));
  }

  void theWindowRunsDownwards() {
    for (const char* part : {"ui/theme", "ui/plot", "ui/widgets", "ui/view", "ui/docks",
                             "ui/dialogs", "ui/commands"}) {
      QVERIFY(mayInclude("ui/window", part) && mayInclude("src/cutis", part));
      QVERIFY(!mayInclude(part, "ui/window") && !mayInclude(part, "src/cutis"));
      QVERIFY(!mayInclude("src/app", part));
    }
    QVERIFY(mayInclude("ui/docks", "ui/view") && !mayInclude("ui/view", "ui/docks"));
    QVERIFY(!mayInclude("ui/docks", "ui/dialogs") && !mayInclude("ui/dialogs", "ui/docks"));
    QVERIFY(!mayInclude("ui/widgets", "ui/plot") && !mayInclude("ui/plot", "ui/widgets"));
    QVERIFY(mayInclude("ui/docks", "src/app/document") && !mayInclude("ui/plot", "src/app"));
    QVERIFY(!mayInclude("ui/window", "src/cli") && !mayInclude("ui/window", "src/bench"));
  }

  void librariesLinkWhatTheirRoomsInclude() {
    QVERIFY(mayLink("core/fit", "core/neural") && !mayLink("core/neural", "core/fit"));
    QVERIFY(mayLink("ui", "src/report") && !mayLink("src/report", "ui"));
    QVERIFY(mayLink("src/cutis", "ui") && !mayLink("core/spectra", "core/transport"));
  }

  void strangersHaveNoPlace() {
    for (const char* stranger : {"core/extra", "core/skin/extra", "src/extra", "tests"}) {
      QVERIFY(!mayInclude(stranger, "core/base") && !mayInclude("src/cutis", stranger));
    }
    const SourceTree tree = {{"core/extra/a.h", "#include <vector>\n"}};
    QCOMPARE(checkIncludes(tree, moduleOf).size(), std::size_t{1});
  }

  void wrongIncludesAreReported() {
    QCOMPARE(included("core/spectra/a.h", "core/skin/profile/profile.h"),
             std::string("core/spectra/a.h:1: core/spectra may not include core/skin/profile"));
    QVERIFY(!included("core/fit/a.cpp", "src/files/io/csv.h").empty());
    QVERIFY(!included("core/fit/a.cpp", "tests/support/expect.h").empty());
    QVERIFY(!included("src/files/a.cpp", "csv.h").empty());
    QVERIFY(!included("src/files/a.cpp", "../files/csv.h").empty());
    QVERIFY(included("src/files/a.cpp", "src/files/io/csv.h").empty());
    QVERIFY(included("src/files/a.cpp", "core/fit/table/skin_table.h").empty());
    QVERIFY(included("ui/view/a.cpp", "a.moc").empty());
  }

  void librariesHaveTheirRooms() {
    QVERIFY(!included("core/base/a.h", "<QString>").empty());
    QVERIFY(!included("core/base/a.h", "<qglobal.h>").empty());
    QVERIFY(included("core/base/a.h", "<queue>").empty());
    QVERIFY(included("core/base/a.h", "<Eigen/Core>").empty());
    QVERIFY(!included("core/skin/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/files/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/color/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/color/a.h", "<jpeglib.h>").empty());
    QVERIFY(included("src/images/a.h", "<jpeglib.h>").empty());
    QVERIFY(included("src/images/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/images/a.h", "<OpenColorIO/OpenColorIO.h>").empty());
    QVERIFY(included("src/color/a.h", "<OpenColorIO/OpenColorIO.h>").empty());
    QVERIFY(included("src/app/a.h", "<QString>").empty());
    QVERIFY(included("src/app/a.h", "<QtCore/QObject>").empty());
    QVERIFY(!included("src/app/a.h", "<QImage>").empty());
    QVERIFY(!included("src/app/a.h", "<QtGui/QImage>").empty());
    QVERIFY(!included("src/app/a.h", "<QUnknown>").empty());
    QVERIFY(included("src/report/a.h", "<QImage>").empty());
    QVERIFY(!included("src/report/a.h", "<QWidget>").empty());
    QVERIFY(included("ui/view/a.h", "<QWidget>").empty());
  }

  void eigenIsFoundHoweverFarAway() {
    const SourceTree tree = {
        {"core/skin/far.h", "#include <Eigen/Core>\n"},
        {"core/skin/near.h", "#include \"core/skin/far.h\"\n"},
        {"core/skin/plain.h", "#include \"core/skin/plain.h\"\n#include <array>\n"},
        {"core/skin/bad.cpp", "#include <hwy/foreach_target.h>\n#include \"core/skin/near.h\"\n"},
        {"core/skin/bad-inl.h", "#include \"core/skin/near.h\"\n"},
        {"core/skin/direct-inl.h", "#include <Eigen/Core>\n"},
        {"core/skin/good.cpp", "#include <hwy/foreach_target.h>\n#include \"core/skin/plain.h\"\n"},
        {"core/skin/free.cpp", "#include \"core/skin/near.h\"\n"},
    };
    const auto violations = checkVectorised(tree);
    QCOMPARE(violations.size(), std::size_t{3});
    QVERIFY(violations[1].find("bad.cpp → core/skin/near.h → core/skin/far.h → <Eigen/Core>") !=
            std::string::npos);
  }

  void wrongLinksAreReported() {
    QVERIFY(checkLinks("core/base: | TBB::tbb\ncore/skin: core/base core/spectra | hwy\n").empty());
    QVERIFY(checkLinks("src/app: core/fit src/images | Qt6::Core\n").empty());
    QVERIFY(checkLinks("src/images: core/base | PkgConfig::OpenImageIO\n").empty());
    for (const char* bad :
         {"core/skin: core/fit", "core/edit: core/base core/rig", "src/files: src/images",
          "core/base: | Qt6::Core", "src/files: | PkgConfig::OpenImageIO",
          "src/color: | PkgConfig::libjpeg", "src/images: | PkgConfig::OpenColorIO",
          "src/app: | Qt6::Core Qt6::Gui", "src/report: | Qt6::Widgets", "core/new: core/base",
          "nonsense"}) {
      QCOMPARE(checkLinks(bad).size(), std::size_t{1});
    }
  }

  void styleIsChecked() {
    const std::string word = std::string("TO") + "DO";
    QVERIFY(checkStyle("a.h", "int x;\n").empty());
    QCOMPARE(checkStyle("a.h", "int x;\n\tint y;\n").front(), std::string("a.h:2: a tab"));
    QVERIFY(!checkStyle("a.h", "// " + word + ": later\n").empty());
    QVERIFY(!checkStyle("a.h", std::string("// X") + "XX\n").empty());
    QVERIFY(checkStyle("a.h", "path = \"cutis-XXXXXX\"; // " + word + "S\n").empty());
    std::string longText;
    for (int i = 0; i < kMaximumLines; ++i)
      longText += "\n";
    QVERIFY(checkStyle("a.h", longText).empty());
    QCOMPARE(checkStyle("a.h", longText + "\n").size(), std::size_t{1});
  }
};

CUTIS_TEST(HouseRulesTest)

}  // namespace
}  // namespace cutis::test

#include "house_rules_test.moc"
