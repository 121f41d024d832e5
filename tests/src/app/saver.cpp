// Saves a project and writes a journal, again and again with other edits and other maps, until it
// is killed: saver IMAGE PROJECT JOURNALS. Says so once it has saved for the first time.

#include <cstdio>

#include <QCoreApplication>

#include "src/app/project/journal.h"
#include "src/app/project/manifest.h"
#include "src/app/project/project_save.h"
#include "tests/src/app/project_fixture.h"

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc != 4) return 2;
  auto journals = cutis::JournalFolder::open(argv[3]);
  if (!journals) return 1;
  const auto journal = journals.value()->add();
  cutis::Project project = cutis::test::projectOf(argv[1]);
  for (int n = 1;; ++n) {
    project.edits.front().parameters[cutis::kMelanin].scale = 1.0 + 0.01 * (n % 100);
    const cutis::MapsFile maps = cutis::test::mapsOfTexture(1.0 / n);
    if (!cutis::saveProject(argv[2], project, &maps, {})) return 1;
    if (!journal->write(journal->nextTurn(), cutis::projectText(project, {}))) return 1;
    if (n == 1) std::puts("saving");
    std::fflush(stdout);
  }
}
