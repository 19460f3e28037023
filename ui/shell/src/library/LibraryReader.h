#pragma once

#include "LibraryEntry.h"

#include <insonate/core/Progress.h>

#include <QStringList>
#include <atomic>

namespace insonate::ui {

/// Folder in the user's cache that stores facts about cases between program starts.
QString libraryCache();

/// Returns those folders that contain a case, sorted; searches the given folders and their direct subfolders.
QStringList casesIn(const QStringList& folders);

/// Returns the facts that are known without reading volumes: folder, title and version; for a case that cannot be read,
/// the reason.
LibraryEntry listedCase(const QString& place, bool builtIn);

/// Reads the case or its cached facts, and adds images, grade and fitness for training. The cache's key depends on the
/// case's state and contains no names or paths. Takes seconds for a new case. Call it on a background thread. Returns
/// null if stopped.
LibraryEntry knownCase(LibraryEntry listed, const QString& cache, const Progress& progress);

}  // namespace insonate::ui
