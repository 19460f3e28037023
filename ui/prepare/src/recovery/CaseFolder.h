#pragma once

#include <insonate/ui/Workspace.h>

#include <QFileInfo>
#include <QString>

namespace insonate::prepare {

/// Returns the folder from which a case can be read again, also if it is a version or was downloaded; empty if there is
/// none. Links are resolved, so that a folder has only one name.
inline QString folderOf(const ui::CaseOrigin& origin) {
  const QString& folder = origin.folder.isEmpty() ? origin.readFrom : origin.folder;
  return folder.isEmpty() ? QString() : QFileInfo(folder).canonicalFilePath();
}

}  // namespace insonate::prepare
