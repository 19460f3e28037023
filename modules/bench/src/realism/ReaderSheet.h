#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// Files of one numbered image that readers see: one for a still, several for a clip.
struct SheetItem {
  std::vector<std::string> files;  ///< paths of the files, relative to the page
};

/// Returns the page on which readers rate a set: protocol, one image after another with six ratings, and a file to
/// save. The page needs no network and no other program than a browser. `key` names the set, so that a browser can
/// continue an interrupted reading.
std::string sheetHtml(const std::vector<SheetItem>& items, const std::string& key);

/// Returns the same protocol as text, for readers who fill in ratings.csv by hand.
std::string readerInstructions(std::size_t images, bool hasClips);

/// Script for a page that shows clips: each image element with the attribute data-frames (file names, separated by
/// spaces) plays these frames in a loop, and a click stops and continues it.
const char* clipScript();

}  // namespace insonate::bench
