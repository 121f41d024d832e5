#include "src/files/profiles/profile_edit.h"

#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class ProfileEditTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingIsChangedUnasked_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : profileNames()) {
      QTest::addRow("%s", name.c_str()) << QString::fromStdString(name);
    }
  }
  void nothingIsChangedUnasked() {
    QFETCH(QString, name);
    const std::string text = profileText(name.toStdString(), "").value();
    const Profile before = parseProfile(text, "before").value();
    const std::string again = editedProfile(text, {});
    const Profile after = parseProfile(again, "after").value();
    QCOMPARE(fingerprint(after), fingerprint(before));
    QVERIFY((after.prior.mean == before.prior.mean).all());
    QCOMPARE(editedProfile(again, {}), again);
    // A prior that is written is the prior that is read.
    ProfileEdits edits;
    edits.prior = before.prior;
    const Profile rewritten = parseProfile(editedProfile(text, edits), "prior").value();
    QVERIFY((rewritten.prior.mean == before.prior.mean).all());
    QVERIFY((rewritten.prior.deviation == before.prior.deviation).all());
    QVERIFY(rewritten.prior.correlation == before.prior.correlation);
    QVERIFY(rewritten.prior.staysLinear == before.prior.staysLinear);
  }

  void fieldsAreFoundByTheirPath() {
    const std::string text = profileText("skin2026", "").value();
    const Profile profile = parseProfile(text, "skin2026").value();
    QCOMPARE(profileNumber(text, "dermis.blood.oxygenation", "p").value(),
             profile.dermalBlood.oxygenation);
    for (const char* field : {"dermis", "dermis.blood", "dermis.blood.age", "name", "", "a.b.c"}) {
      const auto none = profileNumber(text, field, "p");
      QVERIFY2(none.failed(), field);
      QVERIFY(none.error().text().find(std::string("'") + field + "'") != std::string::npos);
    }
  }

  void editsArrive() {
    const std::string text = profileText("skin2026", "").value();
    ProfileEdits edits;
    edits.numbers = {{"epidermis.thickness_mm", 0.123}, {"dermis.blood.oxygenation", 0.5}};
    edits.name = "mine";
    edits.description = "a \"test\"";
    edits.sources = {{"epidermis.thickness_mm", "Guessed."}};
    const std::string edited = editedProfile(text, edits);
    const Profile profile = parseProfile(edited, "edited").value();
    QCOMPARE(profile.epidermalThicknessMm, 0.123);
    QCOMPARE(profile.dermalBlood.oxygenation, 0.5);
    QCOMPARE(profile.name, std::string("mine"));
    QCOMPARE(profile.description, edits.description);
    QVERIFY(edited.find("\"epidermis.thickness_mm\": \"Guessed.\"") != std::string::npos);
  }
};

CUTIS_TEST(ProfileEditTest)

}  // namespace
}  // namespace cutis

#include "profile_edit_test.moc"
