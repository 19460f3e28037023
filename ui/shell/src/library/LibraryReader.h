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

/// Reads the case, or what is kept of it in `cache`, and fills in the rest: images, grade, fitness. Kept under what
/// tells states of a case apart, without names or places. Takes seconds for a case that is new. For a thread of its
/// own; null when told to stop.
LibraryEntry knownCase(LibraryEntry listed, const QString& cache, const Progress& progress);

}  // namespace insonate::ui
