#pragma once

#include "LibraryEntry.h"

#include <insonate/core/Progress.h>

#include <QStringList>
#include <atomic>

namespace insonate::ui {

/// Folder in the user's cache that stores facts about cases between program starts.
QString libraryCache();

/// Returns, sorted, the folders that are cases among these folders and their direct subfolders.
QStringList casesIn(const QStringList& folders);

/// Returns the facts that are known without reading volumes: place, title and version; for a broken case, the reason.
LibraryEntry listedCase(const QString& place, bool builtIn);

/// Reads the case or its cached facts, and fills in images, grade and fitness. The cache's key depends on the case's
/// state and contains no names or paths. Takes seconds for a new case. Call it on a background thread. Returns null if
/// stopped.
LibraryEntry knownCase(LibraryEntry listed, const QString& cache, const Progress& progress);

}  // namespace insonate::ui
