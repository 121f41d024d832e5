#pragma once

// In which folder a dialog of files begins: where the last one of its kind was answered, today or
// before. Interface thread only.

#include <QString>

namespace cutis {

// kind: "open", "save". Empty while none is known, or where the folder has gone.
QString lastFolder(const QString& kind);
void rememberFolderOf(const QString& kind, const QString& file);
void forgetFolders();

}  // namespace cutis
