#pragma once

#include "LibraryEntry.h"

#include <insonate/core/Progress.h>

#include <QStringList>
#include <atomic>

namespace insonate::ui {

/// Folder in which facts about cases are kept between starts: in the user's cache.
QString libraryCache();

/// Folders of cases in these folders and in theirs, sorted; a folder that is a case itself counts.
QStringList casesIn(const QStringList& folders);

/// Facts that are known without reading volumes: place, title, version; for a broken case, the reason.
LibraryEntry listedCase(const QString& place, bool builtIn);

/// Reads the case, or its entry in `cache`, and fills in images, grade and fitness. Cached under a key of the case's
/// state, without names or places. Takes seconds for a new case. For a thread of its own; null when stopped.
LibraryEntry knownCase(LibraryEntry listed, const QString& cache, const Progress& progress);

}  // namespace insonate::ui
