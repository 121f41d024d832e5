#pragma once  // internal to ui/documents

// How a page looks at its document, as a project keeps it.

#include "src/app/project/project.h"

namespace cutis {

class DocumentPage;

ProjectView projectViewOf(DocumentPage& page);
// What is not known, or not said, stays as it is usual.
void showProjectView(DocumentPage& page, const ProjectView& view);

}  // namespace cutis
